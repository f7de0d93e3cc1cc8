"""What a decision says: a certificate, or what does not fit."""

from dataclasses import dataclass
from enum import StrEnum

from kinematics.equivalence.certificates import CertificateCandidate
from kinematics.se3 import Transform


class Kind(StrEnum):
    """What kind of fact does not fit.

    PRECISION: none by itself, but their small errors add up to more than the tolerance.
    """

    JOINT_COUNT = "joint_count"
    JOINT_TYPE = "joint_type"
    TWIST = "twist"
    LENGTH = "length"
    OFFSET = "offset"
    HANDEDNESS = "handedness"
    CONVENTION = "convention"
    BASE = "base"
    TOOL = "tool"
    ZERO = "zero"
    DIRECTION = "direction"
    PRECISION = "precision"


@dataclass(frozen=True, kw_only=True, slots=True)
class Certificate:
    """(σ, δ, B, E) with F_s(σ∘q + δ) = B · F_r(q) · E, verified.

    Attributes:
        joint_signs: σ_1 … σ_n.
        joint_offsets: δ_1 … δ_n [rad, or a length for a prismatic joint].
        base: (4, 4) B.
        tool: (4, 4) E.
        residual: the larger of the largest rotation [rad] and the largest displacement relative to the
            robot's size that were found: of a decision at the samples and climbing from these.
        samples: number of configurations compared, over all parameter draws.
        draws: the same for every parameter draw; the first one is the one above.
    """

    joint_signs: tuple[int, ...]
    joint_offsets: tuple[float, ...]
    base: Transform
    tool: Transform
    residual: float
    samples: int
    draws: tuple[CertificateCandidate, ...]


@dataclass(frozen=True, kw_only=True, slots=True)
class Mismatch:
    """One fact that does not fit.

    Attributes:
        kind: what kind of fact.
        joint: the joint at which it shows, counted from 1: for twist and length the later of the link's two
            joints, for an offset the joint along (or, if prismatic, about) whose axis it is measured.
        row: the row of the submission that holds the fact, counted from 0; None if no single row does.
        angle: how far off, if it is an angle [rad].
        length: how far off, if it is a length.
    """

    kind: Kind
    joint: int | None = None
    row: int | None = None
    angle: float = 0.0
    length: float = 0.0


@dataclass(frozen=True, kw_only=True, slots=True)
class Decision:
    """Whether a submission describes the reference robot and keeps the policy.

    Attributes:
        mismatches: if it does not, what does not fit, base first.
        same_robot: it describes the reference robot, whether or not it keeps the policy.
    """

    certificate: Certificate | None
    mismatches: tuple[Mismatch, ...]
    same_robot: bool

    @property
    def accepted(self) -> bool:
        """There is a certificate."""
        return self.certificate is not None
