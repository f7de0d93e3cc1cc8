"""What is measured between joint axes, read off the rows of tables where one row leads to the next joint.

There α is the angle between the axes, `a` the distance along their common normal, counted as z × z' points,
and d what lies between the feet of two normals; no axis need be carried through space. Along parallel axes
the d add up, each as its axis points; to the last one adds what its d comes to along the first, and where the
axis behind is parallel to it there is no foot, and its d counts for nothing. What is not seen so is measured
between the axes: where rows without a joint, prismatic joints or frames take part, and axes that are parallel
only nearly.
"""

from collections.abc import Sequence
from itertools import pairwise
from typing import NamedTuple, TypeAlias

import numpy as np
from numpy.typing import NDArray

from kinematics.caching import USUAL_INVARIANTS, cached_by_size
from kinematics.equivalence.batches import Variation, axes_of_tables, cells_of_tables
from kinematics.equivalence.measures import PARALLEL, PLAIN_OFFSET, Measure, Shape, measured
from kinematics.equivalence.policy import Policy
from kinematics.se3 import Floats
from kinematics.table import NumericTable

Places: TypeAlias = NDArray[np.intp] | slice
"""Evenly spaced places are a slice: an array of a few takes ten times as long."""

EXACTLY = 1e-12  # A sine: axes are parallel but for the errors of the arithmetic.


def measured_of_tables(
    shapes: tuple[Shape, ...],
    tables: Sequence[NumericTable],
    variations: Sequence[Variation],
    policy: Policy,
    angles_alone: Sequence[int] = (),
) -> Floats:
    """Return (q, k) invariants of tables in which some cells are changed, as their axes point.

    Args:
        shapes: the invariants, as `measured` takes them.
        tables: tables with the same number of joints.
        policy: what is fixed at the ends.
        angles_alone: numbers of candidates of which only the angles are wanted; their lengths may be wrong.
    """
    joints = tables[0].joint_rows
    seen = _seen(shapes, len(joints)) if joints and _has_a_row_each(tables) else None
    if seen is None:
        return measured(shapes, axes_of_tables(tables, variations, policy))
    first, last = joints[0], joints[-1] + 1
    cells = cells_of_tables(tables, variations)
    found, doubtful = _read(seen, cells[first + 1 : last], cells[first:last, 3].real)
    if angles_alone:
        doubtful[angles_alone] = False
    if doubtful.any():
        which = np.flatnonzero(doubtful)
        some = [variations[k] for k in which.tolist()]
        found[:, which] = measured(shapes, axes_of_tables(tables, some, policy))
    return found


def _has_a_row_each(tables: Sequence[NumericTable]) -> bool:
    """Whether the same rows, one after the other, hold the joints of all tables, none of them reversed."""
    rows = tables[0].joint_rows
    return rows[-1] - rows[0] == len(rows) - 1 and all(
        table.joint_rows == rows and all(table.rows[i].sign > 0 for i in rows) for table in tables
    )


class _Seen(NamedTuple):
    """Invariants by what they are read off; links and joints are counted from 0, link i leading from joint i.

    Attributes:
        number: how many there are.
        angles: places among the invariants, and links.
        normals: of distances along common normals the same.
        across: of distances from parallel axes the same.
        offsets: places, and joints, of offsets along one axis.
        runs: places, and the first and the last joint, of offsets along several.
        upto: (links, 1) sines up to which nothing is read but of parallel axes: those of axes parallel
            only nearly; inside a run, where the axes behind are not parallel to its first, any.
    """

    number: int
    angles: tuple[Places, Places]
    normals: tuple[Places, Places]
    across: tuple[Places, Places]
    offsets: tuple[Places, Places]
    runs: tuple[tuple[int, int, int], ...]
    upto: Floats


@cached_by_size(lambda shapes, joints: len(shapes), longest=USUAL_INVARIANTS, most=1024, few=32)
def _seen(shapes: tuple[Shape, ...], joints: int) -> _Seen | None:
    """What is read where; None if not all is seen in the rows."""
    angles: list[tuple[int, int]] = []
    normals: list[tuple[int, int]] = []
    across: list[tuple[int, int]] = []
    offsets: list[tuple[int, int]] = []
    runs: list[tuple[int, int, int]] = []
    inside: set[int] = set()
    for place, (measure, axes) in enumerate(shapes):
        if min(axes) < 1 or max(axes) > joints or measure in (Measure.TURN, Measure.SUM):
            return None
        if measure is Measure.OFFSET:
            if len(axes) != PLAIN_OFFSET:
                return None
            before, first, last, after = (axis - 1 for axis in axes)
            if before != first - 1 or after != last + 1:
                return None
            inside |= set(range(first, last - 1))
            if first == last:
                offsets.append((place, first))
            else:
                runs.append((place, first, last))
            continue
        if axes[1] != axes[0] + 1:
            return None
        if measure is Measure.ANGLE:
            angles.append((place, axes[0] - 1))
        elif axes[2:] == axes[:1]:
            across.append((place, axes[0] - 1))
        elif set(axes[2:]) == set(axes[:2]):
            normals.append((place, axes[0] - 1))
        else:
            return None
    return _Seen(
        number=len(shapes),
        angles=_columns(angles),
        normals=_columns(normals),
        across=_columns(across),
        offsets=_columns(offsets),
        runs=tuple(runs),
        upto=np.array([np.inf if link in inside else PARALLEL for link in range(joints - 1)])[:, None],
    )


def _columns(pairs: Sequence[tuple[int, int]]) -> tuple[Places, Places]:
    return _places([place for place, _ in pairs]), _places([number for _, number in pairs])


def _places(numbers: Sequence[int]) -> Places:
    steps = {two - one for one, two in pairwise(numbers)} or {1}
    if numbers and len(steps) == 1 and (step := min(steps)) > 0:
        return slice(numbers[0], numbers[-1] + 1, step)
    return np.array(numbers, dtype=np.intp)


def _read(seen: _Seen, links: NDArray[np.complex128], d: Floats) -> tuple[Floats, NDArray[np.bool_]]:
    """The invariants (q, k), and in which tables they are not what is read: (k,).

    Args:
        seen: what is read where.
        links: (joints - 1, 4, k) the rows that lead from joint to joint, as `cells_of_tables` gives them.
        d: (joints, k) the offsets of all joints.
    """
    cosine, sine, a = links[:, 0].real, -links[:, 0].imag, links[:, 1].real
    size, lengths = np.abs(sine), np.abs(a)
    steep = size > PARALLEL
    found = np.empty((seen.number, d.shape[1]))
    places, which = seen.angles
    found[places] = np.arctan2(size, cosine)[which]
    places, which = seen.normals
    found[places] = np.where(steep, np.copysign(a, a * sine), lengths)[which]
    places, which = seen.across
    found[places] = lengths[which]
    ends = np.where(steep, d[:-1], 0.0)
    places, which = seen.offsets
    found[places] = ends[which]
    for place, first, last in seen.runs:
        ways = np.multiply.accumulate(cosine[first:last], axis=0)
        found[place] = d[first] + (ways[:-1] * d[first + 1 : last]).sum(axis=0) + ways[-1] * ends[last]
    doubtful = (size > EXACTLY) & (size <= seen.upto)
    return found, np.asarray(doubtful.any(axis=0))
