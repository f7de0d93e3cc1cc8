"""Grading: from two tables and a policy to a verdict.

grade(reference: ReadTable, submission: ReadTable, policy: Policy,
      parameters: Mapping[str, float] | None, help_level: HelpLevel) -> Verdict
"""

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
]
