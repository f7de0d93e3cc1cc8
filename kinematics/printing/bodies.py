"""What a function computes, in the words of several languages."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

from kinematics.expressions import Call, JointVariable, Parameter, Pi, Power
from kinematics.printing.infix import InfixWriter, Spelling
from kinematics.printing.ledger import Ledger, Quotient
from kinematics.printing.program import Program
from kinematics.printing.writer import Binding, Written

_SPELLED = (Call, JointVariable, Pi, Power)


class Body(NamedTuple):
    """Named steps, and the entries."""

    steps: list[tuple[str, str]]
    entries: list[list[str]]


def write_bodies(ledger: Ledger, programs: Sequence[tuple[Program, Spelling]]) -> list[Body]:
    """One function in several languages; what all of them spell alike is written once."""
    first, spelling = programs[0]
    own = _spelled_differently(ledger, [program for program, _ in programs])
    shared = _CodeWriter(spelling, ledger, first)
    for number in first.plan.matrix.nodes:
        if number not in own:
            shared.enter(number)
        elif number in first.steps:
            shared.refer(number)
    bodies = []
    for program, spelling in programs:
        writer = _CodeWriter(spelling, ledger, program, shared)
        for number in own:
            writer.enter(number)
        bodies.append(writer.body())
    return bodies


class _CodeWriter(InfixWriter):
    """Writes in one language; a step is written as its name wherever it occurs."""

    def __init__(
        self, spelling: Spelling, ledger: Ledger, program: Program, shared: _CodeWriter | None = None
    ) -> None:
        super().__init__(spelling, ledger)
        self._program = program
        self._definitions: dict[int, str] = {}
        if shared is not None:
            self._written |= shared._written
            self._definitions |= shared._definitions

    def enter(self, number: int) -> None:
        """Write a node."""
        written = self._write(number)
        if number in self._program.steps:
            self._definitions[number] = self._signed(written)
            self.refer(number)
        else:
            self._written[number] = written

    def refer(self, number: int) -> None:
        """Let a step's name stand for it."""
        self._written[number] = Written(self._program.steps[number], Binding.ATOM)

    def body(self) -> Body:
        """All that was written."""
        steps = [(name, self._definitions[number]) for number, name in self._program.steps.items()]
        return Body(steps, self.lines(self._program.plan.matrix))

    def _parameter(self, name: str) -> str:
        return self._program.arguments[name]


def _spelled_differently(ledger: Ledger, programs: Sequence[Program]) -> list[int]:
    """The nodes of which languages may write different things, those below first."""
    first = programs[0]
    renamed = {
        name
        for name, word in first.arguments.items()
        if any(other.arguments[name] != word for other in programs)
    }
    found: dict[int, None] = {}
    referred: set[int] = set()
    for number in first.plan.matrix.nodes:
        quotient, node = ledger.quotients[number], ledger.nodes[number]
        if quotient is not None:
            parts = (*quotient.typed, *(base for base, _ in quotient.below))
            differs = _holds_whole_numbers(quotient)
        else:
            parts = ledger.below[number]
            differs = isinstance(node, _SPELLED) or (isinstance(node, Parameter) and node.name in renamed)
        if differs or not referred.isdisjoint(parts):
            found[number] = None
            name = first.steps.get(number)
            if name is None or any(other.steps[number] != name for other in programs):
                referred.add(number)
    return list(found)


def _holds_whole_numbers(quotient: Quotient) -> bool:
    """Whether 2, 1/3 or a power is to be written: C calls them 2.0, 1.0/3.0 and pow."""
    weight = quotient.weight
    if weight.divides or any(exponent != 1 for _, exponent in quotient.below):
        return True
    if weight.digits:
        return weight.decimal is None
    return not quotient.typed
