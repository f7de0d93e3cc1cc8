"""A robot with weights, equations of motion that somebody wrote about it, and what is said of them."""

from collections.abc import Mapping
from dataclasses import dataclass, field
from enum import StrEnum
from functools import cached_property, lru_cache

from kinematics.answers.left_open import Rounded
from kinematics.dynamics import Derivation, SymbolicBody
from kinematics.expressions import Expression
from kinematics.symbolic import Matrix, ProofStatus
from kinematics.table import SymbolicTable

derived = lru_cache(maxsize=64)(Derivation)
"""The equations of a table, its links and a gravity; arms of an exercise come back."""


class DynamicsMistake(StrEnum):
    """What a wrong answer looks like.

    ASYMMETRIC: M is not symmetric. POINT_MASSES: M without the links' own moments of inertia. GRAVITY_SIGN: g
    pulls the other way. VELOCITY_SIGN: C q̇ has the other sign. COUPLING_ONCE: products q̇_j q̇_k of two joints
    count once, not twice. MASS_RATE: Ṁ q̇ is taken for C q̇: the gradient of the kinetic energy is missing.
    """

    ASYMMETRIC = "asymmetric"
    POINT_MASSES = "point_masses"
    GRAVITY_SIGN = "gravity_sign"
    VELOCITY_SIGN = "velocity_sign"
    COUPLING_ONCE = "coupling_once"
    MASS_RATE = "mass_rate"


@dataclass(frozen=True, kw_only=True, eq=False)
class DynamicsQuestion:
    """A robot with weights.

    Attributes:
        links: what moves with frame 1 … N.
        gravity: acceleration of free fall in frame 0.
        values: of every name in these.
    """

    table: SymbolicTable
    links: tuple[SymbolicBody, ...]
    gravity: tuple[Expression, Expression, Expression]
    values: Mapping[str, float]

    @cached_property
    def equations(self) -> Derivation:
        """M, C q̇, g and Ṁ in closed form."""
        return derived(self.table, self.links, self.gravity)


@dataclass(frozen=True, kw_only=True, eq=False)
class EquationsAnswer:
    """Equations of motion as functions of q1 … qn and dq1 … dqn; None of what was not answered.

    Attributes:
        mass: n×n, M.
        coriolis: n×n, some C.
        velocity: n, C q̇.
        gravity: n, g.
        rounded: of entries with names and decimals. Where nothing is said of an entry, the tolerance holds
            alone.
    """

    mass: Matrix | None = None
    coriolis: Matrix | None = None
    velocity: tuple[Expression, ...] | None = None
    gravity: tuple[Expression, ...] | None = None
    rounded: Rounded = field(default_factory=dict)


@dataclass(frozen=True, kw_only=True, eq=False)
class DynamicsVerdict:
    """What is said of an answer; None of what was not answered.

    Attributes:
        mass: n×n which entries of M are right.
        velocity: which rows of C q̇ are right, of C and of C q̇ itself where both were given.
        skew: whether Ṁ − 2C is skew-symmetric, M being the robot's; None without C.
        gravity: which entries of g are right.
        proof: PROVED: all of it is equal as functions; UNDECIDED: some was compared at samples only; REFUTED:
            some differs.
        mistakes: what wrong parts look like.
    """

    mass: tuple[tuple[bool, ...], ...] | None
    velocity: tuple[bool, ...] | None
    skew: bool | None
    gravity: tuple[bool, ...] | None
    proof: ProofStatus
    mistakes: tuple[DynamicsMistake, ...]

    @property
    def right(self) -> bool:
        """Everything that was answered is right, whether or not Ṁ − 2C is skew-symmetric."""
        return all(all(row) for row in (*(self.mass or ()), self.velocity or (), self.gravity or ()))
