"""Exact proof that two DH tables describe the same robot, for given joint signs, offsets and end frames."""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import lru_cache
from itertools import chain

from kinematics.errors import FormSizeError
from kinematics.expressions import ZERO, Expression, negate
from kinematics.symbolic.canonical import ProofStatus
from kinematics.symbolic.form_reader import FormReader
from kinematics.symbolic.motions import Motion, motions_of
from kinematics.symbolic.poses import ExactPose, read_matrix
from kinematics.table import SymbolicTable


@dataclass(frozen=True, kw_only=True, slots=True)
class Proof:
    """Outcome of `prove_identity`.

    Attributes:
        verdict: what is known.
        joint: the first joint whose axis is not where it should be; 0 if the end frames disagree or
            nothing is wrong.
    """

    verdict: ProofStatus
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
        return Proof(verdict=ProofStatus.REFUTED)
    reader = FormReader()
    reader.ring.limit = limit
    try:
        failed = _first_failure(reader, reference, submission, signs, offsets, base, tool)
    except (FormSizeError, ZeroDivisionError):
        return Proof(verdict=ProofStatus.UNDECIDED)
    if failed is None:
        return Proof(verdict=ProofStatus.PROVED)
    return Proof(verdict=ProofStatus.REFUTED if reader.decisive else ProofStatus.UNDECIDED, joint=failed)


def _first_failure(
    reader: FormReader,
    reference: SymbolicTable,
    submission: SymbolicTable,
    signs: Sequence[int],
    offsets: Sequence[Expression],
    base: Sequence[Sequence[Expression]] | None,
    tool: Sequence[Sequence[Expression]] | None,
) -> int | None:
    """The first joint at which the identity fails, 0 for the end frames, None if it holds."""
    X = ExactPose(reader, read_matrix(reader, base))
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
        if offsets[index] != ZERO:
            X.undo(Motion(other.kind, offsets[index] if other.sign > 0 else negate(offsets[index])))
        X.tidy()
    return None if X.ends_with(read_matrix(reader, tool)) else 0


@lru_cache(maxsize=64)
def _by_joint(table: SymbolicTable) -> list[list[Motion]]:
    """The motions up to and including each joint, and those after the last; a key's again and again."""
    parts: list[list[Motion]] = [[]]
    for motion in chain.from_iterable(motions_of(table)):
        parts[-1].append(motion)
        if motion.joint:
            parts.append([])
    return parts
