"""What is to be reached: a pose, and within which tolerance."""

import math
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from kinematics.errors import Fault, PoseError
from kinematics.inverse.arm import Array
from kinematics.inverse.lengths import LARGEST_LENGTH, is_far, too_long
from kinematics.se3 import ORTHONORMAL_TOLERANCE, Transform, check_transform

LEAST_TOLERANCE = 7e-10
"""Tolerance for targets that may have been printed [m and rad]: distance and angle together are then within
1e-9."""

COMPUTED_TOLERANCE = 1e-11
"""The same for targets with all digits of a double: rounding of the forward kinematics has room, and what is
isolated is not joined by a way on which the target is missed by more than rounding."""

PRINTED = 1e10
"""A position that is a whole number of 1/PRINTED [m] may have been printed; with more decimals it was
computed."""

ROUNDING = 1e-12  # No tolerance is smaller: rounding of the forward kinematics has to pass.

LARGEST_TOLERANCE = 1e-2
"""Poses with two decimals, or this part of an arm's size. Beyond it families and neighbouring solutions run
into each other."""

OF_ROUNDING = 3.0
"""Rounding that leaves RᵀR off the identity by δ in its worst entry moves pose and position by 3 δ at most
in all but one in ten thousand poses; measured on random rotations with 3 to 12 decimals."""

EXACT = 1e-14  # A rotation whose RᵀR is no farther off than this was not rounded.

FOUR_DIGITS = 5e-4
"""Half a unit of the last of four digits, as a share: a length with fewer was chosen rather than rounded."""

_WHOLE = 1e-4
"""What is off a whole number of 1/PRINTED by no more, for lengths of 1, is one: rounding leaves 2e-6."""

ROUNDED_ENTRIES = 4.0
"""Entries off by half a tolerance each leave RᵀR off by up to √3 tolerances, and by twice that where a
tolerance is given as the half of the last digit."""


class Goal(NamedTuple):
    """A target made ready.

    Attributes:
        pose: (4, 4) rigid motion.
        tolerance: distance [m], and in units of that angle [rad], within which it counts as reached.
        unit: distance [m] that counts as much as 1 rad.
    """

    pose: Transform
    tolerance: float
    unit: float = 1.0


def read_goal(
    target: ArrayLike, tolerance: float | None, where: tuple[str | int, ...], size: float = 1.0
) -> Goal:
    """Return the target as a rigid motion that can be computed with, and its tolerance.

    The rotation part is replaced by the nearest rotation, if it is off by more than rounding.

    Args:
        target: (4, 4).
        tolerance: [m and rad]; left out, three times what the rotation part is off, and at least 1e-11 where
            the target has all digits of a double, 7e-10 elsewhere. Above 0.01 it is a distance; the angle
            is then the same part of 1 rad as it is of the size, or more if the rotation part shows it.
        where: place of the target, for faults.
        size: of the arm [m].

    Raises:
        PoseError: not a rigid motion within the tolerance, a position too far away, or a tolerance that is no
            positive number up to 0.01, or to that part of the size, at ("tolerance",).

    Source: N. J. Higham, Matrix nearness problems and applications (1989) §3, the orthogonal polar factor.
    """
    if tolerance is None and type(target) is np.ndarray and target.shape == (4, 4) and _is_exact(target):
        pose = target.astype(np.float64)
        return Goal(pose, _least_tolerance(*pose[:3, 3].tolist()))
    largest = LARGEST_TOLERANCE * max(1.0, size)
    if tolerance is not None and not 0.0 < tolerance <= largest:
        raise PoseError(Fault.at("pose_tolerance_out_of_range", "tolerance", limit=largest))
    is_distance = tolerance is not None and tolerance > LARGEST_TOLERANCE
    angle = LARGEST_TOLERANCE if is_distance else tolerance or 0.0
    allowed = max(ORTHONORMAL_TOLERANCE, ROUNDED_ENTRIES * angle)
    pose = check_transform(target, where=where, tolerance=allowed)
    if is_far(pose):
        raise PoseError(too_long(where))
    R = pose[:3, :3]
    off = float(np.abs(R.T @ R - np.eye(3)).max())
    least = LEAST_TOLERANCE
    if off > EXACT:
        U, _, V = np.linalg.svd(R)
        pose[:3, :3] = U @ V
    else:
        least = _least_tolerance(*pose[:3, 3].tolist())
    if tolerance is None:
        return Goal(pose, max(OF_ROUNDING * off, least))
    if is_distance:
        angle = min(max(tolerance / size, OF_ROUNDING * off), LARGEST_TOLERANCE)
        return Goal(pose, tolerance, tolerance / angle)
    return Goal(pose, max(tolerance, ROUNDING))


def tolerances_of_exact(targets: Array) -> Array:
    """Return the tolerance of each target whose rotation part is exact, (m,) of (m, 4, 4), as `read_goal`."""
    position = targets[:, :3, 3]
    scaled = PRINTED * position
    computed = (np.abs(scaled - np.rint(scaled)) > _WHOLE * (1.0 + np.abs(position))).any(axis=1)
    return np.where(computed, COMPUTED_TOLERANCE, LEAST_TOLERANCE)


def _least_tolerance(*position: float) -> float:
    """The tolerance of a target whose rotation part is exact."""
    for length in position:
        scaled = PRINTED * length
        if abs(scaled - round(scaled)) > _WHOLE * (1.0 + abs(length)):
            return COMPUTED_TOLERANCE
    return LEAST_TOLERANCE


def rounding_of(position: Array) -> float:
    """Return how far a position may be off, if it was printed with four digits or more; 0 with fewer or all.

    Half a unit of the last decimal in each of three directions; of lengths over 10, as in mm, a share, since
    the angle has the same tolerance.
    """
    longest = float(np.abs(position).max())
    for decimals in range(10):
        scaled = position * 10.0**decimals
        if (np.abs(scaled - np.rint(scaled)) <= _WHOLE).all():
            half = 0.5 * 10.0**-decimals
            return math.sqrt(3.0) * half / max(1.0, 0.1 * longest) if half <= FOUR_DIGITS * longest else 0.0
    return 0.0


def _is_exact(target: NDArray[Any]) -> bool:
    """Whether an array is a rigid motion that was not rounded and is not too far away; never long."""
    if target.dtype != np.float64:
        return False
    rows: list[list[float]] = target.tolist()
    (a, b, c, x), (d, e, f, y), (g, h, i, z), bottom = rows
    return (
        bottom == [0.0, 0.0, 0.0, 1.0]
        and abs(a * a + d * d + g * g - 1.0) <= EXACT
        and abs(b * b + e * e + h * h - 1.0) <= EXACT
        and abs(c * c + f * f + i * i - 1.0) <= EXACT
        and abs(a * b + d * e + g * h) <= EXACT
        and abs(a * c + d * f + g * i) <= EXACT
        and abs(b * c + e * f + h * i) <= EXACT
        and (a * e - b * d) * i > (a * f - c * d) * h - (b * f - c * e) * g
        and -LARGEST_LENGTH < x < LARGEST_LENGTH
        and -LARGEST_LENGTH < y < LARGEST_LENGTH
        and -LARGEST_LENGTH < z < LARGEST_LENGTH
    )
