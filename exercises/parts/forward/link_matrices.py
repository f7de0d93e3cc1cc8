"""The link matrices {}^{i-1}T_i: each is judged by the student's own row; a wrong row is marked once."""

import math
from collections.abc import Iterator, Sequence
from random import Random
from typing import Annotated, ClassVar

import numpy as np

from exercises.definition import Part
from exercises.grading import Feedback, Finding, HelpLevel
from exercises.grading.verdict import ParamValue
from exercises.parts.cells.comparison import (
    Compared,
    Expected,
    cell_names,
    compare,
    is_rigid,
    likeness,
    transposed_cells,
    transposed_rotation,
)
from exercises.parts.cells.matrix_cells import CellMatrix, read_known_matrix, write_matrix
from exercises.parts.cells.symbolic_matrix import SymbolicMatrix
from exercises.parts.context import Context
from exercises.parts.forward.value import is_robot, reads_as_robot
from exercises.parts.protocol import TABLE, Length, PartType, Reading
from exercises.parts.report import Credit, Fact, PartReport, fact, judged, told_from
from kinematics.se3 import inverse_transform
from kinematics.table import JointType, NumericRow


def _own_link(context: Context, row: int) -> Expected:
    """What the matrix of a row of the student's own table must be."""
    return lambda samples: context.own_links(samples)[row]


def _what_is_off(context: Context, i: int, compared: Compared) -> Feedback:
    """The misconception that explains a wrong matrix, or else its wrong cells."""
    assert context.own is not None
    samples = compared.samples
    links = context.own_links(samples)
    own = links[i]
    params: dict[str, ParamValue] = {"matrix": i + 1, "cells": cell_names(compared.cells)}
    looks_like = likeness(context, compared.actual)
    if looks_like(context.own_links(samples, context.own.table.convention.other)[i]):
        return Feedback(code="matrix_other_convention", row=i + 1, params=params)
    if looks_like(inverse_transform(own)):
        return Feedback(code="matrix_inverse", row=i + 1, params=params)
    if looks_like(transposed_rotation(own)):
        return Feedback(code="matrix_rotation_transposed", row=i + 1, params=params)
    if looks_like(context.own_links(samples.at_zero)[i]):
        return Feedback(code="matrix_without_variable", row=i + 1, params=params)
    for k, link in enumerate(links):
        if k != i and looks_like(link):
            return Feedback(code="matrix_of_other_row", row=i + 1, params={**params, "other": k + 1})
    if compared.has_values and not is_rigid(compared.actual, context.policy.tolerance):
        return Feedback(code="matrix_not_rigid", row=i + 1, params=params)
    return Feedback(code="matrix_cells_wrong", row=i + 1, params=params)


class LinkMatricesPart(PartType[Part, Sequence[CellMatrix | None], tuple[SymbolicMatrix | None, ...]]):
    """The matrices {}^{i-1}T_i, one for each row of the table."""

    kind = "link_matrices"
    raw: ClassVar = Annotated[tuple[CellMatrix | None, ...], Length(least=1)]
    meaning = "for each row of the table the matrix of its link, or null"
    follows_table = True
    disclosures: ClassVar = {
        **told_from(HelpLevel.ROW, "matrix_wrong", "matrix_missing"),
        **told_from(HelpLevel.KIND, "matrix_cells_wrong", instead="matrix_wrong"),
        **told_from(
            HelpLevel.REPAIR,
            "matrix_inverse",
            "matrix_rotation_transposed",
            "matrix_other_convention",
            "matrix_of_other_row",
            "matrix_without_variable",
            instead="matrix_cells_wrong",
        ),
        **told_from(HelpLevel.KIND, "matrix_not_rigid", instead="matrix_wrong"),
    }

    def read(
        self, raw: Sequence[CellMatrix | None], reading: Reading
    ) -> tuple[SymbolicMatrix | None, ...] | None:
        """Return the matrices; without a table none may be missing."""
        table = reading.raw.get(TABLE)
        if table is not None and len(raw) != len(table.rows):
            reading.fault("link_matrices_count", expected=len(table.rows), given=len(raw))
        elif table is None and (not raw or any(matrix is None for matrix in raw)):
            reading.fault("link_matrices_need_table")
        elif table is None or reading.table is not None:
            return tuple(
                None if cells is None else read_known_matrix(cells, reading, i) for i, cells in enumerate(raw)
            )
        return None

    def grade(self, part: Part, answer: tuple[SymbolicMatrix | None, ...], context: Context) -> PartReport:
        """Judge by the student's own rows; what does not follow from them may be right as a whole."""
        report = _by_own_rows(context, answer, part) if context.own is not None else None
        if report is not None and (report.score == 1.0 or context.own_correct):
            return report
        whole = [matrix for matrix in answer if matrix is not None]
        if len(whole) == len(answer) and is_robot(context, whole):
            code = "matrices_right" if context.own is None else "matrices_right_not_from_table"
            return judged(part, 1.0, Credit.KEY, feedback=[Feedback(code=code)])
        if report is not None:
            return report
        return judged(part, 0.0, Credit.NONE, feedback=[Feedback(code="matrices_product_wrong")])

    def right(self, part: Part, context: Context) -> list[CellMatrix | None]:
        """Return the matrices of the student's own rows."""
        assert context.own is not None
        n, names = context.own.table.n_joints, tuple(context.own.parameters)
        return [write_matrix(link, n, names) for link in context.own_form.links]

    def wrong(
        self, part: Part, context: Context, rng: Random
    ) -> Iterator[tuple[str, list[CellMatrix | None]]]:
        """Yield the matrices with one transposed, and with the one that is missing."""
        right = self.right(part, context)
        i = rng.randrange(len(right))
        chosen = right[i]
        assert chosen is not None
        asked = context.instance.exercise.part(TABLE) is not None
        if asked:
            yield "matrix_missing", [*right[:i], None, *right[i + 1 :]]
        turned = transposed_cells(chosen)
        if turned is None:
            return
        changed = [*right[:i], turned, *right[i + 1 :]]
        if asked:
            yield "matrix_rotation_transposed", changed
        elif not reads_as_robot(context, [cells for cells in changed if cells is not None]):
            yield "matrices_product_wrong", changed


def _by_own_rows(context: Context, answer: Sequence[SymbolicMatrix | None], part: Part) -> PartReport:
    """Judge link matrices by the rows of the student's own table; see `_weights`."""
    facts: list[Fact] = []
    feedback: list[Feedback] = []
    for i, matrix in enumerate(answer):
        if matrix is None:
            facts.append(Fact(where=(i,), finding=Finding.MISSING))
            feedback.append(Feedback(code="matrix_missing", row=i + 1, params={"matrix": i + 1}))
            continue
        compared = compare(context, matrix, _own_link(context, i))
        facts.append(fact(compared.right, i))
        if not compared.right:
            facts += [fact(False, i, r, c) for r, c in np.argwhere(~compared.cells).tolist()]
            feedback.append(_what_is_off(context, i, compared))
    right = [fact.finding is Finding.OK for fact in facts if len(fact.where) == 1]
    weights = _weights(context, right)
    if all(right):
        feedback.append(Feedback(code="matrices_right" if context.own_correct else "matrices_follow_table"))
    earned = sum(weight for weight, good in zip(weights, right, strict=True) if good)
    return judged(part, earned / sum(weights), context.own_credit, facts=facts, feedback=feedback)


def _weights(context: Context, right: Sequence[bool]) -> list[float]:
    """Return what the matrix of each row counts.

    Those of joints count the same. Rows without a variable may be added to a table at will, so all of them
    together count no more than the key's, or one; one of zeros, whose matrix is there for nothing, can only
    lose.
    """
    assert context.own is not None
    rows = context.own_numbers(context.values(context.own_names())).rows
    fixed = [row.joint is JointType.FIXED for row in rows]
    idle = [still and good and _is_nothing(row) for row, still, good in zip(rows, fixed, right, strict=True)]
    if all(idle):
        return [1.0] * len(rows)
    fixed_in_key = sum(row.joint is JointType.FIXED for row in context.reference_numbers.rows)
    share = min(1.0, max(1, fixed_in_key) / max(1, sum(fixed) - sum(idle)))
    return [0.0 if nothing else share if still else 1.0 for still, nothing in zip(fixed, idle, strict=True)]


def _is_nothing(row: NumericRow) -> bool:
    """Whether the matrix of a row without a variable is the identity."""
    turns = (row.theta, row.alpha)
    return not row.a and not row.d and all(abs(math.remainder(turn, math.tau)) < 1e-9 for turn in turns)


PART = LinkMatricesPart()
