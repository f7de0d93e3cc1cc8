"""Functions in programming languages: SymPy finds what is repeated, and prints it."""

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import count
from typing import TYPE_CHECKING, NamedTuple

from kinematics.expressions import (
    Call,
    Expression,
    Function,
    JointVariable,
    Number,
    Parameter,
    Pi,
    joint_variables_in,
)
from kinematics.printing.notation import short_name
from kinematics.printing.numbers import decimal_text
from kinematics.symbolic.interchange import SympyNodes
from kinematics.symbolic.size import bottom_up

if TYPE_CHECKING:
    import sympy


@dataclass(frozen=True, kw_only=True, slots=True)
class Purpose:
    """What a function is called and what it returns, in words that stand in a comment."""

    name: str
    meaning: str
    result: str = "T"


class ProgramStep(NamedTuple):
    """Something that is computed before the entries.

    Attributes:
        symbol: what stands for it in later steps and in the entries.
        word: the name that it would like to have: c23, or nothing.
        value: what it is.
    """

    symbol: str
    word: str
    value: "sympy.Expr"


@dataclass(frozen=True, kw_only=True, slots=True)
class Program:
    """What a function computes, before a language gives names to it.

    Attributes:
        purpose: its name and meaning.
        n_joints: number of joint variables, its first argument.
        parameters: its other arguments.
        variables: names of the joint variables.
        atoms: what the symbols in the expressions stand for, by their names.
        steps: sines and cosines of joint variables, then what occurs more than once, in an order in which
            they can be computed.
    """

    purpose: Purpose
    n_joints: int
    parameters: tuple[str, ...]
    variables: tuple[str, ...]
    atoms: dict[str, Expression]
    steps: list[ProgramStep]
    entries: "list[list[sympy.Expr]]"


def program(
    matrix: Sequence[Sequence[Expression]],
    purpose: Purpose,
    *,
    n_joints: int,
    parameters: tuple[str, ...],
    variables: tuple[str, ...],
    stepwise: bool = True,
) -> Program:
    """Plan a function.

    If it is not `stepwise`, the entries stay as they are read; else what is repeated is computed once.
    """
    import sympy
    from sympy.simplify.cse_main import tree_cse

    atoms = SourceAtoms(stepwise=stepwise)
    nodes = SympyNodes(atoms=atoms.symbol, evaluate=stepwise)
    entries = [[nodes.convert(entry) for entry in row] for row in matrix]
    steps: list[ProgramStep] = []
    if stepwise:
        names = map("t:{}".format, count(1))
        flat = [entry for row in entries for entry in row]
        repeated, reduced = tree_cse(flat, map(sympy.Symbol, names), order="none")
        for symbol, node in sorted(atoms.circular.items()):
            function = getattr(sympy, node.function.value)
            short = short_name(node)
            value = function(nodes.convert(node.arguments[0]), evaluate=not _of_arctangent(node))
            steps.append(ProgramStep(symbol, short.word if short else "", value))
        steps += [ProgramStep(symbol.name, "", value) for symbol, value in repeated]
        left = iter(reduced)
        entries = [[next(left) for _ in row] for row in entries]
    return Program(
        purpose=purpose,
        n_joints=n_joints,
        parameters=parameters,
        variables=variables,
        atoms=atoms.known,
        steps=steps,
        entries=entries,
    )


class SourceAtoms:
    """Symbols for what SymPy must leave alone.

    It would fold π, write decimals as fractions, and divide by √(x² + y²) for the sine of atan2(y, x), which
    is 0/0 where both are 0; and the sines and cosines of joint variables have names of their own. Names of
    symbols decide the order of factors: decimals, parameters, joint variables, and
    sines and cosines by joint.

    Attributes:
        known: what the symbols stand for.
        circular: the sines, cosines and tangents among them.
    """

    def __init__(self, *, stepwise: bool) -> None:
        self._stepwise = stepwise
        self.known: dict[str, Expression] = {}
        self.circular: dict[str, Call] = {}
        self._places: dict[Call, str] = {}

    def symbol(self, node: Expression) -> "sympy.Expr | None":
        """Return the symbol that stands for a node, if one does."""
        import sympy

        negative = False
        if isinstance(node, Number) and node.value < 0:
            node, negative = Number(-node.value), True
        name = self._name(node)
        if name is None:
            return None
        self.known[name] = node
        return -sympy.Symbol(name) if negative else sympy.Symbol(name)

    def _name(self, node: Expression) -> str | None:
        match node:
            case Number(value):
                decimal = decimal_text(value)
                return None if decimal is None else f"n:{decimal}"
            case Parameter(name):
                return f"p:{name}"
            case Pi():
                return "o:pi"
            case JointVariable(index):
                return f"q:{index:02}"
            case Call(Function.SIN | Function.COS | Function.TAN) if self._stepwise and _is_step(node):
                return self._circular(node)
        return None

    def _circular(self, node: Call) -> str:
        if node not in self._places:
            short = short_name(node)
            joints = [f"{joint:02}{'+-'[sign < 0]}" for joint, sign in short.joints] if short else []
            place = "~".join(joints) or f"~{len(self._places):03}"
            self._places[node] = f"s:{place}{node.function.value[0]}"
            self.circular[self._places[node]] = node
        return self._places[node]


def _is_step(node: Call) -> bool:
    """Whether a sine, cosine or tangent is computed in a step of its own."""
    return bool(node.function is not Function.TAN and joint_variables_in(node)) or _of_arctangent(node)


def _of_arctangent(node: Call) -> bool:
    """Whether an atan2 is in the argument."""
    return any(
        isinstance(part, Call) and part.function is Function.ATAN2 for part in bottom_up(node.arguments)
    )
