"""Shapes of a figure besides bodies and links: axes, arrows of positive sense, gripper, ground, frames."""

from collections.abc import Mapping
from typing import NamedTuple

import numpy as np

from exercises.figures.bodies import Body
from exercises.figures.camera import Camera
from exercises.figures.geometry import FigureJointAxis, Scene, close
from exercises.figures.svg import Canvas, line
from kinematics.frames.wrong_frames import DrawnFrame
from kinematics.se3 import Floats, cross_arrays
from kinematics.table import JointType

REACH = 0.11  # How far an axis is drawn beyond its body, relative to the size of the robot.

FINGER = 0.05  # Length of a gripper's fingers, relative to the size of the robot.


def axis_ends(axis: FigureJointAxis, body: Body, size: float) -> tuple[Floats, Floats]:
    """Return the ends in space of the axis as drawn, against its direction first."""
    reach = body.half + REACH * size * axis.reach
    direction = np.array(axis.direction)
    return body.centre - direction * reach, body.centre + direction * reach


def sense_arrow(axis: FigureJointAxis, body: Body, size: float, camera: Camera) -> tuple[Floats, ...]:
    """Return on paper the arrow of the positive sense, its head, and where its name belongs; or nothing."""
    if not axis.signed:
        return ()
    direction = np.array(axis.direction)
    if axis.type is JointType.PRISMATIC:
        side = body.across[0] * body.radius * 1.9
        reach = body.half * 0.9
        space = body.centre + side + np.outer(np.linspace(-reach, reach, 8), direction)
    else:
        turn = np.linspace(0.3, 0.3 + 1.5 * np.pi, 28)[:, None]
        u = body.across[0]
        v = cross_arrays(direction, u)
        centre = body.centre + direction * (body.half + 0.03 * size)
        space = centre + 1.25 * body.radius * (np.cos(turn) * u + np.sin(turn) * v)
    run = camera.project(space)
    along = run[-1] - run[-2]
    along = along / max(float(np.linalg.norm(along)), 1e-9)
    across = np.array([-along[1], along[0]])
    head = np.array([run[-1] - 6 * along + 4 * across, run[-1], run[-1] - 6 * along - 4 * across])
    return run, head, run[0]


def gripper_lines(scene: Scene, camera: Camera) -> list[Floats]:
    """Return on paper palm and two fingers."""
    gripper = scene.gripper
    if gripper is None:
        return []
    finger = FINGER * scene.size
    at, direction = np.array(gripper.at), np.array(gripper.direction)
    jaws = np.array(gripper.jaws) if gripper.jaws else _widest(direction, camera)
    palm = at - direction * finger
    side = jaws * finger * 0.62
    tip = at + direction * finger * 0.25
    return [camera.project(np.array([tip - side, palm - side, palm + side, tip + side]))]


def ground_lines(scene: Scene, camera: Camera) -> list[tuple[Floats, float]]:
    """Return on paper the line of the ground and the hatches behind it, with their widths."""
    ground = scene.ground
    if ground is None:
        return []
    at = camera.project(ground.at)
    out = camera.project(np.array(ground.at) + np.array(ground.normal)) - at
    out = out / max(float(np.linalg.norm(out)), 1e-9)
    along = np.array([-out[1], out[0]])
    half, step, deep = 32.0, 8.0, 9.0
    lines: list[tuple[Floats, float]] = [(np.array([at - along * half, at + along * half]), 2.0)]
    for k in np.arange(-half + 4, half + 0.1, step):
        foot = at + along * k
        lines.append((np.array([foot, foot - out * deep - along * deep * 0.8]), 1.0))
    return lines


def trimmed(chain: Floats, scene: Scene) -> Floats:
    """Return the chain, ending at the palm where it would run on between the jaws of the gripper."""
    gripper = scene.gripper
    if gripper is None or not close(chain[-1], gripper.at):
        return chain
    palm = np.array(gripper.at) - np.array(gripper.direction) * (FINGER + 0.01) * scene.size
    return np.concatenate([chain[:-1], palm[None]])


def _widest(direction: Floats, camera: Camera) -> Floats:
    """The coordinate direction square to a direction that is longest on paper."""
    square = [axis - direction * (axis @ direction) for axis in np.eye(3)]
    best = max(square, key=lambda v: float(np.linalg.norm(camera.project(v) - camera.project(np.zeros(3)))))
    return np.asarray(best / np.linalg.norm(best), dtype=np.float64)


COLOURS = {"x": "#d1495b", "y": "#2e8b57", "z": "#3d7edb"}
"""Seen on white and on black; the names tell the same."""
LENGTH = 0.15  # Of an arrow, as a part of the robot's size.
SHORTER = 0.12
"""By which part the arrows of the next frame are shorter, so that frames in one place are told apart."""
HEAD, WING = 8.0, 3.4  # Length and half width of an arrow's head [unit of the paper].
WIDTH = 2.2  # Width of an arrow's line [unit of the paper]: thinner than links, thicker than dimension lines.


class Arrow(NamedTuple):
    """An axis of a frame on paper."""

    name: str
    axis: str
    ends: Floats


def arrows(frames: Mapping[int, DrawnFrame], size: float, camera: Camera) -> list[Arrow]:
    """Return the arrows of frames by their numbers."""
    found = []
    for index, frame in frames.items():
        origin = np.array(frame.origin)
        length = LENGTH * size * (1.0 - SHORTER * (index % 3))
        for axis in COLOURS:
            tip = origin + length * np.array(getattr(frame, axis))
            found.append(Arrow(f"{axis}{index}", axis, camera.project(np.array([origin, tip]))))
    return found


def draw_arrow(canvas: Canvas, arrow: Arrow) -> None:
    """Draw an arrow; one that points at the eye is a dot."""
    start, tip = arrow.ends
    colour = COLOURS[arrow.axis]
    length = float(np.linalg.norm(tip - start))
    if length < HEAD:
        canvas.circle(tip, WING, f"frame-{arrow.axis}", fill=colour)
        return
    along = (tip - start) / length
    across = np.array([-along[1], along[0]])
    neck = tip - HEAD * along
    canvas.path(line([start, neck]), f"frame-{arrow.axis}", stroke=colour, stroke_width=WIDTH)
    head = [tip, neck + WING * across, neck - WING * across, tip]
    canvas.path(line(head), f"frame-{arrow.axis}", fill=colour)
