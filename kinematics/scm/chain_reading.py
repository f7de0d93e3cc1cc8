"""An SCM chain as it is handed in, and as it is read."""

from collections.abc import Mapping
from dataclasses import dataclass, replace
from fractions import Fraction
from types import MappingProxyType

from kinematics.cells import DEFAULT, AngleUnit, Cell, LengthUnit, Limits, ParameterKind
from kinematics.cells.entries import cell_meaning, text_length
from kinematics.cells.meaning import Position
from kinematics.cells.refusals import CellRefusal
from kinematics.cells.variables import variable_index
from kinematics.errors import DescriptionError, Fault, ParamValue
from kinematics.expressions import (
    ZERO,
    Expression,
    JointVariable,
    Number,
    Product,
    add,
    joint_variables_in,
    terms_of,
)
from kinematics.scm.chain import ChainRow, Entry, Placement, ScmChain

ENTRIES = ("x", "y", "z", "a", "b", "c")

RawPlacement = Mapping[str, Cell]


@dataclass(frozen=True, kw_only=True, slots=True)
class RawChain:
    """A chain as handed in: entries x, y, z, a, b, c by name; those left out are zero.

    Attributes:
        joints: one row a joint.
        final: the Final Transformation.
        angle_unit: unit of plain numbers where an angle stands.
    """

    joints: tuple[RawPlacement, ...]
    final: RawPlacement
    tool: RawPlacement
    angle_unit: AngleUnit = AngleUnit.RAD
    length_unit: LengthUnit = LengthUnit.M


@dataclass(frozen=True, kw_only=True, slots=True)
class ReadChain:
    """A chain, understood.

    Attributes:
        chain: exact entries; angles in [rad], lengths in `length_unit`.
        angle_unit: the unit in which its angle parameters are given.
        length_unit: the unit of its lengths and length parameters.
        parameters: what each parameter measures, in the order in which they stand in the chain.
        variables: the joint variables as typed; q_i where that name is a parameter elsewhere.
    """

    chain: ScmChain
    angle_unit: AngleUnit
    length_unit: LengthUnit
    parameters: Mapping[str, ParameterKind]
    variables: tuple[str, ...]


def read_chain(raw: RawChain, limits: Limits = DEFAULT) -> ReadChain:
    """Return the exact chain that a chain as handed in means.

    In row i the variable is written q_i or θ_i, or in a row without these as the source writes it: a_i among
    the angles, d_i among the lengths of a row whose angles hold no variable. Other such names are parameters.

    Raises:
        DescriptionError: every fault at once, at ("joints", i, entry), ("final", entry) or ("tool", entry).
    """
    if not raw.joints:
        raise DescriptionError(Fault.at("scm_chain_empty", "joints"))
    if len(raw.joints) > limits.rows:
        raise DescriptionError(
            Fault.at("scm_too_many_joints", "joints", joints=len(raw.joints), limit=limits.rows)
        )
    cells = [row.get(entry) for row in (*raw.joints, raw.final, raw.tool) for entry in ENTRIES]
    length = text_length(cells, limits)
    if length > limits.table_characters:
        raise DescriptionError(
            Fault.at("scm_chain_too_long", "joints", length=length, limit=limits.table_characters)
        )
    reader = _ChainReader(raw=raw, limits=limits, faults=[], kinds={}, typed={})
    rows = tuple(reader.row(i, cells) for i, cells in enumerate(raw.joints))
    final, tool = reader.placement("final", raw.final), reader.placement("tool", raw.tool)
    if reader.faults:
        raise DescriptionError(reader.faults)
    names = [reader.typed.get(joint, f"q{joint}") for joint in range(1, len(rows) + 1)]
    return ReadChain(
        chain=ScmChain(rows=rows, final=final, tool=tool),
        angle_unit=raw.angle_unit,
        length_unit=raw.length_unit,
        parameters=MappingProxyType(reader.kinds),
        variables=tuple(
            f"q{joint}" if name in reader.kinds else name for joint, name in enumerate(names, start=1)
        ),
    )


@dataclass(slots=True)
class _ChainReader:
    raw: RawChain
    limits: Limits
    faults: list[Fault]
    kinds: dict[str, ParameterKind]
    typed: dict[int, str]

    def row(self, i: int, cells: RawPlacement) -> ChainRow:
        before = len(self.faults)
        trial = replace(self, faults=[], kinds={}, typed={})
        named = any(i + 1 in joint_variables_in(trial._entry(e, cells, i, None)) for e in Entry)
        turns = {e: self._entry(e, cells, i, None if named else f"a{i + 1}") for e in Entry if e.is_turn}
        turning = any(joint_variables_in(expression) for expression in turns.values())
        own = None if named or turning else f"d{i + 1}"
        entries = {**{e: self._entry(e, cells, i, own) for e in Entry if not e.is_turn}, **turns}
        holding = [entry for entry in Entry if joint_variables_in(entries[entry])]
        variable, sign = Entry.A, 1
        if len(self.faults) == before:
            variable, sign = self._variable(i, holding, entries)
        constants = {
            e.value: add(term for term in terms_of(expression) if not joint_variables_in(term))
            for e, expression in entries.items()
        }
        return ChainRow(constant=Placement(**constants), variable=variable, sign=sign)

    def placement(self, name: str, cells: RawPlacement) -> Placement:
        entries: dict[str, Expression] = {}
        for entry in Entry:
            expression = self._cell(entry, cells, (name, entry.value), None, 0)
            for index in sorted(joint_variables_in(expression)):
                self._refuse("scm_variable_outside_joints", name, entry.value, name=f"q{index}")
            entries[entry.value] = expression
        return Placement(**entries)

    def _entry(self, entry: Entry, cells: RawPlacement, i: int, own: str | None) -> Expression:
        return self._cell(entry, cells, ("joints", i, entry.value), own, i + 1)

    def _cell(
        self, entry: Entry, cells: RawPlacement, where: tuple[str | int, ...], own: str | None, joint: int
    ) -> Expression:
        def variable_of(name: str) -> Expression | None:
            index = joint if own is not None and name == own else variable_index(name)
            if index is None:
                return None
            if index == joint:
                self.typed.setdefault(joint, name)
            return JointVariable(index)

        position = Position.ANGLE if entry.is_turn else Position.LENGTH
        try:
            meaning = cell_meaning(
                cells.get(entry.value, 0), position, self.raw.angle_unit, self.limits, variable_of
            )
        except CellRefusal as refusal:
            self.faults.append(refusal.at(*where))
            return ZERO
        for name, kind in meaning.kinds.items():
            if self.kinds.setdefault(name, kind) is not kind:
                self._refuse("scm_parameter_two_kinds", *where, name=name)
        return meaning.expression

    def _variable(
        self, i: int, holding: list[Entry], entries: Mapping[Entry, Expression]
    ) -> tuple[Entry, int]:
        joint = i + 1
        if not holding:
            self._refuse("scm_no_variable", "joints", i, joint=joint)
            return Entry.A, 1
        if len(holding) > 1:
            first, second = holding[0].value, holding[1].value
            self._refuse("scm_two_variables", "joints", i, second, joint=joint, first=first, second=second)
            return holding[0], 1
        entry = holding[0]
        foreign = sorted(joint_variables_in(entries[entry]) - {joint})
        if foreign:
            self._refuse(
                "scm_variable_of_other_row", "joints", i, entry.value, name=f"q{foreign[0]}", joint=joint
            )
            return entry, 1
        sign = _variable_sign(entries[entry])
        if sign is None:
            self._refuse("scm_variable_form", "joints", i, entry.value, joint=joint)
        return entry, sign or 1

    def _refuse(self, code: str, *where: str | int, **params: ParamValue) -> None:
        self.faults.append(Fault.at(code, *where, **params))


def _variable_sign(expression: Expression) -> int | None:
    """+1 or -1 where the variable enters as ±q + constant, None where it enters otherwise."""
    moving = [term for term in terms_of(expression) if joint_variables_in(term)]
    match moving:
        case [JointVariable()]:
            return 1
        case [Product((Number(weight), JointVariable()))] if weight == Fraction(-1):
            return -1
    return None
