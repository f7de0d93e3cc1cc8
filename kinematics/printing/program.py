"""A matrix as a straight-line program: common subexpressions first, then the entries."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Collection, Sequence
from dataclasses import dataclass
from fractions import Fraction
from itertools import chain

from kinematics.expressions import Call, Function, JointVariable, Parameter, Pi, Power, Product, Sum
from kinematics.printing.ledger import Entered, Ledger
from kinematics.printing.notation import ShortName, short_name

_HALF = Fraction(1, 2)
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


def plan(ledger: Ledger, matrix: Entered) -> Plan:
    """Find what occurs more than once, and every sine and cosine of a joint."""
    rows, nodes = matrix
    uses = Counter(chain.from_iterable([ledger.below[number] for number in nodes]))
    uses.update(chain.from_iterable(rows))
    functions: set[Function] = set()
    parameters: set[str] = set()
    steps = []
    for number in nodes:
        node = ledger.nodes[number]
        if isinstance(node, Parameter):
            parameters.add(node.name)
        elif isinstance(node, Call):
            functions.add(node.function)
        elif isinstance(node, Power) and abs(node.exponent) == _HALF:
            functions.add(Function.SQRT)
        if _deserves_name(ledger, number, uses[number]):
            steps.append((number, short_name(node)))
    steps.sort(key=_place)
    return Plan(
        matrix=matrix,
        steps=dict(steps),
        functions=frozenset(functions),
        parameters=frozenset(parameters),
        holds_pi=any(isinstance(ledger.nodes[number], Pi) for number in nodes),
        moves=any(map(ledger.moving.__getitem__, chain.from_iterable(rows))),
    )


def program(
    plan: Plan, purpose: Purpose, *, n_joints: int, parameters: Sequence[str], reserved: Collection[str]
) -> Program:
    """Choose the names of a function in one language.

    Args:
        plan: what it computes.
        purpose: what it is called.
        n_joints: number of joint variables.
        parameters: the table's parameters in the order in which they are to be arguments.
        reserved: words that no identifier may be.
    """
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


def _deserves_name(ledger: Ledger, number: int, uses: int) -> bool:
    node = ledger.nodes[number]
    match node:
        case Product() if uses > 1:
            quotient = ledger.quotients[number]
            assert quotient is not None
            # a number times a name is not worth a name of its own
            return len(quotient.typed) + len(quotient.below) > 1
        case Sum(terms):
            # the sum of an angle only stands under a sine or cosine, where adding again costs nothing
            return uses > 1 and not any(isinstance(term, JointVariable) for term in terms)
        case Call(Function.SIN | Function.COS, _) if ledger.moving[number]:
            return True
        case Call():
            return uses > 1
        case Power(_, exponent):
            return uses > 1 and exponent > 0  # a negative power is written as a division
    return False


def _place(step: tuple[int, ShortName | None]) -> tuple[int, tuple[tuple[int, int], ...], str]:
    """Sines and cosines of joint variables first, in the order of the joints; then as they are needed."""
    short = step[1]
    return (0, short.joints, short.letter) if short else (1, (), "")
