"""Turns by one angle, and equations in its cosine and sine."""

import math
from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from kinematics.se3 import skew

NEARLY_REAL = 3e-2
"""Roots e^{iq} whose modulus is this near to 1 are tried: rounding of 1e-15 moves a double root by its square
root, and of a quadruple one by its fourth root, 2e-4; the rest is for coefficients that have lost digits."""

ONE_ROOT = 1e-6
"""Half the distance of two roots [rad] that rounding of some 1e-13 in k may have parted, or made one."""

LEAST_PARTED = 1e-8  # Half the distance [rad] at which two roots are tried that rounding has made one.

NOTHING = 1e-13  # Coefficients this small beside the largest are what rounding leaves of zero.


def rotations(axis: NDArray[np.float64], q: float | NDArray[np.float64]) -> NDArray[np.float64]:
    """Return the turns about a unit axis, (…, 3, 3) of angles (…); Rodrigues' formula."""
    K = skew(axis)
    turns = np.asarray(q)[..., None, None]
    return np.asarray(np.eye(3) + np.sin(turns) * K + (1.0 - np.cos(turns)) * (K @ K))


def linear_roots(c: float, s: float, k: float, parted: float = ONE_ROOT) -> tuple[float, ...] | None:
    """Return both q with c·cos q + s·sin q = k, only the middle where |k| is too large; None if c = s = 0.

    Where both are so near to the middle that rounding may have parted them, the middle is there as well; and
    where it may have made them one, or none, both sides of the middle are: of links that fold onto each other
    they lead in opposite directions.

    Args:
        c: factor of the cosine.
        s: factor of the sine.
        k: their sum.
        parted: half the distance of two real roots [rad] that rounding may have made none.

    Source: C. C. Paden, Kinematics and control of robot manipulators (1986), as R. P. Paul's a cos + b sin
    = d.
    """
    length = math.hypot(c, s)
    if length == 0.0:
        return None
    middle = math.atan2(s, c)
    across = (length - k) * (length + k)
    half = math.atan2(math.sqrt(abs(across)), abs(k))
    middle += math.pi if k < 0.0 else 0.0
    if half < (ONE_ROOT if across > 0.0 else parted):
        half = max(half, LEAST_PARTED)
        return middle - half, middle + half, middle
    return (middle - half, middle + half) if across > 0.0 else (middle,)


def quadratic_roots(cc: float, cs: float, ss: float, c: float, s: float, one: float) -> list[float] | None:
    """Return the zeros, or what is nearly one, of a quadratic function of the cosine and sine of q.

    It is cc·cos² + cs·cos·sin + ss·sin² + c·cos + s·sin + one. With x = e^{iq} it is a polynomial
    of degree 4 in x. None where all coefficients vanish.
    """
    a2 = 0.25 * complex(cc - ss, -cs)
    a1 = 0.5 * complex(c, -s)
    a0 = one + 0.5 * (cc + ss)
    return unit_roots(np.array([a2, a1, a0, a1.conjugate(), a2.conjugate()]))


def unit_roots(falling: NDArray[np.complex128]) -> list[float] | None:
    """Return the angles of a polynomial's roots on the unit circle, or nearly; None if it is zero."""
    size = np.abs(falling)
    largest = float(size.max())
    if largest == 0.0 or not math.isfinite(largest):
        return None
    significant = np.where(size > NOTHING * largest, falling, 0.0)
    roots = np.roots(significant)
    near = np.abs(np.abs(roots) - 1.0) <= NEARLY_REAL
    return [float(q) for q in np.angle(roots[near])]


def sampled_roots(function: Callable[[float], float], degree: int) -> list[float] | None:
    """Return the zeros of a trigonometric polynomial of known degree, found from samples of it.

    None where it vanishes everywhere.
    """
    count = 4 * degree
    values = np.array([function(2.0 * math.pi * k / count) for k in range(count)])
    spectrum = np.fft.fft(values) / count
    return unit_roots(np.concatenate((spectrum[: degree + 1][::-1], spectrum[-degree:][::-1])))
