"""Tables as students have them, in text and in numbers, and their poses by products of the printed matrices.

Nothing here is computed by the package: the numbers are those from which the text is made.
"""

import random
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from exercises.instance import Instance
from exercises.parts.joint_draws import key_numbers
from kinematics.cells import LengthUnit, RawRow, RawTable
from kinematics.table import Convention, JointType, NumericTable

Complexes = NDArray[np.complex128]
TINY = 1e-30
"""A step along the imaginary axis: it gives a derivative to the last digit."""


@dataclass(frozen=True)
class PlainRow:
    """A row in numbers; angles in [rad]. `slides` is None in a row without a variable."""

    alpha: float
    a: float
    d: float
    theta: float
    sign: int
    slides: bool | None


@dataclass(frozen=True)
class PlainTable:
    """A table in numbers."""

    modified: bool
    rows: tuple[PlainRow, ...]
    least: float = 0.0

    @property
    def reach(self) -> float:
        """The lengths of all links together, not less than those of the exercise's robot."""
        return max(self.least, sum(abs(row.a) + abs(row.d) for row in self.rows)) or 1.0

    def links(self, joints: list[complex] | list[float]) -> list[Complexes]:
        """The matrix of each row: two turns and two shifts, one after the other."""
        values = iter(joints)
        found = []
        for row in self.rows:
            theta: complex = row.theta
            d: complex = row.d
            if row.slides is not None:
                q = row.sign * next(values)
                theta, d = (theta, d + q) if row.slides else (theta + q, d)
            about_z, about_x = np.eye(4, dtype=complex), np.eye(4, dtype=complex)
            about_z[:2, :2] = [[np.cos(theta), -np.sin(theta)], [np.sin(theta), np.cos(theta)]]
            about_z[2, 3] = d
            about_x[1:3, 1:3] = [
                [np.cos(row.alpha), -np.sin(row.alpha)],
                [np.sin(row.alpha), np.cos(row.alpha)],
            ]
            about_x[0, 3] = row.a
            found.append(about_x @ about_z if self.modified else about_z @ about_x)
        return found

    def frames(self, joints: list[complex] | list[float]) -> list[Complexes]:
        """Frame 0 to N in frame 0."""
        found = [np.eye(4, dtype=complex)]
        for link in self.links(joints):
            found.append(found[-1] @ link)
        return found

    def pose(self, joints: list[float]) -> NDArray[np.float64]:
        """⁰T_N."""
        return self.frames(joints)[-1].real

    def jacobian(self, joints: list[float]) -> NDArray[np.float64]:
        """(6, n): what the last frame's origin moves by, and the spin Ṙ Rᵀ, by differences."""
        R = self.pose(joints)[:3, :3]
        columns = []
        for i in range(len(joints)):
            moved = [q + TINY * 1j * (k == i) for k, q in enumerate(joints)]
            rate = self.frames(moved)[-1].imag / TINY
            spin = rate[:3, :3] @ R.T
            columns.append([*rate[:3, 3], spin[2, 1], spin[0, 2], spin[1, 0]])
        return np.array(columns).T


def plain(table: NumericTable) -> PlainTable:
    """The numbers of a table of the package."""
    slides = {JointType.REVOLUTE: False, JointType.PRISMATIC: True, JointType.FIXED: None}
    return PlainTable(
        table.convention is Convention.MODIFIED,
        tuple(
            PlainRow(row.alpha, row.a, row.d, row.theta, row.sign, slides[row.joint]) for row in table.rows
        ),
    )


def written(table: NumericTable, unit: LengthUnit) -> RawTable:
    """A table of the package as somebody would type it, in [rad]."""
    rows, joint = [], 0
    for row in table.rows:
        cells: dict[str, str | float] = {"theta": row.theta, "d": row.d}
        if row.joint is not JointType.FIXED:
            joint += 1
            moving = "d" if row.joint is JointType.PRISMATIC else "theta"
            cells[moving] = f"{'-' if row.sign < 0 else ''}q{joint} + ({cells[moving]!r})"
        rows.append(RawRow(alpha=row.alpha, a=row.a, **cells))
    return RawTable(convention=table.convention, rows=tuple(rows), length_unit=unit)


def own_table(instance: Instance, rng: random.Random) -> tuple[RawTable, PlainTable]:
    """A table with the key's kinds of joints and frames of its own, as typed and in numbers."""
    reference = instance.exercise.reference
    degrees = reference.angle_unit.value == "deg"
    modified = rng.random() < 0.5
    lengths = [name for name in instance.parameters if reference.parameters[name].value == "length"]
    rows, raw = [], []
    for i, kind in enumerate(reference.table.joint_types, 1):
        alpha_cell, alpha = _angle(rng, degrees)
        theta_cell, theta = _angle(rng, degrees)
        a_cell, a = _length(rng, lengths, instance)
        d_cell, d = _length(rng, lengths, instance)
        sign = rng.choice([1, 1, -1])
        slides = kind is JointType.PRISMATIC
        variable = f"{'-' if sign < 0 else ''}q{i}"
        if slides:
            d_cell = f"{variable} + ({d_cell})"
        else:
            theta_cell = rng.choice([f"{variable} + ({theta_cell})", f"({theta_cell}) {'+-'[sign < 0]} q{i}"])
        rows.append(PlainRow(alpha, a, d, theta, sign, slides))
        raw.append(RawRow(alpha=alpha_cell, a=a_cell, d=d_cell, theta=theta_cell))
    convention = Convention.MODIFIED if modified else Convention.STANDARD
    written = RawTable(
        convention=convention,
        rows=tuple(raw),
        angle_unit=reference.angle_unit,
        length_unit=reference.length_unit,
    )
    return written, PlainTable(modified, tuple(rows), plain(key_numbers(instance)).reach)


def _angle(rng: random.Random, degrees: bool) -> tuple[str | int, float]:
    quarter = rng.choice([0, 0, 1, -1, 2])
    if rng.random() < 0.7:
        return (90 * quarter if degrees else f"{quarter}*pi/2"), quarter * np.pi / 2
    value = rng.randint(-170, 170)
    return (value if degrees else f"{value}*pi/180"), float(np.radians(value))


def _length(rng: random.Random, names: list[str], instance: Instance) -> tuple[str | float, float]:
    if names and rng.random() < 0.5:
        name, factor = rng.choice(names), rng.choice([1, -1, 2])
        return f"{factor}*{name}", factor * instance.parameters[name]
    usual = max([abs(instance.parameters[name]) for name in names], default=1.0)
    value = rng.choice([0.0, round(rng.uniform(-1.5, 1.5) * usual, 3)])
    return value, value
