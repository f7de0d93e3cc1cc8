"""How long a length may be before powers of it overflow."""

from collections.abc import Sequence

import numpy as np

from kinematics.errors import Fault, PoseError, TableError
from kinematics.se3 import Transform
from kinematics.table import NumericTable

LARGEST_LENGTH = 1e60  # Powers of lengths up to the fourth occur on the way, and a double ends at 1.8e308.


def check_lengths(table: NumericTable) -> None:
    """Make sure that the table's lengths can be computed with.

    Raises:
        TableError: a length beyond `LARGEST_LENGTH`, at ("rows", i, cell).
    """
    cells = [(i, cell) for i in range(len(table.rows)) for cell in ("a", "d")]
    faults = [too_long(("rows", i, cell)) for i, cell in cells if is_long(getattr(table.rows[i], cell))]
    if faults:
        raise TableError(faults)


def check_near(pose: Transform, name: str) -> None:
    """Make sure that a pose is not too far away to be computed with.

    Raises:
        PoseError: it is, at (name,).
    """
    if is_far(pose):
        raise PoseError(too_long((name,)))


def is_far(pose: Transform) -> bool:
    """Return whether a pose is too far away to be computed with."""
    return is_long(np.abs(pose[:3, 3]).max())


def is_long(length: float) -> bool:
    """Return whether a length is beyond `LARGEST_LENGTH`."""
    return abs(length) > LARGEST_LENGTH


def too_long(where: Sequence[str | int]) -> Fault:
    """Return the fault of a length that is."""
    return Fault.at("result_not_finite", *where, limit=LARGEST_LENGTH)
