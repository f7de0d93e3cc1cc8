"""Joint variables in cells: which name is one, and how it may enter.

In a revolute row θ_i = ±q_i + offset, in a prismatic row d_i = ±q_i + offset. Anything else is not a DH
table: were a variable scaled, squared or shared, the row would no longer be one motion of one joint.
"""

import re
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from fractions import Fraction

from kinematics.cells.refusals import CellRefusal
from kinematics.cells.syntax import (
    Addition,
    Application,
    Degrees,
    Literal,
    Multiplication,
    Name,
    Negation,
    Node,
    Parenthesized,
    Raised,
    Reciprocal,
    children,
    names_in,
)

_VARIABLE = re.compile(r"(?:q|Q|theta|Theta)_?([0-9]{1,4})")
_NUMBERLESS = re.compile(r"(q|Q|theta|Theta)(?:_[ijkn])?")
_MISSPELLED = re.compile(
    r"(?:th|(?-i:THETA)|tet|teta|tetha|thet|tita|t|vartheta)_?([0-9]{1,4})|var|variable|variavel|variabila|zminna",
    re.IGNORECASE,
)
"""Abbreviations, and the word variable itself in the languages of the pages."""

IsVariable = Callable[[str], bool]


def variable_index(name: str) -> int | None:
    """Return the k of q_k or θ_k, given its canonical name; None if the name is not a joint variable's."""
    match = _VARIABLE.fullmatch(name)
    return int(match.group(1)) if match else None


def misspelled_index(name: str) -> int | None:
    """Return the k of th_k, t_k and other names that are none of a joint variable and mean it; else None."""
    match = _MISSPELLED.fullmatch(name)
    return int(match.group(1)) if match and match.group(1) else None


def refuse_numberless(node: Node) -> None:
    """Refuse q, θ, q_i and θ_i: a variable has the number of its joint.

    Raises:
        CellRefusal: such a name stands in the cell.
    """
    for name in names_in(node):
        match = _NUMBERLESS.fullmatch(name.name)
        if match:
            raise CellRefusal(
                "variable_without_number", column=name.column, name=name.name, suggestion=f"{match.group(1)}1"
            )


def refuse_misspelled(node: Node) -> None:
    """Refuse th1, t1 and var where a joint angle stands: they mean its variable and are not its name.

    Raises:
        CellRefusal: such a name stands in the cell, with the name that is meant, as far as it is known.
    """
    for name in names_in(node):
        match = _MISSPELLED.fullmatch(name.name)
        if match:
            suggestion = f"q{match.group(1) or ''}"
            raise CellRefusal(
                "variable_misspelled", column=name.column, name=name.name, suggestion=suggestion
            )


@dataclass(frozen=True, kw_only=True, slots=True)
class Use:
    """How a joint variable enters a cell.

    Attributes:
        name: the variable, as it stands in the cell.
        weight: the number that it is multiplied by.
        fault: code of what is wrong with the way in which it enters, or None.
    """

    name: Name
    weight: Fraction
    fault: str | None


def uses(node: Node, is_variable: IsVariable) -> Iterator[Use]:
    """Yield every occurrence of a joint variable in a cell, from left to right."""
    yield from _uses(node, is_variable, Fraction(1), None)


def _uses(node: Node, is_variable: IsVariable, weight: Fraction, fault: str | None) -> Iterator[Use]:
    match node:
        case Name(name=name):
            if is_variable(name):
                scaled = "variable_scaled" if abs(weight) != 1 else None
                yield Use(name=node, weight=weight, fault=fault or scaled)
        case Negation(operand=operand):
            yield from _uses(operand, is_variable, -weight, fault)
        case Multiplication(factors=factors):
            for i, factor in enumerate(factors):
                others = _constant((*factors[:i], *factors[i + 1 :]))
                inner = fault or (None if others is not None else "variable_in_product")
                yield from _uses(factor, is_variable, weight * (1 if others is None else others), inner)
        case Addition() | Parenthesized():
            for part in children(node):
                yield from _uses(part, is_variable, weight, fault)
        case _:
            for part in children(node):
                yield from _uses(part, is_variable, weight, fault or _CODES.get(type(node)))


_CODES: dict[type[Node], str] = {
    Reciprocal: "variable_in_denominator",
    Raised: "variable_in_power",
    Application: "variable_in_function",
    Degrees: "degree_of_angle",
}


def _constant(factors: tuple[Node, ...]) -> Fraction | None:
    """The product of the factors if all of them are rational numbers."""
    product = Fraction(1)
    for factor in factors:
        value = _rational(factor)
        if value is None:
            return None
        product *= value
    return product


def _rational(node: Node) -> Fraction | None:
    match node:
        case Literal(value=value):
            return value
        case Parenthesized(operand=operand):
            return _rational(operand)
        case Negation(operand=operand):
            negated = _rational(operand)
            return None if negated is None else -negated
        case Reciprocal(operand=operand):
            divisor = _rational(operand)
            return 1 / divisor if divisor else None
        case Multiplication(factors=factors):
            return _constant(factors)
    return None
