"""Inverse kinematics beside EAIK and roboticstoolbox."""

import os
from typing import Any

import numpy as np

from bench import Better, Outcome, Row, measured, race
from bench.peers import ALPHA, A, D, puma560, puma560_ets

TITLE = "Inverse kinematics"
ABOUT = """
PUMA 560 at 1000 random reachable poses: our figure is the whole answer (all eight solutions of every pose,
each judged by our own forward kinematics, singular poses told apart, turns brought into range); EAIK's is
its call and reading the joint values. The bar of a third is the promise to cost at most three times as
much. Solved means, for us, every solution within 1e-9, and all eight of them; for roboticstoolbox one
solution within 1e-6 (1e-8 where so said), judged by our forward kinematics.

Then every robot of the catalogue, and 50 random arms of four to eight joints of both kinds. The random arms,
most of which have no closed form and are searched, get a tenth of the promised 1000 poses; those of more than
six joints, of which every family of solutions is followed (up to a second a pose), get ten poses each.
`FRAMEWISE_BENCH_POSES=1000` gives them all, in some hours.

On an AMD EPYC, on 2026-11-25, one pose with all eight solutions verified took 20.2 µs: within its bar, which
a slower machine misses. In one hour of 2026-11-29, on such a machine, the code of 2026-11-21 took 430 to
460 µs for one pose and 9 to 11 µs for each of a thousand.
"""

EAIK, RTB, RTB_TIGHT = "EAIK `DhRobot.IK`", "roboticstoolbox `ik_LM`", "roboticstoolbox `ik_LM`, tol 1e-12"
MANY = 1000
ROBOT_POSES = int(os.environ.get("FRAMEWISE_BENCH_POSES", "1000"))
ARM_POSES = int(os.environ.get("FRAMEWISE_BENCH_POSES", "100"))
REDUNDANT_POSES = int(os.environ.get("FRAMEWISE_BENCH_POSES", "10"))
POSE_COORDINATES = 6  # An arm of more joints reaches a pose in families of configurations.


def rows() -> list[Outcome]:
    """Measure."""
    return [*_puma(), *_others()]


def _puma() -> list[Outcome]:
    from kinematics.forward import end_poses
    from kinematics.inverse import solve_many, solver_of

    table, modified = puma560(), _craig()
    theirs, ets = _eaik(), puma560_ets()
    q = np.random.default_rng(560).uniform(-np.pi, np.pi, (MANY, 6))
    outcomes: list[Outcome] = []
    for name, own in (("standard", table), ("modified", modified)):
        targets = end_poses(own, q)
        their_targets = list(end_poses(table, q))
        solver = solver_of(own)
        outcomes += race(
            f"PUMA 560, {name}: all solutions of 1000 poses, each",
            lambda solver=solver, targets=targets: solve_many(solver, targets),
            {EAIK: lambda targets=their_targets: [theirs.IK(pose).Q for pose in targets]},
            bars={EAIK: 1 / 3},
            items=MANY,
            rounds=9,
        )
        found = solve_many(solver, targets)
        eight = np.bincount(found.target[found.residual <= 1e-9], minlength=MANY) == 8
        rtb = _share(table, their_targets, lambda pose: ets.ik_LM(pose), 1e-6)
        outcomes.append(_solved(f"PUMA 560, {name}: poses solved", RTB, 100 * eight.mean(), rtb))
    pose, solver = end_poses(table, q)[0], solver_of(table)
    one = race("PUMA 560: one pose", lambda: solver.solve(pose), {EAIK: lambda: theirs.IK(pose).Q})
    ours = next(row.ours for row in one if isinstance(row, Row))
    barred = measured(
        "PUMA 560: one pose, all eight, each verified",
        peer="a bar of 25 µs",
        ours=ours,
        theirs=25e-6,
        unit="s",
        better=Better.LESS,
        bar=1,
    )
    return [*outcomes, *one, barred]


def _others() -> list[Outcome]:
    from kinematics.catalogue import robots
    from kinematics.cells import bind_parameters
    from tests.kinematics.inverse.arms import random_table

    rng = np.random.default_rng(50)
    arms = [
        random_table(rng, int(rng.integers(4, 9)), (0.0, 0.15, 0.3)[i % 3], bool(i % 2)) for i in range(50)
    ]
    listed = [bind_parameters(robot.table, robot.parameters) for robot in robots()]
    return [
        _campaign(f"{len(listed)} catalogue robots", listed, ROBOT_POSES),
        _campaign("50 random arms of 4 to 8 joints", arms, ARM_POSES),
    ]


def _campaign(whose: str, tables: list[Any], poses: int) -> Outcome:
    from kinematics.forward import end_poses
    from kinematics.inverse import solver_of

    ours, theirs = [], []
    for table in tables:
        rng = np.random.default_rng(table.n_joints)
        solver = solver_of(table)
        slide = 0.5 * solver.arm.size
        span = np.where(solver.arm.revolute, np.pi, slide)
        count = min(poses, REDUNDANT_POSES) if table.n_joints > POSE_COORDINATES else poses
        targets = end_poses(table, rng.uniform(-span, span, (count, table.n_joints)))
        for pose in targets:
            solutions = solver.solve(pose).solutions
            ours.append(bool(solutions) and all(solution.residual <= 1e-8 for solution in solutions))
        ets = _ets(table, slide)
        theirs.append(_share(table, list(targets), lambda pose, ets=ets: ets.ik_LM(pose, tol=1e-12), 1e-8))
    work = f"{whose}, {poses} poses each ({REDUNDANT_POSES} above six joints): solved"
    return _solved(work, RTB_TIGHT, 100 * float(np.mean(ours)), float(np.mean(theirs)))


def _solved(work: str, peer: str, ours: float, theirs: float) -> Outcome:
    return measured(work, peer=peer, ours=ours, theirs=theirs, unit="%", better=Better.MORE, bar=1)


def _share(table: Any, poses: list[Any], solve: Any, tolerance: float) -> float:
    """Per cent of poses of which the peer's answer is within the tolerance."""
    from kinematics.forward import end_pose
    from kinematics.inverse.residuals import pose_errors

    good = 0
    for pose in poses:
        joints = np.asarray(solve(pose)[0])
        good += bool(np.hypot(*pose_errors(end_pose(table, joints)[None], pose))[0] <= tolerance)
    return 100 * good / len(poses)


def _eaik() -> Any:
    from eaik.IK_DH import DhRobot

    return DhRobot(np.array(ALPHA), np.array(A), np.array(D))


def _craig() -> Any:
    """The same arm, frames as in J. J. Craig's book: another table, other zeros, the same work."""
    from kinematics.table import Convention, DHRow, DHTable, JointType

    right = np.pi / 2
    figures = (
        (0.0, 0.0, 0.0),
        (-right, 0.0, 0.0),
        (0.0, 0.4318, 0.15005),
        (-right, 0.0203, 0.4318),
        (right, 0.0, 0.0),
        (-right, 0.0, 0.0),
    )
    rows = (DHRow(joint=JointType.REVOLUTE, theta=0.0, d=d, a=a, alpha=al) for al, a, d in figures)
    return DHTable(convention=Convention.MODIFIED, rows=tuple(rows))


def _ets(table: Any, slide: float) -> Any:
    """The table as roboticstoolbox's elementary transforms."""
    from roboticstoolbox import ET, ETS

    from kinematics.table import Convention, JointType

    parts: list[Any] = []
    for row in table.rows:
        turn = [ET.Rz(row.theta)]
        shift = [ET.tz(row.d)]
        if row.joint is JointType.REVOLUTE:
            turn.append(ET.Rz(flip=row.sign < 0, qlim=[-np.pi, np.pi]))
        elif row.joint is JointType.PRISMATIC:
            shift.append(ET.tz(flip=row.sign < 0, qlim=[-2 * slide, 2 * slide]))
        along = [ET.tx(row.a), ET.Rx(row.alpha)]
        about = turn + shift
        parts += about + along if table.convention is Convention.STANDARD else along + about
    return ETS(parts)
