"""Forward kinematics of the PUMA 560 beside roboticstoolbox and Pinocchio."""

import numpy as np

from bench import Outcome, race
from bench.peers import PinocchioPuma, puma560, puma560_ets

TITLE = "Forward kinematics, PUMA 560"
ABOUT = """
`ETS.eval` is the fast path of roboticstoolbox, a C extension that takes a whole batch; `pin` computes all
joint frames of one configuration in C++, and reading the flange's pose as a 4×4 array is part of the work on
both sides. Its batch is therefore a loop that fills one array. Joint values are uniform in ±π.
"""

ETS, PIN = "roboticstoolbox `ETS.eval`", "`pin` FK, pose read"
MANY = 100_000


def rows() -> list[Outcome]:
    """Measure."""
    from kinematics.forward import end_pose, end_poses, forward_kinematics

    table, ets, pin = puma560(), puma560_ets(), PinocchioPuma()
    batch = np.random.default_rng(560).uniform(-np.pi, np.pi, (MANY, 6))
    q, few = batch[0], batch[:10_000]
    for theirs in (ets.eval(batch), pin.poses(batch)):
        np.testing.assert_allclose(end_poses(table, batch), theirs, atol=1e-14)
    np.testing.assert_allclose(end_pose(table, q), pin.pose(q), atol=1e-14)
    one = {ETS: lambda: ets.eval(q), PIN: lambda: pin.pose(q)}
    return [
        *race(
            "100 000 configurations → 4×4 poses, each",
            lambda: end_poses(table, batch),
            {ETS: lambda: ets.eval(batch), PIN: lambda: pin.poses(few)},
            bars={ETS: 10, PIN: 8},
            items={"ours": MANY, ETS: MANY, PIN: len(few)},
        ),
        *race("one configuration → 4×4 pose", lambda: end_pose(table, q), one, bars={ETS: 1, PIN: 0.5}),
        *race(
            "one configuration through `forward_kinematics`, pose read",
            lambda: forward_kinematics(table, q).transform,
            one,
            bars={ETS: 1, PIN: 0.5},
        ),
    ]
