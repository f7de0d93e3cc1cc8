"""The certificate as the verdict shows it: in the submission's units, and in closed form if it was proved."""

import math
from collections.abc import Mapping, Sequence

from exercises.grading.judging.comparison import Comparison
from exercises.grading.judging.exact_text import angle_text, expression_text
from exercises.grading.verdict import CertificateReport, ExactForms, Matrix4
from kinematics.cells import AngleUnit, ParameterKind, ReadTable
from kinematics.equivalence import Certificate, ExactCertificate
from kinematics.se3 import Transform
from kinematics.table import JointType


def certificate_report(
    certificate: Certificate, exact: ExactCertificate | None, comparison: Comparison, submission: ReadTable
) -> CertificateReport:
    """Return the certificate in the submission's units, at the first draw of the parameters."""
    types = comparison.reference.joint_types
    return CertificateReport(
        joint_signs=certificate.joint_signs,
        joint_offsets=tuple(
            in_unit(offset, joint, submission.angle_unit)
            for offset, joint in zip(certificate.joint_offsets, types, strict=True)
        ),
        base=_matrix(certificate.base),
        tool=_matrix(certificate.tool),
        exact=None if exact is None else _exact(exact, types, submission.angle_unit),
        parameters=_parameters(comparison.draws[0], submission),
        residual=certificate.residual,
        samples=certificate.samples,
    )


def in_unit(offset: float, joint: JointType, unit: AngleUnit) -> float:
    """Return a joint offset in the unit in which the joint's variable is given."""
    return math.degrees(offset) if joint is JointType.REVOLUTE and unit is AngleUnit.DEG else offset


def _parameters(draw: Mapping[str, float], submission: ReadTable) -> dict[str, float]:
    """The values in the submission's units."""
    degrees = submission.angle_unit is AngleUnit.DEG
    return {
        name: math.degrees(value)
        if degrees and submission.parameters.get(name) is ParameterKind.ANGLE
        else value
        for name, value in draw.items()
    }


def _matrix(transform: Transform) -> Matrix4:
    return tuple(tuple(0.0 if entry == 0.0 else entry for entry in row) for row in transform.tolist())


def _exact(exact: ExactCertificate, types: Sequence[JointType], unit: AngleUnit) -> ExactForms:
    return ExactForms(
        joint_offsets=tuple(
            angle_text(offset, unit) if joint is JointType.REVOLUTE else expression_text(offset)
            for offset, joint in zip(exact.joint_offsets, types, strict=True)
        ),
        base=tuple(tuple(expression_text(entry) for entry in row) for row in exact.base),
        tool=tuple(tuple(expression_text(entry) for entry in row) for row in exact.tool),
    )
