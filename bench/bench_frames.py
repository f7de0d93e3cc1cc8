"""Frame assignment beside AutoDH: random chains of joint axes to DH tables."""

import os
from typing import Any

import numpy as np

from bench import Better, Outcome, measured, race

TITLE = "Frame assignment"
ABOUT = """
Joint axes to a DH table. Chains are of one to eight axes: general, or skew, parallel, antiparallel,
coincident, crossing and perpendicular neighbours, or along the coordinate axes; a fifth of the joints
slides. A table is wrong if base · table · tool differs from the chain's own screws by more than 1e-9 at
some of three configurations, in an axis or in the tool. Both are given the base and the tool. AutoDH's
fixed rows at either end are taken as it gives them. `FRAMEWISE_BENCH_CHAINS` sets how many chains are judged.
"""

AUTODH = "AutoDH 0.2"
CHAINS = int(os.environ.get("FRAMEWISE_BENCH_CHAINS", "10000"))
TOLERANCE = 1e-9


def rows() -> list[Outcome]:
    """Measure."""
    from kinematics.table import Convention

    chains = _chains(CHAINS)
    six = [chain for chain, _ in chains if len(chain) == 6][:100]
    outcomes: list[Outcome] = []
    for convention in Convention:
        ours, theirs = _ours(six, convention), _theirs(six, convention)
        outcomes += race(
            f"six axes to a {convention.value} table, each",
            ours,
            {AUTODH: theirs},
            bars={AUTODH: 1},
            items=len(six),
            rounds=7,
        )
        outcomes.append(
            measured(
                f"{CHAINS} chains to {convention.value} tables, wrong",
                peer=AUTODH,
                ours=float(sum(_wrong_ours(chain, tool, convention) for chain, tool in chains)),
                theirs=float(sum(_wrong_theirs(chain, tool, convention) for chain, tool in chains)),
                unit="wrong",
                better=Better.LESS,
            )
        )
    return outcomes


def _chains(count: int) -> list[tuple[Any, Any]]:
    from tests.kinematics.frames.chains import KINDS, random_chain, random_end

    rng = np.random.default_rng(20)
    chains = [random_chain(rng, KINDS[i % len(KINDS)]) for i in range(count)]
    return [(chain, random_end(rng, chain[-1])) for chain in chains]


def _ours(chains: list[Any], convention: Any) -> Any:
    from kinematics.frames.assignment import assign_frames

    return lambda: [assign_frames(chain, convention) for chain in chains]


def _theirs(chains: list[Any], convention: Any) -> Any:
    from autodh.autodh import get_dh_parameters

    joints = [[_autodh_joint(axis) for axis in chain] for chain in chains]
    kind = _autodh_convention(convention)
    return lambda: [get_dh_parameters(chain, np.eye(4), np.eye(4), kind) for chain in joints]


def _autodh_joint(axis: Any) -> Any:
    from autodh.joint import Joint

    direction = np.array(axis.direction) / np.linalg.norm(axis.direction)
    turns = axis.joint.value == "revolute"
    return Joint(direction, axis.point, Joint.Type.Revolute if turns else Joint.Type.Prismatic)


def _autodh_convention(convention: Any) -> Any:
    from autodh.dh_table import DHTable

    conventions = DHTable.Convention
    return conventions.Standard if convention.value == "standard" else conventions.Modified


def _configurations(n: int) -> Any:
    return [np.zeros(n), *np.random.default_rng(n).normal(size=(2, n))]


def _moved(chain: Any, q: Any, tool: Any) -> Any:
    from tests.kinematics.frames.chains import motion

    pose = np.eye(4)
    for axis, value in zip(chain, q, strict=True):
        pose = pose @ motion(axis, value)
    return pose @ tool


def _wrong_ours(chain: Any, tool: Any, convention: Any) -> bool:
    from kinematics.forward import end_pose
    from kinematics.frames.assignment import assign_frames

    found = assign_frames(chain, convention, tool=tool)
    return any(
        np.abs(end_pose(found.table, q, base=found.base, tool=found.tool) - _moved(chain, q, tool)).max()
        > TOLERANCE
        for q in _configurations(len(chain))
    )


def _wrong_theirs(chain: Any, tool: Any, convention: Any) -> bool:
    from autodh.autodh import create_dh_table

    try:
        joints = [_autodh_joint(axis) for axis in chain]
        table = create_dh_table(joints, np.eye(4), tool, _autodh_convention(convention))
        return not all(
            np.abs(table.forward(list(q)) - _moved(chain, q, tool)).max() <= TOLERANCE
            for q in _configurations(len(chain))
        )
    except (AssertionError, ValueError, IndexError, FloatingPointError):
        return True
