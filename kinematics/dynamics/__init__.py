"""How forces move a robot: M(q) q̈ + C(q, q̇) q̇ + g(q) = τ, in numbers and in closed form.

`recursion` computes, `equations` derives; `links` says what a link weighs. Everything is in SI units.
"""

from kinematics.dynamics.equations import Derivation, EquationsOfMotion, rate_name, reading_order
from kinematics.dynamics.links import (
    MASSLESS,
    NumericBody,
    RigidBody,
    SymbolicBody,
    bind_links,
    check_links,
)
from kinematics.dynamics.recursion import EARTH, MovingRobot

__all__ = [
    "EARTH",
    "MASSLESS",
    "Derivation",
    "EquationsOfMotion",
    "MovingRobot",
    "NumericBody",
    "RigidBody",
    "SymbolicBody",
    "bind_links",
    "check_links",
    "rate_name",
    "reading_order",
]
