"""⁰T_N in closed form: right if it follows from the student's own table, or is the robot's by itself."""

from collections.abc import Iterator
from functools import reduce
from itertools import accumulate
from random import Random
from typing import ClassVar

import numpy as np

from exercises.definition import Part
from exercises.grading import Feedback, HelpLevel
from exercises.parts.cells.comparison import (
    Compared,
    Expected,
    cell_facts,
    cell_names,
    compare,
    halves_right,
    is_rigid,
    likeness,
    transposed_cells,
    transposed_rotation,
)
from exercises.parts.cells.matrix_cells import CellMatrix, read_known_matrix, write_matrix
from exercises.parts.cells.symbolic_matrix import SymbolicMatrix
from exercises.parts.context import Context
from exercises.parts.forward.value import is_robot, reads_as_robot
from exercises.parts.protocol import TABLE, PartType, Reading
from exercises.parts.report import Credit, PartReport, judged, told_from
from kinematics.se3 import inverse_transform


def transform_is_robot(context: Context, answer: SymbolicMatrix) -> bool:
    """Return whether a ⁰T_N describes the robot by itself."""
    return is_robot(context, (answer,))


def _own(context: Context) -> Expected:
    return lambda samples: reduce(np.matmul, context.own_links(samples))


def _wrong(context: Context, compared: Compared, part: Part) -> PartReport:
    cells = compared.cells
    rotation, position = bool(cells[:3, :3].all()), bool(cells[:3, 3].all())
    feedback = [_what_is_off(context, compared)]
    score = halves_right(cells, _own(context)(compared.samples), context.size, context.policy.tolerance)
    if rotation and score:
        feedback.append(Feedback(code="transform_rotation_right"))
    if position and score:
        feedback.append(Feedback(code="transform_position_right"))
    return judged(part, score, context.own_credit, correct=False, facts=cell_facts(cells), feedback=feedback)


def _what_is_off(context: Context, compared: Compared) -> Feedback:
    """The misconception that explains a wrong ⁰T_N, or else its wrong cells."""
    links = context.own_links(compared.samples)
    frames = list(accumulate(links, np.matmul))
    own = frames[-1]

    looks_like = likeness(context, compared.actual)
    if looks_like(inverse_transform(own)):
        return Feedback(code="transform_inverse")
    if looks_like(transposed_rotation(own)):
        return Feedback(code="transform_rotation_transposed")
    if looks_like(reduce(np.matmul, links[::-1])):
        return Feedback(code="transform_order_reversed")
    for k in range(len(frames) - 1, 0, -1):
        if looks_like(frames[k - 1]):
            return Feedback(code="transform_links_missing", params={"last": k})
    if compared.has_values and not is_rigid(compared.actual, context.policy.tolerance):
        return Feedback(code="transform_not_rigid")
    return Feedback(code="transform_cells_wrong", params={"cells": cell_names(compared.cells)})


class TransformPart(PartType[Part, CellMatrix, SymbolicMatrix]):
    """⁰T_N in closed form."""

    kind = "transform"
    raw: ClassVar = CellMatrix
    meaning = "⁰T_N in closed form"
    follows_table = True
    disclosures: ClassVar = {
        **told_from(HelpLevel.ROW, "transform_rotation_right", "transform_position_right"),
        **told_from(HelpLevel.KIND, "transform_cells_wrong", "transform_not_rigid"),
        **told_from(
            HelpLevel.REPAIR,
            "transform_inverse",
            "transform_rotation_transposed",
            "transform_order_reversed",
            "transform_links_missing",
            instead="transform_cells_wrong",
        ),
    }

    def read(self, raw: CellMatrix, reading: Reading) -> SymbolicMatrix | None:
        """Return the matrix in expressions."""
        return read_known_matrix(raw, reading)

    def grade(self, part: Part, answer: SymbolicMatrix, context: Context) -> PartReport:
        """Judge by the student's own table, then as the robot's; rotation and position count half."""
        compared = compare(context, answer, _own(context)) if context.own is not None else None
        follows = compared is not None and compared.right
        if follows and context.own_correct:
            return judged(part, 1.0, Credit.KEY, feedback=[Feedback(code="transform_right")])
        if transform_is_robot(context, answer):
            code = "transform_right_not_from_table" if context.own is not None else "transform_right"
            return judged(part, 1.0, Credit.KEY, feedback=[Feedback(code=code)])
        if follows:
            return judged(part, 1.0, Credit.OWN_TABLE, feedback=[Feedback(code="transform_follows_table")])
        if compared is None:
            return judged(part, 0.0, Credit.NONE, feedback=[Feedback(code="transform_wrong")])
        return _wrong(context, compared, part)

    def right(self, part: Part, context: Context) -> CellMatrix:
        """Return ⁰T_N of the student's own table."""
        assert context.own is not None
        form = context.own_form
        return write_matrix(form.transform, context.own.table.n_joints, tuple(context.own.parameters))

    def wrong(self, part: Part, context: Context, rng: Random) -> Iterator[tuple[str, CellMatrix]]:
        """Yield the matrix with its rotation transposed, unless that is right in other frames."""
        turned = transposed_cells(self.right(part, context))
        if turned is None or reads_as_robot(context, (turned,)):
            return
        asked = context.instance.exercise.part(TABLE) is not None
        yield "transform_rotation_transposed" if asked else "transform_wrong", turned


PART = TransformPart()
