"""Exact proof that two DH tables describe the same robot, for given joint signs, offsets and end frames."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from enum import StrEnum
from itertools import chain

from kinematics.errors import FormSizeError
from kinematics.expressions import Expression, multiply, number
from kinematics.symbolic.motions import Kind, Motion, motions_of
from kinematics.symbolic.reading import Reader
from kinematics.symbolic.ring import ONE_FORM, ZERO_FORM, Form
from kinematics.table import SymbolicTable

_IDENTITY = tuple(tuple(ONE_FORM if i == j else ZERO_FORM for j in range(4)) for i in range(3))


class Verdict(StrEnum):
    """What is known of an identity.

    PROVED: it holds for all joint and parameter values. REFUTED: it does not. UNDECIDED: it was not proved,
    and the entries hold what has no unique normal form (a square root of lengths, an arctangent), or their
    expansion is too large.
    """

    PROVED = "proved"
    REFUTED = "refuted"
    UNDECIDED = "undecided"


@dataclass(frozen=True, kw_only=True, slots=True)
class Proof:
    """Outcome of `prove_identity`.

    Attributes:
        verdict: what is known.
        joint: the first joint whose axis is not where it should be; 0 if the end frames disagree or
            nothing is wrong.
    """

    verdict: Verdict
    joint: int = 0


def prove_identity(
    reference: SymbolicTable,
    submission: SymbolicTable,
    *,
    signs: Sequence[int],
    offsets: Sequence[Expression],
    base: Sequence[Sequence[Expression]] | None = None,
    tool: Sequence[Sequence[Expression]] | None = None,
    limit: int = 200_000,
) -> Proof:
    """Decide whether F_s(σ∘q + δ) = B · F_r(q) · E for all q and all parameter values.

    Write F(q) = C_0 J_1(q_1) C_1 ⋯ J_n(q_n) C_n with constant C_i, and X_0 = (C_0^s)^(-1) B C_0^r. Setting
    all joint variables but one to zero shows that the identity holds if and only if

        J_i^s(σ_i q)^(-1) X_(i-1) J_i^r(q) does not depend on q,      i = 1 … n,
        X_i = (J_i^s(δ_i) C_i^s)^(-1) X_(i-1) C_i^r,                  X_n E = 1.

    So a statement about trigonometric polynomials in n variables becomes n + 1 statements about constants.
    They are decided in the ring of `kinematics.symbolic.ring`.

    Args:
        reference: the table of F_r.
        submission: the table of F_s.
        signs: σ, +1 or -1 for each joint.
        offsets: δ, exact [rad, or the tables' length].
        base: B, 4×4 exact with the last row 0 0 0 1; the identity if left out.
        tool: E, likewise.
        limit: products of terms that may be formed before the answer is UNDECIDED.
    """
    if not len(signs) == len(offsets) == reference.n_joints == submission.n_joints:
        return Proof(verdict=Verdict.REFUTED)
    reader = Reader()
    reader.ring.limit = limit
    try:
        failed = _first_failure(reader, reference, submission, signs, offsets, base, tool)
    except (FormSizeError, ZeroDivisionError):
        return Proof(verdict=Verdict.UNDECIDED)
    if failed is None:
        return Proof(verdict=Verdict.PROVED)
    return Proof(verdict=Verdict.REFUTED if reader.decisive else Verdict.UNDECIDED, joint=failed)


def _first_failure(
    reader: Reader,
    reference: SymbolicTable,
    submission: SymbolicTable,
    signs: Sequence[int],
    offsets: Sequence[Expression],
    base: Sequence[Sequence[Expression]] | None,
    tool: Sequence[Sequence[Expression]] | None,
) -> int | None:
    """The first joint at which the identity fails, 0 for the end frames, None if it holds."""
    X = _Pose(reader, _read(reader, base))
    expected, given = _by_joint(reference), _by_joint(submission)
    for index, (ours, theirs) in enumerate(zip(expected, given, strict=True)):
        for motion in ours:
            if not motion.joint:
                X.then(motion)
        for motion in theirs:
            if not motion.joint:
                X.undo(motion)
        if index == len(signs):
            break
        mine, other = ours[-1], theirs[-1]
        sign = signs[index] * mine.sign * other.sign
        if mine.kind is not other.kind or not X.carries(mine.kind, sign):
            return index + 1
        X.undo(Motion(other.kind, multiply((number(other.sign), offsets[index]))))
    return None if X.ends_with(_read(reader, tool)) else 0


def _by_joint(table: SymbolicTable) -> list[list[Motion]]:
    """The motions up to and including each joint, and those after the last."""
    parts: list[list[Motion]] = [[]]
    for motion in chain.from_iterable(motions_of(table)):
        parts[-1].append(motion)
        if motion.joint:
            parts.append([])
    return parts


def _read(reader: Reader, matrix: Sequence[Sequence[Expression]] | None) -> list[list[Form]]:
    if matrix is None:
        return [list(row) for row in _IDENTITY]
    return [[reader.form(entry) for entry in row] for row in matrix[:3]]


@dataclass(slots=True)
class _Pose:
    """X: the reference's moving frame seen from the submission's, as the chains are followed."""

    reader: Reader
    m: list[list[Form]]

    def then(self, motion: Motion) -> None:
        """X ← X · motion."""
        ring = self.reader.ring
        if motion.kind in (Kind.SLIDE_X, Kind.SLIDE_Z):
            amount = self.reader.form(motion.amount)
            for row in self.m:
                along = row[0 if motion.kind is Kind.SLIDE_X else 2]
                row[3] = ring.add(row[3], ring.multiply(amount, along))
            return
        i, j = (0, 1) if motion.kind is Kind.ROTATE_Z else (1, 2)
        circle = self.reader.cosine_and_sine(motion.amount)
        for row in self.m:
            row[i], row[j] = self._mixed(circle, row[i], row[j])

    def undo(self, motion: Motion) -> None:
        """X ← motion^(-1) · X."""
        ring = self.reader.ring
        if motion.kind in (Kind.SLIDE_X, Kind.SLIDE_Z):
            row = self.m[0 if motion.kind is Kind.SLIDE_X else 2]
            row[3] = ring.add(row[3], self.reader.form(motion.amount), -1)
            return
        i, j = (0, 1) if motion.kind is Kind.ROTATE_Z else (1, 2)
        circle = self.reader.cosine_and_sine(motion.amount)
        upper, lower = self.m[i], self.m[j]
        for k in range(4):
            upper[k], lower[k] = self._mixed(circle, upper[k], lower[k])

    def carries(self, kind: Kind, sign: int) -> bool:
        """Whether X takes the joint's axis, or its direction if it slides, onto sign times the z-axis."""
        m, ring = self.m, self.reader.ring
        vanishing = [m[0][2], m[1][2]]
        if kind is Kind.ROTATE_Z:
            vanishing += [m[2][0], m[2][1], m[0][3], m[1][3]]
            vanishing += [ring.add(m[0][0], m[1][1], -sign), ring.add(m[0][1], m[1][0], sign)]
        else:
            vanishing.append(ring.add(m[2][2], ring.rational(sign), -1))
        return all(map(self.reader.vanishes, vanishing))

    def ends_with(self, tool: list[list[Form]]) -> bool:
        """Whether X · tool is the identity."""
        ring = self.reader.ring
        for i, row in enumerate(self.m):
            for j in range(4):
                entry = row[3] if j == 3 else ZERO_FORM
                for k in range(3):
                    entry = ring.add(entry, ring.multiply(row[k], tool[k][j]))
                if not self.reader.vanishes(ring.add(entry, _IDENTITY[i][j], -1)):
                    return False
        return True

    def _mixed(self, circle: tuple[Form, Form], u: Form, v: Form) -> tuple[Form, Form]:
        ring, (c, s) = self.reader.ring, circle
        return (
            ring.add(ring.multiply(c, u), ring.multiply(s, v)),
            ring.add(ring.multiply(c, v), ring.multiply(s, u), -1),
        )
