"""Functions as quotients: a numerator over a product, tangents taken apart.

Where both sides exist, N/D and N'/D' are one function just if N D' and N' D are.
"""

import math
from fractions import Fraction
from itertools import chain as in_turn

from kinematics.expressions import Call, Expression, Function, Power, Product, Sum, add, call, multiply, power


def cleared(expression: Expression) -> Expression:
    """Return the numerator of an expression; tangents are sine over cosine."""
    return quotient_of(expression)[0]


def reduced(expression: Expression) -> tuple[Expression, tuple[Expression, ...]]:
    """Return an expression without the factors that stand above and below, and its denominator's factors.

    cos x · tan x is sin x.
    """
    top, bottom = quotient_of(expression)
    if not bottom:
        return expression, ()
    factors: list[Expression] = list(top.factors) if isinstance(top, Product) else [top]
    left = list(bottom)
    for i, factor in enumerate(factors):
        base, exponent = (
            (factor.base, factor.exponent) if isinstance(factor, Power) else (factor, Fraction(1))
        )
        times = min(left.count(base), math.floor(exponent))
        if times > 0:
            factors[i] = power(base, exponent - times)
            for _ in range(times):
                left.remove(base)
    if len(left) == len(bottom):
        return expression, bottom
    return multiply((*factors, *(power(each, Fraction(-1)) for each in left))), tuple(left)


def quotient_of(expression: Expression) -> tuple[Expression, tuple[Expression, ...]]:
    """Return a numerator and the factors of a denominator; without one, the expression itself."""
    match expression:
        case Call(Function.TAN, (angle,)):
            return call(Function.SIN, angle), (call(Function.COS, angle),)
        case Power(base, exponent) if exponent < 0 and exponent.denominator == 1:
            top, bottom = quotient_of(base)
            over = (top,) * -exponent.numerator
            return multiply(bottom * -exponent.numerator), over
        case Power(base, exponent) if exponent.denominator == 1:
            top, bottom = quotient_of(base)
            if top is base:
                return expression, ()
            return power(top, exponent), bottom * exponent.numerator
        case Product(factors):
            parts = [quotient_of(factor) for factor in factors]
            if all(top is factor for (top, _), factor in zip(parts, factors, strict=True)):
                return expression, ()
            return multiply(top for top, _ in parts), tuple(in_turn.from_iterable(b for _, b in parts))
        case Sum(terms):
            parts = [quotient_of(term) for term in terms]
            if all(top is term for (top, _), term in zip(parts, terms, strict=True)):
                return expression, ()
            common = tuple(dict.fromkeys(in_turn.from_iterable(bottom for _, bottom in parts)))
            counts = {each: max(bottom.count(each) for _, bottom in parts) for each in common}
            rows = [
                multiply((top, *(power(each, counts[each] - bottom.count(each)) for each in common)))
                for top, bottom in parts
            ]
            return add(rows), tuple(each for each in common for _ in range(counts[each]))
    return expression, ()
