"""Bodies of joints on paper: a cylinder turns, a block slides.

A body is convex, so the ray from a point of the paper towards the eye leaves it at one depth: whatever is on
that ray and deeper is hidden by the body.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from exercises.figures.camera import Camera
from exercises.figures.geometry import FigureJointAxis
from kinematics.se3 import Floats, cross_arrays
from kinematics.table import JointType

RADIUS = 0.036  # Radius of a cylinder, relative to the size of the robot.

LENGTH = 0.11  # Length of a body along its axis, relative to the size of the robot.

NOWHERE = -np.inf


@dataclass(frozen=True, kw_only=True, slots=True)
class Body:
    """A cylinder or a block around a point of a joint's axis.

    Attributes:
        type: revolute (cylinder) or prismatic (block).
        centre: (3,) centre.
        axis: (3,) unit vector along the axis, towards the eye where there is a choice.
        across: two (3,) unit vectors perpendicular to the axis and to each other.
        radius: of the cylinder; half the width of the block.
        half: half the length along the axis.
    """

    type: JointType
    centre: Floats
    axis: Floats
    across: tuple[Floats, Floats]
    radius: float
    half: float

    def front(self, on_paper: Floats, eye: Floats) -> Floats:
        """Return the depth at which rays towards the eye leave the body, minus infinity where they miss it.

        Args:
            on_paper: (n, 3) points in space of the plane of the paper.
            eye: (3,) unit vector towards the eye.
        """
        relative = on_paper - self.centre
        start, stop = _slab(relative @ self.axis, float(eye @ self.axis), self.half)
        if self.type is JointType.PRISMATIC:
            spans = [_slab(relative @ u, float(eye @ u), self.radius) for u in self.across]
        else:
            spans = [_tube(relative, self.axis, eye, self.radius)]
        for low, high in spans:
            start, stop = np.maximum(start, low), np.minimum(stop, high)
        return np.where(start <= stop, stop, NOWHERE)


def body_of(axis: FigureJointAxis, size: float, camera: Camera) -> Body:
    """Return the body of a joint at the usual proportions."""
    direction = np.array(axis.direction)
    if direction @ camera.eye < 0:
        direction = -direction
    reference = np.array([0.0, 0.0, 1.0]) if abs(direction[2]) < 0.9 else np.array([1.0, 0.0, 0.0])
    first = cross_arrays(direction, reference)
    first /= np.linalg.norm(first)
    return Body(
        type=axis.type,
        centre=np.array(axis.point),
        axis=direction,
        across=(first, cross_arrays(direction, first)),
        radius=RADIUS * size * axis.scale,
        half=LENGTH / 2 * size * axis.scale * (1.15 if axis.type is JointType.PRISMATIC else 1.0),
    )


def outline(body: Body, camera: Camera) -> list[tuple[str, str]]:
    """Return what is drawn of a body.

    Pairs of a role ("side", "cap") and SVG path data, in the order of drawing.
    """
    return _block(body, camera) if body.type is JointType.PRISMATIC else _cylinder(body, camera)


def corners(body: Body, camera: Camera) -> NDArray[np.float64]:
    """Return (n, 2) points on paper whose convex hull holds the body."""
    u, v = body.across
    along = [body.axis * body.half, -body.axis * body.half]
    ring = [body.radius * (a * u + b * v) for a in (-1, 1) for b in (-1, 1)]
    return camera.project(np.array([body.centre + x + y for x in along for y in ring]))


def _cylinder(body: Body, camera: Camera) -> list[tuple[str, str]]:
    near = camera.project(body.centre + body.axis * body.half)
    far = camera.project(body.centre - body.axis * body.half)
    major = body.radius * camera.scale
    minor = major * abs(float(body.axis @ camera.eye))
    along = near - far
    length = float(np.linalg.norm(along))
    direction = along / length if length > 1e-6 else np.array([0.0, -1.0])
    normal = np.array([-direction[1], direction[0]]) * major
    turn = float(np.degrees(np.arctan2(normal[1], normal[0])))
    arc = f"A{major:.1f} {minor:.1f} {turn:.1f} 0"
    cap = f"M{_pair(near + normal)}{arc} 1 {_pair(near - normal)}{arc} 1 {_pair(near + normal)}Z"
    if length <= 1e-6:
        return [("side", cap), ("cap", cap)]
    side = (
        f"M{_pair(near + normal)}L{_pair(far + normal)}{arc} 1 {_pair(far - normal)}"
        f"L{_pair(near - normal)}{arc} 1 {_pair(near + normal)}Z"
    )
    return [("side", side), ("cap", cap)]


def _block(body: Body, camera: Camera) -> list[tuple[str, str]]:
    extents = [(body.axis, body.half), (body.across[0], body.radius), (body.across[1], body.radius)]
    faces: list[tuple[str, str]] = []
    for k, (normal, extent) in enumerate(extents):
        facing = float(normal @ camera.eye)
        if abs(facing) < 1e-9:
            continue
        (u, a), (v, b) = (extents[j] for j in range(3) if j != k)
        centre = body.centre + normal * extent * np.sign(facing)
        ring = np.array([centre + su * u * a + sv * v * b for su, sv in ((-1, -1), (-1, 1), (1, 1), (1, -1))])
        role = "cap" if k == 0 else "side"
        faces.append((role, "M" + "L".join(_pair(p) for p in camera.project(ring)) + "Z"))
    return faces


def _slab(position: Floats, speed: float, half: float) -> tuple[Floats, Floats]:
    """Interval of ray parameters between two planes."""
    if abs(speed) < 1e-12:
        inside = np.abs(position) <= half
        return np.where(inside, -np.inf, np.inf), np.where(inside, np.inf, -np.inf)
    ends = np.stack([(-half - position) / speed, (half - position) / speed])
    return ends.min(axis=0), ends.max(axis=0)


def _tube(relative: Floats, axis: Floats, eye: Floats, radius: float) -> tuple[Floats, Floats]:
    """Interval of ray parameters inside an endless cylinder."""
    position = relative - np.outer(relative @ axis, axis)
    speed = eye - (eye @ axis) * axis
    a = float(speed @ speed)
    c = np.einsum("ij,ij->i", position, position) - radius**2
    if a < 1e-12:
        return np.where(c <= 0, -np.inf, np.inf), np.where(c <= 0, np.inf, -np.inf)
    b = position @ speed
    disc = b * b - a * c
    root = np.sqrt(np.maximum(disc, 0.0))
    return np.where(disc >= 0, (-b - root) / a, np.inf), np.where(disc >= 0, (-b + root) / a, -np.inf)


def _pair(point: NDArray[np.float64]) -> str:
    return f"{point[0]:.1f} {point[1]:.1f}"
