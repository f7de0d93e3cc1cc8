"""Hypothesis strategies for numeric tables and configurations, degenerate ones on purpose."""

import math

import numpy as np
from hypothesis import strategies as st

from kinematics.table import Convention, DHRow, DHTable, JointType, NumericTable

TINY = (1e-12, -1e-12, 3e-9, 1e-6)

lengths = st.one_of(
    st.just(0.0), st.sampled_from((0.4318, -0.15005, 1.0, 250.0, *TINY)), st.floats(-2.0, 2.0)
)
right_angles = st.integers(-24, 24).map(lambda k: k * math.pi / 12)
constant_angles = st.one_of(
    st.sampled_from((0.0, math.pi / 2, -math.pi / 2, math.pi)),
    right_angles,
    st.sampled_from((*TINY, math.pi + 1e-12, math.pi / 2 - 1e-9, 1.57, 100.0)),
    st.floats(-7.0, 7.0),
)
joint_angles = st.one_of(
    st.floats(-math.pi, math.pi),
    st.sampled_from((0.0, math.pi, -math.pi, math.pi / 2, np.nextafter(math.pi, 4), *TINY)),
    st.integers(-1001, 1001).map(lambda k: k * math.pi),
    st.floats(-1e6, 1e6),
    st.sampled_from((1e15, -1e22, 5e-324)),
)
slides = st.one_of(st.sampled_from((0.0, 1.0, -1.0, *TINY)), st.floats(-3.0, 3.0))


@st.composite
def rows(draw: st.DrawFn, joints: st.SearchStrategy[JointType] | None = None) -> DHRow[float]:
    """One row, with zeros and right angles far more often than chance would have them."""
    return DHRow(
        joint=draw(joints if joints is not None else st.sampled_from(JointType)),
        theta=draw(constant_angles),
        d=draw(lengths),
        a=draw(lengths),
        alpha=draw(constant_angles),
        sign=draw(st.sampled_from((1, 1, 1, -1))),
    )


@st.composite
def tables(draw: st.DrawFn, min_rows: int = 0, max_rows: int = 8) -> NumericTable:
    """A table of any kind: fixed rows anywhere, prismatic ends, reversed variables."""
    return DHTable(
        convention=draw(st.sampled_from(Convention)),
        rows=tuple(draw(st.lists(rows(), min_size=min_rows, max_size=max_rows))),
    )


@st.composite
def configured(draw: st.DrawFn, min_rows: int = 0, max_rows: int = 8) -> tuple[NumericTable, list[float]]:
    """A table and one configuration of it."""
    table = draw(tables(min_rows=min_rows, max_rows=max_rows))
    return table, draw(configurations(table))


def configurations(table: NumericTable) -> st.SearchStrategy[list[float]]:
    """Joint values of a table."""
    kinds = [slides if kind is JointType.PRISMATIC else joint_angles for kind in table.joint_types]
    return st.tuples(*kinds).map(list)


@st.composite
def transforms(draw: st.DrawFn) -> np.ndarray:
    """A rigid transform, sometimes the identity, a pure shift or a half turn."""
    kind = draw(st.sampled_from(("identity", "shift", "turn", "any")))
    pose = np.eye(4)
    if kind in ("turn", "any"):
        w, x, y, z = draw(
            st.tuples(*[st.floats(-1.0, 1.0)] * 4).filter(lambda v: math.hypot(*v) > 1e-3)
            | st.sampled_from([(0.0, 1.0, 0.0, 0.0), (1.0, 1e-12, 0.0, 0.0), (1e-9, 0.0, 0.0, 1.0)])
        )
        n = math.hypot(w, x, y, z)
        w, x, y, z = w / n, x / n, y / n, z / n
        pose[:3, :3] = [
            [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
            [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
            [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
        ]
    if kind in ("shift", "any"):
        pose[:3, 3] = draw(st.tuples(*[st.floats(-2.0, 2.0)] * 3))
    return pose
