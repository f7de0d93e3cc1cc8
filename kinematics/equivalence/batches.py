"""The joint axes of hundreds of tables at once.

A standard table is a modified one in which a and α stand a row lower, and one row more at the end:

    Rot_z(θ_1) Trans_z(d_1) · Trans_x(a_1) Rot_x(α_1) Rot_z(θ_2) Trans_z(d_2) · …

so tables of either convention are carried along by one product, the candidates side by side in the last index
of every array.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from kinematics.angles import cos_sin
from kinematics.chain import Axis
from kinematics.equivalence.policy import BaseRule, Policy, ToolRule
from kinematics.table import Convention, NumericTable

Floats = NDArray[np.float64]
CellChange = tuple[int, str, float]
"""Row (counted from 0), cell and its new value."""
Variation = tuple[int, Sequence[CellChange]]
"""The number of a table, and the cells in which a candidate differs from it."""

# Where the numbers of a cell stand among the six of a row: cos α, sin α, a, cos θ, sin θ, d.
_PLACE = {"alpha": 0, "a": 2, "theta": 3, "d": 5}
_ALONG_X = ("alpha", "a")
_NOTHING = (1.0, 0.0, 0.0)


class AxisBatch(NamedTuple):
    """Lines in space, of many chains side by side.

    Attributes:
        directions: (3, m, k) unit directions.
        points: (3, m, k) a point of each.
    """

    directions: Floats
    points: Floats

    def at(self, which: Sequence[int]) -> AxisBatch:
        """The lines of some of the chains."""
        return AxisBatch(self.directions[:, :, which], self.points[:, :, which])


def axis_batch(chains: Sequence[Sequence[Axis]]) -> AxisBatch:
    """Lines that are known already, those of one chain after those of another."""
    directions = np.array([[axis.direction for axis in axes] for axes in chains], dtype=np.float64)
    points = np.array([[axis.point for axis in axes] for axes in chains], dtype=np.float64)
    return AxisBatch(directions.transpose(2, 1, 0), points.transpose(2, 1, 0))


def axes_of_tables(
    tables: Sequence[NumericTable], variations: Sequence[Variation], policy: Policy
) -> AxisBatch:
    """The axes of `axes_of`, for tables in which some cells are changed.

    Args:
        tables: tables with the same number of joints.
        variations: the candidates.
        policy: what is fixed at the ends.

    Returns:
        The axes of every candidate: the base's place, the joints', the tool's.
    """
    directions, points, ends = _carried(_cells(tables, variations))
    which = [number for number, _ in variations]
    joints = len(tables), len(tables[0].joint_rows)
    rows = np.array([table.joint_rows for table in tables], dtype=np.intp).reshape(joints).T[:, which]
    signs = np.array([[table.rows[i].sign for i in table.joint_rows] for table in tables], dtype=np.float64)
    n, k = rows.shape
    found = AxisBatch(np.zeros((3, n + 2, k)), np.zeros((3, n + 2, k)))
    found.directions[:, 1:-1] = directions[:, rows, np.arange(k)] * signs.reshape(joints).T[:, which]
    found.points[:, 1:-1] = points[:, rows, np.arange(k)]
    found.points[:, -1] = ends[1]
    if policy.base is BaseRule.FRAME:
        found.directions[2, 0] = 1.0
    else:
        found.directions[:, 0] = found.directions[:, 1]
    found.directions[:, -1] = ends[0] if policy.tool is ToolRule.FRAME else found.directions[:, -2]
    return found


def _cells(tables: Sequence[NumericTable], variations: Sequence[Variation]) -> Floats:
    """The six numbers of every row in the order of a modified table, (6, rows, k)."""
    lower = [table.convention is Convention.STANDARD for table in tables]
    length = max(len(table.rows) + down for table, down in zip(tables, lower, strict=True))
    plain = np.array([_plain(table, length) for table in tables], dtype=np.float64).transpose(2, 1, 0)
    cells = plain[:, :, [number for number, _ in variations]]
    places: list[tuple[int, int, int]] = []
    values: list[float] = []
    for k, (number, changes) in enumerate(variations):
        for i, cell, value in changes:
            place, at = _PLACE[cell], i + (lower[number] and cell in _ALONG_X)
            if cell in ("a", "d"):
                places.append((place, at, k))
                values.append(value)
            else:
                places += (place, at, k), (place + 1, at, k)
                values += cos_sin(value)
    if places:
        p, r, k = np.array(places).T
        cells[p, r, k] = values
    return cells


def _plain(table: NumericTable, length: int) -> list[tuple[float, ...]]:
    """The six numbers of so many rows: a table's, and such that change nothing."""
    along_x = [(*cos_sin(row.alpha), row.a) for row in table.rows]
    along_z = [(*cos_sin(row.theta), row.d) for row in table.rows]
    if table.convention is Convention.STANDARD:
        along_x.insert(0, _NOTHING)
    along_x += [_NOTHING] * (length - len(along_x))
    along_z += [_NOTHING] * (length - len(along_z))
    return [(*x, *z) for x, z in zip(along_x, along_z, strict=True)]


def _carried(cells: Floats) -> tuple[Floats, Floats, tuple[Floats, Floats]]:
    """The z axis of every row, about or along which its joint would move, and that of frame N.

    Returns:
        (3, rows, k) directions, (3, rows, k) points, and frame N's z axis and origin, (3, k) each.
    """
    _, rows, k = cells.shape
    directions, points = np.empty((3, rows, k)), np.empty((3, rows, k))
    x, y, z = (np.zeros((3, k)) for _ in range(3))
    x[0] = y[1] = z[2] = 1.0
    p = np.zeros((3, k))
    for i in range(rows):
        cos_alpha, sin_alpha, a, cos_theta, sin_theta, d = cells[:, i]
        y, z = cos_alpha * y + sin_alpha * z, cos_alpha * z - sin_alpha * y
        p = p + a * x
        directions[:, i], points[:, i] = z, p
        x, y = cos_theta * x + sin_theta * y, cos_theta * y - sin_theta * x
        p = p + d * z
    return directions, points, (z, p)
