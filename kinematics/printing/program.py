"""A matrix as a straight-line program: common subexpressions first, then the entries."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Collection, Hashable, Sequence
from dataclasses import dataclass

from kinematics.expressions import (
    Call,
    Expression,
    Function,
    JointVariable,
    Number,
    Power,
    Product,
    Sum,
    joint_variables_in,
)
from kinematics.printing.notation import short_name
from kinematics.symbolic.size import bottom_up, children

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
    """What a function computes, before its names are chosen.

    Attributes:
        entries: the matrix.
        nodes: all nodes, children before parents.
        steps: what is computed first and given a name, in an order in which that is possible.
        step_of: which step a node is, by the node's id.
        functions: what is called.
    """

    entries: Sequence[Sequence[Expression]]
    nodes: Sequence[Expression]
    steps: tuple[Expression, ...]
    step_of: dict[int, int]
    functions: frozenset[Function]


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
    steps: tuple[str, ...]
    result: str

    def name(self, node: Expression) -> str | None:
        """The name of a node that has one."""
        step = self.plan.step_of.get(id(node))
        return None if step is None else self.steps[step]


def plan(matrix: Sequence[Sequence[Expression]]) -> Plan:
    """Find what occurs more than once, and every sine and cosine of a joint."""
    nodes = bottom_up(entry for row in matrix for entry in row)
    kinds = _interned(nodes)
    firsts = _firsts(nodes, kinds)
    uses = Counter(kinds[id(child)] for node in firsts for child in children(node))
    uses.update(kinds[id(entry)] for row in matrix for entry in row)
    steps = [node for node in firsts if _deserves_name(node, uses[kinds[id(node)]])]
    steps.sort(key=_place)
    order = {kinds[id(node)]: i for i, node in enumerate(steps)}
    functions = {node.function for node in nodes if isinstance(node, Call)}
    if any(isinstance(node, Power) and node.exponent.denominator == 2 for node in nodes):
        functions.add(Function.SQRT)
    return Plan(
        entries=matrix,
        nodes=nodes,
        steps=tuple(steps),
        step_of={id(node): order[kinds[id(node)]] for node in nodes if kinds[id(node)] in order},
        functions=frozenset(functions),
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
    identifiers = _Identifiers({*reserved, purpose.name, "q"})
    arguments = {name: identifiers.take(name) for name in parameters}
    steps = []
    for node in plan.steps:
        short = short_name(node)
        steps.append(identifiers.take(short.word) if short else identifiers.number("t"))
    return Program(
        plan=plan,
        purpose=purpose,
        n_joints=n_joints,
        arguments=arguments,
        steps=tuple(steps),
        result=identifiers.take(purpose.result),
    )


class _Identifiers:
    """Names that are not taken yet."""

    def __init__(self, taken: set[str]) -> None:
        self._taken = taken
        self._numbers: Counter[str] = Counter()

    def take(self, wanted: str) -> str:
        """The wanted name, with underscores appended until nothing else has it."""
        name = _FOREIGN.sub("_", wanted)
        if not name[:1].isalpha():
            name = f"p{name}"
        while name in self._taken:
            name += "_"
        self._taken.add(name)
        return name

    def number(self, letter: str) -> str:
        """The next of t1, t2 and so on."""
        self._numbers[letter] += 1
        return self.take(f"{letter}{self._numbers[letter]}")


def _interned(nodes: Sequence[Expression]) -> dict[int, int]:
    """For each node, by its id, the number of its kind: equal nodes have one number."""
    kinds: dict[int, int] = {}
    numbers: dict[Hashable, int] = {}
    for node in nodes:
        below = tuple(kinds[id(child)] for child in children(node))
        key: Hashable
        match node:
            case Sum() | Product():
                key = (type(node), below)
            case Power(_, exponent):
                key = (Power, exponent, below)
            case Call(function, _):
                key = (Call, function, below)
            case _:
                key = node
        kinds[id(node)] = numbers.setdefault(key, len(numbers))
    return kinds


def _firsts(nodes: Sequence[Expression], kinds: dict[int, int]) -> list[Expression]:
    """The first node of each kind."""
    first: dict[int, Expression] = {}
    for node in nodes:
        first.setdefault(kinds[id(node)], node)
    return list(first.values())


def _deserves_name(node: Expression, uses: int) -> bool:
    match node:
        case Call(Function.SIN | Function.COS, (angle,)) if joint_variables_in(angle):
            return True
        case Product((Number(), _)):
            return False
        case Sum(terms):
            return uses > 1 and not _is_angle(terms)
        case Power(_, exponent) if exponent < 0:
            return False  # it is written as a division
        case Product() | Power() | Call():
            return uses > 1
    return False


def _place(node: Expression) -> tuple[int, tuple[tuple[int, int], ...], str]:
    """Sines and cosines of joint variables first, in the order of the joints; then as they are needed."""
    short = short_name(node)
    return (0, short.joints, short.letter) if short else (1, (), "")


def _is_angle(terms: Sequence[Expression]) -> bool:
    """Whether a sum only stands under a sine or cosine, where adding joint variables again costs nothing."""
    return any(isinstance(term, JointVariable) for term in terms)
