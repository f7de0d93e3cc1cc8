"""Conditions as students write them: `sin(q3)`, `q3 = 0, π`, `q5 = k·π`, `a2*c2 = d4*s23`.

A cell holds one or several. Each becomes a function that vanishes just where it holds. An equation between
angles holds whatever full turns they differ by: lhs ≡ rhs means sin((lhs - rhs)/2) = 0, and with k·2π/N on
its right sin(N(lhs - rhs)/2) = 0.
"""

import re
from collections.abc import Collection, Iterator, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from itertools import islice
from math import gcd, lcm

from exercises.parts.cells.exactness import MOST_DECIMALS, has_letters, moved_decimals
from exercises.parts.cells.matrix_cells import Where, read_functions
from kinematics.cells import AngleUnit, Cell
from kinematics.cells.meaning import CellMeaning, Position
from kinematics.errors import Fault
from kinematics.expressions import (
    Call,
    Expression,
    Function,
    JointVariable,
    Number,
    Power,
    Product,
    Sum,
    add,
    call,
    joint_variables_in,
    multiply,
    negate,
    pi_fraction,
)
from kinematics.symbolic.angles import angle_of
from kinematics.table import JointType

MOST_TURNS = 24  # Solutions in one turn that k·2π/N may stand for; multiples of π/12 have closed forms.
_NO_EQUATION = re.compile(r"[<>≤≥≠]|!=")
MOST_CONDITIONS = 16  # In a cell: as many as rows of cells are read. Each takes milliseconds to be judged.
LONGEST = 2000  # Characters of a cell with conditions.
_INTEGERS = re.compile(r"\b[knm]\s*(?:∈|\bin\b)\s*(?:ℤ|\bZ\b|\bintegers?\b).*$")
_LETTER = re.compile(r"(?<![A-Za-z_])[knm](?=(?:pi|π)\b|π|[^A-Za-z_0-9(]|$)")
_ONE_OF = re.compile(r"(?:∈|\\in\b)\s*\\?\{((?:[^{}]|\{[^{}]*\})*?)\\?\}(?=\s*(?:[,;]|$))")
"""The values of a variable as a set: q2 ∈ {0, π}."""
_DASHES = " -–—−"
_OR = re.compile(r"(?<=\s)(o|ou|u|sau|або|чи)(?=\s)|\bor\b|∨|\\(?:lor|vee)\b|\n")
"""Between conditions, in the languages of the pages; a word may be a name, too."""
_PLUS_MINUS = re.compile(r"\\pm\b")


@dataclass(frozen=True, kw_only=True, slots=True)
class Condition(CellMeaning):
    """A function that vanishes just where a condition holds.

    Attributes:
        rounded: what it is with one of its decimals moved by what its rounding leaves open.
    """

    rounded: tuple[Expression, ...] = ()


@dataclass(frozen=True, kw_only=True, slots=True)
class _Equation:
    """Two sides as typed."""

    left: str
    right: str


def read_conditions(
    cell: Cell,
    joint_types: Sequence[JointType],
    angle_unit: AngleUnit,
    where: Where,
    names: Collection[str] = (),
) -> list[Condition | Fault]:
    """Return for each condition in a cell a function that vanishes just where it holds, or what is wrong.

    Several conditions have commas, semicolons or "or" between them; no word for "or" is one of the `names`.
    """
    text = str(cell)
    if len(text) > LONGEST:
        return [Fault.at("cell_too_long", *where, length=len(text), limit=LONGEST)]
    text = _PLUS_MINUS.sub("±", _without_integers(text))
    if _NO_EQUATION.search(text) or not text.strip(_DASHES):
        return [_no_condition(cell, where)]
    equations = list(islice(_equations(text.replace("==", "="), names), MOST_CONDITIONS + 1))
    if len(equations) > MOST_CONDITIONS:
        return [Fault.at("conditions_too_many", *where, limit=MOST_CONDITIONS)]
    sides = [side for equation in equations for side in (equation.left, equation.right)]
    if not sides or any(not side or "=" in side for side in sides):
        return [_no_condition(cell, where)]
    return [_condition(equation, joint_types, angle_unit, where) for equation in equations]


def _condition(
    equation: _Equation, joint_types: Sequence[JointType], angle_unit: AngleUnit, where: Where
) -> Condition | Fault:
    found = _function(equation, joint_types, angle_unit, where)
    if isinstance(found, Fault):
        return found
    near = [replace(equation, left=text) for text in moved_decimals(equation.left)]
    plain = not has_letters(equation.right)
    near += [replace(equation, right=text) for text in moved_decimals(equation.right, measured=plain)]
    if len(near) > MOST_DECIMALS:
        near = []
    read = [_function(other, joint_types, angle_unit, where) for other in near]
    rounded = tuple(other.expression for other in read if not isinstance(other, Fault))
    return Condition(expression=found.expression, kinds=found.kinds, rounded=rounded)


def _without_integers(text: str) -> str:
    """Leave out `(k ∈ ℤ)` and the like at the end, and the comma before it."""
    found = _INTEGERS.search(text)
    return (
        text if found is None else text[: found.start()].rstrip().removesuffix("(").rstrip().removesuffix(",")
    )


def _no_condition(cell: Cell, where: Where) -> Fault:
    return Fault.at("condition_not_equation", *where, text=str(cell).strip()[:80] or "–")


def _equations(text: str, names: Collection[str]) -> Iterator[_Equation]:
    left: str | None = None
    beside = _OR.sub(lambda found: found[0] if found[1] in names else ";", text)
    for piece in _pieces(_ONE_OF.sub(r"= \1", beside)):
        if "=" in piece:
            left, piece = (side.strip() for side in piece.split("=", 1))
        if left is None:
            yield _Equation(left=piece, right="0")
        elif piece.startswith(("±", "+-", "+/-")):
            value = piece.lstrip("±+/-").strip()
            yield _Equation(left=left, right=value)
            yield _Equation(left=left, right=f"-({value})")
        else:
            yield _Equation(left=left, right=piece)


def _pieces(text: str) -> Iterator[str]:
    """Yield what stands between commas and semicolons outside of parentheses."""
    depth, start = 0, 0
    for i, character in enumerate(f"{text};"):
        depth += (character in "({[") - (character in ")}]")
        if (character in ",;" and depth <= 0) or i == len(text):
            piece = text[start:i].strip()
            if piece:
                yield piece
            start = i + 1


def _function(
    equation: _Equation, joint_types: Sequence[JointType], angle_unit: AngleUnit, where: Where
) -> CellMeaning | Fault:
    def read(text: str, position: Position) -> CellMeaning | Fault:
        (found,) = read_functions((text,), joint_types, angle_unit, where, position)
        return replace(found, where=where) if isinstance(found, Fault) else found

    left = read(equation.left, Position.LENGTH)
    if isinstance(left, Fault):
        return left
    turning = {i for i, kind in enumerate(joint_types, 1) if kind is JointType.REVOLUTE}
    if not _outside(left.expression) & turning:
        right = read(equation.right, Position.LENGTH)
        if isinstance(right, Fault):
            return right
        if _outside(right.expression) & turning:
            return Fault.at("condition_angle_nonlinear", *where)
        difference = add((left.expression, negate(right.expression)))
        return CellMeaning(expression=difference, kinds={**left.kinds, **right.kinds})
    sides = [read(equation.left, Position.ANGLE)]
    sides += [read(_LETTER.sub(value, equation.right), Position.ANGLE) for value in ("(0)", "(1)")]
    known = [side for side in sides if not isinstance(side, Fault)]
    if len(known) < len(sides):
        return next(side for side in sides if isinstance(side, Fault))
    angle, first, second = (side.expression for side in known)
    period = pi_fraction(add((second, negate(first))))
    function = _angle_equation(add((angle, negate(first))), period, where)
    if isinstance(function, Fault):
        return function
    return CellMeaning(
        expression=function, kinds={name: kind for side in known for name, kind in side.kinds.items()}
    )


def _angle_equation(angle: Expression, period: Fraction | None, where: Where) -> Expression | Fault:
    """Return what vanishes where an angle is a multiple of a period, or of a full turn if that is 0."""
    weights = [weight for part, weight in angle_of(angle).parts if isinstance(part, JointVariable)]
    others = [part for part, _ in angle_of(angle).parts if not isinstance(part, JointVariable)]
    if not weights or any(joint_variables_in(part) for part in others):
        return Fault.at("condition_angle_nonlinear", *where)
    common = Fraction(
        gcd(*(weight.numerator for weight in weights)), lcm(*(weight.denominator for weight in weights))
    )
    if period is None:
        return Fault.at("condition_period", *where)
    turns = Fraction(2) * common / abs(period) if period else Fraction(1)
    if turns.denominator != 1 or turns > MOST_TURNS:
        return Fault.at("condition_period", *where)
    return call(Function.SIN, multiply((Number(turns / common / 2), angle)))


def _outside(expression: Expression) -> set[int]:
    """Return the joint variables that stand outside of all functions."""
    match expression:
        case JointVariable(index):
            return {index}
        case Sum(parts) | Product(parts):
            return set[int]().union(*map(_outside, parts))
        case Power(base, _):
            return _outside(base)
        case Call(Function.ABS | Function.SQRT, arguments):
            return set[int]().union(*map(_outside, arguments))
    return set()
