"""Links as handed in: cells with numbers, names and expressions, read into exact bodies in SI units."""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction

from kinematics.cells import DEFAULT, Cell, Limits, ParameterKind, ReadTable
from kinematics.cells.entries import cell_meaning
from kinematics.cells.meaning import Position
from kinematics.cells.refusals import CellRefusal
from kinematics.cells.scaling import scaled_cell
from kinematics.cells.variables import variable_index
from kinematics.dynamics.links import RigidBody, SymbolicBody
from kinematics.errors import CellError, DescriptionError, Fault
from kinematics.expressions import ZERO, Expression, JointVariable, joint_variables_in
from kinematics.se3 import triple

NOTHING: tuple[Cell, Cell, Cell] = (0, 0, 0)


@dataclass(frozen=True, kw_only=True, slots=True)
class RawBody:
    """A link as handed in.

    Attributes:
        mass: [kg].
        centre: centre of mass in the link's frame, in the table's length unit.
        inertia: 3×3 about the centre of mass, in the axes of the link's frame [kg m²].
    """

    mass: Cell = 0
    centre: tuple[Cell, ...] = NOTHING
    inertia: tuple[tuple[Cell, ...], ...] = (NOTHING, NOTHING, NOTHING)


@dataclass(frozen=True, kw_only=True, slots=True)
class ReadBodies:
    """Links and gravity as read.

    Attributes:
        links: in SI units; names of lengths stand for metres.
        gravity: acceleration of free fall in frame 0 [m/s²].
        kinds: the parameters of the table and of the links, and what each measures.
        lengths: those of them that are lengths: of the table, or in a centre of mass.
    """

    links: tuple[SymbolicBody, ...]
    gravity: tuple[Expression, Expression, Expression]
    kinds: Mapping[str, ParameterKind]
    lengths: frozenset[str]


def read_bodies(
    read: ReadTable, links: Sequence[RawBody], gravity: Sequence[Cell], limits: Limits = DEFAULT
) -> ReadBodies:
    """Read what the links of a table weigh.

    Args:
        read: the table, in its own unit of length.
        links: one for each row.
        gravity: acceleration of free fall in frame 0 [m/s²], three cells.

    Raises:
        DescriptionError: not one link for each row.
        CellError: cells cannot be read, each at ("links", i, …) or ("gravity", i).
    """
    expected = len(read.table.rows)
    if len(links) != expected:
        raise DescriptionError(Fault.at("links_count", "links", expected=expected, given=len(links)))
    reader = _BodyReader(read, limits)
    bodies = [reader.body(link, i) for i, link in enumerate(links)]
    falling = triple(reader.cell(cell, ("gravity", i)) for i, cell in enumerate(gravity))
    if reader.faults:
        raise CellError(reader.faults)
    return ReadBodies(
        links=tuple(bodies), gravity=falling, kinds=reader.kinds, lengths=frozenset(reader.lengths)
    )


class _BodyReader:
    def __init__(self, read: ReadTable, limits: Limits) -> None:
        self._read, self._limits = read, limits
        self.faults: list[Fault] = []
        self.kinds = dict(read.parameters)
        self.lengths = {name for name, kind in self.kinds.items() if kind is ParameterKind.LENGTH}
        self._ratio = 1 / Fraction(read.length_unit.metres_per_unit)

    def body(self, link: RawBody, i: int) -> SymbolicBody:
        where: tuple[str | int, ...] = ("links", i)
        centre = triple(self._length(cell, (*where, "centre", k)) for k, cell in enumerate(link.centre))
        inertia = tuple(
            triple(self.cell(cell, (*where, "inertia", k, m)) for m, cell in enumerate(row))
            for k, row in enumerate(link.inertia)
        )
        return RigidBody(mass=self.cell(link.mass, (*where, "mass")), centre=centre, inertia=inertia)

    def cell(self, cell: Cell, where: tuple[str | int, ...]) -> Expression:
        return self._meaning(cell, where, lambda kinds: None)

    def _length(self, cell: Cell, where: tuple[str | int, ...]) -> Expression:
        found = self._meaning(cell, where, self.lengths.update)
        return (
            scaled_cell(found, ParameterKind.LENGTH, self.kinds, self._ratio) if self._ratio != 1 else found
        )

    def _meaning(
        self, cell: Cell, where: tuple[str | int, ...], note: Callable[[list[str]], None]
    ) -> Expression:
        try:
            found = cell_meaning(cell, Position.LENGTH, self._read.angle_unit, self._limits, _variable)
        except CellRefusal as refusal:
            self.faults.append(refusal.at(*where))
            return ZERO
        if joint_variables_in(found.expression):
            self.faults.append(Fault.at("body_varies", *where))
            return ZERO
        for name, kind in found.kinds.items():
            known = self.kinds.setdefault(name, kind)
            if known is not kind:
                self.faults.append(
                    Fault.at(
                        "parameter_two_kinds", *where, column=1, name=name, kind=kind.value, other=known.value
                    )
                )
        note([name for name, kind in found.kinds.items() if kind is ParameterKind.LENGTH])
        return found.expression


def _variable(name: str) -> Expression | None:
    index = variable_index(name)
    return None if index is None else JointVariable(index)
