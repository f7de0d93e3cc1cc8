"""Exact expressions as text that a table's cell would accept."""

from fractions import Fraction
from functools import lru_cache

from kinematics.cells import AngleUnit
from kinematics.expressions import Expression, Number, Pi, Power, Sum, add, multiply, number, pi_fraction
from kinematics.printing.notation import Names
from kinematics.printing.text import TextWriter


@lru_cache(maxsize=4096)
def expression_text(expression: Expression) -> str:
    """Return the expression as infix text."""
    return TextWriter(Names()).text(expression)


@lru_cache(maxsize=4096)
def angle_text(angle: Expression, unit: AngleUnit) -> str:
    """Return an angle as written in a cell of a table with that angle unit."""
    if unit is AngleUnit.RAD:
        return expression_text(angle)
    terms = angle.terms if isinstance(angle, Sum) else (angle,)
    return expression_text(add(_in_degrees(term) for term in terms))


def _in_degrees(term: Expression) -> Expression:
    turns = pi_fraction(term)
    if turns is not None:
        return Number(turns * 180)
    if isinstance(term, Number):
        return multiply((number(180), term, Power(Pi(), Fraction(-1))))
    return term
