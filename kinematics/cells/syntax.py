"""The syntax tree of a cell, before units and variables are known.

Every node knows the column at which it begins (1-based, in characters of the cell as typed) and how deeply
it is nested. The tree says what was written; what it means depends on where it stands (`meaning`).
"""

from collections.abc import Iterator
from dataclasses import dataclass
from fractions import Fraction

from kinematics.expressions import Function


@dataclass(frozen=True, kw_only=True, slots=True)
class Node:
    """A part of a cell.

    Attributes:
        column: where it begins, counted from 1.
        depth: how many parentheses, functions, powers and signs are nested in it.
    """

    column: int
    depth: int = 0


@dataclass(frozen=True, kw_only=True, slots=True)
class Literal(Node):
    """A number as typed."""

    value: Fraction


@dataclass(frozen=True, kw_only=True, slots=True)
class Name(Node):
    """A parameter or a joint variable, spelled canonically: L_1, L_{1} and L₁ are L1, θ1 is theta1."""

    name: str


@dataclass(frozen=True, kw_only=True, slots=True)
class HalfTurn(Node):
    """The symbol π."""


@dataclass(frozen=True, kw_only=True, slots=True)
class UnaryNode(Node):
    """What is done to one value."""

    operand: Node


@dataclass(frozen=True, kw_only=True, slots=True)
class Degrees(UnaryNode):
    """A value marked with the degree sign."""


@dataclass(frozen=True, kw_only=True, slots=True)
class Parenthesized(UnaryNode):
    """A value in parentheses."""


@dataclass(frozen=True, kw_only=True, slots=True)
class Negation(UnaryNode):
    """A value with a minus sign before it."""


@dataclass(frozen=True, kw_only=True, slots=True)
class Addition(Node):
    """Terms added; a subtracted term is a negation."""

    terms: tuple[Node, ...]


@dataclass(frozen=True, kw_only=True, slots=True)
class Multiplication(Node):
    """Factors multiplied; a divisor is a reciprocal."""

    factors: tuple[Node, ...]


@dataclass(frozen=True, kw_only=True, slots=True)
class Reciprocal(UnaryNode):
    """One over a value."""


@dataclass(frozen=True, kw_only=True, slots=True)
class Raised(UnaryNode):
    """A power."""

    exponent: Node


@dataclass(frozen=True, kw_only=True, slots=True)
class Application(Node):
    """A function of its arguments."""

    function: Function
    arguments: tuple[Node, ...]


def children(node: Node) -> tuple[Node, ...]:
    """Return the parts of a node, from left to right."""
    match node:
        case Addition(terms=parts) | Multiplication(factors=parts) | Application(arguments=parts):
            return parts
        case Raised(operand=base, exponent=exponent):
            return (base, exponent)
        case UnaryNode(operand=part):
            return (part,)
    return ()


def names_in(node: Node) -> Iterator[Name]:
    """Yield every name in a tree, from left to right."""
    stack = [node]
    while stack:
        top = stack.pop()
        if isinstance(top, Name):
            yield top
        stack.extend(reversed(children(top)))
