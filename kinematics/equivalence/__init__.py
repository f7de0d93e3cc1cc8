"""When are two DH tables the same robot? The decision, with a certificate or the first mismatch."""

from kinematics.equivalence.policy import (
    BaseRule,
    ConventionRule,
    DirectionRule,
    Policy,
    Tolerance,
    ToolRule,
    ZeroRule,
)

__all__ = ["BaseRule", "ConventionRule", "DirectionRule", "Policy", "Tolerance", "ToolRule", "ZeroRule"]
