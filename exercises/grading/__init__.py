"""Grading: from two tables and a policy to a verdict; see `grade`.

grade            the whole of it
verdict          what is said of a table; `verdict_html` in notebooks
judging          is it right?
edits            what is wrong?
explanation      what is told, and what is earned
idle_rows        fixed rows of zeros, which are left out
coarse           is it right, but rounded too much?
findings         what is said, by level of help
facts, score     which facts of the robot are right, and what they earn
axis_directions  which way its axes point
alignments       which links and joints of an answer are compared with which of the key
one_twist        all that is wrong is one twist
standard         what they are worth
across_prismatic   which facts go together
"""

from exercises.grading.grade import accept, grade, is_accepted
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
    "is_accepted",
]
