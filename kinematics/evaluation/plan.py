"""Plans: what is kept of a table so that its second evaluation is faster than the first.

A first evaluation walks the recurrences on floats. From the `WARM`th on, the computation is recorded and made
a straight-line function; batches are recorded at once. A plan hangs on the table object it was made for, and
equal tables share it, so a caller who reads the same table again and again need not keep the object.
"""

from collections.abc import Callable, Sequence
from enum import StrEnum
from functools import cached_property, lru_cache
from threading import Lock
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from kinematics.angles import cos_sin
from kinematics.errors import Fault, JointValueError
from kinematics.evaluation.blocks import run_blocks
from kinematics.evaluation.recurrences import (
    LinkMotions,
    Rows,
    base_jacobian,
    end_jacobian,
    end_pose,
    frame_poses,
    link_poses,
    motions_of_table,
)
from kinematics.evaluation.straight_line import Evaluator, straight_line
from kinematics.evaluation.tape import Recorder, Tape
from kinematics.se3 import Floats, Scalar, check_transform
from kinematics.table import JointType, NumericTable

WARM = 8
"""A recording costs as much as 17 evaluations without one (a PUMA, 1.6 ms beside 0.1 ms); who has asked eight
times goes on asking."""
CACHED_TABLES = 64
"""Tables whose recordings are held at once: a class works on one exercise, a page on a handful."""
CACHED_VARIANTS = 4  # Pairs of base and tool held for one table: callers change them rarely.
LARGEST_TAPE = 1000
"""Longer computations are replayed from the tape: compiling grows faster than what it saves."""
SAFE_LENGTH = 1e300  # Lengths that add up to less stay finite through every product of the recurrences.


class Quantity(StrEnum):
    """What can be computed of a chain."""

    POSE = "pose"
    LINKS = "links"
    FRAMES = "frames"
    BASE_JACOBIAN = "base_jacobian"
    END_JACOBIAN = "end_jacobian"


class Computation:
    """One quantity of one chain: for one configuration or many, walked, recorded or made straight.

    Attributes:
        shape: of the quantity at one configuration.
        once: computes it at one configuration, given as a list of n finite floats.
    """

    def __init__(self, chain: LinkMotions, quantity: Quantity) -> None:
        n, rows = len(chain.joint_types), len(chain.links)
        shapes = {Quantity.POSE: (4, 4), Quantity.LINKS: (rows, 4, 4), Quantity.FRAMES: (rows, 4, 4)}
        self.shape = shapes.get(quantity, (6, n))
        self._chain = chain
        self._results = _RESULTS[quantity]
        self._uses = 0
        self._may_overflow = may_overflow(chain)
        self._unchecked: Evaluator = self._walk
        self.once: Evaluator = self._checked if self._may_overflow else self._walk

    def many(self, joints: Floats) -> Floats:
        """Return the quantity at many configurations, given as (m, n) finite floats; (m, …)."""
        out = np.empty((len(joints), *self.shape))
        if out.size:
            flat = out.reshape(len(joints), -1)
            run_blocks(self._tape, self._chain.joint_types, joints, flat)
            if self._may_overflow and not np.isfinite(flat).all():
                raise _overflow(int(np.argmin(np.isfinite(flat).all(axis=1))))
        return out

    def _checked(self, joints: Sequence[float]) -> Floats:
        """Evaluate where lengths and slides might add up to more than a double can hold."""
        array = self._unchecked(joints)
        if not np.isfinite(array).all():
            raise _overflow()
        return array

    def _walk(self, joints: Sequence[float]) -> Floats:
        """Evaluate without a recording the first few times, then make one."""
        self._uses += 1
        if self._uses > WARM and len(self._tape.operations) <= LARGEST_TAPE:
            return self._straighten()(joints)
        values = [
            q if kind is JointType.PRISMATIC else cos_sin(q)
            for q, kind in zip(joints, self._chain.joint_types, strict=True)
        ]
        results = np.array(self._results(self._chain, values)).reshape(self.shape)
        results += 0.0  # turns -0.0 into 0.0, as the other ways do
        return results

    def _straighten(self) -> Evaluator:
        """Put a straight-line function in the place of `_walk`."""
        self._unchecked = straight_line(self._tape, self._chain.joint_types, self.shape)
        if not self._may_overflow:
            self.once = self._unchecked
        return self._unchecked

    @cached_property
    def _tape(self) -> Tape:
        n = len(self._chain.joint_types)
        recorder = Recorder(2 * n)
        values = [
            recorder.inputs[joint]
            if kind is JointType.PRISMATIC
            else (recorder.inputs[joint], recorder.inputs[n + joint])
            for joint, kind in enumerate(self._chain.joint_types)
        ]
        return recorder.tape(self._results(self._chain, values))


class EvaluationPlan:
    """All computations of one table between one base and one tool."""

    def __init__(self, table: NumericTable, base: Floats | None, tool: Floats | None) -> None:
        self.chain = motions_of_table(table, base, tool)
        self.n_joints = table.n_joints
        self.has_tool = tool is not None
        self.pose = Computation(self.chain, Quantity.POSE)
        self._others: dict[Quantity, Computation] = {Quantity.POSE: self.pose}

    def of(self, quantity: Quantity) -> Computation:
        """Return the computation of a quantity."""
        found = self._others.get(quantity)
        if found is None:
            found = self._others[quantity] = Computation(self.chain, quantity)
        return found


class _Plans:
    """The plans of one table, by base and tool."""

    def __init__(self, table: NumericTable) -> None:
        self._table = table
        self.plain = EvaluationPlan(table, None, None)
        self._variants: dict[tuple[bytes | None, bytes | None], EvaluationPlan] = {}
        self._lock = Lock()

    def between(self, base: ArrayLike | None, tool: ArrayLike | None) -> EvaluationPlan:
        """Return the plan with a base and a tool; the few used last are kept."""
        base, tool = (
            None if pose is None else check_transform(pose, where=(name,))
            for name, pose in (("base", base), ("tool", tool))
        )
        key = (None if base is None else base.tobytes(), None if tool is None else tool.tobytes())
        with self._lock:
            found = self._variants.pop(key, None) or EvaluationPlan(self._table, base, tool)
            self._variants[key] = found
            if len(self._variants) > CACHED_VARIANTS:
                del self._variants[next(iter(self._variants))]
        return found

    def __reduce__(self) -> tuple[Any, ...]:
        # A table that goes to another process leaves its plans behind: functions made here cannot be pickled.
        return (_nothing, ())


def plan_of(
    table: NumericTable, base: ArrayLike | None = None, tool: ArrayLike | None = None
) -> EvaluationPlan:
    """Return the plan of a table, made if there is none yet.

    Raises:
        TableError: an entry of the table is NaN or infinite.
        PoseError: base or tool is not a rigid transform.
    """
    plans: _Plans | None = table.__dict__.get("_plans")
    if plans is None:
        plans = table.__dict__["_plans"] = _plans_of_equal(table)
    return plans.plain if base is None and tool is None else plans.between(base, tool)


def _nothing() -> None:
    return None


_plans_of_equal = lru_cache(maxsize=CACHED_TABLES)(_Plans)


def may_overflow(chain: LinkMotions) -> bool:
    """Return whether finite joint values can give infinite results.

    Rotations are bounded, but shifts add up.
    """
    shifts = [
        motion.first for motions in chain.links for motion in motions if motion.kind.startswith("shift")
    ]
    shifts += [row[3] for pose in (chain.base, chain.tool) if pose is not None for row in pose]
    return JointType.PRISMATIC in chain.joint_types or sum(map(abs, shifts)) > SAFE_LENGTH


def _overflow(*where: int) -> JointValueError:
    return JointValueError(Fault.at("result_not_finite", "joints", *where))


def _flat(*poses: Rows) -> list[Scalar]:
    return [x for r0, r1, r2 in poses for x in (*r0, *r1, *r2, 0.0, 0.0, 0.0, 1.0)]


def _by_rows(columns: Sequence[Sequence[Scalar]]) -> list[Scalar]:
    return [column[i] for i in range(6) for column in columns]


_RESULTS: dict[Quantity, Callable[[LinkMotions, Sequence[Any]], list[Scalar]]] = {
    Quantity.POSE: lambda chain, values: _flat(end_pose(chain, values)),
    Quantity.LINKS: lambda chain, values: _flat(*link_poses(chain, values)),
    Quantity.FRAMES: lambda chain, values: _flat(*frame_poses(chain, values)),
    Quantity.BASE_JACOBIAN: lambda chain, values: _by_rows(base_jacobian(chain, values)),
    Quantity.END_JACOBIAN: lambda chain, values: _by_rows(end_jacobian(chain, values)),
}
