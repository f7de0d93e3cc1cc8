"""Chains of frames: {}^A T_C from the poses that are known, and what a wrong one looks like.

    {}^A T_C = {}^A T_B · {}^B T_C ,        {}^B T_A = ({}^A T_B)⁻¹ = ( Rᵀ  −Rᵀp ; 0  1 )

An answer is right when it is that matrix: its rotation entry by entry, its position relative to a length.
There is no freedom in it, for both frames are named.
"""

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace
from enum import StrEnum
from functools import reduce

import numpy as np

from kinematics.se3 import Floats, Transform, inverse_transform


class ChainMistake(StrEnum):
    """What a wrong pose in a chain of frames looks like.

    INVERTED: it leads the other way. NOT_INVERTED: a known pose was used as it is that had to be inverted.
    INVERSE_WITHOUT_TRANSPOSE: the inverse was formed with R for Rᵀ. INVERSE_POSITION: with −p for −Rᵀp.
    ORDER_REVERSED: the factors changed places. TRANSPOSED: the rotation is transposed. NOT_RIGID: no pose.
    """

    INVERTED = "inverted"
    NOT_INVERTED = "not_inverted"
    INVERSE_WITHOUT_TRANSPOSE = "inverse_without_transpose"
    INVERSE_POSITION = "inverse_position"
    ORDER_REVERSED = "order_reversed"
    TRANSPOSED = "transposed"
    NOT_RIGID = "not_rigid"


@dataclass(frozen=True, kw_only=True, eq=False)
class ChainFactor:
    """A known pose in the chain.

    Attributes:
        pose: (4, 4) as it is known.
        inverted: it has to be inverted to lead the right way.
    """

    pose: Transform
    inverted: bool = False

    @property
    def used(self) -> Transform:
        """The pose as it stands in the product."""
        return inverse_transform(self.pose) if self.inverted else self.pose


@dataclass(frozen=True, kw_only=True, slots=True)
class ChainVerdict:
    """What is said of a pose.

    Attributes:
        entries: (4, 4) which entries are right, row by row.
    """

    rotation: bool
    position: bool
    entries: tuple[tuple[bool, ...], ...]
    mistakes: tuple[ChainMistake, ...] = ()

    @property
    def right(self) -> bool:
        """Everything is right."""
        return self.rotation and self.position


def chain_product(factors: Sequence[ChainFactor]) -> Transform:
    """Return the pose that the factors lead to, from left to right."""
    return reduce(np.matmul, (factor.used for factor in factors), np.eye(4))


def judge_chain(
    factors: Sequence[ChainFactor], given: Floats, *, size: float, tolerance: float
) -> ChainVerdict:
    """Judge a pose against a chain of known ones.

    Args:
        factors: the known poses in order.
        given: (4, 4) what was answered; any finite numbers.
        size: a typical length; errors of positions are relative to it.
        tolerance: largest error of a direction cosine, and of a position as a share of the size.
    """
    expected = chain_product(factors)
    scale = np.full((3, 4), tolerance)
    scale[:, 3] *= size
    near = np.abs(given[:3] - expected[:3]) <= scale
    last = np.abs(given[3] - [0.0, 0.0, 0.0, 1.0]) <= 1e-6
    bottom, entries = bool(last.all()), tuple(map(tuple, [*near.tolist(), last.tolist()]))
    rotation, position = bool(near[:, :3].all()) and bottom, bool(near[:, 3].all()) and bottom
    if rotation and position:
        return ChainVerdict(rotation=True, position=True, entries=entries)

    def looks_like(other: Floats) -> bool:
        return bool((np.abs(given[:3] - other[:3]) <= scale).all())

    slips = _slips(factors, expected, given, looks_like, tolerance) if bottom else (ChainMistake.NOT_RIGID,)
    return ChainVerdict(rotation=rotation, position=position, entries=entries, mistakes=tuple(slips))


def _slips(
    factors: Sequence[ChainFactor],
    expected: Transform,
    given: Floats,
    looks_like: Callable[[Floats], bool],
    tolerance: float,
) -> Iterator[ChainMistake]:
    """Yield the slip that makes the answer, the likeliest first; one at most."""
    turned = [factor.used for factor in reversed(factors)]
    inverted = any(factor.inverted for factor in factors)
    ways: list[tuple[ChainMistake, Floats]] = [
        (ChainMistake.INVERTED, inverse_transform(expected)),
        (ChainMistake.ORDER_REVERSED, reduce(np.matmul, turned, np.eye(4))),
        (ChainMistake.TRANSPOSED, _with_rotation(expected, expected[:3, :3].T)),
    ]
    if inverted:
        ways[:0] = [
            *((ChainMistake.NOT_INVERTED, product) for product in _inverted_otherwise(factors)),
            (ChainMistake.INVERSE_WITHOUT_TRANSPOSE, _product(factors, _negated_position)),
            (ChainMistake.INVERSE_WITHOUT_TRANSPOSE, _product(factors, _kept_rotation)),
            (ChainMistake.INVERSE_POSITION, _product(factors, _plain_position)),
        ]
    for mistake, other in ways:
        if looks_like(other):
            yield mistake
            return
    rotation = given[:3, :3]
    if np.abs(rotation.T @ rotation - np.eye(3)).max() > 3 * tolerance or np.linalg.det(rotation) < 0:
        yield ChainMistake.NOT_RIGID


def _inverted_otherwise(factors: Sequence[ChainFactor]) -> Iterator[Floats]:
    """Yield products in which a pose that has to be inverted stands as it is: one, all, or all but those."""
    yield _product(factors, lambda pose: pose)
    yield chain_product([replace(factor, inverted=not factor.inverted) for factor in factors])
    for i, factor in enumerate(factors):
        if factor.inverted:
            yield chain_product([*factors[:i], replace(factor, inverted=False), *factors[i + 1 :]])


def _product(factors: Sequence[ChainFactor], inverse: Callable[[Transform], Floats]) -> Floats:
    used = (inverse(factor.pose) if factor.inverted else factor.pose for factor in factors)
    return reduce(np.matmul, used, np.eye(4))


def _with_rotation(pose: Transform, rotation: Floats) -> Floats:
    result = pose.copy()
    result[:3, :3] = rotation
    return result


def _negated_position(pose: Transform) -> Floats:
    """Return (R, −p): no transpose at all."""
    result = pose.copy()
    result[:3, 3] *= -1.0
    return result


def _kept_rotation(pose: Transform) -> Floats:
    """Return (R, −Rᵀp): the transpose for the position alone."""
    return _with_rotation(inverse_transform(pose), pose[:3, :3])


def _plain_position(pose: Transform) -> Floats:
    """Return (Rᵀ, −p): the transpose for the rotation alone."""
    result = inverse_transform(pose)
    result[:3, 3] = -pose[:3, 3]
    return result
