"""Angles that are sums of joint variables, parameters and constants, and their cosines and sines."""

from dataclasses import dataclass, field
from fractions import Fraction
from functools import lru_cache
from math import inf

from kinematics.expressions import (
    ONE,
    ZERO,
    Call,
    Expression,
    Function,
    JointVariable,
    Number,
    add,
    call,
    multiply,
    number,
    pi_fraction,
    pi_times,
    split_weight,
    terms_of,
)
from kinematics.symbolic.form_reader import FormReader

_ROOT_2, _ROOT_3, _ROOT_6 = (call(Function.SQRT, number(n)) for n in (2, 3, 6))
_QUARTER = Fraction(1, 4)
_QUADRANT: tuple[Expression, ...] = (
    ONE,
    multiply((Number(_QUARTER), add((_ROOT_6, _ROOT_2)))),
    multiply((Number(Fraction(1, 2)), _ROOT_3)),
    multiply((Number(Fraction(1, 2)), _ROOT_2)),
    Number(Fraction(1, 2)),
    multiply((Number(_QUARTER), add((_ROOT_6, multiply((number(-1), _ROOT_2)))))),
    ZERO,
)
COSINES = (*_QUADRANT, *(multiply((number(-1), cosine)) for cosine in _QUADRANT[-2::-1]))
"""Cosines of 0, π/12, …, π."""

_ARCS = (Function.ASIN, Function.ACOS, Function.ATAN, Function.ATAN2)


@dataclass(frozen=True, slots=True)
class Angle:
    """half_turns·π + number + Σ weight·part [rad].

    Attributes:
        half_turns: in (-1, 1].
        number: rational number of radians.
        parts: what else is added, with rational weights that are not zero: joint variables by their number,
            then everything else in the order in which it came.
    """

    half_turns: Fraction = Fraction(0)
    number: Fraction = Fraction(0)
    parts: tuple[tuple[Expression, Fraction], ...] = ()
    _hash: int = field(init=False, repr=False, compare=False)

    def __post_init__(self) -> None:
        # angles are looked up all the time, and a fraction takes long to hash
        object.__setattr__(self, "_hash", hash((self.half_turns, self.number, self.parts)))

    def __hash__(self) -> int:
        return self._hash

    def plus(self, other: "Angle", sign: int = 1) -> "Angle":
        """Return the sum, or difference, of two angles."""
        return _sum(self, other, sign)

    @property
    def quarter_turns(self) -> int | None:
        """The angle in quarter turns, in -1 … 2, if it is a whole number of them."""
        quarters = self.half_turns * 2
        if self.parts or self.number or quarters.denominator != 1:
            return None
        return quarters.numerator

    def weight_of(self, joint: int) -> int:
        """Return with which sign a joint variable enters, 0 if it does not."""
        for part, weight in self.parts:
            if isinstance(part, JointVariable) and part.index == joint:
                return weight.numerator
        return 0

    @property
    def is_constant(self) -> bool:
        """Whether no joint variable stands in the angle."""
        return not any(isinstance(part, JointVariable) for part, _ in self.parts)

    def expression(self) -> Expression:
        """Return the angle as an expression [rad]."""
        terms = [part if weight == 1 else multiply((Number(weight), part)) for part, weight in self.parts]
        return add((*terms, pi_times(self.half_turns), Number(self.number)))


NO_ANGLE = Angle()


@lru_cache(maxsize=256)
def joint_angle(joint: int, sign: int) -> Angle:
    """Return the angle sign·q_joint."""
    return Angle(parts=((JointVariable(joint), Fraction(sign)),))


@lru_cache(maxsize=4096)
def _sum(angle: Angle, other: Angle, sign: int) -> Angle:
    weights = dict(angle.parts)
    for part, weight in other.parts:
        weights[part] = weights.get(part, Fraction(0)) + sign * weight
    kept = [(part, weight) for part, weight in weights.items() if weight]
    kept.sort(key=_place)
    return Angle(
        _wrapped(angle.half_turns + sign * other.half_turns), angle.number + sign * other.number, tuple(kept)
    )


@lru_cache(maxsize=4096)
def angle_of(expression: Expression) -> Angle:
    """Return an expression as an angle."""
    half_turns = radians = Fraction(0)
    weights: dict[Expression, Fraction] = {}
    for term in terms_of(expression):
        term = _exact_arc(term)
        turns = pi_fraction(term)
        if turns is not None:
            half_turns += turns
        elif isinstance(term, Number):
            radians += term.value
        else:
            weight, part = split_weight(term)
            weights[part] = weights.get(part, Fraction(0)) + weight
    parts = sorted(((part, weight) for part, weight in weights.items() if weight), key=_place)
    return Angle(_wrapped(half_turns), radians, tuple(parts))


@lru_cache(maxsize=4096)
def cosine_and_sine(angle: Angle) -> tuple[Expression, Expression]:
    """Return the cosine and sine.

    Quarter turns folded, multiples of π/12 exact, other constants brought within a right angle of zero.
    """
    if not angle.parts and not angle.number and (angle.half_turns * 12).denominator == 1:
        steps = (angle.half_turns * 12).numerator
        return _twelfth(steps), _twelfth(steps - 6)
    quarters = int(angle.half_turns * 2)  # towards zero
    angle = Angle(angle.half_turns - Fraction(quarters, 2), angle.number, angle.parts)
    flipped = _leads_negative(angle)
    if flipped:
        angle = NO_ANGLE.plus(angle, -1)
    argument = angle.expression()
    cosine: Expression = Call(Function.COS, (argument,))
    sine: Expression = Call(Function.SIN, (argument,))
    if flipped:
        sine = _negative(sine)
    for _ in range(quarters % 4):
        cosine, sine = _negative(sine), cosine
    return cosine, sine


def _leads_negative(angle: Angle) -> bool:
    leading = angle.parts[0][1] if angle.parts else angle.number or angle.half_turns
    return leading < 0


def _twelfth(steps: int) -> Expression:
    """Cosine of steps·π/12."""
    steps %= 24
    return COSINES[min(steps, 24 - steps)]


def _negative(expression: Expression) -> Expression:
    return multiply((number(-1), expression))


def _wrapped(half_turns: Fraction) -> Fraction:
    return 1 - (1 - half_turns) % 2


def _place(item: tuple[Expression, Fraction]) -> float:
    part = item[0]
    return part.index if isinstance(part, JointVariable) else inf


def _exact_arc(term: Expression) -> Expression:
    """asin(1/2) is π/6; an arc of something that is no multiple of π/12 stays what it is."""
    weight, part = split_weight(term)
    if isinstance(part, Call) and part.function in _ARCS:
        turns = FormReader().half_turns(part)
        if turns is not None:
            return pi_times(weight * turns)
    return term
