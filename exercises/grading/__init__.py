"""Grading: from two tables and a policy to a verdict; see `grade`."""

from exercises.grading.grade import accept, grade
from exercises.grading.verdict import (
    Basis,
    CertificateReport,
    Edit,
    ExactForms,
    Feedback,
    Finding,
    HelpLevel,
    LinkFinding,
    Repair,
    Verdict,
)
from kinematics.equivalence import (
    BaseRule,
    ConventionRule,
    DirectionRule,
    Policy,
    Tolerance,
    ToolRule,
    ZeroRule,
)

__all__ = [
    "BaseRule",
    "Basis",
    "CertificateReport",
    "ConventionRule",
    "DirectionRule",
    "Edit",
    "ExactForms",
    "Feedback",
    "Finding",
    "HelpLevel",
    "LinkFinding",
    "Policy",
    "Repair",
    "Tolerance",
    "ToolRule",
    "Verdict",
    "ZeroRule",
    "accept",
    "grade",
]
