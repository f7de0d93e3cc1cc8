"""A matrix as a straight-line program: common subexpressions first, then the entries."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Collection, Sequence
from dataclasses import dataclass
from itertools import chain, count

from kinematics.expressions import Function, Parameter, Pi
from kinematics.printing.ledger import Entered
from kinematics.printing.notation import ShortName
from kinematics.printing.traits import Head, Naming, Traits

_PLAIN = re.compile(r"[A-Za-z][A-Za-z0-9_]*")
_FOREIGN = re.compile(r"[^A-Za-z0-9_]")


@dataclass(frozen=True, kw_only=True, slots=True)
class Purpose:
    """What a function is called and what it returns, in words that stand in a comment.

    Attributes:
        name: the function's name, an identifier in every language.
        meaning: one sentence.
        result: the name of the matrix.
    """

    name: str
    meaning: str
    result: str = "T"


@dataclass(frozen=True, kw_only=True, slots=True)
class Plan:
    """What a function computes, before its names are chosen; nodes are numbers of a ledger.

    Attributes:
        matrix: the entries, and all nodes.
        steps: what is computed first and given a name, in an order in which that is possible, with the short
            name of what is a sine or cosine of joint variables.
        functions: what is called.
        parameters: names of the parameters that occur.
        moves: whether a joint variable occurs.
        holds_pi: whether π does.
    """

    matrix: Entered
    steps: dict[int, ShortName | None]
    functions: frozenset[Function]
    parameters: frozenset[str]
    moves: bool
    holds_pi: bool


@dataclass(frozen=True, kw_only=True, slots=True)
class Program:
    """A function to be written.

    Attributes:
        plan: what it computes.
        purpose: its name and meaning.
        n_joints: number of joint variables, its first argument.
        arguments: for each parameter its identifier, in the order of the arguments.
        steps: names of the common subexpressions.
        result: the identifier of the matrix.
    """

    plan: Plan
    purpose: Purpose
    n_joints: int
    arguments: dict[str, str]
    steps: dict[int, str]
    result: str


def plan(traits: Traits, matrix: Entered) -> Plan:
    """Find what occurs more than once, and every sine and cosine of a joint."""
    traits.entries(matrix)
    uses = Counter(chain.from_iterable([traits.ledger.below[number] for number in matrix.nodes]))
    uses.update(chain.from_iterable(matrix.rows))
    heads: set[Head] = set()
    steps = []
    for number in matrix.nodes:
        naming, short, _, head, *_ = traits.of(number)
        heads.add(head)
        if naming is Naming.ALWAYS or (naming is Naming.REPEATED and uses[number] > 1):
            steps.append((number, short))
    steps.sort(key=_place)
    moving = traits.ledger.moving
    return Plan(
        matrix=matrix,
        steps=dict(steps),
        functions=frozenset(head for head in heads if isinstance(head, Function)),
        parameters=frozenset(head.name for head in heads if isinstance(head, Parameter)),
        holds_pi=Pi() in heads,
        moves=any(moving[number] for row in matrix.rows for number in row),
    )


def named(
    plan: Plan,
    purpose: Purpose,
    *,
    n_joints: int,
    parameters: Sequence[str],
    reserved: Sequence[frozenset[str]],
) -> list[Program]:
    """Choose the names of a function, in languages that reserve some words; most often one choice suits all.

    Args:
        plan: what it computes.
        purpose: what it is called.
        n_joints: number of joint variables.
        parameters: the table's parameters in the order in which they are to be arguments.
        reserved: words that no identifier may be, for each language.
    """
    counter = count(1)
    words = [short.word if short else f"t{next(counter)}" for short in plan.steps.values()]
    wanted = [*parameters, *words, purpose.result]
    suits = len({*wanted, purpose.name, "q"}) == len(wanted) + 2 and all(map(_PLAIN.fullmatch, wanted))
    common = None
    if suits:
        common = Program(
            plan=plan,
            purpose=purpose,
            n_joints=n_joints,
            arguments=dict(zip(parameters, parameters, strict=True)),
            steps=dict(zip(plan.steps, words, strict=True)),
            result=purpose.result,
        )
    return [
        common if common and kept.isdisjoint(wanted) else _program(plan, purpose, n_joints, parameters, kept)
        for kept in reserved
    ]


def _program(
    plan: Plan, purpose: Purpose, n_joints: int, parameters: Sequence[str], reserved: Collection[str]
) -> Program:
    identifiers = _Identifiers(reserved, {purpose.name, "q"})
    arguments = {name: identifiers.take(name) for name in parameters}
    steps = {
        number: identifiers.take(short.word) if short else identifiers.number("t")
        for number, short in plan.steps.items()
    }
    result = identifiers.take(purpose.result)
    return Program(
        plan=plan, purpose=purpose, n_joints=n_joints, arguments=arguments, steps=steps, result=result
    )


class _Identifiers:
    """Names that are not taken yet."""

    def __init__(self, reserved: Collection[str], taken: set[str]) -> None:
        self._reserved = reserved
        self._taken = taken
        self._numbers: Counter[str] = Counter()

    def take(self, wanted: str) -> str:
        """The wanted name, with underscores appended until nothing else has it."""
        name = wanted if _PLAIN.fullmatch(wanted) else _FOREIGN.sub("_", wanted)
        if not name[:1].isalpha():
            name = f"p{name}"
        while name in self._taken or name in self._reserved:
            name += "_"
        self._taken.add(name)
        return name

    def number(self, letter: str) -> str:
        """The next of t1, t2 and so on."""
        self._numbers[letter] += 1
        return self.take(f"{letter}{self._numbers[letter]}")


def _place(step: tuple[int, ShortName | None]) -> tuple[int, tuple[tuple[int, int], ...], str]:
    """Sines and cosines of joint variables first, in the order of the joints; then as they are needed."""
    short = step[1]
    return (0, short.joints, short.letter) if short else (1, (), "")
