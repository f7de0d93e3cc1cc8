"""Frame assignment between the wire and the domain."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from kinematics.errors import Fault
from kinematics.frames.assignment import assign_frames
from kinematics.frames.axes import Gripper
from kinematics.frames.rules import FrameFinding
from kinematics.frames.trainer import JudgedFrame, check_frames
from kinematics.se3 import Transform
from service.schemas.kinematics.frame_assignment_models import (
    AssignFramesAnswer,
    AssignFramesRequest,
    AxesQuestion,
    Broken,
    CheckFramesAnswer,
    CheckFramesRequest,
    Choices,
    FoundRow,
    Frame,
    GripperTool,
    JudgedFrameModel,
    Remark,
)
from service.schemas.tables import AnsweredTable
from service.wire.kinematics.pose_matrices import pose_matrix
from service.wire.kinematics.written_tables import numeric_row, numeric_table

Say = Callable[[str, dict[str, object]], str]


def assigned(request: AssignFramesRequest, say: Say) -> AssignFramesAnswer:
    """Return the frames and the table for the axes of a request.

    Raises:
        DescriptionError: malformed axes, frames or tolerance.
        PoseError: base or tool is no rigid motion.
    """
    result = assign_frames(
        [axis.axis() for axis in request.axes],
        request.convention,
        **_ends(request),
        parallel_tolerance=request.parallel_tolerance,
        near_parallel=request.near_parallel,
        lengths=request.lengths,
        intersecting=request.intersecting,
    )
    table = numeric_table(result.table, request.angle_unit, request.length_unit)
    return AssignFramesAnswer(
        angle_unit=request.angle_unit.value,
        length_unit=request.length_unit.value,
        table=AnsweredTable.model_validate(table),
        base=result.base.tolist(),
        tool=result.tool.tolist(),
        frames=[Frame.from_record(frame) for frame in result.frames],
        warnings=[_remark(warning, say) for warning in result.warnings],
    )


def checked(request: CheckFramesRequest, say: Say) -> CheckFramesAnswer:
    """Return what the rules say of a student's frames.

    Raises:
        DescriptionError: malformed axes or frames.
        PoseError: base or tool is no rigid motion.
    """
    judged = check_frames(
        [axis.axis() for axis in request.axes],
        request.convention,
        [None if chosen is None else chosen.frame() for chosen in request.frames],
        **_ends(request),
    )
    units = request.angle_unit, request.length_unit
    rows = [row and numeric_row(row, i, request.angle_unit) for i, row in enumerate(judged.rows, 1)]
    return CheckFramesAnswer(
        angle_unit=units[0].value,
        length_unit=units[1].value,
        frames=[_judged(frame, say) for frame in judged.frames],
        rows=[FoundRow.model_validate(row, strict=False) if row else None for row in rows],
        table=AnsweredTable.model_validate(numeric_table(judged.table, *units)) if judged.table else None,
        base=_matrix(judged.base),
        tool=_matrix(judged.tool),
    )


def _ends(request: AxesQuestion) -> dict[str, Any]:
    """Base and tool as the domain takes them."""
    angle = request.angle_unit.radians
    base, tool = request.base, request.tool
    held = tool.gripper() if isinstance(tool, GripperTool) else tool
    return {
        "base": base if base is None else pose_matrix(base, angle, "base"),
        "tool": held if held is None or isinstance(held, Gripper) else pose_matrix(held, angle, "tool"),
    }


def _matrix(transform: Transform | None) -> list[list[float]] | None:
    return None if transform is None else transform.tolist()


def _remark(warning: Fault, say: Say) -> Remark:
    return Remark(code=warning.code, message=say(f"error-{warning.code}", dict(warning.params)))


def _judged(frame: JudgedFrame, say: Say) -> JudgedFrameModel:
    return JudgedFrameModel(
        index=frame.index,
        complete=frame.complete,
        findings=[_broken(finding, say) for finding in frame.findings],
        candidates=Choices.from_record(frame.candidates),
    )


def _broken(finding: FrameFinding, say: Say) -> Broken:
    params = dict(finding.params)
    return Broken(
        rule=finding.rule,
        part=finding.part,
        severity=finding.severity,
        params=params,
        message=say(f"rule-{finding.rule.value}", {**params}),
    )
