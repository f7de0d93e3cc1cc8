"""The nodes of the matrices of one table, each once.

Equal nodes have one number, and a node has a larger one than those below it. Whatever is written of a node is
kept under its number, so matrices that share their entries, as all matrices of one table do, are written in
the time that what is new in each of them takes.
"""

from collections.abc import Hashable, Iterable, Sequence
from fractions import Fraction
from functools import lru_cache
from itertools import chain, islice
from typing import NamedTuple

from kinematics.expressions import Call, Expression, Function, JointVariable, Number, Pi, Power, Product, Sum
from kinematics.printing.numbers import decimal_text, fraction_as_decimal
from kinematics.symbolic.size import bottom_up, children, operations_of


class Entered(NamedTuple):
    """A matrix in the ledger.

    Attributes:
        rows: the numbers of its entries.
        nodes: the numbers of all nodes, in the order in which they are needed.
    """

    rows: tuple[tuple[int, ...], ...]
    nodes: list[int]


class Weight(NamedTuple):
    """A rational number as it is written.

    Attributes:
        negative: whether it has a minus sign.
        digits: what stands above the line, nothing for 1.
        decimal: the same, if it is a decimal.
        denominator: what stands below the line, if there is one.
    """

    negative: bool
    digits: str
    decimal: str
    denominator: str


class Quotient(NamedTuple):
    """A product, sorted by what stands above and below the line; a number is one without factors.

    Attributes:
        weight: the rational number.
        constants: roots of numbers and π, which are typeset with that number: √3/2.
        above: the other factors.
        typed: both, in the order of the product.
        below: what is divided by, and to which positive power.
    """

    weight: Weight
    constants: tuple[int, ...] = ()
    above: tuple[int, ...] = ()
    typed: tuple[int, ...] = ()
    below: tuple[tuple[int, Fraction], ...] = ()


ONE = Weight(negative=False, digits="", decimal="", denominator="")


class Ledger:
    """The nodes in use.

    Attributes:
        nodes: the first node of each number.
        below: the numbers of the nodes directly below.
        quotients: of a product, a number, and a negative power what stands above and below the line.
        operations: how many operations there are in the whole tree, written out.
        moving: whether a joint variable occurs in it.
    """

    def __init__(self) -> None:
        self.nodes: list[Expression] = []
        self.below: list[tuple[int, ...]] = []
        self.quotients: list[Quotient | None] = []
        self.operations: list[int] = []
        self.moving: list[bool] = []
        self._numbers: dict[Hashable, int] = {}
        self._known: dict[int, int] = {}
        self._decimals: list[bool] = []
        self._fractions: list[bool] = []
        self._restyled: dict[int, int] = {}
        self._kept: list[Expression] = []

    def numbers(self, expressions: Iterable[Expression]) -> tuple[int, ...]:
        """Return the numbers of some expressions, which are entered if they are new."""
        roots = tuple(expressions)
        new = [root for root in roots if id(root) not in self._known]
        if new:
            self._kept += new  # an id is a node's only while the node lives
            for node in bottom_up(new, self._known):
                self._known[id(node)] = self._enter(node)
        return tuple([self._in_one_style(self._known[id(root)]) for root in roots])

    def matrix(self, matrix: Sequence[Sequence[Expression]]) -> Entered:
        """Return a matrix, which is entered if it is new."""
        numbers = iter(self.numbers(chain.from_iterable(matrix)))
        return self.entered(tuple([tuple(islice(numbers, len(row))) for row in matrix]))

    def entered(self, rows: tuple[tuple[int, ...], ...]) -> Entered:
        """Return a matrix of nodes that are in the ledger."""
        return Entered(rows, self.under(chain.from_iterable(rows)))

    def under(self, roots: Iterable[int]) -> list[int]:
        """Return the numbers of all nodes in some trees, in the order in which they are needed."""
        order: list[int] = []
        seen: set[int] = set()
        stack = [*roots]
        stack.reverse()
        while stack:
            number = stack.pop()
            if number < 0:
                order.append(~number)
            elif number not in seen:
                seen.add(number)
                below = self.below[number]
                if below:
                    stack.append(~number)
                    stack += below[::-1]
                else:
                    order.append(number)
        return order

    def _enter(self, node: Expression) -> int:
        below = tuple([self._known[id(child)] for child in children(node)])
        kind = type(node)
        key: Hashable = node
        if kind is Product or kind is Sum:
            key = (kind, below)
        elif isinstance(node, Call):
            key = (node.function, below)
        elif isinstance(node, Power):
            key = (node.exponent, below)
        number = self._numbers.get(key)
        if number is None:
            operations = operations_of(node, [self.operations[child] for child in below])
            moving = kind is JointVariable or any(map(self.moving.__getitem__, below))
            number = self._add(node, below, self._quotient(node, below), operations, moving)
            self._numbers[key] = number
        return number

    def _in_one_style(self, number: int) -> int:
        """The number under which a node is written: beside decimals, fractions that equal some are such."""
        if not (self._decimals[number] and self._fractions[number]):
            return number
        for one in self.under((number,)):
            if one in self._restyled or not self._fractions[one]:
                continue
            below = tuple([self._restyled.get(child, child) for child in self.below[one]])
            quotient = self._quotient(self.nodes[one], below)
            quotient = _beside_decimals(quotient) or quotient
            self._restyled[one] = self._add(
                self.nodes[one], below, quotient, self.operations[one], self.moving[one]
            )
        return self._restyled[number]

    def _add(
        self,
        node: Expression,
        below: tuple[int, ...],
        quotient: Quotient | None,
        operations: int,
        moving: bool,
    ) -> int:
        self.nodes.append(node)
        self.below.append(below)
        self.quotients.append(quotient)
        self.operations.append(operations)
        self.moving.append(moving)
        is_decimal = quotient is not None and bool(quotient.weight.decimal)
        self._decimals.append(is_decimal or any(map(self._decimals.__getitem__, below)))
        is_fraction = _beside_decimals(quotient) is not None
        self._fractions.append(is_fraction or any(map(self._fractions.__getitem__, below)))
        return len(self.nodes) - 1

    def _quotient(self, node: Expression, below: tuple[int, ...]) -> Quotient | None:
        if isinstance(node, Product):
            return self._sorted(node.factors, below)
        if isinstance(node, Number):
            return Quotient(_weight(node.value))
        if isinstance(node, Power) and node.exponent < 0:
            return Quotient(ONE, below=((below[0], -node.exponent),))
        return None

    def _sorted(self, factors: tuple[Expression, ...], numbers: tuple[int, ...]) -> Quotient:
        value: Fraction | None = None
        typed: list[int] = []
        constants: list[int] = []
        divisors: list[tuple[int, Fraction]] = []
        for number, factor in zip(numbers, factors, strict=True):
            if isinstance(factor, Number):
                value = factor.value if value is None else value * factor.value
                continue
            if isinstance(factor, Power) and factor.exponent < 0:
                divisors.append((self.below[number][0], -factor.exponent))
                continue
            typed.append(number)
            if _is_constant(factor):
                constants.append(number)
        above = [number for number in typed if number not in constants] if constants else typed
        weight = ONE if value is None else _weight(value)
        return Quotient(weight, tuple(constants), tuple(above), tuple(typed), tuple(divisors))


def _weight(value: Fraction) -> Weight:
    return _known_weight(value.numerator, value.denominator)


@lru_cache(maxsize=4096)
def _known_weight(numerator: int, denominator: int) -> Weight:
    negative, size = numerator < 0, Fraction(abs(numerator), denominator)
    decimal = decimal_text(size)
    if decimal is not None:
        return Weight(negative, decimal, decimal, "")
    digits = "" if size.numerator == 1 else str(size.numerator)
    return Weight(negative, digits, "", "" if denominator == 1 else str(denominator))


def _beside_decimals(quotient: Quotient | None) -> Quotient | None:
    """What is written beside decimals for a fraction, alone or before a product without roots; else None."""
    if quotient is None or quotient.constants or quotient.below or not quotient.weight.denominator:
        return None
    weight = quotient.weight
    decimal = fraction_as_decimal(Fraction(int(weight.digits or 1), int(weight.denominator)))
    if decimal is None:
        return None
    return quotient._replace(weight=Weight(weight.negative, decimal, decimal, ""))


def _is_constant(factor: Expression) -> bool:
    if isinstance(factor, Call):
        return factor.function is Function.SQRT and isinstance(factor.arguments[0], Number)
    return isinstance(factor, Pi)
