"""Recording a computation: symbols that remember what was done to them.

The recurrences of `kinematics.evaluation.recurrences` know only + − ×. Run on symbols they leave behind a
tape: the list of the operations that are really needed for one table. Products with 0 and ±1 have vanished,
signs have moved into sums and differences, nothing is computed twice, and nothing that no result needs is
computed at all.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from enum import StrEnum
from typing import NamedTuple


class Operator(StrEnum):
    """What an operation does with its two operands."""

    ADD = "add"
    SUBTRACT = "subtract"
    MULTIPLY = "multiply"


class Operation(NamedTuple):
    """One operation of a tape; its result goes to the register that follows all earlier ones.

    An operand is the number of a register if it is not negative, and ~k for the tape's constant k.
    """

    operator: Operator
    left: int
    right: int


@dataclass(frozen=True, kw_only=True, slots=True)
class Tape:
    """A straight-line computation.

    Registers 0 … n_inputs-1 hold the inputs; operation k writes register n_inputs + k.

    Attributes:
        n_inputs: number of inputs.
        operations: in the order in which they are done.
        constants: what they use beside registers.
        outputs: operand of each result.
    """

    n_inputs: int
    operations: tuple[Operation, ...]
    constants: tuple[float, ...]
    outputs: tuple[int, ...]


class RecordedNumber:
    """± the content of a register of a recorder."""

    __slots__ = ("_recorder", "register", "sign")

    def __init__(self, recorder: Recorder, register: int, sign: int = 1) -> None:
        self._recorder, self.register, self.sign = recorder, register, sign

    def __neg__(self) -> RecordedNumber:
        return RecordedNumber(self._recorder, self.register, -self.sign)

    def __add__(self, other: RecordedNumber | float) -> RecordedNumber | float:
        return self._recorder.add(self, other)

    def __sub__(self, other: RecordedNumber | float) -> RecordedNumber | float:
        return self._recorder.add(self, -other)

    def __mul__(self, other: RecordedNumber | float) -> RecordedNumber | float:
        return self._recorder.multiply(self, other)

    def __rsub__(self, other: float) -> RecordedNumber | float:
        return self._recorder.add(-self, other)

    __radd__ = __add__
    __rmul__ = __mul__


class Recorder:
    """Records what is done to its symbols."""

    def __init__(self, n_inputs: int) -> None:
        self.inputs = [RecordedNumber(self, register) for register in range(n_inputs)]
        self._operations: list[Operation] = []
        self._known: dict[Operation, int] = {}
        self._constants: dict[float, int] = {}

    def add(self, left: RecordedNumber, right: RecordedNumber | float) -> RecordedNumber | float:
        """Return the sum; −a − b is recorded as −(a + b), and a − b and b − a as one operation."""
        if not isinstance(right, RecordedNumber):
            if right == 0.0:
                return left
            if left.sign > 0:
                return self._do(Operator.ADD, left.register, self._constant(right))
            return -self._do(Operator.SUBTRACT, left.register, self._constant(right))
        a, b = left.register, right.register
        if a == b:
            return left * 2.0 if left.sign == right.sign else 0.0
        if left.sign == right.sign:
            total = self._do(Operator.ADD, min(a, b), max(a, b))
            return total if left.sign > 0 else -total
        plus, minus = (a, b) if left.sign > 0 else (b, a)
        opposite = self._known.get(Operation(Operator.SUBTRACT, minus, plus))
        return RecordedNumber(self, opposite, -1) if opposite else self._do(Operator.SUBTRACT, plus, minus)

    def multiply(self, left: RecordedNumber, right: RecordedNumber | float) -> RecordedNumber | float:
        """Return the product; the sign stays outside."""
        if isinstance(right, RecordedNumber):
            a, b = left.register, right.register
            product = self._do(Operator.MULTIPLY, min(a, b), max(a, b))
            return product if left.sign == right.sign else -product
        if right == 0.0:
            return 0.0
        scaled = (
            RecordedNumber(self, left.register)
            if abs(right) == 1.0
            else self._do(Operator.MULTIPLY, left.register, self._constant(abs(right)))
        )
        return scaled if (right > 0.0) == (left.sign > 0) else -scaled

    def tape(self, results: Sequence[RecordedNumber | float]) -> Tape:
        """Return the tape that computes the results, without what none of them needs.

        A negated register is handed out as 0 − register, a negated difference a − b as b − a.
        """
        outputs = [self._output(result) for result in results]
        n_inputs = len(self.inputs)
        needed = set(outputs)
        for k in reversed(range(len(self._operations))):
            if n_inputs + k in needed:
                needed.update(self._operations[k][1:])
        places = {operand: operand for operand in range(-len(self._constants), n_inputs)}
        kept: list[Operation] = []
        for k, (operator, left, right) in enumerate(self._operations):
            if n_inputs + k in needed:
                places[n_inputs + k] = n_inputs + len(kept)
                kept.append(Operation(operator, places[left], places[right]))
        return Tape(
            n_inputs=n_inputs,
            operations=tuple(kept),
            constants=tuple(self._constants),
            outputs=tuple(places[x] for x in outputs),
        )

    def _output(self, result: RecordedNumber | float) -> int:
        if not isinstance(result, RecordedNumber):
            return self._constant(result)
        if result.sign > 0:
            return result.register
        made_by = result.register - len(self.inputs)
        operation = self._operations[made_by] if made_by >= 0 else None
        if operation is not None and operation.operator is Operator.SUBTRACT:
            return self._do(Operator.SUBTRACT, operation.right, operation.left).register
        return self._do(Operator.SUBTRACT, self._constant(0.0), result.register).register

    def _constant(self, value: float) -> int:
        return ~self._constants.setdefault(value + 0.0, len(self._constants))

    def _do(self, operator: Operator, left: int, right: int) -> RecordedNumber:
        operation = Operation(operator, left, right)
        register = self._known.get(operation)
        if register is None:
            register = len(self.inputs) + len(self._operations)
            self._operations.append(operation)
            self._known[operation] = register
        return RecordedNumber(self, register)
