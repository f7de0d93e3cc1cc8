"""From space to paper: parallel projection."""

import math
from collections.abc import Iterable
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import ArrayLike

from exercises.figures.specification import View
from kinematics.se3 import Floats


@dataclass(frozen=True, kw_only=True, slots=True)
class Camera:
    """A parallel projection with a scale.

    Attributes:
        right: unit vector in space that points right on paper.
        up: unit vector in space that points up on paper.
        eye: unit vector in space towards the eye.
        scale: units of paper per unit of length.
        shift: position on paper of the origin of space.
    """

    right: Floats
    up: Floats
    eye: Floats
    scale: float = 1.0
    shift: tuple[float, float] = (0.0, 0.0)

    def project(self, points: ArrayLike) -> Floats:
        """Return (…, 3) points in space as (…, 2) points on paper, y downwards."""
        p = np.asarray(points, dtype=np.float64)
        found: Floats = np.empty((*p.shape[:-1], 2))
        found[..., 0] = p @ self.right * self.scale + self.shift[0]
        found[..., 1] = -(p @ self.up) * self.scale + self.shift[1]
        return found

    def depth(self, points: ArrayLike) -> Floats:
        """Return (…, 3) points in space as (…) distances towards the eye; the larger, the nearer."""
        return np.asarray(np.asarray(points, dtype=np.float64) @ self.eye, dtype=np.float64)


def camera_for(view: View) -> Camera:
    """Return the camera of a view, at scale 1."""
    ca, sa = math.cos(view.azimuth), math.sin(view.azimuth)
    ce, se = math.cos(view.elevation), math.sin(view.elevation)
    return Camera(
        right=np.array([-sa, ca, 0.0]),
        up=np.array([-se * ca, -se * sa, ce]),
        eye=np.array([ce * ca, ce * sa, se]),
    )


def fitted(
    camera: Camera, points: Iterable[ArrayLike], *, width: float, height: float, most: float
) -> Camera:
    """Return the camera scaled, up to `most`, so that (3,) points fit into a box of paper at the origin."""
    flat = replace(camera, scale=1.0, shift=(0.0, 0.0)).project(np.array(list(points)))
    low, high = flat.min(axis=0), flat.max(axis=0)
    extent = np.maximum(high - low, 1e-12)
    scale = float(min(width / extent[0], height / extent[1], most))
    left = (width - extent[0] * scale) / 2
    shift = float(left - low[0] * scale), float(-low[1] * scale)
    return replace(camera, scale=scale, shift=shift)
