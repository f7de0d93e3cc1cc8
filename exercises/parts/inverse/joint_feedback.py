"""What a student is told of joint values."""

from __future__ import annotations

from collections.abc import Iterator

from exercises.grading import Feedback
from kinematics.answers.joint_verdicts import JointAnswer, JointClaim, JointVerdict, RowVerdict


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


def _slip(i: int, row: RowVerdict) -> Feedback:
    """Return what to say of a wrong row, counted from 1."""
    if row.mistake is None:
        return Feedback(code="joints_wrong", params={"row": i})
    params = {"row": i, "joint": row.joint or 0}
    if row.other is not None:
        params["other"] = row.other + 1
    return Feedback(code=f"joints_{row.mistake.value}", params=params)
