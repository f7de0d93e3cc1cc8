"""Random expressions, and other ways to write them.

The rules are identities of a school book. Each is applied at a random place of the tree, so that equal
expressions look nothing alike after some rounds; a rule knows nothing of normal forms.
"""

import random
from collections.abc import Callable
from fractions import Fraction

from kinematics.expressions import (
    Call,
    Expression,
    Function,
    JointVariable,
    Number,
    Parameter,
    Power,
    Product,
    Sum,
    add,
    call,
    multiply,
    negate,
    number,
    pi_times,
    power,
)

PARAMETERS = ("L1", "L2", "alpha", "beta")
JOINTS = 3
_LENGTHS = tuple(map(Parameter, ("L1", "L2")))
_ANGLES: tuple[Expression, ...] = (
    *map(JointVariable, (1, 2, 3)),
    *map(Parameter, ("alpha", "beta")),
    *(pi_times(Fraction(k, 12)) for k in (1, 2, 3, 5, 7)),
    pi_times(Fraction(1, 5)),
    pi_times(Fraction(37, 180)),
    number("0.3"),
)

Rule = Callable[[Expression, random.Random], Expression | None]


def cos(angle: Expression) -> Expression:
    return call(Function.COS, angle)


def sin(angle: Expression) -> Expression:
    return call(Function.SIN, angle)


def root(value: int) -> Expression:
    return call(Function.SQRT, number(value))


def minus(a: Expression, b: Expression) -> Expression:
    return add((a, negate(b)))


def random_angle(rng: random.Random) -> Expression:
    """A sum or difference of one to three angles."""
    terms = rng.sample(_ANGLES, rng.randrange(1, 4))
    return add(multiply((number(rng.choice([1, 1, -1, 2])), term)) for term in terms)


def random_expression(rng: random.Random, depth: int = 3) -> Expression:
    """Sums of products of sines, cosines, lengths and numbers."""
    if depth == 0 or rng.random() < 0.15:
        choice = rng.randrange(5)
        if choice == 0:
            return rng.choice(_LENGTHS)
        if choice == 1:
            return number(Fraction(rng.randrange(-9, 10) or 1, rng.randrange(1, 5)))
        if choice == 2:
            return root(rng.choice([2, 3, 5, 6, 12, 37]))
        return rng.choice([cos, sin])(random_angle(rng))
    parts = [random_expression(rng, depth - 1) for _ in range(rng.randrange(2, 4))]
    return add(parts) if rng.random() < 0.5 else multiply(parts)


def _addition_theorem(node: Expression, rng: random.Random) -> Expression | None:
    match node:
        case Call(Function.COS, (Sum(terms),)):
            a, b = terms[0], add(terms[1:])
            return minus(multiply((cos(a), cos(b))), multiply((sin(a), sin(b))))
        case Call(Function.SIN, (Sum(terms),)):
            a, b = terms[0], add(terms[1:])
            return add((multiply((sin(a), cos(b))), multiply((cos(a), sin(b)))))
    return None


def _shift(node: Expression, rng: random.Random) -> Expression | None:
    quarter = pi_times(Fraction(1, 2))
    match node:
        case Call(Function.COS, (angle,)):
            return rng.choice(
                [
                    sin(add((angle, quarter))),
                    negate(cos(add((angle, pi_times(1))))),
                    cos(negate(angle)),
                    cos(add((angle, pi_times(2)))),
                    negate(sin(minus(angle, quarter))),
                ]
            )
        case Call(Function.SIN, (angle,)):
            return rng.choice(
                [
                    cos(minus(angle, quarter)),
                    negate(sin(negate(angle))),
                    negate(sin(add((angle, pi_times(-1))))),
                ]
            )
    return None


def _double_angle(node: Expression, rng: random.Random) -> Expression | None:
    match node:
        case Call(Function.SIN, (angle,)):
            half = multiply((number("1/2"), angle))
            return multiply((number(2), sin(half), cos(half)))
        case Call(Function.COS, (angle,)):
            half = multiply((number("1/2"), angle))
            return rng.choice(
                [
                    minus(number(1), multiply((number(2), power(sin(half), 2)))),
                    minus(power(cos(half), 2), power(sin(half), 2)),
                    minus(multiply((number(2), power(cos(half), 2))), number(1)),
                ]
            )
    return None


def _triple_angle(node: Expression, rng: random.Random) -> Expression | None:
    match node:
        case Call(Function.COS, (angle,)):
            third = cos(multiply((number("1/3"), angle)))
            return minus(multiply((number(4), power(third, 3))), multiply((number(3), third)))
    return None


def _product_to_sum(node: Expression, rng: random.Random) -> Expression | None:
    if not isinstance(node, Product):
        return None
    circular = [f for f in node.factors if isinstance(f, Call) and f.function in (Function.SIN, Function.COS)]
    if len(circular) < 2:
        return None
    f, g = rng.sample(circular, 2)
    rest = list(node.factors)
    rest.remove(f)
    rest.remove(g)
    if f.function is Function.COS:
        f, g = g, f
    a, b = f.arguments[0], g.arguments[0]
    if f.function is Function.SIN and g.function is Function.SIN:
        pair = minus(cos(minus(a, b)), cos(add((a, b))))
    elif f.function is Function.SIN:
        pair = add((sin(add((a, b))), sin(minus(a, b))))
    else:
        pair = add((cos(add((a, b))), cos(minus(a, b))))
    return multiply((number("1/2"), pair, *rest))


def _distribute(node: Expression, rng: random.Random) -> Expression | None:
    if not isinstance(node, Product):
        return None
    sums = [factor for factor in node.factors if isinstance(factor, Sum)]
    if not sums:
        return None
    chosen = rng.choice(sums)
    rest = list(node.factors)
    rest.remove(chosen)
    return add(multiply((term, *rest)) for term in chosen.terms)


def _commute(node: Expression, rng: random.Random) -> Expression | None:
    match node:
        case Sum(terms):
            return Sum(tuple(rng.sample(terms, len(terms))))
        case Product(factors) if not isinstance(factors[0], Number):
            return Product(tuple(rng.sample(factors, len(factors))))
    return None


def _one(node: Expression, rng: random.Random) -> Expression | None:
    angle = random_angle(rng)
    return multiply((node, add((power(sin(angle), 2), power(cos(angle), 2)))))


def _nothing(node: Expression, rng: random.Random) -> Expression | None:
    angle = random_angle(rng)
    zero = minus(sin(multiply((number(2), angle))), multiply((number(2), sin(angle), cos(angle))))
    return add((node, multiply((rng.choice(_LENGTHS), zero))))


def _surd(node: Expression, rng: random.Random) -> Expression | None:
    match node:
        case Call(Function.SQRT, (Number(value),)) if value == 12:
            return multiply((number(2), root(3)))
        case Call(Function.SQRT, (Number(value),)) if value == 6:
            return multiply((root(2), root(3)))
        case Call(Function.SQRT, (Number(value),)):
            return multiply((Number(value), power(node, -1)))
        case Number(value) if value.denominator == 1 and abs(value) < 10:
            fifth = multiply((number(4), cos(pi_times(Fraction(1, 5)))))
            return multiply((node, minus(fifth, root(5))))
    return None


def _root_of_a_twelfth(node: Expression, rng: random.Random) -> Expression | None:
    match node:
        case Call(Function.COS, (angle,)) if angle == pi_times(Fraction(1, 12)):
            return multiply((number("1/4"), add((root(6), root(2)))))
    return None


def _tangent(node: Expression, rng: random.Random) -> Expression | None:
    match node:
        case Call(Function.SIN, (angle,)) if not isinstance(angle, Number):
            return multiply((call(Function.TAN, angle), cos(angle)))
    return None


RULES: tuple[Rule, ...] = (
    _addition_theorem,
    _addition_theorem,
    _shift,
    _double_angle,
    _triple_angle,
    _product_to_sum,
    _product_to_sum,
    _distribute,
    _distribute,
    _commute,
    _one,
    _nothing,
    _surd,
    _surd,
    _root_of_a_twelfth,
    _tangent,
)


def rewritten(expression: Expression, rng: random.Random, rounds: int) -> Expression:
    """The same function, written otherwise.

    A tangent is a quotient; within the angle of a sine it is beyond what the canonical form decides.
    """
    for _ in range(rounds):
        expression = somewhere(expression, rng, rng.choice(RULES))
    return expression


def somewhere(expression: Expression, rng: random.Random, rule: Rule) -> Expression:
    """The expression with a rule applied at one of its nodes, if it applies anywhere it is tried."""
    for _ in range(8):
        path: list[tuple[Expression, int]] = []
        node = expression
        while rng.random() < 0.75:
            below = _children(node)
            if not below:
                break
            i = rng.randrange(len(below))
            path.append((node, i))
            node = below[i]
        within_angle = any(isinstance(parent, Call) for parent, _ in path)
        replaced = None if rule is _tangent and within_angle else rule(node, rng)
        if replaced is not None:
            for parent, i in reversed(path):
                replaced = _with_child(parent, i, replaced)
            return replaced
    return expression


def _children(node: Expression) -> tuple[Expression, ...]:
    match node:
        case Sum(parts) | Product(parts) | Call(_, parts):
            # the radicand of a root stays what it is: a changed one need not be positive
            return () if isinstance(node, Call) and node.function is Function.SQRT else parts
        case Power(base, _):
            return (base,)
    return ()


def _with_child(node: Expression, i: int, child: Expression) -> Expression:
    match node:
        case Sum(terms):
            return add((*terms[:i], child, *terms[i + 1 :]))
        case Product(factors):
            return multiply((*factors[:i], child, *factors[i + 1 :]))
        case Call(function, arguments):
            return call(function, *arguments[:i], child, *arguments[i + 1 :])
        case Power(_, exponent):
            return power(child, exponent)
    raise AssertionError(node)
