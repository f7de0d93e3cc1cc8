"""Joint values as students write them, right ones in that form, and what a student is told of them."""

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Annotated

from exercises.grading import Feedback
from exercises.instance import Instance
from exercises.parts.cells.number_cells import DECIMALS
from exercises.parts.protocol import Length
from kinematics.answers.joint_verdicts import JointAnswer, JointClaim, JointVerdict, RowVerdict
from kinematics.cells import Cell
from kinematics.table import JointType

MOST_ROWS = 20  # Configurations in an answer: an arm of six joints has sixteen at most.
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
    unit = instance.exercise.angle_unit
    types = instance.exercise.reference.table.joint_types
    rows = tuple(
        tuple(
            round(unit.from_radians(value) if kind is JointType.REVOLUTE else value, DECIMALS)
            for value, kind in zip(row, types, strict=True)
        )
        for row in answer.rows
    )
    return JointAnswerCells(claim=answer.claim, solutions=rows, combinations=answer.combinations)


def joint_feedback(found: JointVerdict, answer: JointAnswer) -> Iterator[Feedback]:
    """Yield what to say of an answer, the most important first."""
    if found.right:
        yield Feedback(code="joints_right")
        if not found.complete:
            yield Feedback(code="joints_searched")
        return
    if answer.claim is not found.expected:
        yield Feedback(code="claim_wrong")
    seen: dict[int, int] = {}
    for i, row in enumerate(found.rows, 1):
        if not row.right:
            yield _slip(i, row)
        elif row.solution in seen and found.expected is JointClaim.FINITE:
            yield Feedback(code="joints_twice", params={"row": i, "other": seen[row.solution]})
        elif row.solution is not None:
            seen[row.solution] = i
    if found.missing:
        yield Feedback(code="joints_missing", params={"count": len(found.missing)})
        for branch in dict.fromkeys(found.missing) if seen else ():
            yield Feedback(code=f"branch_{branch.value}", params={"count": found.missing.count(branch)})
    if found.combination_missing:
        yield Feedback(code="joints_family_missing")
    for i, holds in enumerate(found.combinations, 1):
        if not holds:
            loose = "loose" if found.loose[i - 1] else "wrong"
            says = loose if any(answer.combinations[i - 1]) else "zero"
            yield Feedback(code=f"joints_combination_{says}", params={"row": i})
    says_some = answer.claim in (JointClaim.FINITE, JointClaim.INFINITE)
    if not found.share and says_some and any(row.right for row in found.rows):
        yield Feedback(code="joints_taken_off")


def _slip(i: int, row: RowVerdict) -> Feedback:
    """Return what to say of a wrong row, counted from 1."""
    if row.mistake is None:
        return Feedback(code="joints_wrong", params={"row": i})
    params = {"row": i, "joint": row.joint or 0}
    if row.other is not None:
        params["other"] = row.other + 1
    return Feedback(code=f"joints_{row.mistake.value}", params=params)
