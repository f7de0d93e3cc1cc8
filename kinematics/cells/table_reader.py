"""From a DH table as handed in to exact entries."""

from collections.abc import Sequence
from types import MappingProxyType

from kinematics.caching import USUAL_TABLE, cached_by_size
from kinematics.cells.entries import text_length
from kinematics.cells.joints import row_joints, variable_names
from kinematics.cells.limits import DEFAULT, Limits
from kinematics.cells.refusals import CellRefusal
from kinematics.cells.rows import RowMeaning, row_meaning, row_syntax
from kinematics.cells.tables import RawTable, ReadTable
from kinematics.cells.units import ParameterKind
from kinematics.errors import CellError, Fault, TableError
from kinematics.table import CELLS, DHTable


def read_table(raw: RawTable, limits: Limits = DEFAULT, *, by_row: bool = True) -> ReadTable:
    """Return the exact table that a table as handed in means.

    Args:
        raw: the table, cells as numbers or text.
        by_row: whether variables may be numbered by row as well as by joint.

    Raises:
        CellError: cells cannot be read, each fault at ("rows", i, cell); table faults are among them.
        TableError: every cell can be read, but the rows do not form a DH table.
    """
    return _read(raw, limits, by_row)


@cached_by_size(lambda raw, limits, by_row: raw.length, longest=USUAL_TABLE, most=1024, few=16)
def _read(raw: RawTable, limits: Limits, by_row: bool) -> ReadTable:
    _refuse_size(raw, limits)
    syntax = [row_syntax(row, limits) for row in raw.rows]
    trees = [row.trees for row in syntax]
    joints, misnumbered = row_joints([row.joint for row in raw.rows], trees, by_row=by_row)
    rows = [
        row_meaning(row, joint, raw.angle_unit, limits) for row, joint in zip(raw.rows, joints, strict=True)
    ]
    kinds, places, faults = _gathered(rows)
    if not any(row.faults for row in syntax):  # a cell not read may be the very one that names the joint
        for found in misnumbered:
            faults.setdefault((int(found.where[1]), str(found.where[2])), found)
    if faults:
        ordered = [faults[place] for place in sorted(faults, key=_reading_order)]
        table_codes = all(found.code.startswith(("variable_", "table_")) for found in ordered)
        raise (TableError if table_codes else CellError)(ordered)
    if len(kinds) > limits.table_parameters:
        raise TableError(Fault.at("table_too_many_parameters", "rows", limit=limits.table_parameters))
    return ReadTable(
        typed_length=raw.length,
        table=DHTable(convention=raw.convention, rows=tuple(row.row for row in rows)),
        angle_unit=raw.angle_unit,
        length_unit=raw.length_unit,
        parameters=MappingProxyType(kinds),
        places=MappingProxyType(places),
        variables=variable_names(joints, trees, kinds),
        last_places=MappingProxyType(
            {(i, cell): place for i, row in enumerate(rows) for cell, place in row.last_places.items()}
        ),
    )


def _gathered(
    rows: Sequence[RowMeaning],
) -> tuple[dict[str, ParameterKind], dict[str, tuple[int, str]], dict[tuple[int, str], Fault]]:
    """The kinds of all parameters, the cells in which they stand first, and the faults by row and cell."""
    kinds: dict[str, ParameterKind] = {}
    places: dict[str, tuple[int, str]] = {}
    faults: dict[tuple[int, str], Fault] = {}
    for i, row in enumerate(rows):
        for cell, found in row.faults.items():
            faults[i, cell] = found.within("rows", i, cell)
        for cell, name, kind in row.kinds:
            if (i, cell) in faults:
                continue
            known = kinds.setdefault(name, kind)
            places.setdefault(name, (i, cell))
            if known is not kind:
                refusal = CellRefusal("parameter_two_kinds", column=1, name=name, kind=kind, other=known)
                faults[i, cell] = refusal.at("rows", i, cell)
    return kinds, places, faults


def _refuse_size(raw: RawTable, limits: Limits) -> None:
    if not raw.rows:
        raise TableError(Fault.at("table_empty", "rows"))
    if len(raw.rows) > limits.rows:
        raise TableError(Fault.at("table_too_many_rows", "rows", rows=len(raw.rows), limit=limits.rows))
    length = text_length((getattr(row, cell) for row in raw.rows for cell in CELLS), limits)
    if length > limits.table_characters:
        raise TableError(Fault.at("table_too_long", "rows", length=length, limit=limits.table_characters))


def _reading_order(place: tuple[int, str]) -> tuple[int, int]:
    row, cell = place
    return row, CELLS.index(cell)
