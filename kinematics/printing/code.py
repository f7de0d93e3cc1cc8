"""Functions in Python, NumPy, C, MATLAB and JavaScript."""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence

from kinematics.printing.bodies import Body, BodyWriter
from kinematics.printing.languages import JAVASCRIPT, MATLAB, NUMPY, PYTHON, C, Language
from kinematics.printing.ledger import Entered, Ledger
from kinematics.printing.program import Program, Purpose, named, plan
from kinematics.printing.traits import Traits

_WORD = re.compile(r"[A-Za-z_]\w*", re.ASCII)


class FunctionWriter:
    """Writes functions of the joint variables q and of every parameter.

    Args:
        ledger: where the nodes are.
        n_joints: number of joint variables.
        parameters: the table's parameters; each is an argument, whether a matrix holds it or not.
    """

    def __init__(self, ledger: Ledger, *, n_joints: int, parameters: Sequence[str]) -> None:
        self._n_joints = n_joints
        self._parameters = parameters
        self._traits = Traits(ledger)
        spellings = {name: language.spelling for name, (language, _) in _LANGUAGES.items()}
        self._bodies = BodyWriter(self._traits, spellings)

    def write(self, matrix: Entered, purpose: Purpose, languages: Sequence[str]) -> dict[str, str]:
        """The source of one function in some of python, numpy, c, matlab, javascript."""
        programs = named(
            plan(self._traits, matrix),
            purpose,
            n_joints=self._n_joints,
            parameters=self._parameters,
            reserved=[_LANGUAGES[language][0].reserved for language in languages],
        )
        bodies = self._bodies.bodies(dict(zip(languages, programs, strict=True)))
        return {
            language: _LANGUAGES[language][1](program, body)
            for language, program, body in zip(languages, programs, bodies, strict=True)
        }


def _comments(code: Program) -> list[str]:
    """What a reader must know: the joint variables, and parameters that had to be renamed."""
    lines = [code.purpose.meaning]
    if code.n_joints:
        lines.append(f"q: the {code.n_joints} joint variables, angles in radians.")
    changed = [(old, new) for old, new in code.arguments.items() if new != old]
    renamed = [f"{new} is {old}" for old, new in changed if _WORD.fullmatch(old)]
    if renamed:
        lines.append(f"Renamed: {', '.join(renamed)}.")
    return lines


def _signature(code: Program) -> str:
    return ", ".join(["q", *code.arguments.values()])


def _python(code: Program, body: Body) -> str:
    used = [*{PYTHON.spelling.functions[function] for function in code.plan.functions} - {"abs"}]
    if code.plan.holds_pi:
        used.append("pi")
    steps = [f"    {name} = {value}" for name, value in body.steps]
    rows = [f"        [{', '.join(row)}]," for row in body.entries]
    lines = [f"from math import {', '.join(sorted(used))}", "", ""] if used else []
    lines += [f"def {code.purpose.name}({_signature(code)}):", *_docstring(code)]
    if code.n_joints:
        lines += [f"    if len(q) != {code.n_joints}:", f'        raise ValueError("{_length(code)}")']
    return "\n".join([*lines, *steps, "    return [", *rows, "    ]", ""])


def _numpy(code: Program, body: Body) -> str:
    result, shape = code.result, f"({len(body.entries)}, {len(body.entries[0])})"
    lines = ["import numpy as np", "", "", f"def {code.purpose.name}({_signature(code)}):"]
    lines += _docstring(code, "One configuration of shape (n,), or a batch (…, n).")
    lines.append("    q = np.asarray(q, dtype=float)")
    lines += [f"    if q.shape[-1:] != ({code.n_joints},):", f'        raise ValueError("{_length(code)}")']
    lines += [f"    {name} = {value}" for name, value in body.steps]
    lines.append(f"    {result} = np.empty(q.shape[:-1] + {shape})")
    lines += [
        f"    {result}[..., {i}, {j}] = {entry}"
        for i, row in enumerate(body.entries)
        for j, entry in enumerate(row)
    ]
    return "\n".join([*lines, f"    return {result}", ""])


def _c(code: Program, body: Body) -> str:
    columns = len(body.entries[0])
    result = f"double {code.result}[{len(body.entries)}][{columns}]" if columns else f"double *{code.result}"
    arguments = ["const double *q", *(f"double {name}" for name in code.arguments.values()), result]
    steps = [f"    const double {name} = {value};" for name, value in body.steps]
    entries = [
        f"    {code.result}[{i}][{j}] = {entry};"
        for i, row in enumerate(body.entries)
        for j, entry in enumerate(row)
    ]
    unused = [] if code.plan.moves else ["q"]
    unused += [word for name, word in code.arguments.items() if name not in code.plan.parameters]
    unused += [] if columns else [code.result]
    ignored = [f"    (void){name};" for name in unused]
    comment = ["/*", *(f" * {line}" for line in _comments(code)), " */"]
    head = [f"void {code.purpose.name}({', '.join(arguments)})", "{"]
    return "\n".join(["#include <math.h>", "", *comment, *head, *steps, *ignored, *entries, "}", ""])


def _matlab(code: Program, body: Body) -> str:
    comment = [f"% {line}" for line in _comments(code)]
    lines = [f"function {code.result} = {code.purpose.name}({_signature(code)})", *comment]
    if code.n_joints:
        lines.append(f"assert(numel(q) == {code.n_joints}, '{_length(code)}');")
    lines += [f"{name} = {value};" for name, value in body.steps]
    if body.entries[0]:
        rows = [f"    {', '.join(row)}" for row in body.entries]
        lines += [f"{code.result} = [", ";\n".join(rows), "];"]
    else:
        lines.append(f"{code.result} = zeros({len(body.entries)}, 0);")
    return "\n".join([*lines, "end", ""])


def _javascript(code: Program, body: Body) -> str:
    comment = ["/**", *(f" * {line}" for line in _comments(code)), " */"]
    lines = [*comment, f"function {code.purpose.name}({_signature(code)}) {{"]
    if code.n_joints:
        lines.append(f'  if (q.length !== {code.n_joints}) throw new RangeError("{_length(code)}");')
    lines += [f"  const {name} = {value};" for name, value in body.steps]
    rows = [f"    [{', '.join(row)}]," for row in body.entries]
    return "\n".join([*lines, "  return [", *rows, "  ];", "}", ""])


def _docstring(code: Program, *more: str) -> list[str]:
    first, *rest = [*_comments(code), *more]
    if not rest:
        return [f'    """{first}"""']
    return [f'    """{first}', "", *(f"    {line}" for line in rest), '    """']


def _length(code: Program) -> str:
    return f"q holds {code.n_joints} joint variables"


_LANGUAGES: dict[str, tuple[Language, Callable[[Program, Body], str]]] = {
    "python": (PYTHON, _python),
    "numpy": (NUMPY, _numpy),
    "c": (C, _c),
    "matlab": (MATLAB, _matlab),
    "javascript": (JAVASCRIPT, _javascript),
}
