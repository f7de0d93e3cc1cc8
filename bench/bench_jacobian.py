"""Geometric Jacobians of the PUMA 560 beside roboticstoolbox and Pinocchio."""

import numpy as np

from bench import Outcome, race
from bench.peers import PinocchioPuma, loop, puma560, puma560_ets

TITLE = "Numeric Jacobian, PUMA 560"
ABOUT = """
J0 (6×6, linear rows on top, axes of frame 0) and Jn (axes of the end frame). `ETS.jacob0` and `ETS.jacobe`
are the C extension of roboticstoolbox; it takes one configuration at a time, so both peers loop over a batch.
"""

ETS, PIN = "roboticstoolbox `ETS.jacob0`", "`pin` frame Jacobian"
ETS_END = "roboticstoolbox `ETS.jacobe`"
MANY = 100_000


def rows() -> list[Outcome]:
    """Measure."""
    from kinematics.jacobian import JacobianFrame, jacobian

    table, ets, pin = puma560(), puma560_ets(), PinocchioPuma()
    batch = np.random.default_rng(560).uniform(-np.pi, np.pi, (MANY, 6))
    q, few = batch[0], batch[:5_000]
    end = JacobianFrame.END
    np.testing.assert_allclose(jacobian(table, q), ets.jacob0(q), atol=1e-14)
    np.testing.assert_allclose(jacobian(table, q), pin.jacobian(q), atol=1e-14)
    np.testing.assert_allclose(jacobian(table, few), [ets.jacob0(one) for one in few], atol=1e-14)
    np.testing.assert_allclose(jacobian(table, q, end), ets.jacobe(q), atol=1e-14)
    return [
        *race(
            "J0, one configuration",
            lambda: jacobian(table, q),
            {ETS: lambda: ets.jacob0(q), PIN: lambda: pin.jacobian(q)},
            bars={ETS: 1},
        ),
        *race(
            "Jn, one configuration",
            lambda: jacobian(table, q, end),
            {ETS_END: lambda: ets.jacobe(q)},
            bars={ETS_END: 1},
        ),
        *race(
            "J0, 100 000 configurations, each",
            lambda: jacobian(table, batch),
            {ETS: loop(ets.jacob0, few), PIN: loop(pin.jacobian, few)},
            bars={ETS: 10},
            items={"ours": MANY, ETS: len(few), PIN: len(few)},
        ),
    ]
