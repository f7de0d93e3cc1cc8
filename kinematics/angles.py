"""Cosines and sines: exact for multiples of 15°, vectorised for the many angles of a batch.

No double is π/2, so `math.cos(math.pi / 2)` is 6e-17, and a right angle would spread small numbers over every
matrix. Therefore the doubles that result from writing k·π/12 (|k| ≤ 24, that is up to two turns), in radians
or by one of the usual conversions from degrees, count as k·π/12 itself, in tables and in joint values,
for one configuration and for many. There are 82 such doubles, each within 8.3e-16 rad of the value for which
it counts; neighbouring doubles are not changed.
"""

import math
from fractions import Fraction

import numpy as np
from numpy.typing import NDArray

TWELFTH = math.pi / 12
MOST_TWELFTHS = 24  # Two turns: as far as people write angles.

_COSINES = (1.0, 0.9659258262890683, 0.8660254037844386, 0.7071067811865476, 0.5, 0.25881904510252074, 0.0)
"""For k = 0 … 6 cos(k·π/12), correctly rounded: 1, (√6+√2)/4, √3/2, √2/2, 1/2, (√6−√2)/4, 0."""
# 51 digits: products with the numerators of doubles keep far more than a double's 17.
_PI = Fraction("3.14159265358979323846264338327950288419716939937510")
_NEARLY_INTEGER = 1e-13
"""A sieve before the exact comparison: of the doubles in `_EXACT` none is 1e-14 from an integer number of
twelfths."""


def cos_sin(angle: float) -> tuple[float, float]:
    """Return the cosine and sine of an angle, exact if it counts as a multiple of π/12.

    Args:
        angle: [rad], finite.

    Returns:
        (cos, sin), correctly rounded for multiples of π/12.
    """
    return _EXACT.get(angle) or (math.cos(angle), math.sin(angle))


def nearest_twelfth(angle: float, tolerance: float) -> int | None:
    """Return k if an angle is k·π/12, otherwise None.

    Args:
        angle: [rad].
        tolerance: how far from k·π/12 it may be [rad].
    """
    k = round(angle / TWELFTH)
    rest = abs(angle - k * TWELFTH)
    if rest > tolerance + _NEARLY_INTEGER * (1.0 + abs(angle)):  # most angles are none
        return None
    return k if abs(angle - twelfths(k)) <= tolerance else None


def twelfths(k: int) -> float:
    """Return k·π/12 [rad], the double that people write: k·π/12 in lowest terms."""
    turn = Fraction(k, 12)
    return turn.numerator * math.pi / turn.denominator


def cos_sin_arrays(half: NDArray[np.float64], cos: NDArray[np.float64], sin: NDArray[np.float64]) -> None:
    """Compute the cosines and sines of many angles, from one tangent each.

    With t = tan(q/2):  cos q = 2/(1 + t²) − 1  and  sin q = t · 2/(1 + t²).

    numpy computes the double tangent with vector instructions and sine and cosine without. Nothing is lost
    near q = π, where t → ∞: no double is an odd multiple of π/2, so |t| stays below 1e20 and t² far from
    overflow; there cos q → −1 exactly and sin q ≈ 2/t keeps the tangent's relative accuracy. Halving an angle
    is exact, so large angles are as accurate as the tangent's own range reduction. Measured errors are below
    4e-16 for |q| up to 1e308.

    Args:
        half: q/2 [rad], finite; overwritten.
        cos: receives cos q.
        sin: receives sin q.
    """
    exact = _exact_places(half, cos, sin)
    t = np.tan(half, out=half)
    np.multiply(t, t, out=cos)
    np.add(cos, 1.0, out=cos)
    np.divide(2.0, cos, out=cos)
    np.multiply(t, cos, out=sin)
    np.subtract(cos, 1.0, out=cos)
    if exact is not None:
        places, rank = exact
        cos[places], sin[places] = _EXACT_PAIRS[rank].T


def _exact_places(
    half: NDArray[np.float64], scratch: NDArray[np.float64], other: NDArray[np.float64]
) -> tuple[tuple[NDArray[np.intp], ...], NDArray[np.intp]] | None:
    """Return the indices of the angles that count as multiples of π/12, and which; None if there are none."""
    with np.errstate(over="ignore", invalid="ignore"):
        np.multiply(half, 2.0 / TWELFTH, out=scratch)
        np.rint(scratch, out=other)
        np.subtract(scratch, other, out=scratch)
        if not scratch.size or np.abs(scratch, out=scratch).min() > _NEARLY_INTEGER:
            return None
    near = np.nonzero((scratch <= _NEARLY_INTEGER) & (other != 0.0))
    angles = half[near] * 2.0
    rank = np.minimum(np.searchsorted(_EXACT_ANGLES, angles), len(_EXACT_ANGLES) - 1)
    exact = _EXACT_ANGLES[rank] == angles
    return tuple(axis[exact] for axis in near), rank[exact]


def _cosine(k: int) -> float:
    k = min(k % 24, -k % 24)
    return _COSINES[k] if k <= 6 else -_COSINES[12 - k]


def _written(k: int) -> set[float]:
    """Return every double that results from writing k·π/12 in one of the usual ways."""
    turn = Fraction(k, 12)
    n, d = turn.numerator, turn.denominator
    return {
        float(_PI * turn),
        k * math.pi / 12,
        k * TWELFTH,
        n * math.pi / d,
        n * (math.pi / d),
        15 * k * math.pi / 180,
        math.radians(15 * k),
    }


_EXACT = {
    angle: (_cosine(k), _cosine(k - 6))
    for k in range(-MOST_TWELFTHS, MOST_TWELFTHS + 1)
    if k
    for angle in _written(k)
}
_EXACT_ANGLES = np.array(sorted(_EXACT))
_EXACT_PAIRS = np.array([_EXACT[angle] for angle in sorted(_EXACT)])

are_ordinary = frozenset({0.0, *_EXACT}).isdisjoint
"""Whether none of some numbers counts as a multiple of π/12, 0 among them; of six it is told in 0.1 µs."""
