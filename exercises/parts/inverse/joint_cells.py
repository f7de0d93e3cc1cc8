"""Joint values as students write them, and right ones in that form."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Annotated

from exercises.instance import Instance
from exercises.parts.cells.number_cells import DECIMALS
from exercises.parts.protocol import Length
from kinematics.answers.joint_verdicts import JointAnswer, JointClaim
from kinematics.cells import AngleUnit, Cell
from kinematics.table import JointType

MOST_ROWS = 20
"""Configurations in an answer: an arm of six joints has sixteen at most."""
ConfigurationRow = Annotated[tuple[Cell, ...], Length(least=1, most=12)]


@dataclass(frozen=True, kw_only=True, slots=True)
class JointAnswerCells:
    """Joint values that reach a pose.

    Attributes:
        claim: finite (the rows are the solutions), infinite (infinitely many, the rows are some),
            out_of_reach or joint_limits (none, because …).
        solutions: rows of joint values q1 … qn.
        combinations: of infinitely many solutions, which combinations stay the same along them: rows of
            coefficients of q1 … qn, such as 0 0 0 1 0 1 where only q4 + q6 counts.
    """

    claim: JointClaim
    solutions: Annotated[tuple[ConfigurationRow, ...], Length(least=0, most=MOST_ROWS)] = ()
    combinations: Annotated[tuple[ConfigurationRow, ...], Length(least=0, most=4)] = ()


def kept_combination(direction: tuple[float, ...]) -> tuple[float, ...] | None:
    """Return the coefficients that a straight family of two joints keeps; None of other families."""
    moving = [i for i, rate in enumerate(direction) if abs(rate) > 1e-9]
    if len(moving) != 2:
        return None
    i, k = moving
    return tuple(direction[k] if j == i else -direction[i] if j == k else 0.0 for j in range(len(direction)))


def written_answer(answer: JointAnswer, instance: Instance) -> JointAnswerCells:
    """Return an answer in the exercise's units, rounded as on paper."""
    degrees = instance.exercise.angle_unit is AngleUnit.DEG
    types = instance.exercise.reference.table.joint_types
    rows = tuple(
        tuple(
            round(math.degrees(value) if degrees and kind is JointType.REVOLUTE else value, DECIMALS)
            for value, kind in zip(row, types, strict=True)
        )
        for row in answer.rows
    )
    return JointAnswerCells(claim=answer.claim, solutions=rows, combinations=answer.combinations)
