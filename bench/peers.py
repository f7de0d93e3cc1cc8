"""The PUMA 560 as each peer writes it, from the figures of one standard DH table."""

import math
from collections.abc import Callable
from typing import Any

import numpy as np

from kinematics.se3 import Transform
from kinematics.table import Convention, DHRow, DHTable, JointType, NumericTable

ALPHA = (math.pi / 2, 0.0, -math.pi / 2, math.pi / 2, -math.pi / 2, 0.0)
A = (0.0, 0.4318, 0.0203, 0.0, 0.0, 0.0)
D = (0.0, 0.0, 0.15005, 0.4318, 0.0, 0.0)


def puma560() -> NumericTable:
    """Our own table."""
    rows = (
        DHRow(joint=JointType.REVOLUTE, theta=0.0, d=d, a=a, alpha=alpha)
        for alpha, a, d in zip(ALPHA, A, D, strict=True)
    )
    return DHTable(convention=Convention.STANDARD, rows=tuple(rows))


def puma560_ets() -> Any:
    """Elementary transform sequence of roboticstoolbox: the fast path of that library."""
    import roboticstoolbox as rtb

    links = [rtb.RevoluteDH(d=d, a=a, alpha=alpha) for alpha, a, d in zip(ALPHA, A, D, strict=True)]
    return rtb.DHRobot(links).ets()


class PinocchioPuma:
    """Pinocchio's model of the arm, with an operational frame at the flange (frame 6 of the table)."""

    def __init__(self) -> None:
        import pinocchio as pin

        self.pin = pin
        self.model = pin.Model()
        parent, placement = 0, pin.SE3.Identity()
        for i, (alpha, a, d) in enumerate(zip(ALPHA, A, D, strict=True)):
            parent = self.model.addJoint(parent, pin.JointModelRZ(), placement, f"joint{i + 1}")
            twist = pin.SE3(pin.utils.rotate("x", alpha), np.array([a, 0.0, 0.0]))
            placement = pin.SE3(np.eye(3), np.array([0.0, 0.0, d])) * twist
        frame = pin.Frame("flange", parent, 0, placement, pin.FrameType.OP_FRAME)
        self.flange = self.model.addFrame(frame)
        self.data = self.model.createData()

    def pose(self, q: Transform) -> Transform:
        """Pose of the flange, read as a 4×4 array."""
        self.pin.framesForwardKinematics(self.model, self.data, q)
        return self.data.oMf[self.flange].homogeneous

    def poses(self, configurations: Transform) -> Transform:
        """One pose per configuration, in one array."""
        out = np.empty((len(configurations), 4, 4))
        forward, model, data = self.pin.framesForwardKinematics, self.model, self.data
        frames, flange = data.oMf, self.flange
        for i, q in enumerate(configurations):
            forward(model, data, q)
            out[i] = frames[flange].homogeneous
        return out

    def jacobian(self, q: Transform) -> Transform:
        """J0 of the flange: linear velocity on top, both parts in the axes of frame 0."""
        pin = self.pin
        return pin.computeFrameJacobian(self.model, self.data, q, self.flange, pin.LOCAL_WORLD_ALIGNED)


def loop(function: Callable[[Transform], object], configurations: Transform) -> Callable[[], None]:
    """Call a function that knows one configuration only for each of many."""

    def run() -> None:
        for q in configurations:
            function(q)

    return run
