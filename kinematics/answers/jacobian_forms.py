"""A Jacobian in closed form, and joint forces in closed form: are they right for every configuration?

    (v, ω) = J(q) q̇        (v, (α, β, γ)˙) = J_A(q) q̇        τ = J(q)ᵀ (f, m)

An entry is right when it is the same function as that of the table. Where both are exact this is equality of
their canonical forms (`kinematics.symbolic.canonical`). What is not (numbers rounded on paper, roots of
lengths, rates of angles) is compared at configurations that nobody knows before the answer is written: they
are drawn from it; and, if the answer names every length, with other lengths, too.
"""

from __future__ import annotations

import random
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property, lru_cache
from itertools import chain as in_turn
from typing import TypeAlias

import numpy as np
from numpy.typing import NDArray

from kinematics.answers.jacobian_answers import (
    MIDDLE,
    JacobianMistake,
    JacobianVerdict,
    entry_limits,
    judge_forces,
    judge_jacobian,
)
from kinematics.chain import Chain, chain_of_table, size_of
from kinematics.errors import Fault, FormSizeError, JointValueError
from kinematics.expressions import ZERO, Expression, add, multiply
from kinematics.expressions.arrays import values_at
from kinematics.jacobian import JacobianFrame
from kinematics.rotations.sequences import EulerSequence
from kinematics.se3 import Floats
from kinematics.symbolic import Matrix, ProofStatus, jacobian
from kinematics.symbolic.analytic import analytic_form
from kinematics.symbolic.form_reader import FormReader
from kinematics.symbolic.ring import Ring
from kinematics.symbolic.size import refuse_longer_than
from kinematics.table import JointType, SymbolicTable, bind

POINTS = 8
"""Configurations with the table's lengths, and as many with others."""
PRODUCTS = 100_000
"""Products of terms that a proof may form, some 50 ms; all entries of a PUMA need a tenth."""
OPERATIONS = 20_000
"""Operations of a Jacobian that is compared; an arm with a wrist has a thousand."""
QUICK = 1_000
"""Products of terms that are tried before anything is sampled: enough for arms in a plane."""
LARGE_RATE = 20.0
"""Rate of an angle per rate of a joint: more of it is next to gimbal lock, where roundings grow, too."""
DOUBLED = 1e-9
"""How nearly twice the lengths must double an entry: far above rounding, below any length left out."""

Expressions: TypeAlias = Sequence[Sequence[Expression]]


@dataclass(frozen=True, kw_only=True, eq=False)
class FormVerdict(JacobianVerdict):
    """What is said of a Jacobian in closed form.

    Attributes:
        proof: PROVED: every entry is the same function; UNDECIDED: some were compared at samples only;
            REFUTED: some differ, if only by what is rounded.
    """

    proof: ProofStatus


@dataclass(frozen=True, kw_only=True, eq=False)
class FormRobot:
    """The robot that closed forms are of.

    Attributes:
        table: its table.
        values: of every name in the table and in the answer [the answer's length, or rad].
        lengths: the names that are lengths.
    """

    table: SymbolicTable
    values: Mapping[str, float]
    lengths: frozenset[str]

    @cached_property
    def chain(self) -> Chain:
        """The chain at these values."""
        return chain_of_table(bind(self.table, self.values))

    @cached_property
    def size(self) -> float:
        """Typical length of the robot."""
        return size_of(self.chain) or 1.0


@dataclass(frozen=True, kw_only=True, eq=False)
class _Samples:
    """Points where functions are compared: joints (n, k), parameters (k,) each."""

    parameters: Mapping[str, Floats]
    joints: Floats

    def of(self, entries: Iterable[Expression]) -> Floats:
        """Return the values of some entries, (entries, k)."""
        found = [values_at(entry, self.parameters, self.joints) for entry in entries]
        return np.array(found).reshape(len(found), self.joints.shape[1])


@np.errstate(all="ignore")
def judge_jacobian_form(
    robot: FormRobot,
    given: Expressions,
    frame: JacobianFrame,
    tolerance: float,
    angles: EulerSequence | None = None,
) -> FormVerdict:
    """Judge a Jacobian in closed form, entry by entry.

    Args:
        robot: whose Jacobian it is said to be.
        given: (6, n), linear rows first.
        frame: in whose axes the geometric one is asked.
        tolerance: of an entry's value; where it is a length, as a share of the robot's size.
        angles: of the analytic Jacobian, in frame 0; None for the geometric one.

    Raises:
        JointValueError: the angles have rates in no configuration.
    """
    n = robot.table.n_joints
    ours = jacobian_form(robot.table, frame, angles)
    pairs = list(zip(in_turn.from_iterable(given), in_turn.from_iterable(ours), strict=True))
    if _proved(pairs, QUICK) is ProofStatus.PROVED:
        return FormVerdict(entries=np.ones((6, n), dtype=np.bool_), proof=ProofStatus.PROVED)
    samples = _samples(robot, *zip(*pairs, strict=True))
    limit = entry_limits(robot.chain, tolerance)[:, :, None]
    actual, expected = (samples.of(entries).reshape(6, n, -1) for entries in zip(*pairs, strict=True))
    if angles is not None:
        usable = _where_rates_are_small(robot, expected)
        actual, expected = actual[:, :, usable], expected[:, :, usable]
        # which of the two triples is meant may change from one configuration to the next
        other = (np.abs(actual[MIDDLE] + expected[MIDDLE]) <= limit[MIDDLE]).all(axis=0)
        expected[MIDDLE] *= np.where(other, -1.0, 1.0)
    right: NDArray[np.bool_] = np.all(np.abs(actual - expected) <= limit, axis=2)
    if right.all():
        return FormVerdict(entries=right, proof=_proved_but_for_signs(given, ours, angles is not None))
    mistakes = _mistakes(robot, given, frame, tolerance, angles)
    return FormVerdict(entries=right, proof=ProofStatus.REFUTED, mistakes=mistakes)


@np.errstate(all="ignore")
def judge_force_form(
    robot: FormRobot,
    given: Sequence[Expression],
    wrench: Sequence[Expression],
    frame: JacobianFrame,
    tolerance: float,
) -> tuple[tuple[bool, ...], ProofStatus, JacobianMistake | None]:
    """Judge joint forces in closed form; return which are right, what is proved, what wrong ones look like.

    Args:
        robot: whose joints they are of; its values are also those of the names in the wrench.
        given: one for each joint.
        wrench: force and moment on the tool, (f, m).
        frame: in whose axes the wrench is given.
        tolerance: as a share of what force and moment can do at the robot's size.
    """
    ours = force_form(robot.table, wrench, frame)
    samples = _samples(robot, given, ours)
    load = np.abs(samples.of(wrench))
    force, moment = load[:3].sum(axis=0), load[3:].sum(axis=0)
    slides = [kind is JointType.PRISMATIC for kind in robot.table.joint_types]
    limit = tolerance * np.array([force if slide else force * robot.size + moment for slide in slides])
    close: NDArray[np.bool_] = np.all(np.abs(samples.of(given) - samples.of(ours)) <= limit, axis=1)
    right = tuple(close.tolist())
    if all(right):
        return right, _proved(list(zip(given, ours, strict=True))), None
    found: set[JacobianMistake | None] = set()
    for k in range(2):
        here = _at(samples, k)
        numbers = here.of(wrench)[:, 0].tolist()
        typed = np.nan_to_num(here.of(given)[:, 0], nan=np.inf).tolist()
        found.add(judge_forces(robot.chain, here.joints[:, 0].tolist(), numbers, typed, frame, tolerance)[1])
    return right, ProofStatus.REFUTED, found.pop() if len(found) == 1 else None


def jacobian_form(table: SymbolicTable, frame: JacobianFrame, angles: EulerSequence | None = None) -> Matrix:
    """Return the Jacobian in closed form, linear rows first: the geometric one, or that of some angles.

    Raises:
        JointValueError: the angles have rates in no configuration.
    """
    found = _geometric(table, frame) if angles is None else analytic_form(table, angles)
    refuse_longer_than(OPERATIONS, in_turn.from_iterable(found or ()))
    if found is None:
        assert angles is not None
        raise JointValueError(Fault(code="angles_locked", where=("angles",), params={"axes": angles.axes}))
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


def _proved(pairs: Iterable[tuple[Expression, Expression]], limit: int = PRODUCTS) -> ProofStatus:
    """Return whether each pair of entries is one function; all are read into one ring."""
    reader = FormReader(Ring(limit=limit))
    try:
        for given, ours in pairs:
            if given == ours:
                continue
            difference = reader.ring.add(reader.form(given), reader.form(ours), -1)
            if not reader.vanishes(difference):
                return ProofStatus.REFUTED if reader.decisive else ProofStatus.UNDECIDED
    except (FormSizeError, ZeroDivisionError):
        return ProofStatus.UNDECIDED
    return ProofStatus.PROVED


@lru_cache(maxsize=64)
def _geometric(table: SymbolicTable, frame: JacobianFrame) -> Matrix:
    return jacobian(table, frame)


def _proved_but_for_signs(given: Expressions, ours: Expressions, analytic: bool) -> ProofStatus:
    """Return what is proved of a Jacobian whose row of the middle angle may have either sign anywhere."""
    free = analytic and tuple(given[MIDDLE]) != tuple(ours[MIDDLE])
    rows = [r for r in range(6) if not (free and r == MIDDLE)]
    proof = _proved([pair for r in rows for pair in zip(given[r], ours[r], strict=True)])
    return ProofStatus.UNDECIDED if free and proof is ProofStatus.PROVED else proof


def _samples(robot: FormRobot, given: Iterable[Expression], ours: Iterable[Expression]) -> _Samples:
    """Return points drawn from the answer; with other lengths only if both name every length."""
    given, ours = tuple(given), tuple(ours)
    rng = random.Random(repr(given))  # noqa: S311 - the same answer, the same points
    kinds = robot.table.joint_types

    def drawn() -> Floats:
        return np.array(
            [
                [
                    rng.uniform(-3.0, 3.0) * (robot.size / 3.0 if kind is JointType.PRISMATIC else 1.0)
                    for _ in range(POINTS)
                ]
                for kind in kinds
            ]
        ).reshape(len(kinds), POINTS)

    usual = {name: np.full(POINTS, value) for name, value in robot.values.items()}
    samples = _Samples(parameters=usual, joints=drawn())
    if not _names_every_length(robot, samples, given, ours):
        return samples
    other = {
        name: np.array([robot.size * rng.uniform(0.2, 1.2) for _ in range(POINTS)])
        if name in robot.lengths
        else values
        for name, values in usual.items()
    }
    return _Samples(
        parameters={name: np.concatenate([usual[name], other[name]]) for name in usual},
        joints=np.hstack([samples.joints, drawn()]),
    )


def _names_every_length(
    robot: FormRobot, samples: _Samples, given: Sequence[Expression], ours: Sequence[Expression]
) -> bool:
    """Whether twice the lengths double each entry or leave it as it is, the given one just like ours."""
    slides = np.array([[kind is JointType.PRISMATIC] for kind in robot.table.joint_types])
    twice = _Samples(
        parameters={
            name: values * (2.0 if name in robot.lengths else 1.0)
            for name, values in samples.parameters.items()
        },
        joints=samples.joints * np.where(slides, 2.0, 1.0),
    )

    def grown(entries: Sequence[Expression], factor: float) -> NDArray[np.bool_]:
        before, after = samples.of(entries), twice.of(entries)
        limit = DOUBLED * max(1.0, robot.size, float(np.nan_to_num(np.abs(before)).max(initial=0.0)))
        same: NDArray[np.bool_] = np.all(np.abs(after - factor * before) <= limit, axis=1)
        return same

    kept, doubled = (grown(ours, factor) & grown(given, factor) for factor in (1.0, 2.0))
    return bool((kept | doubled).all())


def _where_rates_are_small(robot: FormRobot, expected: Floats) -> NDArray[np.bool_]:
    """Return at which samples no rate is so large that rounding tells; all, if everywhere one is."""
    usable: NDArray[np.bool_] = np.all(np.abs(expected[3:]) < LARGE_RATE, axis=(0, 1))
    return usable if usable.any() else np.all(np.isfinite(expected), axis=(0, 1))


def _at(samples: _Samples, k: int) -> _Samples:
    parameters = {name: values[k : k + 1] for name, values in samples.parameters.items()}
    return _Samples(parameters=parameters, joints=samples.joints[:, k : k + 1])


def _mistakes(
    robot: FormRobot, given: Expressions, frame: JacobianFrame, tolerance: float, angles: EulerSequence | None
) -> tuple[tuple[JacobianMistake, int | None], ...]:
    """Return the slips that explain wrong columns at two configurations alike."""
    entries = tuple(in_turn.from_iterable(given))
    samples = _samples(robot, entries, entries)
    found: list[set[tuple[JacobianMistake, int | None]]] = []
    for k in range(2):
        here = _at(samples, k)
        numbers = np.nan_to_num(here.of(entries)[:, 0], nan=np.inf).reshape(6, -1)
        try:
            told = judge_jacobian(
                robot.chain, here.joints[:, 0].tolist(), numbers, frame, tolerance, angles
            ).mistakes
        except JointValueError:
            continue
        found.append(set(told))
    both = set.intersection(*found) if found else set()
    return tuple(sorted(both, key=lambda told: (told[1] or 0, told[0].value)))
