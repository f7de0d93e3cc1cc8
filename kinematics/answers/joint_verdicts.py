"""What is said of joint values, and what an answer says: claims, rows, branches and slips."""

from collections.abc import Sequence
from dataclasses import dataclass
from enum import StrEnum


class JointClaim(StrEnum):
    """What an answer says of a pose.

    FINITE: the rows are its solutions. INFINITE: there are infinitely many, and the rows are members of them.
    OUT_OF_REACH: none, for the pose is too far or too near. JOINT_LIMITS: none within the joints' limits.
    """

    FINITE = "finite"
    INFINITE = "infinite"
    OUT_OF_REACH = "out_of_reach"
    JOINT_LIMITS = "joint_limits"


class Branch(StrEnum):
    """How a missing solution differs from the nearest one that was found.

    SHOULDER: the arm reaches backwards. ELBOW: the elbow bends the other way. WRIST: the wrist is flipped.
    OTHER: otherwise.
    """

    SHOULDER = "shoulder"
    ELBOW = "elbow"
    WRIST = "wrist"
    OTHER = "other"


class JointMistake(StrEnum):
    """What a wrong row of joint values is.

    QUADRANT: one joint is half a turn off, as atan gives it for atan2. SIGN: one joint turns the wrong way.
    DEGREES: degrees were taken for radians or the reverse. SWAPPED: one joint is π/2 − q, the arguments of
    atan2 exchanged. HALF_BRANCH: another row with one joint turned over, and the joints that go with it
    left as they were. POSITION_ONLY: the position is reached and the orientation is not. ORIENTATION_ONLY:
    the reverse. LIMITS: the pose is reached beyond a joint's limit. ROUNDED: close to a solution.
    """

    QUADRANT = "quadrant"
    SIGN = "sign"
    DEGREES = "degrees"
    SWAPPED = "swapped"
    HALF_BRANCH = "half_branch"
    POSITION_ONLY = "position_only"
    ORIENTATION_ONLY = "orientation_only"
    LIMITS = "limits"
    ROUNDED = "rounded"


@dataclass(frozen=True, kw_only=True, slots=True)
class JointAnswer:
    """An answer, in the variables and the frames of the arm that it is judged by.

    Attributes:
        claim: what it says of the pose.
        rows: configurations [rad, or the table's length].
        combinations: coefficients c of combinations c·q that are fixed along a family.
        signs: σ of the answerer's own variables σ∘q + δ; empty if these are the arm's.
        offsets: δ of them [rad, or the table's length].
    """

    claim: JointClaim
    rows: tuple[tuple[float, ...], ...] = ()
    combinations: tuple[tuple[float, ...], ...] = ()
    signs: tuple[int, ...] = ()
    offsets: tuple[float, ...] = ()

    def own(self, row: Sequence[float]) -> tuple[float, ...]:
        """Return a row in the answerer's own variables."""
        if not self.signs:
            return tuple(row)
        return tuple(s * q + d for s, q, d in zip(self.signs, row, self.offsets, strict=True))

    def of_own(self, row: Sequence[float]) -> tuple[float, ...]:
        """Return a row of the answerer's own variables in those of the arm: q = σ∘(q_s − δ)."""
        if not self.signs:
            return tuple(row)
        return tuple(s * (q - d) for s, q, d in zip(self.signs, row, self.offsets, strict=True))


@dataclass(frozen=True, kw_only=True, slots=True)
class RowVerdict:
    """What is said of one row.

    Attributes:
        right: it reaches the target within the limits.
        solution: which solution it is, an index into the complete set; of a wrong row the one that it is
            without its slip, or None.
        joint: the joint, counted from 1, that a mistake is about.
        mistake: what a wrong row is, if a usual slip explains it.
        other: index of the right row that a half branch was made of.
    """

    right: bool
    solution: int | None = None
    joint: int | None = None
    mistake: JointMistake | None = None
    other: int | None = None


@dataclass(frozen=True, kw_only=True, slots=True)
class JointVerdict:
    """What is said of an answer.

    Attributes:
        right: everything that was asked is there, and nothing is wrong.
        share: of what was asked, 0 … 1.
        expected: what is true of the pose.
        rows: on each row.
        missing: how each solution without a row, right or with a slip, differs from the nearest one found.
        combination_missing: a family has a member, but not its condition.
        combinations: which of the combinations hold along a family.
        loose: which of the others are fixed along every family, but do not say which configurations belong
            to it, nor does any other one; beside one that does they hold.
        complete: the solutions are known to be all; false: all that a search found.
    """

    right: bool
    share: float
    expected: JointClaim
    rows: tuple[RowVerdict, ...] = ()
    missing: tuple[Branch, ...] = ()
    combination_missing: bool = False
    combinations: tuple[bool, ...] = ()
    loose: tuple[bool, ...] = ()
    complete: bool = True
