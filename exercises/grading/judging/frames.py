"""How the frames of a right answer differ from the key's, so that a right answer teaches, too."""

import math
import re
from collections.abc import Iterator, Set
from dataclasses import dataclass

from exercises.grading.judging.certificate_report import in_unit
from exercises.grading.judging.exact_text import angle_text, expression_text
from exercises.grading.verdict import Feedback, ParamValue
from kinematics.cells import AngleUnit
from kinematics.chain import frames_at_zero
from kinematics.equivalence import Certificate, ExactCertificate
from kinematics.equivalence.reference import prepared, prepared_for
from kinematics.se3 import Motion, compose, from_matrix, inverse, position, rotation_about, scale, translation
from kinematics.table import Convention, JointType, NumericTable

NOTICED = 1e-3  # [rad], and a share of the robot: smaller differences of frames are not told.
NOTICED_IF_ROUNDED = 0.02  # The same, where rounded entries turn and move frames by a little of their own.
# Of a residual: above it an answer was right only because of rounding.
ROUNDED = 1e-8
OF_VARIABLES = {"variable_reversed", "variable_offset"}
_NUMBER = re.compile(r"-?[\d.]+")


def explained(
    key: NumericTable,
    answer: NumericTable,
    certificate: Certificate,
    exact: ExactCertificate | None,
    unit: AngleUnit,
) -> tuple[Feedback, ...]:
    """Return what to say of a right answer.

    Args:
        key: the key, in the answer's length unit.
        answer: the answer.
        certificate: how they agree, at the same parameter values.
        exact: the same in closed form, if it was proved.
        unit: the answer's angle unit.
    """
    told: list[Feedback] = []
    noticed = _Noticed.beside(key, answer, certificate)
    if answer.convention is not key.convention:
        told.append(Feedback(code="other_convention", params={"convention": answer.convention.value}))
    if _same_layout(key, answer):
        told += _frames(key, answer, certificate, noticed)
        elsewhere = {said.params["frame"] for said in told}
        told += _variables(elsewhere, key, answer, certificate, exact, unit, noticed)
    else:
        told += _joints(key, answer, certificate)
        told += _zeros(answer, certificate, exact, unit, noticed)
        told += _ends(key, answer, certificate, noticed)
        told += _between(key, answer, certificate, noticed)
    if all(said.code in OF_VARIABLES for said in told):
        told.insert(0, Feedback(code="same_frames"))
    if certificate.residual > ROUNDED:
        told.append(Feedback(code="rounded"))
    return tuple(told)


@dataclass(frozen=True, slots=True)
class _Noticed:
    """From where on a difference is told; rounded entries turn and move frames by a little of their own.

    Attributes:
        angle: [rad].
        length: in the answer's length unit.
    """

    angle: float
    length: float

    @classmethod
    def beside(cls, key: NumericTable, answer: NumericTable, certificate: Certificate) -> "_Noticed":
        share = NOTICED if certificate.residual <= ROUNDED else NOTICED_IF_ROUNDED
        return cls(share, share * prepared_for(key, answer).size)


def _same_layout(key: NumericTable, answer: NumericTable) -> bool:
    """Whether frame k of the one corresponds to frame k of the other."""
    return key.convention is answer.convention and [row.joint for row in key.rows] == [
        row.joint for row in answer.rows
    ]


def _body_motions(key: NumericTable, certificate: Certificate) -> list[Motion]:
    """g_0 … g_n: what takes each link of the answer at its zero to the key's link at its own."""
    g = inverse(from_matrix(certificate.base))
    motions = [g]
    for axis, sign, offset in zip(
        prepared(key).chain.axes, certificate.joint_signs, certificate.joint_offsets, strict=True
    ):
        value = sign * offset
        if axis.prismatic:
            step = translation(scale(axis.direction, value))
        else:
            step = rotation_about(axis.point, axis.direction, math.cos(value), math.sin(value))
        g = compose(step, g)
        motions.append(g)
    return motions


def _frames(
    key: NumericTable, answer: NumericTable, certificate: Certificate, noticed: _Noticed
) -> Iterator[Feedback]:
    """Frame by frame: z reversed, x turned, origin elsewhere."""
    motions = _body_motions(key, certificate)
    ours, theirs = frames_at_zero(key), frames_at_zero(answer)
    body = 0
    for k in range(len(ours)):
        if k and key.rows[k - 1].joint is not JointType.FIXED:
            body += 1
        apart = compose(compose(inverse(ours[k]), motions[body]), theirs[k])
        yield from _apart(apart, k, _joint_of_axis(answer, k), noticed)


def _variables(
    elsewhere: Set[ParamValue],
    key: NumericTable,
    answer: NumericTable,
    certificate: Certificate,
    exact: ExactCertificate | None,
    unit: AngleUnit,
    noticed: _Noticed,
) -> Iterator[Feedback]:
    """Joint by joint, where frames correspond: the variable counts from elsewhere, or the other way.

    Beside a frame that is `elsewhere`, by its number, the variable's zero follows from what is told of that.
    """
    of_joints = (
        *_joints(key, answer, certificate),
        *_zeros(answer, certificate, exact, unit, noticed),
    )
    for said in of_joints:
        if (
            said.code in OF_VARIABLES
            and said.row is not None
            and elsewhere.isdisjoint({said.row - 1, said.row})
        ):
            yield said


def _ends(
    key: NumericTable, answer: NumericTable, certificate: Certificate, noticed: _Noticed
) -> Iterator[Feedback]:
    """Frame 0 and the last frame, which correspond whatever lies between; z of a joint is `_joints`'."""
    motions = _body_motions(key, certificate)
    ours, theirs = frames_at_zero(key), frames_at_zero(answer)
    for k, end in ((0, 0), (len(answer.rows), -1)):
        apart = compose(compose(inverse(ours[end]), motions[end]), theirs[end])
        joint = _joint_of_axis(answer, k)
        yield from (said for said in _apart(apart, k, joint, noticed) if said.code != "axis_reversed")


def _between(
    key: NumericTable, answer: NumericTable, certificate: Certificate, noticed: _Noticed
) -> Iterator[Feedback]:
    """Frames of one convention on joint axes, without the ends; z and x of a joint are told elsewhere."""
    if answer.convention is not key.convention:
        return
    motions, behind = _body_motions(key, certificate), key.convention is Convention.MODIFIED
    ours, theirs = frames_at_zero(key), frames_at_zero(answer)
    for i, (mine, k) in enumerate(zip(key.axis_frames, answer.axis_frames, strict=True)):
        if 0 < k < len(answer.rows):
            apart = compose(compose(inverse(ours[mine]), motions[i + behind]), theirs[k])
            told = _apart(apart, k, i + 1, noticed)
            yield from (said for said in told if said.code in ("axis_moved", "origin_slid"))


def _joint_of_axis(table: NumericTable, k: int) -> int | None:
    """The joint, counted from 1, whose axis is z_k; None if no joint's is."""
    return table.axis_frames.index(k) + 1 if k in table.axis_frames else None


def _apart(apart: Motion, k: int, joint: int | None, noticed: _Noticed) -> Iterator[Feedback]:
    """What tells the answer's frame k from the key's, in the coordinates of the key's."""
    row = k or None
    params: dict[str, ParamValue] = {"frame": k}
    x, y, z = position(apart)
    if math.hypot(apart[2], apart[5]) > noticed.angle:
        yield Feedback(code="frame_elsewhere", row=row, params=params)
        return
    if apart[8] < 0.0 and joint is None:
        yield Feedback(code="end_axis_reversed", row=row, params=params)
    elif apart[8] < 0.0 and joint is not None:
        yield Feedback(code="axis_reversed", row=row, params={**params, "joint": joint})
    turned = math.degrees(math.atan2(apart[3], apart[0]))
    if abs(turned) > math.degrees(noticed.angle):
        yield Feedback(code="x_turned", row=row, params={**params, "degrees": _whole(abs(turned))})
    if math.hypot(x, y) > noticed.length:
        yield Feedback(code="axis_moved", row=row, params=params)
    elif abs(z) > noticed.length:
        yield Feedback(code="origin_slid", row=row, params=params)


def _whole(value: float) -> float | int:
    nearest = round(value)
    return nearest if abs(value - nearest) < 0.05 else round(value, 1)


def _joints(key: NumericTable, answer: NumericTable, certificate: Certificate) -> Iterator[Feedback]:
    """Joint by joint: the axis or the variable points the other way.

    A joint moves by s·q about its z. With q_s = σ q + δ the same motion is s_s σ about z_s and s about z:
    z_s = σ s_s s z.
    """
    for i, sign in enumerate(certificate.joint_signs):
        row = answer.joint_rows[i]
        if sign * answer.rows[row].sign * key.rows[key.joint_rows[i]].sign < 0:
            params: dict[str, ParamValue] = {"frame": answer.axis_frames[i], "joint": i + 1}
            yield Feedback(code="axis_reversed", row=answer.axis_frames[i] or None, params=params)
        elif sign < 0:
            yield Feedback(code="variable_reversed", row=row + 1, params={"joint": i + 1})


def _zeros(
    answer: NumericTable,
    certificate: Certificate,
    exact: ExactCertificate | None,
    unit: AngleUnit,
    noticed: _Noticed,
) -> Iterator[Feedback]:
    """Joint by joint: the variable is zero elsewhere."""
    for i, offset in enumerate(certificate.joint_offsets):
        joint = answer.joint_types[i]
        limit = noticed.angle if joint is JointType.REVOLUTE else noticed.length
        if abs(offset) <= limit:
            continue
        if exact is None:
            text = f"{in_unit(offset, joint, unit):.4g}"
        elif joint is JointType.REVOLUTE:
            text = angle_text(exact.joint_offsets[i], unit)
        else:
            text = expression_text(exact.joint_offsets[i])
        if joint is JointType.REVOLUTE and unit is AngleUnit.DEG:
            text = f"{text}°" if _NUMBER.fullmatch(text) else f"({text})°"
        params: dict[str, ParamValue] = {"joint": i + 1, "offset": text}
        yield Feedback(code="variable_offset", row=answer.joint_rows[i] + 1, params=params)
