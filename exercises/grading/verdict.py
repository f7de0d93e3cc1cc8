"""The verdict: what a grader says of a table. Codes and values only; the prose lives in message files.

Everything here is plain data (strings, numbers, tuples, mappings), so a caller may write it out as it stands.
"""

from collections.abc import Mapping
from dataclasses import dataclass, field
from enum import StrEnum

from kinematics.cells import AngleUnit, LengthUnit

Matrix4 = tuple[tuple[float, ...], ...]
ParamValue = str | int | float | tuple[str, ...] | tuple[int, ...]


class HelpLevel(StrEnum):
    """How much a verdict on a wrong table gives away; each level includes the ones before.

    VERDICT: right or wrong, and the score.
    ROW: which rows are wrong.
    KIND: what kind of fact is wrong in them.
    REPAIR: which misconception explains it. The key's own values are never given.
    """

    VERDICT = "verdict"
    ROW = "row"
    KIND = "kind"
    REPAIR = "repair"

    def includes(self, needed: "HelpLevel") -> bool:
        """Return whether this level tells what is told from another one on."""
        return LEVELS.index(self) >= LEVELS.index(needed)


LEVELS = tuple(HelpLevel)  # From the least help to the most.


class Basis(StrEnum):
    """What a verdict rests on.

    PROVED: accepted; equation (1) of docs/checker.md holds identically in all joint variables and parameters.
    VERIFIED: accepted; equation (1) holds within the tolerance at every sampled configuration, and at the
        worst that were found from there.
    REFUTED: rejected; no choice of frames makes equation (1) hold, or the policy excludes every one that
        does.
    """

    PROVED = "proved"
    VERIFIED = "verified"
    REFUTED = "refuted"


class Finding(StrEnum):
    """What was found of one fact of a row.

    OK: it agrees with the robot.
    WRONG: it does not.
    MISSING: the row should be there and is not.
    UNKNOWN: it cannot be judged, because something before it is wrong, or it has no counterpart.
    HIDDEN: the help level does not tell.
    """

    OK = "ok"
    WRONG = "wrong"
    MISSING = "missing"
    UNKNOWN = "unknown"
    HIDDEN = "hidden"


@dataclass(frozen=True, kw_only=True, slots=True)
class LinkFinding:
    """What was found of one row.

    Attributes:
        row: the submission's row, counted from 1; a missing row bears the number it should have.
        length: the link length (a, up to sign and to where the frames were put).
        twist: the link twist (α, up to sign and reversal of axes).
        offset: the link offset (d of a revolute row, θ of a prismatic one).
        joint: the joint's type; where a rule fixes them, zero and direction of its variable.
    """

    row: int
    length: Finding
    twist: Finding
    offset: Finding
    joint: Finding


@dataclass(frozen=True, kw_only=True, slots=True)
class Feedback:
    """One thing to tell the student; the sentence is message `feedback-<code>` with `params` by name.

    Attributes:
        code: stable identifier in snake_case.
        row: the submission's row that it speaks of, counted from 1, if it speaks of one.
        params: values for the sentence.
    """

    code: str
    row: int | None = None
    params: Mapping[str, ParamValue] = field(default_factory=dict)


@dataclass(frozen=True, kw_only=True, slots=True)
class Edit:
    """One misconception, and where; the sentence is message `repair-<code>` with `params` by name.

    Attributes:
        code: the misconception's identifier in the catalogue, in snake_case.
        row: the submission's row, counted from 1; None where it concerns the whole table.
        cell: "alpha", "a", "d", "theta" or "joint", if it concerns one cell.
        params: values for the sentence; never a value of the key.
    """

    code: str
    row: int | None = None
    cell: str | None = None
    params: Mapping[str, ParamValue] = field(default_factory=dict)


@dataclass(frozen=True, kw_only=True, slots=True)
class Repair:
    """Edits that together make the submission right; one or two.

    Attributes:
        edits: the edits, first row first.
    """

    edits: tuple[Edit, ...]


@dataclass(frozen=True, kw_only=True, slots=True)
class ExactForms:
    """The certificate in closed form, each entry an expression that a table's cell would accept.

    Attributes:
        joint_offsets: δ_1 … δ_n.
        base: 4x4, B.
        tool: 4x4, E.
    """

    joint_offsets: tuple[str, ...]
    base: tuple[tuple[str, ...], ...]
    tool: tuple[tuple[str, ...], ...]


@dataclass(frozen=True, kw_only=True, slots=True)
class CertificateReport:
    """(σ, δ, B, E) with F_s(σ∘q + δ) = B · F_r(q) · E, in the submission's units.

    Attributes:
        joint_signs: σ_1 … σ_n, each +1 or -1.
        joint_offsets: δ_1 … δ_n [the submission's angle or length unit].
        base: 4x4, B [translation in the submission's length unit].
        tool: 4x4, E [translation in the submission's length unit].
        exact: the same in closed form, if the verdict is proved.
        parameters: values of the parameters for which the numbers above hold [the submission's units].
        residual: largest difference between the two sides that was found at any configuration: position
            relative to the robot's size, or rotation [rad], whichever is larger.
        samples: number of configurations at which they were compared.
    """

    joint_signs: tuple[int, ...]
    joint_offsets: tuple[float, ...]
    base: Matrix4
    tool: Matrix4
    exact: ExactForms | None
    parameters: Mapping[str, float]
    residual: float
    samples: int


@dataclass(frozen=True, kw_only=True, slots=True)
class Verdict:
    """What the grader says of a table.

    Attributes:
        correct: the submission describes the reference robot and keeps the policy.
        score: 0 … 1; 1 if correct, else partial credit for the facts that are right.
        basis: what the verdict rests on.
        certificate: for a right answer, how its frames lie against the key's; None for a wrong one.
        links: per row of the submission (and per missing row), what is right; limited by the help level.
        feedback: what to tell the student, most important first; limited by the help level.
        repairs: what would make a wrong answer right, most plausible first; only at the help level `repair`.
        angle_unit: unit of the angles in the certificate.
        length_unit: unit of the lengths in the certificate.
    """

    correct: bool
    score: float
    basis: Basis
    certificate: CertificateReport | None
    links: tuple[LinkFinding, ...]
    feedback: tuple[Feedback, ...]
    repairs: tuple[Repair, ...]
    angle_unit: AngleUnit
    length_unit: LengthUnit

    def _repr_html_(self) -> str:
        from exercises.grading.verdict_html import verdict_html  # a notebook asks, and nobody else

        return verdict_html(self)
