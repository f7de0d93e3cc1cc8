"""Inverse kinematics at and near singularities, against brute force.

Poses are drawn at chosen distances from singular configurations and written with few or many decimals. Of
every answer it is asked whether the configuration that made the pose is in it, whether it has more isolated
solutions than such an arm can have, and of complete ones whether descents from 500 random starts find
another.
"""

import time
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from itertools import chain, islice

import numpy as np

from kinematics.forward import end_pose
from kinematics.inverse.distinct import differences
from kinematics.inverse.goals import Goal, read_goal
from kinematics.inverse.newton import polish
from kinematics.inverse.residuals import are_solutions, error_vectors
from kinematics.inverse.results import InverseKinematics
from kinematics.inverse.search import Bounds, descend, search, unbounded
from kinematics.inverse.self_motions.components import belongs, components_of
from kinematics.inverse.self_motions.families import FamilyPath, Follower, nearest_on
from kinematics.inverse.self_motions.isolation import lost_value
from kinematics.inverse.self_motions.membership import Component
from kinematics.inverse.self_motions.walks import leads
from kinematics.inverse.solve import solver_of
from kinematics.inverse.solver import Solver
from kinematics.table import DHTable
from tests.kinematics.inverse.arms import random_joints, random_table
from tests.kinematics.inverse.models import MODELS

DISTANCES = (0.0, *(10.0**-k for k in range(12, 1, -1)))
DECIMALS = range(4, 18)
ROUGH = 6
"""With as many decimals or fewer a tolerance of one unit of the last is asked for."""

STARTS = 500
SAMPLES = 200
NEIGHBOURS = 12
"""Where there are families of two dimensions or more, so many solutions are sampled, and ways looked for from
each to so many that are near it: what such ways join is one family."""

AWAY = 1e-3
"""What brute force found counts as another solution if it is farther than this from all and not joined to
one."""


@dataclass
class Tally:
    """What a campaign found.

    Attributes:
        poses: how many were asked.
        complete: how many answers claimed to be complete, and how many of these were tried by brute force.
        rough: poses whose own configuration is off by more than the tolerance: rounding was unlucky.
        faults: what should not have been: kind, arm, seed.
    """

    poses: int = 0
    complete: int = 0
    tried: int = 0
    rough: int = 0
    faults: list[tuple[str, str, int]] = field(default_factory=list)


def singular_configuration(rng: np.random.Generator, solver: Solver) -> np.ndarray:
    """One where the Jacobian has lost rank: by bisection of its determinant, or at right angles."""
    arm = solver.arm
    n = arm.n_joints
    spans = np.where(arm.revolute, np.pi, 0.5 * arm.size)
    q = rng.uniform(-spans, spans)
    if n == 6 and arm.generic_rank == 6 and rng.random() < 0.5:
        other = q + 0.5 * rng.normal(size=n) * np.where(arm.revolute, 1.0, arm.size)

        def determinant(part: float) -> float:
            J = arm.jacobians(arm.frames((q + part * (other - q))[None])) * arm.units
            return float(np.linalg.det(J[0]))

        low, high = 0.0, 1.0
        if determinant(low) * determinant(high) < 0.0:
            for _ in range(80):
                middle = 0.5 * (low + high)
                low, high = (middle, high) if determinant(middle) * determinant(low) > 0.0 else (low, middle)
            return q + low * (other - q)
    right = rng.random(n) < rng.choice([0.3, 0.6, 1.0])
    return np.where(arm.revolute & right, np.round(q / (np.pi / 2)) * np.pi / 2, q)


def questions(
    table: DHTable, solver: Solver, seed: int
) -> Iterator[tuple[np.ndarray, np.ndarray, float | None]]:
    """Configurations, their poses as written, and the tolerance asked for; without end."""
    rng = np.random.default_rng(seed)
    while True:
        q = singular_configuration(rng, solver)
        away = rng.normal(size=len(q))
        q = q + rng.choice(DISTANCES) * away / np.linalg.norm(away) * solver.arm.units
        decimals = int(rng.choice(DECIMALS))
        pose = end_pose(table, q)
        yield (
            q,
            pose if decimals == 17 else np.round(pose, decimals),
            10.0**-decimals if decimals <= ROUGH else None,
        )


def posed(name: str, q: Sequence[float], decimals: int) -> tuple[Solver, np.ndarray, float | None]:
    """An arm's solver, the pose of a configuration as it is written, and the tolerance asked for."""
    pose = end_pose(MODELS[name], q)
    tolerance = 10.0**-decimals if decimals <= ROUGH else None
    return solver_of(MODELS[name]), pose if decimals == 17 else np.round(pose, decimals), tolerance


def most_isolated(solver: Solver) -> int:
    """The most isolated solutions of such an arm: 16 in general, 8 with a wrist or three parallel axes."""
    return 16 if "General" in type(solver.closed_form).__name__ or solver.closed_form is None else 8


def run(name: str, table: DHTable, poses: int, tried: int, seed: int = 1) -> Tally:
    """Ask so many poses of an arm; try so many of the complete answers by brute force."""
    solver = solver_of(table)
    tally = Tally()
    for k, (q, pose, tolerance) in enumerate(islice(questions(table, solver, seed), poses)):
        tally.poses += 1
        answer = solver.solve(pose, tolerance)
        goal = read_goal(pose, tolerance, where=())._replace(tolerance=answer.tolerance)
        isolated = [s.joints for s in answer.solutions if s.family is None]
        if len(isolated) > most_isolated(solver):
            tally.faults.append(("too many", name, k))
        if not _reaches(solver, goal, q):
            tally.rough += 1
        elif not has(solver, goal, q, answer):
            tally.faults.append(("own lost", name, k))
        if answer.complete:
            tally.complete += 1
            if tally.tried < tried:
                tally.tried += 1
                if _another(solver, goal, np.array(isolated), k):
                    tally.faults.append(("not complete", name, k))
    return tally


def run_arms(arms: int, seed: int) -> tuple[Tally, list[float]]:
    """Ask a pose of each of so many random arms of six turning joints, and search for more solutions.

    Returns:
        What was found, and the processor time of each answer [s].
    """
    rng = np.random.default_rng(seed)
    tally, times = Tally(), []
    for k in range(arms):
        table = random_table(rng, 6, sliding=0.0)
        q = random_joints(rng, table)
        pose = end_pose(table, q)
        solver = solver_of(table)
        begun = time.process_time()
        answer = solver.solve(pose)
        times.append(time.process_time() - begun)
        tally.poses += 1
        tally.complete += answer.complete
        found = search(solver.arm, pose, solver.box, Bounds.IGNORED).solutions
        known = np.array([solution.joints for solution in answer.solutions])
        goal = read_goal(pose, None, where=())
        for other in (q, *found):
            if not is_among(solver, goal, other, known):
                tally.faults.append(("not complete" if answer.complete else "own lost", "random arm", k))
    return tally, times


def _reaches(solver: Solver, goal: Goal, q: np.ndarray) -> bool:
    e = error_vectors(solver.arm.frames(q[None])[-1], goal.pose, solver.arm.size)
    return bool(are_solutions(e, solver.arm, goal.tolerance)[0])


def has(solver: Solver, goal: Goal, q: np.ndarray, answer: InverseKinematics) -> bool:
    """Whether a configuration is in an answer: one of its solutions, or in one of its families."""
    return (
        _is_on_a_family(solver, goal, q, answer)
        or is_among(solver, goal, q, np.array([s.joints for s in answer.solutions]))
        or _is_on_a_surface(solver, goal, q, answer)
    )


def is_among(solver: Solver, goal: Goal, q: np.ndarray, known: np.ndarray) -> bool:
    """Whether a configuration is one of the solutions, joined to one, or on the path of a family of one."""
    if not len(known):
        return False
    arm, follower = solver.arm, Follower(solver.arm, goal.pose, 2.0 * goal.tolerance)
    x = q / arm.units
    for s in known:
        apart = differences(s, q, arm)
        if np.abs(apart).max() <= 1e-6 or _straight(solver, goal, q, apart):
            return True
        if np.abs(apart).max() <= 0.5 and follower.joined(x, x + apart):
            return True
    own = components_of(arm, goal.pose, q[None], goal.tolerance)
    if any(_holds(follower, goal, s, component) for s in known for component in own):
        return True
    together = components_of(arm, goal.pose, known, goal.tolerance)
    nearest = known[np.argsort(np.abs(differences(known, q, arm)).max(axis=1), kind="stable")]
    each = (one for s in nearest for one in components_of(arm, goal.pose, s[None], goal.tolerance))
    return any(_holds(follower, goal, q, component) for component in chain(together, each))


def _holds(follower: Follower, goal: Goal, q: np.ndarray, component: Component) -> bool:
    if any(_is_on(follower, goal, q, path) for path in component.paths):
        return True
    return belongs(follower.arm, goal.pose, component, q, 2.0 * goal.tolerance)


def _is_on_a_family(solver: Solver, goal: Goal, q: np.ndarray, answer: InverseKinematics) -> bool:
    """Whether a configuration is on the path of a family, by the members that the answer lists."""
    follower = Follower(solver.arm, goal.pose, 2.0 * goal.tolerance)
    families = [s.family for s in answer.solutions if s.family is not None and s.family.members]
    return any(
        _is_on(follower, goal, q, FamilyPath(np.array(one.members), closed=False, second=np.empty(0)))
        for one in families
    )


def _is_on_a_surface(solver: Solver, goal: Goal, q: np.ndarray, answer: InverseKinematics) -> bool:
    """Whether ways from sample to sample lead from a configuration to a family of two dimensions or more."""
    arm = solver.arm
    surfaces = [s.joints for s in answer.solutions if s.family is not None and s.family.dimension > 1]
    if not surfaces:
        return False
    known = np.array(surfaces)
    x = np.vstack((q, known, _samples(solver, goal, SAMPLES, seed=0))) / arm.units
    apart = np.abs(differences((x * arm.units)[:, None], (x * arm.units)[None], arm)).sum(axis=2)
    np.fill_diagonal(apart, np.inf)
    near = np.argsort(apart, axis=1, kind="stable")[:, :NEIGHBOURS]
    family = np.arange(len(x))
    for others in near.T:
        apart_yet = np.flatnonzero(family != family[others])
        follower = Follower(arm, goal.pose, goal.tolerance)
        led = leads(follower, x[apart_yet], x[others[apart_yet]], lost_value(goal.tolerance))
        for one, other in zip(apart_yet[led], others[apart_yet[led]], strict=True):
            family[family == family[other]] = family[one]
    return bool((family[1 : 1 + len(known)] == family[0]).any())


def _is_on(follower: Follower, goal: Goal, q: np.ndarray, path: FamilyPath) -> bool:
    """Whether the nearest chord of a path, corrected, leads to a configuration."""
    x = q / follower.arm.units
    off, chord = nearest_on(follower.arm, path, q)
    if np.linalg.norm(off) > 0.1:
        return False
    corrected, e, _ = follower.corrected(x - off, (chord / max(np.linalg.norm(chord), 1e-300))[None])
    if follower.reached(e) and np.linalg.norm(corrected - x) <= max(2e-3, 40 * goal.tolerance):
        return True
    return follower.joined(x, corrected)


def _straight(solver: Solver, goal: Goal, q: np.ndarray, apart: np.ndarray) -> bool:
    """Whether the straight way to a solution reaches the target within twice the tolerance."""
    way = q + np.linspace(0.0, 1.0, 9)[:, None] * apart * solver.arm.units
    e = error_vectors(solver.arm.frames(way)[-1], goal.pose, solver.arm.size)
    return bool(are_solutions(e, solver.arm, 2.0 * goal.tolerance).all())


def _another(solver: Solver, goal: Goal, known: np.ndarray, seed: int) -> bool:
    """Whether descents from random starts find a solution that is not among the known ones."""
    found = _samples(solver, goal, STARTS, seed)
    far = [q for q in found if np.abs(differences(q, known, solver.arm)).max(axis=1).min() > AWAY]
    return any(not is_among(solver, goal, q, known) for q in far)


def _samples(solver: Solver, goal: Goal, starts: int, seed: int) -> np.ndarray:
    """(m, n) solutions that descents from so many random starts find."""
    arm = solver.arm
    rng = np.random.default_rng(seed)
    spans = np.where(arm.revolute, np.pi, arm.size + np.linalg.norm(goal.pose[:3, 3]))
    descent = descend(
        arm, goal.pose, rng.uniform(-spans, spans, (starts, arm.n_joints)), unbounded(arm.n_joints)
    )
    found = polish(arm, goal.pose, descent.joints[descent.errors < 1e-4])
    e = error_vectors(arm.frames(found)[-1], goal.pose, arm.size)
    return np.asarray(found[are_solutions(e, arm, goal.tolerance)])
