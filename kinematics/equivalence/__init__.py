"""When are two DH tables the same robot? The decision, with a certificate or what does not fit.

`policy` says what is asked, `decision` decides it, `proof` turns a verified certificate into a proved one.
The theory stands in docs/checker.md; `chains`, `groups`, `plan`, `alignment`, `search`, `certificates`,
`verification`, `worst_case` and `refinement` are its steps, `diagnosis` what follows when a step fails.
"""

from kinematics.equivalence.decision import decide, decide_draws, mirrored
from kinematics.equivalence.policy import (
    BaseRule,
    ConventionRule,
    DirectionRule,
    Policy,
    Tolerance,
    ToolRule,
    ZeroRule,
)
from kinematics.equivalence.proof import ExactCertificate, prove
from kinematics.equivalence.results import Certificate, Decision, Kind, Mismatch
from kinematics.equivalence.rounding import rounding_tolerance

__all__ = [
    "BaseRule",
    "Certificate",
    "ConventionRule",
    "Decision",
    "DirectionRule",
    "ExactCertificate",
    "Kind",
    "Mismatch",
    "Policy",
    "Tolerance",
    "ToolRule",
    "ZeroRule",
    "decide",
    "decide_draws",
    "mirrored",
    "prove",
    "rounding_tolerance",
]
