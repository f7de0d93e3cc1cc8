"""The terms of nested sums: a rational number times factors, which are known by numbers."""

from enum import IntEnum, auto
from fractions import Fraction
from typing import TypeAlias

from kinematics.expressions import Call, Expression, Function, JointVariable, Number, joint_variables_in

Rational: TypeAlias = int | Fraction
Term: TypeAlias = tuple[Rational, tuple[int, ...]]
Nested: TypeAlias = tuple[Term, ...]

NOTHING: Nested = ()
UNITY: Nested = ((1, ()),)
MINUS: Nested = ((-1, ()),)

NAME_BITS = 32
PLACE_BITS = 16  # Bits of a name in a key, and of the joint within a name; the rank stands above both.


class Rank(IntEnum):
    """The order of factors within a term."""

    ROOT = auto()
    LENGTH = auto()
    PRISMATIC = auto()
    CONSTANT_ANGLE = auto()
    JOINT_ANGLE = auto()
    PARENTHESES = auto()


def place_of(expression: Expression) -> int:
    """Return where a symbol stands: by its rank, then by the first joint in it."""
    joint = 0
    match expression:
        case Call(Function.SQRT, (Number(),)):
            rank = Rank.ROOT
        case JointVariable(joint):
            rank = Rank.PRISMATIC
        case Call(Function.SIN | Function.COS | Function.TAN):
            joint = min(joint_variables_in(expression), default=0)
            rank = Rank.JOINT_ANGLE if joint else Rank.CONSTANT_ANGLE
        case _:
            rank = Rank.LENGTH
    return (rank << PLACE_BITS) + joint


def rank_of(name: int) -> int:
    """Return the rank of a factor, from its number."""
    return name >> (PLACE_BITS + NAME_BITS)


def _shared_factors(a: Nested) -> tuple[int, ...]:
    """The factors that every term has, as often as every term has them."""
    shared = list(a[0][1])
    for _, factors in a[1:]:
        if not shared:
            break
        left = list(factors)
        kept = []
        for name in shared:
            if name in left:
                left.remove(name)
                kept.append(name)
        shared = kept
    return tuple(shared)


def _shared_weight(a: Nested) -> Rational:
    """The number that every term has up to sign; negative if all terms are."""
    first = a[0][0]
    size = max(first, -first)
    if any(abs(weight) != size for weight, _ in a):
        size = 1
    return size if any(weight > 0 for weight, _ in a) else -size


def leads_negative(a: Nested) -> bool:
    """Return whether a sum without parentheses within looks better with the opposite sign.

    So does -c4·c6 + s4·c5·s6.
    """
    if any(factors and rank_of(factors[-1]) == Rank.PARENTHESES for _, factors in a):
        return False
    excess = sum([1 if weight < 0 else -1 for weight, _ in a])
    return excess > 0 or (excess == 0 and min(a, key=_reading_order)[0] < 0)


def _reading_order(term: Term) -> tuple[list[int], tuple[int, ...]]:
    """The cosine of a twist does not decide what a sum begins with: c1·c2 - cos(alpha)·s1·s2."""
    factors = term[1]
    return [name for name in factors if rank_of(name) != Rank.CONSTANT_ANGLE], factors


def stripped(a: Nested) -> tuple[Rational, tuple[int, ...], Nested]:
    """Return what all terms share, a number and factors, and the sum that is left."""
    weight = _shared_weight(a)
    shared = _shared_factors(a)
    if weight != 1:
        a = tuple((quotient(w, weight), f) for w, f in a)
    if shared:
        a = tuple((w, _without(f, shared)) for w, f in a)
    return weight, shared, a


def _without(factors: tuple[int, ...], shared: tuple[int, ...]) -> tuple[int, ...]:
    left = list(factors)
    for name in shared:
        left.remove(name)
    return tuple(left)


def quotient(a: Rational, b: Rational) -> Rational:
    """Return the quotient a / b."""
    top, bottom = a.numerator * b.denominator, a.denominator * b.numerator
    return Fraction(top, bottom) if top % bottom else top // bottom


def plain(value: Rational) -> Rational:
    """Return a whole number as an int, whose arithmetic is faster."""
    return value.numerator if value.denominator == 1 else value
