"""A tape as a Python function, for one configuration at a time.

Six joints take some seventy multiplications and additions. Walking over a tape costs more than doing them,
and numpy more still; a function of nothing but local floats takes about a microsecond. Such a function is put
together here from syntax nodes, never from text: names are made of register numbers, operators come from an
enumeration, and every number is handed over as a default argument. No character of anything that a user wrote
gets in. See docs/decisions/recorded-computations.md.
"""

from __future__ import annotations

import ast
import math
from collections import Counter
from collections.abc import Callable, Sequence
from struct import Struct
from types import CodeType, FunctionType
from typing import TypeAlias

import numpy as np
from numpy.typing import NDArray

from kinematics.evaluation.tape import Operator, Tape
from kinematics.table import JointType

Evaluator: TypeAlias = Callable[[Sequence[float]], NDArray[np.float64]]
"""Takes [q_1, …, q_n] [rad or m], gives the tape's outputs as an array."""

DEEPEST_EXPRESSION = 12

_NODES: dict[Operator, type[ast.operator]] = {
    Operator.ADD: ast.Add,
    Operator.SUBTRACT: ast.Sub,
    Operator.MULTIPLY: ast.Mult,
}


def straight_line(tape: Tape, joint_types: Sequence[JointType], shape: tuple[int, ...]) -> Evaluator:
    """The function that does what a tape says.

    Args:
        tape: its inputs are cos q_i (of a revolute joint) or q_i (of a prismatic one) for every joint, then
            sin q_i.
        joint_types: types of joint 1 … n.
        shape: of the array that the outputs fill, in row-major order.

    Returns:
        Function of a list of n finite floats.
    """
    writer = _Writer(tape)
    body = [*_inputs(tape, joint_types), *writer.statements()]
    arguments = [ast.arg("joints"), *(ast.arg(f"k{i}") for i in range(len(writer.constants)))]
    definition = ast.FunctionDef(
        name="evaluate",
        args=ast.arguments(posonlyargs=[], args=arguments, kwonlyargs=[], kw_defaults=[], defaults=[]),
        body=body,
        decorator_list=[],
    )
    module = ast.fix_missing_locations(ast.Module(body=[definition], type_ignores=[]))
    code = compile(module, "<recorded computation>", "exec")
    (inner,) = (constant for constant in code.co_consts if isinstance(constant, CodeType))
    names = {
        "cos": math.cos,
        "sin": math.sin,
        "empty": np.empty,
        "shape": shape,
        "pack_into": Struct(f"{len(tape.outputs)}d").pack_into,
        "__builtins__": {},
    }
    return FunctionType(inner, names, "evaluate", writer.constants)


class _Writer:
    """Writes the statements of a tape; what is used once stands where it is used."""

    def __init__(self, tape: Tape) -> None:
        self.constants = (*tape.constants, 0.0)
        self._tape = tape
        self._uses = Counter(x for operation in tape.operations for x in operation[1:])
        self._uses.update(tape.outputs)
        self._pending: dict[int, tuple[ast.expr, int]] = {}

    def statements(self) -> list[ast.stmt]:
        """One assignment for each register that is used more than once, and the return."""
        body: list[ast.stmt] = []
        for register, (operator, left, right) in enumerate(self._tape.operations, self._tape.n_inputs):
            (a, depth_a), (b, depth_b) = self._operand(left), self._operand(right)
            depth = 1 + max(depth_a, depth_b)
            value = ast.BinOp(left=a, op=_NODES[operator](), right=b)
            if self._uses[register] == 1 and depth < DEEPEST_EXPRESSION:
                self._pending[register] = value, depth
            else:
                body.append(_assign(f"r{register}", value))
        results = [self._result(x) for x in self._tape.outputs]
        array = _load("array")
        offset = ast.Constant(value=0)
        return [
            *body,
            _assign("array", _call("empty", _load("shape"))),
            ast.Expr(value=_call("pack_into", array, offset, *results)),
            ast.Return(value=array),
        ]

    def _operand(self, operand: int) -> tuple[ast.expr, int]:
        if operand < 0:
            return _load(f"k{~operand}"), 0
        return self._pending.pop(operand, None) or (_load(f"r{operand}"), 0)

    def _result(self, operand: int) -> ast.expr:
        """An output; + 0 turns -0.0 into 0.0."""
        value, _ = self._operand(operand)
        zero = _load(f"k{len(self.constants) - 1}")
        return value if operand < 0 else ast.BinOp(left=value, op=ast.Add(), right=zero)


def _inputs(tape: Tape, joint_types: Sequence[JointType]) -> list[ast.stmt]:
    """Unpack the joint values; cosine and sine where a result needs them."""
    used = {x for operation in tape.operations for x in operation[1:]} | set(tape.outputs)
    n = len(joint_types)
    names: list[ast.expr] = [ast.Name(id=f"q{joint}", ctx=ast.Store()) for joint in range(n)]
    statements: list[ast.stmt] = []
    if n:
        statements.append(ast.Assign(targets=[ast.Tuple(elts=names, ctx=ast.Store())], value=_load("joints")))
    for joint, joint_type in enumerate(joint_types):
        q = _load(f"q{joint}")
        if joint_type is JointType.PRISMATIC:
            statements.append(_assign(f"r{joint}", q))
            continue
        for register, function in ((joint, "cos"), (joint + n, "sin")):
            if register in used:
                statements.append(_assign(f"r{register}", _call(function, q)))
    return statements


def _load(name: str) -> ast.Name:
    return ast.Name(id=name, ctx=ast.Load())


def _call(function: str, *arguments: ast.expr) -> ast.Call:
    return ast.Call(func=_load(function), args=list(arguments), keywords=[])


def _assign(name: str, value: ast.expr) -> ast.Assign:
    return ast.Assign(targets=[ast.Name(id=name, ctx=ast.Store())], value=value)
