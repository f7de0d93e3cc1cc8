"""What a function computes, in the words of several languages."""

from __future__ import annotations

from collections.abc import Container, Mapping, Sequence
from typing import NamedTuple

from kinematics.expressions import Parameter
from kinematics.printing.infix import InfixWriter, Spelling
from kinematics.printing.program import Program
from kinematics.printing.traits import Traits
from kinematics.printing.writer import Binding, Written


class Body(NamedTuple):
    """Named steps, and the entries."""

    steps: list[tuple[str, str]]
    entries: list[list[str]]


class BodyWriter:
    """Writes what functions compute.

    What all languages spell alike is written once for each function, and what no function's names decide,
    such as cos(q[1] + q[2]), once for each language.
    """

    def __init__(self, traits: Traits, spellings: Mapping[str, Spelling]) -> None:
        self._traits = traits
        self._fixed = {
            language: InfixWriter(spelling, traits.ledger) for language, spelling in spellings.items()
        }

    def bodies(self, programs: Mapping[str, Program]) -> list[Body]:
        """One function in several languages."""
        traits, first = self._traits, next(iter(programs.values()))
        own = _spelled_differently(traits, list(programs.values()))
        shared = _CodeWriter(next(iter(self._fixed.values())), first)
        for number in first.plan.matrix.nodes:
            if number not in own:
                shared.enter(number)
            elif number in first.steps:
                shared.refer(number)
        fixed = [number for number in first.plan.matrix.nodes if traits.of(number).fixed]
        loose = [number for number in own if not traits.of(number).fixed]
        bodies = []
        for language, program in programs.items():
            writer = _CodeWriter(self._fixed[language], program, shared)
            writer.take(fixed, own)
            for number in loose:
                writer.enter(number)
            bodies.append(writer.body())
        return bodies


class _CodeWriter(InfixWriter):
    """Writes one function in one language; a step is written as its name wherever it occurs."""

    def __init__(self, fixed: InfixWriter, program: Program, shared: _CodeWriter | None = None) -> None:
        super().__init__(fixed.spelling, fixed.ledger)
        self._fixed = fixed
        self._program = program
        self._definitions: dict[int, str] = {}
        if shared is not None:
            self._written = shared._written.copy()
            self._definitions = shared._definitions.copy()
            if program is not shared._program:
                for number in program.steps:
                    self.refer(number)

    def take(self, numbers: Sequence[int], own: Container[int]) -> None:
        """Take what no name decides, where the language has its own spelling."""
        for number, written in self._fixed.known(numbers):
            if number in self._program.steps:
                self._definitions[number] = self._signed(written)
            elif number in own:
                self._written[number] = written

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


def _spelled_differently(traits: Traits, programs: Sequence[Program]) -> dict[int, None]:
    """The nodes of which languages may write different things, those below first."""
    first, others = programs[0], [program for program in programs if program is not programs[0]]
    renamed = {
        name
        for name, word in first.arguments.items()
        if any(other.arguments[name] != word for other in others)
    }
    found: dict[int, None] = {}
    referred: set[int] = set()
    for number in first.plan.matrix.nodes:
        trait = traits.of(number)
        if (
            trait.own
            or not referred.isdisjoint(trait.parts)
            or (isinstance(trait.head, Parameter) and trait.head.name in renamed)
        ):
            found[number] = None
            name = first.steps.get(number)
            if name is None or any(other.steps[number] != name for other in others):
                referred.add(number)
    return found
