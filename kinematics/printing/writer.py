"""What every way of writing expressions has in common."""

from abc import ABC, abstractmethod
from collections.abc import Mapping, Sequence
from enum import IntEnum
from fractions import Fraction
from typing import ClassVar, Generic, NamedTuple, TypeVar

from kinematics.expressions import Call, Expression, Function, JointVariable, Parameter, Pi, Power, Sum
from kinematics.printing.ledger import Entered, Ledger, Quotient
from kinematics.printing.notation import Names, ShortName

W = TypeVar("W")


class Writer(ABC, Generic[W]):
    """Writes the nodes of a ledger, each once.

    Args:
        names: how sines, cosines and joint variables are written.
        ledger: where the nodes are; one of its own if left out.
    """

    def __init__(self, names: Names, ledger: Ledger | None = None) -> None:
        self._names = names
        self.ledger = Ledger() if ledger is None else ledger
        self._written: dict[int, W] = {}

    def written(self, expression: Expression) -> W:
        """Return an expression, written."""
        return self.entries(self.ledger.matrix(((expression,),)))[0][0]

    def entries(self, matrix: Entered) -> list[list[W]]:
        """Return the entries of a matrix, written."""
        known = self._written
        for number in matrix.nodes:
            if number not in known:
                known[number] = self._write(number)
        return [[known[number] for number in row] for row in matrix.rows]

    def known(self, numbers: Sequence[int]) -> list[tuple[int, W]]:
        """Return some nodes, those below first, written; each with its number."""
        known = self._written
        for number in numbers:
            if number not in known:
                known[number] = self._write(number)
        return [(number, known[number]) for number in numbers]

    @abstractmethod
    def _write(self, number: int) -> W:
        """One node, those below being written."""


class Binding(IntEnum):
    """How strongly the outermost operation of something written binds."""

    SUM = 1
    PRODUCT = 2
    POWER = 3
    ATOM = 4


class WrittenTerm(NamedTuple):
    """An expression without its sign, how strongly it binds, and whether the sign is a minus."""

    body: str
    binding: Binding
    negative: bool = False


class LineWriter(Writer[WrittenTerm]):
    """Writes expressions as lines of signs and symbols.

    Attributes:
        plus: what stands between two terms.
        minus: what stands before a term that is subtracted.
        sign: what stands before a negative first term.
    """

    plus = "+"
    minus = "-"
    sign = "-"
    pi = "pi"

    def name(self, number: int, name: str) -> None:
        """Let a name stand for a node in what is written from now on."""
        self._written[number] = WrittenTerm(name, Binding.ATOM)

    def text(self, expression: Expression) -> str:
        """Return the expression with its sign."""
        return self._signed(self.written(expression))

    def lines(self, matrix: Entered) -> list[list[str]]:
        """Return the entries of a matrix with their signs."""
        return [list(map(self._signed, row)) for row in self.entries(matrix)]

    def _write(self, number: int) -> WrittenTerm:
        quotient = self.ledger.quotients[number]
        if quotient is not None:
            return self._quotient(quotient)
        below = self.ledger.below[number]
        match self.ledger.nodes[number]:
            case Sum():
                return self._sum([self._written[term] for term in below])
            case Call() as node:
                return self._call(node, [self._written[argument] for argument in below])
            case Parameter(name):
                return WrittenTerm(self._parameter(name), Binding.ATOM)
            case JointVariable(index):
                return WrittenTerm(self._parameter(self._names.variable(index)), Binding.ATOM)
            case Pi():
                return WrittenTerm(self.pi, Binding.ATOM)
            case Power(_, exponent):
                return self._raised(below[0], exponent)
        raise AssertionError(number)

    def _sum(self, terms: Sequence[WrittenTerm]) -> WrittenTerm:
        parts: list[str] = []
        for body, binding, negative in terms:
            if negative:
                parts.append(self.minus if parts else self.sign)
            elif parts:
                parts.append(self.plus)
            parts.append(body if binding > Binding.SUM else self._bracketed(body))
        return WrittenTerm(self._joined(parts), Binding.SUM)

    def _joined(self, parts: Sequence[str]) -> str:
        return "".join(parts)

    def _signed(self, written: WrittenTerm) -> str:
        return self.sign + written.body if written.negative else written.body

    def _within(self, written: WrittenTerm, binding: Binding) -> str:
        """What is written, with its sign, in parentheses unless it binds at least so strongly."""
        if written.negative or written.binding < binding:
            return self._bracketed(self._signed(written))
        return written.body

    def _bracketed(self, text: str) -> str:
        return f"({text})"

    @abstractmethod
    def _quotient(self, quotient: Quotient) -> WrittenTerm: ...

    @abstractmethod
    def _call(self, node: Call, arguments: Sequence[WrittenTerm]) -> WrittenTerm: ...

    @abstractmethod
    def _raised(self, base: int, exponent: Fraction) -> WrittenTerm:
        """A positive power."""

    @abstractmethod
    def _parameter(self, name: str) -> str: ...


class Typesetter(LineWriter):
    """Writes expressions in two dimensions: fractions with a line, roots, powers above.

    Numbers, fractions, roots, absolute values and powers are given by templates.
    """

    comma: ClassVar[str]
    digits: ClassVar[str]
    over: ClassVar[str]
    root: ClassVar[str]
    absolute: ClassVar[str]
    power: ClassVar[str]
    functions: ClassVar[Mapping[Function, str]]

    def _call(self, node: Call, arguments: Sequence[WrittenTerm]) -> WrittenTerm:
        short = self._names.short(node)
        if short is not None:
            return WrittenTerm(self._short(short), Binding.ATOM)
        inner = self.comma.join(map(self._signed, arguments))
        own = {Function.SQRT: self.root, Function.ABS: self.absolute}.get(node.function)
        return WrittenTerm(own.format(inner) if own else self._applied(node.function, inner), Binding.ATOM)

    def _quotient(self, quotient: Quotient) -> WrittenTerm:
        """A product with its numbers and roots in one fraction: (√3/2)·c1."""
        weight = quotient.weight
        constants = [self._written[factor] for factor in quotient.constants]
        above = [self._written[factor] for factor in quotient.above]
        below = [self._raised(base, exponent) for base, exponent in quotient.below]
        weakest = Binding.SUM if len(below) == 1 and not weight.denominator else Binding.PRODUCT
        denominator = [self.digits.format(weight.denominator)] if weight.denominator else []
        denominator += [self._within(factor, weakest) for factor in below]
        head = [self._decimal(weight.digits)] if weight.digits else []
        head += [self._within(factor, Binding.PRODUCT) for factor in constants]
        least = Binding.SUM if below and not head and len(above) == 1 else Binding.PRODUCT
        tail = [self._within(factor, least) for factor in above]
        if below:
            head, tail = head + tail, []
        if denominator:
            over = self.over.format(self._times(head or [self.digits.format("1")]), self._times(denominator))
            return WrittenTerm(self._times([over, *tail]), Binding.PRODUCT, weight.negative)
        factors = head + tail
        if len(factors) > 1:
            return WrittenTerm(self._times(factors), Binding.PRODUCT, weight.negative)
        alone = (*constants, *above)
        binding = alone[0].binding if alone else Binding.ATOM
        return WrittenTerm(factors[0] if factors else self.digits.format("1"), binding, weight.negative)

    def _decimal(self, text: str) -> str:
        """A number; a very small one has a power of ten."""
        number, *power = map(self.digits.format, text.split("e-"))
        if not power:
            return number
        exponent = self._signed(WrittenTerm(power[0], Binding.ATOM, negative=True))
        return self._times([number, self.power.format(self.digits.format("10"), exponent)])

    def _raised(self, base: int, exponent: Fraction) -> WrittenTerm:
        written = self._written[base]
        if exponent == 1:
            return written
        if exponent == Fraction(1, 2):
            return WrittenTerm(self.root.format(self._signed(written)), Binding.ATOM)
        power, node = self._exponent(exponent), self.ledger.nodes[base]
        if isinstance(node, Call) and node.function in self.functions and self._names.short(node) is None:
            name = self.functions[node.function]
            raised = written.body.replace(name, self.power.format(name, power), 1)
        else:
            raised = self.power.format(self._within(written, Binding.ATOM), power)
        return WrittenTerm(raised, Binding.POWER)

    @abstractmethod
    def _short(self, short: ShortName) -> str: ...

    @abstractmethod
    def _applied(self, function: Function, inner: str) -> str: ...

    @abstractmethod
    def _exponent(self, exponent: Fraction) -> str: ...

    @abstractmethod
    def _times(self, factors: Sequence[str]) -> str: ...
