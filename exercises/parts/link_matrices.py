"""The link matrices {}^{i-1}T_i: each is judged by the student's own row; a wrong row is marked once."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from fractions import Fraction

import numpy as np

from exercises.definition import PartKind
from exercises.grading import Feedback, Finding, HelpLevel
from exercises.grading.verdict import ParamValue
from exercises.parts.comparison import (
    Compared,
    Expected,
    Matrices,
    agreeing,
    cell_names,
    compare,
    inverse,
    is_rigid,
    transposed_rotation,
)
from exercises.parts.context import Context
from exercises.parts.matrix_cells import SymbolicMatrix
from exercises.parts.report import Credit, Disclosure, Fact, PartReport, shown
from kinematics.dh import link_transform
from kinematics.table import Convention, bind

_DISCLOSURES = {
    "matrix_wrong": Disclosure(level=HelpLevel.ROW),
    "matrix_missing": Disclosure(level=HelpLevel.ROW),
    "matrix_cells_wrong": Disclosure(level=HelpLevel.KIND, instead="matrix_wrong"),
    "matrix_inverse": Disclosure(level=HelpLevel.REPAIR, instead="matrix_cells_wrong"),
    "matrix_rotation_transposed": Disclosure(level=HelpLevel.REPAIR, instead="matrix_cells_wrong"),
    "matrix_other_convention": Disclosure(level=HelpLevel.REPAIR, instead="matrix_cells_wrong"),
    "matrix_of_other_row": Disclosure(level=HelpLevel.REPAIR, instead="matrix_cells_wrong"),
    "matrix_without_variable": Disclosure(level=HelpLevel.REPAIR, instead="matrix_cells_wrong"),
    "matrix_not_rigid": Disclosure(level=HelpLevel.KIND, instead="matrix_wrong"),
}


def grade_link_matrices(
    context: Context, answer: Sequence[SymbolicMatrix | None], points: Fraction
) -> PartReport:
    """Judge link matrices by the rows of the student's own table; each counts the same.

    Args:
        context: what the answer is judged by; it holds the student's own table.
        answer: one matrix per row of that table; None where none was handed in.
        points: what the part is worth.
    """
    assert context.own is not None
    facts: list[Fact] = []
    feedback: list[Feedback] = []
    for i, matrix in enumerate(answer):
        if matrix is None:
            facts.append(Fact(where=(i,), finding=Finding.MISSING))
            feedback.append(Feedback(code="matrix_missing", row=i + 1, params={"matrix": i + 1}))
            continue
        compared = compare(context, matrix, link_of(context, i))
        facts.append(Fact(where=(i,), finding=Finding.OK if compared.right else Finding.WRONG))
        if not compared.right:
            facts += _cell_facts(i, compared)
            feedback.append(_what_is_off(context, i, compared))
    right = sum(fact.finding is Finding.OK and len(fact.where) == 1 for fact in facts)
    score = right / len(answer)
    correct = score == 1.0 and context.own_correct
    if score == 1.0:
        feedback.append(Feedback(code="matrices_right" if correct else "matrices_follow_table"))
    report = PartReport(
        kind=PartKind.LINK_MATRICES,
        correct=correct,
        score=score,
        points=float(points) * score,
        max_points=float(points),
        credit=Credit.NONE if not right else Credit.KEY if context.own_correct else Credit.OWN_TABLE,
        facts=tuple(facts),
        feedback=tuple(feedback),
    )
    return shown(report, context.help_level, _DISCLOSURES)


def link_of(context: Context, row: int, convention: Convention | None = None) -> Expected:
    """What the matrix of a row of the student's own table must be, or would be in another convention."""
    assert context.own is not None
    table = context.own.table
    joint = table.joint_rows.index(row) if row in table.joint_rows else None

    def expected(values: Mapping[str, float], joints: Sequence[float]) -> Matrices:
        numbers = bind(table, values)
        q = joints[joint] if joint is not None else 0.0
        return link_transform(numbers.rows[row], convention or table.convention, q)

    return expected


def _cell_facts(i: int, compared: Compared) -> list[Fact]:
    return [Fact(where=(i, r, c), finding=Finding.WRONG) for r, c in np.argwhere(~compared.cells).tolist()]


def _what_is_off(context: Context, i: int, compared: Compared) -> Feedback:
    """The misconception that explains a wrong matrix, or else its wrong cells."""
    assert context.own is not None
    own = np.array([link_of(context, i)(values, q) for values, q in compared.samples])
    params: dict[str, ParamValue] = {"matrix": i + 1, "cells": cell_names(compared.cells)}

    def looks_like(other: Matrices) -> bool:
        return bool(agreeing(compared.actual, other, context.size, context.policy.tolerance).all())

    table = context.own.table
    other = Convention.MODIFIED if table.convention is Convention.STANDARD else Convention.STANDARD
    if looks_like(np.array([link_of(context, i, other)(values, q) for values, q in compared.samples])):
        return Feedback(code="matrix_other_convention", row=i + 1, params=params)
    if looks_like(inverse(own)):
        return Feedback(code="matrix_inverse", row=i + 1, params=params)
    if looks_like(transposed_rotation(own)):
        return Feedback(code="matrix_rotation_transposed", row=i + 1, params=params)
    if looks_like(np.array([link_of(context, i)(values, [0.0] * len(q)) for values, q in compared.samples])):
        return Feedback(code="matrix_without_variable", row=i + 1, params=params)
    for k in range(len(table.rows)):
        if k != i and looks_like(
            np.array([link_of(context, k)(values, q) for values, q in compared.samples])
        ):
            return Feedback(code="matrix_of_other_row", row=i + 1, params={**params, "other": k + 1})
    if not is_rigid(compared.actual, context.policy.tolerance):
        return Feedback(code="matrix_not_rigid", row=i + 1, params=params)
    return Feedback(code="matrix_cells_wrong", row=i + 1, params=params)
