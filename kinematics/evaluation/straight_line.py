"""A tape as a Python function, for one configuration at a time.

Six joints take some seventy multiplications and additions. Walking over a tape costs more than doing them,
and numpy more still; a function of nothing but local floats takes about a microsecond. Such a function is put
together here from syntax nodes, never from text: names are made of register numbers, operators come from an
enumeration, and every number is handed over as a default argument. No character of anything that a user wrote
gets in. See docs/decisions/recorded-computations.md.
"""

import ast
import math
import sys
from collections import Counter
from collections.abc import Callable, Sequence
from functools import partial
from struct import Struct
from types import CodeType, FunctionType
from typing import Any, TypeAlias

import numpy as np
from numpy.typing import NDArray

from kinematics.angles import are_ordinary, cos_sin
from kinematics.evaluation.tape import Operator, Tape
from kinematics.table import JointType

Evaluator: TypeAlias = Callable[[Sequence[float]], NDArray[np.float64]]
"""Takes [q_1, …, q_n] [rad or m], gives the tape's outputs as an array."""

DEEPEST_EXPRESSION = 12
"""Deeper expressions get a name of their own: the compiler of Python recurses over them."""

_NODES: dict[Operator, type[ast.operator]] = {
    Operator.ADD: ast.Add,
    Operator.SUBTRACT: ast.Sub,
    Operator.MULTIPLY: ast.Mult,
}

_TYPE_PARAMETERS: dict[str, Any] = {"type_params": []} if sys.version_info >= (3, 12) else {}
"""A field that a function of the syntax tree has since Python 3.12."""


def straight_line(tape: Tape, joint_types: Sequence[JointType], shape: tuple[int, ...]) -> Evaluator:
    """Return the function that does what a tape says.

    Args:
        tape: its inputs are cos q_i (of a revolute joint) or q_i (of a prismatic one) for every joint, then
            sin q_i.
        joint_types: types of joint 1 … n.
        shape: of the array that the outputs fill, in row-major order.

    Returns:
        Function of a list of n finite floats.
    """
    writer = _CodeWriter(tape)
    values, results = writer.computed()
    array = _load("array")
    body = [
        _inputs(tape, joint_types),
        *values,
        _assign("array", _call("empty", _load("shape"))),
        ast.Expr(value=_call("pack_into", array, ast.Constant(value=0), *results)),
        ast.If(test=_load("pairs"), body=[ast.Expr(value=_call("tidy", array))], orelse=[]),
        ast.Return(value=array),
    ]
    names = {
        "ordinary": are_ordinary,
        "exact": partial(joint_motions, joint_types),
        "tidy": _tidy,
        "cos": math.cos,
        "sin": math.sin,
        "empty": np.empty,
        "shape": shape,
        "pack_into": Struct(f"{len(tape.outputs)}d").pack_into,
    }
    return _function(["joints"], body, names, writer.constants)


def function_of_floats(tape: Tape) -> Callable[..., tuple[float, ...]]:
    """Return the function that takes a tape's inputs as floats, one after another, and gives its outputs."""
    writer = _CodeWriter(tape)
    values, results = writer.computed()
    body = [*values, ast.Return(value=ast.Tuple(elts=results, ctx=ast.Load()))]
    return _function([f"r{i}" for i in range(tape.n_inputs)], body, {}, writer.constants)


def _function(
    arguments: Sequence[str], body: list[ast.stmt], names: dict[str, Any], constants: tuple[float, ...]
) -> Callable[..., Any]:
    """A function of its arguments, the constants handed over as defaults of further ones."""
    every = [ast.arg(name) for name in (*arguments, *(f"k{i}" for i in range(len(constants))))]
    definition = ast.FunctionDef(
        name="evaluate",
        args=ast.arguments(posonlyargs=[], args=every, kwonlyargs=[], kw_defaults=[], defaults=[]),
        body=body,
        decorator_list=[],
        **_TYPE_PARAMETERS,
    )
    module = ast.fix_missing_locations(ast.Module(body=[definition], type_ignores=[]))
    code = compile(module, "<recorded computation>", "exec")
    (inner,) = (constant for constant in code.co_consts if isinstance(constant, CodeType))
    return FunctionType(inner, {**names, "__builtins__": {}}, "evaluate", constants)


def joint_motions(joint_types: Sequence[JointType], joints: Sequence[float]) -> list[tuple[float, float]]:
    """Return (cos q, sin q) of every revolute joint, exact for multiples of π/12, and (q, 0) of others."""
    return [
        (q, 0.0) if kind is JointType.PRISMATIC else cos_sin(q)
        for q, kind in zip(joints, joint_types, strict=True)
    ]


def _tidy(array: NDArray[np.float64]) -> None:
    """Turn -0.0 into 0.0."""
    np.add(array, 0.0, out=array)


class _CodeWriter:
    """Writes the statements of a tape; what is used once stands where it is used."""

    def __init__(self, tape: Tape) -> None:
        self.constants = tape.constants
        self._tape = tape
        self._uses = Counter(x for operation in tape.operations for x in operation[1:])
        self._uses.update(tape.outputs)
        self._pending: dict[int, tuple[ast.expr, int]] = {}

    def computed(self) -> tuple[list[ast.stmt], list[ast.expr]]:
        """Return one assignment for each register that is used more than once, and the results."""
        body: list[ast.stmt] = []
        for register, (operator, left, right) in enumerate(self._tape.operations, self._tape.n_inputs):
            (a, depth_a), (b, depth_b) = self._operand(left), self._operand(right)
            depth = 1 + max(depth_a, depth_b)
            value = ast.BinOp(left=a, op=_NODES[operator](), right=b)
            if self._uses[register] == 1 and depth < DEEPEST_EXPRESSION:
                self._pending[register] = value, depth
            else:
                body.append(_assign(f"r{register}", value))
        return body, [self._operand(x)[0] for x in self._tape.outputs]

    def _operand(self, operand: int) -> tuple[ast.expr, int]:
        if operand < 0:
            return _load(f"k{~operand}"), 0
        return self._pending.pop(operand, None) or (_load(f"r{operand}"), 0)


def _inputs(tape: Tape, joint_types: Sequence[JointType]) -> ast.stmt:
    """Cosine and sine of the joint values: of ordinary ones by the library, else with a look at each."""
    used = {x for operation in tape.operations for x in operation[1:]} | set(tape.outputs)
    n = len(joint_types)
    plain: list[ast.stmt] = [_assign("pairs", ast.Constant(value=None))]
    if n:
        names = _names([f"q{joint}" for joint in range(n)])
        plain.append(ast.Assign(targets=[names], value=_load("joints")))
    for joint, joint_type in enumerate(joint_types):
        q = _load(f"q{joint}")
        if joint_type is JointType.PRISMATIC:
            plain.append(_assign(f"r{joint}", q))
            continue
        for register, function in ((joint, "cos"), (joint + n, "sin")):
            if register in used:
                plain.append(_assign(f"r{register}", _call(function, q)))
    pairs: list[ast.expr] = [_names([f"r{joint}", f"r{joint + n}"]) for joint in range(n)]
    exact: list[ast.stmt] = [
        _assign("pairs", _call("exact", _load("joints"))),
        ast.Assign(targets=[ast.Tuple(elts=pairs, ctx=ast.Store())], value=_load("pairs")),
    ]
    return ast.If(test=_call("ordinary", _load("joints")), body=plain, orelse=exact)


def _names(names: list[str]) -> ast.expr:
    return ast.Tuple(elts=[ast.Name(id=name, ctx=ast.Store()) for name in names], ctx=ast.Store())


def _load(name: str) -> ast.Name:
    return ast.Name(id=name, ctx=ast.Load())


def _call(function: str, *arguments: ast.expr) -> ast.Call:
    return ast.Call(func=_load(function), args=list(arguments), keywords=[])


def _assign(name: str, value: ast.expr) -> ast.Assign:
    return ast.Assign(targets=[ast.Name(id=name, ctx=ast.Store())], value=value)
