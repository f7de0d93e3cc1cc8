"""How large an expression is, and its nodes in an order in which they can be worked through."""

from collections.abc import Container, Iterable, Sequence

from kinematics.errors import Fault, FormSizeError
from kinematics.expressions import Call, Expression, Number, Power, Product, Sum


def bottom_up(expressions: Iterable[Expression], known: Container[int] = frozenset()) -> list[Expression]:
    """Return every node, each object once, children before parents; however deep the trees are.

    Args:
        known: ids of nodes that are left out, with all that is below them.
    """
    order: list[Expression] = []
    seen: set[int] = set()
    stack: list[Expression | None] = [*expressions]
    stack.reverse()
    while stack:
        node = stack.pop()
        if node is None:
            ready = stack.pop()
            assert ready is not None
            order.append(ready)
            continue
        name = id(node)
        if name in seen or name in known:
            continue
        seen.add(name)
        below = children(node)
        if below:
            stack += (node, None)
            stack += below[::-1]
        else:
            order.append(node)
    return order


def children(node: Expression) -> tuple[Expression, ...]:
    """Return the nodes directly below a node."""
    match node:
        case Product():
            return node.factors
        case Sum():
            return node.terms
        case Call():
            return node.arguments
        case Power():
            return (node.base,)
    return ()


def count_operations(expressions: Iterable[Expression]) -> int:
    """Count additions, subtractions, signs, multiplications, divisions, powers and calls, as written.

    Counted as SymPy's `count_ops` does, but for roots, which count 1. What occurs several times counts each
    time but is visited once, so the count is cheap however large the written form would be.
    """
    roots = tuple(expressions)
    known: dict[int, int] = {}
    for node in bottom_up(roots):
        known[id(node)] = operations_of(node, [known[id(child)] for child in children(node)])
    return sum(known[id(root)] for root in roots)


def refuse_longer_than(limit: int, expressions: Iterable[Expression]) -> None:
    """Refuse expressions with more operations, written out: node by node they take as long to evaluate.

    Raises:
        FormSizeError: they have.
    """
    if count_operations(expressions) > limit:
        raise FormSizeError(Fault.at("form_too_large", limit=limit))


def operations_of(node: Expression, below: Sequence[int]) -> int:
    """Return the count for one node, given those for the nodes directly below it."""
    match node:
        case Product(factors):
            written = len(factors)
            if isinstance(factors[0], Number):
                written -= abs(factors[0].value.numerator) == 1
            return sum(below) + written - 1
        case Sum(terms):
            negative = sum(map(is_negative, terms))
            return sum(below) - negative + len(terms) - 1 + (negative == len(terms))
        case Call():
            return 1 + sum(below)
        case Number(value):
            return (value < 0) + (value.denominator != 1)
        case Power(_, exponent):
            return below[0] + (exponent != -1) + (exponent < 0)
    return 0


def is_negative(term: Expression) -> bool:
    """Return whether a term is written with a minus sign."""
    if isinstance(term, Product):
        term = term.factors[0]
    return isinstance(term, Number) and term.value < 0
