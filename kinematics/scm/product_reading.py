"""Products of motions as they are handed in: elementary ones, placements, and matrices of cells."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import TypeAlias

from kinematics.cells import DEFAULT, AngleUnit, Cell, LengthUnit, Limits, ParameterKind, canonical_name
from kinematics.cells.entries import cell_meaning
from kinematics.cells.meaning import Position
from kinematics.cells.refusals import CellRefusal
from kinematics.cells.variables import variable_index
from kinematics.errors import DescriptionError, Fault
from kinematics.expressions import ONE, ZERO, Expression, JointVariable, joint_variables_in
from kinematics.scm.chain import Entry, Placement
from kinematics.symbolic import Matrix

RawMatrix: TypeAlias = Sequence[Sequence[Cell]]
RawFactor: TypeAlias = Mapping[str, Cell] | RawMatrix
Factor: TypeAlias = Placement | Matrix

LARGEST_VARIABLE = 64  # The number of the last joint variable that a product may hold.
IDENTITY: Matrix = tuple(tuple(ONE if i == j else ZERO for j in range(4)) for i in range(4))


@dataclass(frozen=True, kw_only=True, slots=True)
class ReadProducts:
    """Products, understood.

    Attributes:
        products: factors of each, exact; angles in [rad], lengths in `length_unit`.
        angle_unit: the unit in which angle parameters are given.
        parameters: what each parameter measures.
        joints: kind of each joint variable that occurs, by its number: angle or length.
        named: the names of the joint variables, if they were given.
    """

    products: tuple[tuple[Factor, ...], ...]
    angle_unit: AngleUnit
    length_unit: LengthUnit
    parameters: Mapping[str, ParameterKind]
    joints: Mapping[int, ParameterKind]
    named: tuple[str, ...] = ()

    @property
    def n_joints(self) -> int:
        """The number of joint variables: as many as have names, or the largest number of one."""
        return len(self.named) or max(self.joints, default=0)

    @property
    def variables(self) -> tuple[str, ...]:
        """The names of the joint variables."""
        return self.named or tuple(f"q{k}" for k in range(1, self.n_joints + 1))


def read_products(
    raw: Sequence[Sequence[RawFactor]],
    angle_unit: AngleUnit = AngleUnit.RAD,
    length_unit: LengthUnit = LengthUnit.M,
    limits: Limits = DEFAULT,
    variables: Sequence[str] | None = None,
) -> ReadProducts:
    """Return the products that factors as handed in mean.

    q_i and θ_i are joint variables, and so are the names in `variables`; other names are parameters.

    Args:
        raw: for each product its factors: entries x, y, z, a, b, c by name, or a 4×4 of cells.
        angle_unit: unit of plain numbers where an angle stands.
        limits: how large a cell may be.
        variables: names of joint variables 1 … n, as in h2j(H, [a1 a2 d3]).

    Raises:
        DescriptionError: every fault, at ("products", i, k) and below it the entry, or row and column; at
            ("variables", i) what is no name or the name of two.
    """
    named, faults = _names(variables or ())
    numbers = {name: number for number, name in enumerate(named, start=1)}
    reader = _ProductReader(angle_unit, limits, numbers, faults, {}, {})
    products = tuple(
        tuple(reader.factor(factor, ("products", i, k)) for k, factor in enumerate(factors))
        for i, factors in enumerate(raw)
    )
    if reader.faults:
        raise DescriptionError(reader.faults)
    return ReadProducts(
        products=products,
        angle_unit=angle_unit,
        length_unit=length_unit,
        parameters=reader.kinds,
        joints=reader.joints,
        named=named,
    )


def _names(given: Sequence[str]) -> tuple[tuple[str, ...], list[Fault]]:
    """The canonical names of joint variables, and what is wrong with them."""
    names: list[str] = []
    faults = []
    for i, text in enumerate(given):
        name = canonical_name(text)
        if name is None or name in names:
            faults.append(Fault.at("variable_name_invalid", "variables", i, name=text, joint=i + 1))
        names.append(name or text)
    return tuple(names), faults


@dataclass(slots=True)
class _ProductReader:
    angle_unit: AngleUnit
    limits: Limits
    named: Mapping[str, int]
    faults: list[Fault]
    kinds: dict[str, ParameterKind]
    joints: dict[int, ParameterKind]

    def factor(self, raw: RawFactor, where: tuple[str | int, ...]) -> Factor:
        if isinstance(raw, Mapping):
            cells = {entry: raw.get(entry.value, 0) for entry in Entry}
            return Placement(
                **{
                    entry.value: self._cell(
                        cell, Position.ANGLE if entry.is_turn else Position.LENGTH, (*where, entry.value)
                    )
                    for entry, cell in cells.items()
                }
            )
        if len(raw) != 4 or any(len(row) != 4 for row in raw):
            self.faults.append(Fault.at("matrix_not_4x4", *where))
            return IDENTITY
        rows = tuple(
            tuple(
                self._cell(cell, Position.LENGTH if k == 3 and i < 3 else Position.RATIO, (*where, i, k))
                for k, cell in enumerate(row)
            )
            for i, row in enumerate(raw)
        )
        if rows[3] != IDENTITY[3]:
            self.faults.append(Fault.at("pose_bottom_row", *where, 3))
        return rows

    def _cell(self, cell: Cell, position: Position, where: tuple[str | int, ...]) -> Expression:
        def variable_of(name: str) -> Expression | None:
            index = self.named.get(name, variable_index(name))
            return None if index is None else JointVariable(index)

        try:
            meaning = cell_meaning(cell, position, self.angle_unit, self.limits, variable_of)
        except CellRefusal as refusal:
            self.faults.append(refusal.at(*where))
            return ZERO
        for name, kind in meaning.kinds.items():
            if self.kinds.setdefault(name, kind) is not kind:
                self.faults.append(Fault.at("scm_parameter_two_kinds", *where, name=name))
        kind = ParameterKind.LENGTH if position is Position.LENGTH else ParameterKind.ANGLE
        largest = len(self.named) or LARGEST_VARIABLE
        for index in joint_variables_in(meaning.expression):
            if not 1 <= index <= largest:
                self.faults.append(Fault.at("number_too_large", *where, limit=largest, bound="included"))
            self.joints.setdefault(index, kind)
        return meaning.expression
