"""A checked reader of the MATLAB that the printer writes: it reads a whole function, or fails, and runs it.

The grammar accepts only what means the same in MATLAB and in Octave, wherever it stands: binary + and - have
white space on both sides, for within brackets [a -b] is two elements; nothing else has any.
"""

from __future__ import annotations

import math
import re
from collections.abc import Callable
from typing import Any

from lark import Lark, Transformer, v_args

_KEYWORDS = """
break case catch classdef continue else elseif end for function global if otherwise parfor persistent return
spmd switch try while
"""
_WORDS = frozenset(_KEYWORDS.split())
_HEAD = re.compile(r"function ([A-Za-z]\w*) = ([A-Za-z]\w*)\(([A-Za-z]\w*(?:, [A-Za-z]\w*)*)\)")
_CHECK = re.compile(r"assert\(numel\(q\) == (\d+), '[^'\n]*'\);")
_ASSIGNMENT = re.compile(r"([A-Za-z]\w*) = ([^;\n]+);")
_FUNCTIONS: dict[str, Callable[..., float]] = {
    name: getattr(math, name) for name in ("sin", "cos", "tan", "asin", "acos", "atan", "atan2", "sqrt")
} | {"abs": abs}

_PARSER = Lark(
    r"""
    ?sum: product | sum " + " product -> add | sum " - " product -> sub
    ?product: power | "-" product -> neg | product "*" power -> mul | product "/" power -> div
    ?power: atom | atom "^" atom -> pow
    ?atom: NUMBER -> number | NAME -> variable | "(" sum ")" | NAME "(" sum ("," " " sum)* ")" -> call
    NAME: /[A-Za-z]\w*/
    NUMBER: /[0-9]+(\.[0-9]+)?/
    """,
    start="sum",
    parser="lalr",
)


class _Evaluate(Transformer[Any, float]):
    def __init__(self, scope: dict[str, Any]) -> None:
        super().__init__()
        self.scope = scope

    @v_args(inline=True)
    def number(self, token: str) -> float:
        return float(token)

    @v_args(inline=True)
    def variable(self, name: str) -> float:
        assert name not in _WORDS
        return float(self.scope[name] if name in self.scope else {"pi": math.pi}[name])

    @v_args(inline=True)
    def call(self, name: str, *given: float) -> float:
        if name in self.scope:
            (index,) = given
            return float(self.scope[name][int(index) - 1])
        return float(_FUNCTIONS[name](*given))

    add = v_args(inline=True)(lambda self, a, b: a + b)
    sub = v_args(inline=True)(lambda self, a, b: a - b)
    mul = v_args(inline=True)(lambda self, a, b: a * b)
    div = v_args(inline=True)(lambda self, a, b: a / b)
    pow = v_args(inline=True)(lambda self, a, b: a**b)
    neg = v_args(inline=True)(lambda self, a: -a)


def run(source: str, *values: Any) -> list[list[float]]:
    """The value of the function that `source` defines, at the given arguments."""
    lines = source.splitlines()
    head = _HEAD.fullmatch(lines[0])
    assert head is not None, lines[0]
    assert lines[-1] == "end"
    names = head.group(3).split(", ")
    assert not _WORDS & {*names, head.group(1), head.group(2)}
    assert len(set(names)) == len(names)
    scope = dict(zip(names, values, strict=True))
    body = [line for line in lines[1:-1] if not line.startswith("%")]
    checked = _CHECK.fullmatch(body[0])
    if checked:
        assert len(scope["q"]) == int(checked.group(1))
        body = body[1:]
    opening = body.index(f"{head.group(1)} = [")
    for line in body[:opening]:
        assignment = _ASSIGNMENT.fullmatch(line)
        assert assignment is not None, line
        name = assignment.group(1)
        assert name not in _WORDS
        assert name not in scope
        scope[name] = _value(assignment.group(2), scope)
    assert body[-1] == "];"
    rows = body[opening + 1 : -1]
    assert all(row.endswith(";") for row in rows[:-1])
    return [[_value(entry, scope) for entry in _elements(row)] for row in rows]


def _value(text: str, scope: dict[str, Any]) -> float:
    return _Evaluate(scope).transform(_PARSER.parse(text))


def _elements(row: str) -> list[str]:
    """The elements of a row, which are separated by commas outside parentheses."""
    assert row.startswith("    ")
    elements, depth = [""], 0
    for character in row[4:].rstrip(";"):
        depth += {"(": 1, ")": -1}.get(character, 0)
        if character == "," and not depth:
            elements.append("")
        else:
            elements[-1] += character
    return [element.removeprefix(" ") for element in elements]
