"""A Jacobian in closed form, and joint forces in closed form: are they right for every configuration?

    (v, ω) = J(q) q̇        (v, (α, β, γ)˙) = J_A(q) q̇        τ = J(q)ᵀ (f, m)

An entry is right when it is the same function as that of the table. Where both are exact this is equality of
their canonical forms: of polynomials in sines and cosines (`kinematics.symbolic.polynomials`), which most
entries are, else of sums of exponentials (`kinematics.symbolic.canonical`). What is not equal so (numbers
rounded on paper, roots of lengths, rates of angles) is compared at configurations that nobody knows before
the answer is written: they are drawn from it; and, if it names every length, with other lengths, too.
"""

import random
from collections.abc import Mapping, Sequence
from functools import lru_cache
from itertools import chain as in_turn
from typing import TypeAlias

import numpy as np
from numpy.typing import NDArray

from kinematics.answers.entry_proofs import FormKey, key_of, proved
from kinematics.answers.form_samples import FormRobot, FormSamples, form_samples, usual_samples
from kinematics.answers.jacobian_answers import (
    MIDDLE,
    entry_limits,
    jacobian_at,
    judge_forces,
    judge_jacobian,
)
from kinematics.answers.jacobian_verdicts import FormVerdict, JacobianMistake
from kinematics.answers.left_open import EXACT, Rounded, left_open
from kinematics.errors import Fault, JointValueError
from kinematics.expressions import ZERO, Expression, add, multiply
from kinematics.jacobian import JacobianFrame
from kinematics.rotations.sequences import EulerSequence
from kinematics.se3 import Floats
from kinematics.symbolic import Matrix, ProofStatus, jacobian
from kinematics.symbolic.analytic import analytic_form
from kinematics.symbolic.size import refuse_longer_than
from kinematics.table import JointType, SymbolicTable

OPERATIONS = 20_000  # Operations of a Jacobian that is compared; an arm with a wrist has a thousand.
LARGE_RATE = 20.0
"""Rate of an angle per rate of a joint: more of it is next to gimbal lock, where roundings tell."""

Expressions: TypeAlias = Sequence[Sequence[Expression]]


@np.errstate(all="ignore")
def judge_jacobian_form(
    robot: FormRobot,
    given: Expressions,
    frame: JacobianFrame,
    tolerance: float,
    angles: EulerSequence | None = None,
    rounded: Rounded | None = None,
) -> FormVerdict:
    """Judge a Jacobian in closed form, entry by entry.

    Args:
        robot: whose Jacobian it is said to be.
        given: (6, n), linear rows first.
        frame: in whose axes the geometric one is asked.
        tolerance: of an entry's value; where it is a length, as a share of the robot's size.
        angles: of the analytic Jacobian, in frame 0; None for the geometric one.
        rounded: of entries with names and decimals, which are off by no more than the decimals leave open.
            Where nothing is said of an entry with decimals, the tolerance holds alone.

    Raises:
        JointValueError: the angles have rates in no configuration.
    """
    n = robot.table.n_joints
    key = _key(robot.table, frame, angles)
    flat = tuple(in_turn.from_iterable(given))
    other, refuted = key.unlike(flat)
    right = np.ones(6 * n, dtype=np.bool_)
    if not other:
        return FormVerdict(entries=right.reshape(6, n), proof=ProofStatus.PROVED)
    compared = other if angles is None else range(6 * n)
    samples = form_samples(robot, [flat[k] for k in compared], [key.entries[k] for k in compared])
    actual, expected = samples.of([flat[k] for k in compared]), samples.of([key.entries[k] for k in compared])
    limit = entry_limits(robot.chain, tolerance).reshape(6 * n, 1)[list(compared)]
    limit = np.minimum(limit, _as_typed([flat[k] for k in compared], rounded, samples, limit / tolerance))
    if angles is not None:
        actual, expected = _in_the_same_triple(robot, actual, expected, limit)
    right[list(compared)] = np.all(np.abs(actual - expected) <= limit, axis=1)
    if right.all():
        return FormVerdict(
            entries=right.reshape(6, n), proof=_proof(key, flat, other, refuted, angles is not None)
        )
    mistakes = _mistakes(robot, {k: flat[k] for k in compared}, frame, tolerance, angles)
    return FormVerdict(entries=right.reshape(6, n), proof=ProofStatus.REFUTED, mistakes=mistakes)


@np.errstate(all="ignore")
def judge_force_form(
    robot: FormRobot,
    given: Sequence[Expression],
    wrench: Sequence[Expression],
    frame: JacobianFrame,
    tolerance: float,
    rounded: Rounded | None = None,
) -> tuple[tuple[bool, ...], ProofStatus, JacobianMistake | None]:
    """Judge joint forces in closed form; return which are right, what is proved, what wrong ones look like.

    Args:
        robot: whose joints they are of; its values are also those of the names in the wrench.
        given: one for each joint.
        wrench: force and moment that the tool exerts, (f, m).
        frame: in whose axes the wrench is given.
        tolerance: as a share of what force and moment can do at the robot's size.
        rounded: of entries with names and decimals, as for the Jacobian.
    """
    ours = force_form(robot.table, wrench, frame)
    other, refuted = key_of(ours).unlike(given)
    right = [True] * len(given)
    if not other:
        return tuple(right), ProofStatus.PROVED, None
    samples = form_samples(robot, [given[k] for k in other], [ours[k] for k in other])
    load = np.abs(samples.of(wrench))
    force, moment = load[:3].sum(axis=0), load[3:].sum(axis=0)
    actual, expected = samples.of([given[k] for k in other]), samples.of([ours[k] for k in other])
    for k, one, two in zip(other, actual, expected, strict=True):
        slides = robot.table.joint_types[k] is JointType.PRISMATIC
        size = force if slides else force * robot.size + moment
        limit = np.minimum(tolerance * size, _as_typed([given[k]], rounded, samples, size)[0])
        right[k] = bool(np.all(np.abs(one - two) <= limit))
    if all(right):
        proof = ProofStatus.REFUTED if refuted else proved([(given[k], ours[k]) for k in other])
        return tuple(right), proof, None
    found: set[JacobianMistake | None] = set()
    for k in range(2):
        here = samples.at(k)
        numbers = here.of(wrench)[:, 0].tolist()
        typed = np.nan_to_num(here.of(given)[:, 0], nan=np.inf).tolist()
        found.add(judge_forces(robot.chain, here.joints[:, 0].tolist(), numbers, typed, frame, tolerance)[1])
    return tuple(right), ProofStatus.REFUTED, found.pop() if len(found) == 1 else None


def _as_typed(
    entries: Sequence[Expression], rounded: Rounded | None, samples: FormSamples, size: Floats
) -> Floats:
    """Return by how much entries may be off for their decimals, (entries, k); size (…, 1) or (k,)."""
    known = rounded or {}
    moved = [left_open(entry, known, samples.parameters, samples.joints) for entry in entries]
    return EXACT * size + np.array(moved)


@lru_cache(maxsize=64)
def jacobian_form(table: SymbolicTable, frame: JacobianFrame, angles: EulerSequence | None = None) -> Matrix:
    """Return the Jacobian in closed form, linear rows first: the geometric one, or that of some angles.

    Raises:
        JointValueError: the angles have rates in no configuration.
    """
    found = jacobian(table, frame) if angles is None else analytic_form(table, angles)
    refuse_longer_than(OPERATIONS, in_turn.from_iterable(found or ()))
    if found is None:
        assert angles is not None
        raise JointValueError(Fault.at("angles_locked", "angles", axes=angles.axes))
    return found


def force_form(
    table: SymbolicTable, wrench: Sequence[Expression], frame: JacobianFrame
) -> tuple[Expression, ...]:
    """Return τ = Jᵀ (f, m) in closed form."""
    rows = jacobian_form(table, frame)
    return tuple(
        add(multiply((rows[r][c], wrench[r])) for r in range(6) if ZERO not in (rows[r][c], wrench[r]))
        for c in range(table.n_joints)
    )


@lru_cache(maxsize=64)
def _key(table: SymbolicTable, frame: JacobianFrame, angles: EulerSequence | None) -> FormKey:
    return key_of(tuple(in_turn.from_iterable(jacobian_form(table, frame, angles))))


def _proof(
    key: FormKey, given: Sequence[Expression], unlike: Sequence[int], refuted: Sequence[int], analytic: bool
) -> ProofStatus:
    """Return what is proved of a Jacobian whose row of the middle angle may have either sign anywhere."""
    n = len(given) // 6
    free = {k for k in unlike if analytic and k // n == MIDDLE}
    if set(refuted) - free:
        return ProofStatus.REFUTED
    proof = proved([(given[k], key.entries[k]) for k in unlike if k not in free])
    return ProofStatus.UNDECIDED if free and proof is ProofStatus.PROVED else proof


def _in_the_same_triple(
    robot: FormRobot, actual: Floats, expected: Floats, limit: Floats
) -> tuple[Floats, Floats]:
    """Return the values of an analytic Jacobian's entries where rates are small enough to be compared.

    Which of the two triples is meant, the one that more entries agree with, may change from one
    configuration to the next.
    """
    n = robot.table.n_joints
    rates = np.abs(expected[3 * n :])
    usable: NDArray[np.bool_] = np.all(rates < LARGE_RATE, axis=0)
    usable = usable if usable.any() else np.all(np.isfinite(expected), axis=0)
    actual, expected = actual[:, usable], expected[:, usable]
    middle = slice(MIDDLE * n, (MIDDLE + 1) * n)
    ours, other = (
        (np.abs(actual[middle] - theirs) <= limit[middle]).sum(axis=0)
        for theirs in (expected[middle], -expected[middle])
    )
    expected[middle] *= np.where(other > ours, -1.0, 1.0)
    return actual, expected


def _mistakes(
    robot: FormRobot,
    given: Mapping[int, Expression],
    frame: JacobianFrame,
    tolerance: float,
    angles: EulerSequence | None,
) -> tuple[tuple[JacobianMistake, int | None], ...]:
    """Return the slips that explain wrong columns at two configurations alike; other entries are right."""
    samples = usual_samples(robot, random.Random(repr(given)))  # noqa: S311 - the same answer, the same points
    found: list[set[tuple[JacobianMistake, int | None]]] = []
    for k in range(2):
        here = samples.at(k)
        joints = here.joints[:, 0].tolist()
        try:
            numbers = jacobian_at(robot.chain, joints, frame, angles)
            numbers.flat[list(given)] = np.nan_to_num(here.of(given.values())[:, 0], nan=np.inf)
            told = judge_jacobian(robot.chain, joints, numbers, frame, tolerance, angles).mistakes
        except JointValueError:
            continue
        found.append(set(told))
    both = set.intersection(*found) if found else set()
    return tuple(sorted(both, key=lambda told: (told[1] or 0, told[0].value)))
