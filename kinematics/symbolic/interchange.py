"""Exact expressions as SymPy objects, and back.

The conversion is structural: every node of one tree becomes the corresponding node of the other, and no text
is parsed on the way. SymPy is imported when one of these functions is called, not before.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping, Sequence
from fractions import Fraction
from typing import TYPE_CHECKING

from kinematics.expressions import (
    PI,
    Call,
    Expression,
    Function,
    JointVariable,
    Number,
    Parameter,
    Pi,
    Power,
    Product,
    Sum,
    add,
    call,
    multiply,
    power,
)
from kinematics.symbolic.size import bottom_up, children

if TYPE_CHECKING:
    import sympy

_SYMPY_NAMES = {Function.ABS: "Abs"}  # Where SymPy's name of a function is not ours.

_VARIABLE = re.compile(r"q([1-9][0-9]*)", re.ASCII)


def to_sympy(
    expression: Expression | Sequence[Sequence[Expression]], *, evaluate: bool = True
) -> sympy.Expr | sympy.Matrix:
    """Return an expression, or a matrix of expressions, as a SymPy object.

    q1, q2, … and the parameters become plain symbols without assumptions, decimals become rational numbers.
    Sines and cosines of constants stay as written: cos(37π/180) is not replaced by radicals.

    Args:
        evaluate: whether SymPy puts sums and products into its own order, so that the result compares equal
            to what a SymPy user writes; without it the nesting and the order of terms stay as they are.

    Raises:
        ValueError: a parameter has the name of a joint variable (q1).
    """
    import sympy

    rows = expression if isinstance(expression, Sequence) else ((expression,),)
    nodes = SympyNodes(evaluate=evaluate)
    entries = [[nodes.convert(entry) for entry in row] for row in rows]
    if not isinstance(expression, Sequence):
        return entries[0][0]
    return sympy.Matrix(len(entries), len(entries[0]) if entries else 0, [e for row in entries for e in row])


class SympyNodes:
    """Converts nodes to SymPy, each once.

    Args:
        evaluate: see `to_sympy`.
        atoms: what is to stand for some nodes, instead of what they are made of.
    """

    def __init__(
        self, *, evaluate: bool = True, atoms: Callable[[Expression], sympy.Expr | None] = lambda _: None
    ) -> None:
        self._evaluate, self._atoms = evaluate, atoms
        self._known: dict[int, sympy.Expr] = {}
        self._kept: list[Expression] = []

    def convert(self, expression: Expression) -> sympy.Expr:
        """Return the SymPy object of an expression."""
        self._kept.append(expression)  # an id names a node only while the node lives
        for node in bottom_up((expression,), self._known):
            atom = self._atoms(node)
            self._known[id(node)] = self._converted(node) if atom is None else atom
        return self._known[id(expression)]

    def _converted(self, node: Expression) -> sympy.Expr:
        import sympy

        below = [self._known[id(child)] for child in children(node)]
        match node:
            case Number(value):
                return sympy.Rational(value.numerator, value.denominator)
            case Pi():
                return sympy.pi
            case Parameter(name):
                if _VARIABLE.fullmatch(name):
                    raise ValueError(f"the parameter {name} has the name of a joint variable")
                return sympy.Symbol(name)
            case JointVariable(index):
                return sympy.Symbol(f"q{index}")
            case Sum():
                return sympy.Add(*below, evaluate=self._evaluate)
            case Product():
                return sympy.Mul(*below, evaluate=self._evaluate)
            case Power(_, exponent):
                raised = sympy.Rational(exponent.numerator, exponent.denominator)
                return sympy.Pow(below[0], raised, evaluate=self._evaluate)
            case Call(Function.SQRT, _):
                return sympy.Pow(below[0], sympy.Rational(1, 2), evaluate=self._evaluate)
            case Call(function, _):
                sympy_function = getattr(sympy, _SYMPY_NAMES.get(function, function.value))
                evaluated = self._evaluate and not all(argument.is_number for argument in below)
                return sympy_function(*below, evaluate=evaluated)


def from_sympy(expression: sympy.Basic) -> Expression:
    """Return the expression of a SymPy object: the opposite of `to_sympy`.

    Args:
        expression: made of numbers, π, symbols, sums, products, powers with rational exponents, sin, cos,
            tan, asin, acos, atan, atan2 and Abs. The symbols q1, q2, … are joint variables, all others
            parameters. A floating-point number means the decimal that it prints as.

    Raises:
        ValueError: it holds anything else.
    """
    import sympy

    known: dict[sympy.Basic, Expression] = {}
    for node in sympy.postorder_traversal(expression):
        if node not in known:
            known[node] = _read(node, known)
    return known[expression]


def _read(node: sympy.Basic, known: Mapping[sympy.Basic, Expression]) -> Expression:
    import sympy

    below = [known[argument] for argument in node.args]
    match node:
        case sympy.Symbol():
            index = _VARIABLE.fullmatch(node.name)
            return JointVariable(int(index[1])) if index else Parameter(node.name)
        case sympy.Rational():
            return Number(Fraction(int(node.p), int(node.q)))
        case sympy.Float() if node.is_finite:
            return Number(Fraction(str(node)))
        case sympy.Add():
            # `add` would move the number of a sum to its end
            plain = not any(isinstance(term, Sum) for term in below) and len(set(below)) == len(below)
            return Sum(tuple(below)) if plain else add(below)
        case sympy.Mul():
            return multiply(below)
        case sympy.Pow() if isinstance(below[1], Number):
            if below[1].value == Fraction(1, 2):
                return call(Function.SQRT, below[0])
            return power(below[0], below[1].value)
    if node is sympy.pi:
        return PI
    for function in Function:
        name = _SYMPY_NAMES.get(function, function.value)
        if type(node).__name__ == name and function is not Function.SQRT:
            return call(function, *below)
    raise ValueError(f"{type(node).__name__} has no counterpart in a closed form")
