"""The joint axes of hundreds of tables at once.

A standard table is a modified one in which a and α stand a row lower, and one row more at the end:

    Rot_z(θ_1) Trans_z(d_1) · Trans_x(a_1) Rot_x(α_1) Rot_z(θ_2) Trans_z(d_2) · …

so tables of either convention are carried along by one product, the candidates side by side in the last index
of every array.
"""

from collections.abc import Sequence
from functools import lru_cache
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from kinematics.angles import cos_sin
from kinematics.chain import Axis
from kinematics.equivalence.policy import BaseRule, Policy, ToolRule
from kinematics.se3 import Floats
from kinematics.table import LENGTHS, Convention, NumericTable

Numbers = NDArray[np.complex128]
CellChange = tuple[int, str, float]  # Row (counted from 0), cell and its new value.
Variation = tuple[int, Sequence[CellChange]]
"""The number of a table, and the cells in which a candidate differs from it."""

# Where the number of a cell stands among the four of a row: exp(-iα), a, exp(-iθ), d.
_PLACE = {"alpha": 0, "a": 1, "theta": 2, "d": 3}
_NUMBERS = len(_PLACE)
_PLACE_LOWER = {**_PLACE, **{cell: _PLACE[cell] + _NUMBERS for cell in ("alpha", "a")}}
_NOTHING: tuple[complex, ...] = (1.0, 0.0, 1.0, 0.0)


class AxisBatch(NamedTuple):
    """Lines in space, of many chains side by side.

    Attributes:
        directions: (m, 3, k) unit directions.
        points: (m, 3, k) a point of each.
    """

    directions: Floats
    points: Floats


def axis_batch(chains: Sequence[Sequence[Axis]]) -> AxisBatch:
    """Return the lines that are known already, those of one chain after those of another."""
    directions = np.array([[axis.direction for axis in axes] for axes in chains], dtype=np.float64)
    points = np.array([[axis.point for axis in axes] for axes in chains], dtype=np.float64)
    return AxisBatch(directions.transpose(1, 2, 0), points.transpose(1, 2, 0))


def axes_of_tables(
    tables: Sequence[NumericTable], variations: Sequence[Variation], policy: Policy
) -> AxisBatch:
    """Return the axes of `axes_of`, for tables in which some cells are changed.

    Returns:
        The axes of every candidate: the base's place, the joints', the tool's.
    """
    which = [number for number, _ in variations]
    directions, points, end = _carried(cells_of_tables(tables, variations))
    joints = [table.joint_rows for table in tables]
    n, k = len(joints[0]), len(which)
    found = AxisBatch(np.zeros((n + 2, 3, k)), np.zeros((n + 2, 3, k)))
    if joints.count(joints[0]) == len(joints):
        rows = np.array(joints[0], dtype=np.intp)
        directions.take(rows, axis=0, out=found.directions[1:-1], mode="clip")
        points.take(rows, axis=0, out=found.points[1:-1], mode="clip")
    else:
        each = np.array(joints, dtype=np.intp).reshape(len(joints), n).T[:, which]
        found.directions[1:-1] = directions[each, :, np.arange(k)].transpose(0, 2, 1)
        found.points[1:-1] = points[each, :, np.arange(k)].transpose(0, 2, 1)
    signs = [[table.rows[i].sign for i in rows] for table, rows in zip(tables, joints, strict=True)]
    if any(sign < 0 for each in signs for sign in each):
        found.directions[1:-1] *= np.array(signs, dtype=np.float64).T[:, None, which]
    found.points[-1] = points[-1]
    if policy.base is BaseRule.FRAME:
        found.directions[0, 2] = 1.0
    else:
        found.directions[0] = found.directions[1]
    found.directions[-1] = end if policy.tool is ToolRule.FRAME else found.directions[-2]
    return found


def cells_of_tables(tables: Sequence[NumericTable], variations: Sequence[Variation]) -> Numbers:
    """Return the four numbers of every row in the order of a modified table, (rows, 4, k).

    They are exp(-iα), a, exp(-iθ) and d; arguments as of `axes_of_tables`.
    """
    which = [number for number, _ in variations]
    lower = [table.convention is Convention.STANDARD for table in tables]
    length = max(len(table.rows) + down for table, down in zip(tables, lower, strict=True))
    plain = _plain(tables, lower, length)
    cells = plain.transpose(1, 2, 0).take(which, axis=2)
    k = len(which)
    changes = [
        ((i * _NUMBERS + place[cell]) * k + at, cell, value)
        for at, (number, changes) in enumerate(variations)
        for place in (_PLACE_LOWER if lower[number] else _PLACE,)
        for i, cell, value in changes
    ]
    if changes:
        values = [value if cell in LENGTHS else _turn(value) for _, cell, value in changes]
        cells.put([place for place, _, _ in changes], values)
    return cells


def _plain(tables: Sequence[NumericTable], lower: Sequence[bool], length: int) -> Numbers:
    """The four numbers of so many rows of tables, of which many have rows in common, (tables, rows, 4).

    Args:
        lower: in which of them a and α stand a row lower.
        length: how many rows; behind a table's own stand such that change nothing.
    """
    numbers = [_NOTHING]
    places: dict[int, int] = {}
    along_x, along_z = [], []
    for table, down in zip(tables, lower, strict=True):
        for row in table.rows:
            if id(row) not in places:
                places[id(row)] = len(numbers)
                numbers.append((_turn(row.alpha), row.a, _turn(row.theta), row.d))
        own = [places[id(row)] for row in table.rows]
        rest = [0] * (length - len(own))
        along_z.append(own + rest)
        along_x.append([0, *own, *rest[1:]] if down else own + rest)
    known = np.array(numbers, dtype=np.complex128)
    plain = known.take(along_z, axis=0)
    if any(lower):
        plain[..., :2] = known[:, :2].take(along_x, axis=0)
    return plain


@lru_cache(maxsize=4096)
def _turn(angle: float) -> complex:
    """Return exp(-i angle); cached, for most angles are right ones."""
    cosine, sine = cos_sin(angle)
    return complex(cosine, -sine)


def _carried(cells: Numbers) -> tuple[Floats, Floats, Floats]:
    """The z axis of every row, about or along which its joint would move, and that of frame N.

    A rotation about x turns y and z in their plane, as multiplying y + iz by a number of length one does; one
    about z so turns x + iy.

    Returns:
        (rows, 3, k) directions, (rows + 1, 3, k) points, the last of them frame N's origin, and (3, k) its z
        axis.
    """
    rows, _, k = cells.shape
    y_z, x_y = np.empty((2, rows + 1, 3, k), dtype=np.complex128)
    y_z[0] = np.array((0.0, 0.0, 1.0j))[:, None]
    x_y[0] = np.array((1.0, 1.0j, 0.0))[:, None]
    x, y = x_y.real, x_y.imag
    beside, z = y_z.real, y_z.imag
    for i in range(rows):
        beside[i] = y[i]
        np.multiply(y_z[i], cells[i, 0], out=y_z[i + 1])
        y[i] = beside[i + 1]
        np.multiply(x_y[i], cells[i, 2], out=x_y[i + 1])
    lengths = cells.real
    points = np.zeros((rows + 1, 3, k))
    np.multiply(z[1:], lengths[:, 3, None], out=points[1:])
    points[:-1] += lengths[:, 1, None] * x[:-1]
    np.cumsum(points, axis=0, out=points)
    return z[1:], points, z[-1]
