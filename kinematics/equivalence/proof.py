"""Equation (1) as an identity: from a verified certificate to a proved one."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import TypeAlias

from kinematics.equivalence.certificates import CertificateCandidate
from kinematics.equivalence.closed_forms import (
    LengthForms,
    angle_atoms,
    angle_form,
    known_number,
    length_atoms,
)
from kinematics.errors import ParameterError
from kinematics.expressions import ONE, ZERO, Expression, evaluate
from kinematics.se3 import Motion
from kinematics.symbolic import ProofStatus, prove_identity
from kinematics.table import JointType, SymbolicTable

MOST_TERM_PRODUCTS = 5_000
"""A bound of the work: the exercises' own tables are proved with some fifty products; where angles that were
typed as decimals pile up, tens of thousands prove nothing."""

ExactMatrix: TypeAlias = tuple[tuple[Expression, ...], ...]


@dataclass(frozen=True, kw_only=True, slots=True)
class ExactCertificate:
    """A certificate in closed form, with which equation (1) holds identically.

    Attributes:
        joint_signs: σ.
        joint_offsets: δ [rad, or a length].
        base: 4×4, B.
        tool: 4×4, E.
    """

    joint_signs: tuple[int, ...]
    joint_offsets: tuple[Expression, ...]
    base: ExactMatrix
    tool: ExactMatrix


def prove(
    reference: SymbolicTable,
    submission: SymbolicTable,
    candidates: Sequence[CertificateCandidate],
    draws: Sequence[Mapping[str, float]],
) -> ExactCertificate | None:
    """Guess the closed form of a certificate from its values at several draws, and prove it.

    Args:
        reference: the key, exact.
        submission: the submission, exact, in the same length unit.
        candidates: the certificate at each draw, all with the same signs.
        draws: the values of the parameters; a few, or a single empty one.

    Returns:
        None if no closed form was recognised, or it could not be proved.
    """
    try:
        guess = _guess(reference, submission, candidates, draws)
    except ParameterError:
        return None
    if guess is None:
        return None
    proof = prove_identity(
        reference,
        submission,
        signs=guess.joint_signs,
        offsets=guess.joint_offsets,
        base=guess.base,
        tool=guess.tool,
        limit=MOST_TERM_PRODUCTS,
    )
    return guess if proof.verdict is ProofStatus.PROVED else None


def _guess(
    reference: SymbolicTable,
    submission: SymbolicTable,
    candidates: Sequence[CertificateCandidate],
    draws: Sequence[Mapping[str, float]],
) -> ExactCertificate | None:
    tables = (reference, submission)
    entries = (entry for table in tables for row in table.rows for entry in (row.a, row.d))
    size = max((abs(evaluate(entry, draws[0])) for entry in entries), default=0.0)
    lengths, angles = LengthForms(length_atoms(tables), draws, size), angle_atoms(tables)
    offsets: list[Expression] = []
    for i, joint in enumerate(reference.joint_types):
        values = [candidate.offsets[i] for candidate in candidates]
        slides = joint is JointType.PRISMATIC
        form = lengths.form(values) if slides else angle_form(values, angles, draws)
        if form is None:
            return None
        offsets.append(form)
    base = _matrix([candidate.base for candidate in candidates], lengths)
    tool = _matrix([candidate.tool for candidate in candidates], lengths)
    if base is None or tool is None:
        return None
    return ExactCertificate(
        joint_signs=candidates[0].signs, joint_offsets=tuple(offsets), base=base, tool=tool
    )


def _matrix(motions: Sequence[Motion], lengths: LengthForms) -> ExactMatrix | None:
    rows: list[tuple[Expression, ...]] = []
    for i in range(3):
        turning = [known_number(motions[0][3 * i + j]) for j in range(3)]
        shift = lengths.form([motion[9 + i] for motion in motions])
        if shift is None or any(entry is None for entry in turning):
            return None
        rows.append((*(entry for entry in turning if entry is not None), shift))
    return (*rows, (ZERO, ZERO, ZERO, ONE))
