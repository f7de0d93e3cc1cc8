"""The catalogue of what students do wrong in a DH table, and how to undo it.

Each misconception is a code and a pure function that undoes it wherever it may have happened.
The order is that of likelihood; if several edits explain a wrong answer, the earlier one is reported first:
so it is one list, however long.
"""

from collections.abc import Callable, Iterator
from dataclasses import dataclass

from exercises.grading.edits.cell_edits import (
    alpha_sign,
    alpha_value,
    angle_in_degrees,
    angle_in_radians,
    length_in_other_unit,
    length_value,
    offset_value,
    sign_of_length,
    sign_of_offset,
    sign_of_variable,
    theta_value,
)
from exercises.grading.edits.changes import Change, TableSlip
from exercises.grading.edits.row_edits import (
    cells_swapped,
    fixed_row_left_out,
    joint_left_out,
    joint_of_other_type,
    row_left_out,
    row_too_many,
    rows_swapped,
    twists_swapped,
)
from exercises.grading.edits.table_edits import (
    all_in_degrees,
    all_in_other_length_unit,
    all_in_radians,
    all_turns_turned_round,
    all_twists_turned_round,
    columns_a_row_early,
    columns_a_row_late,
    columns_exchanged,
    columns_reordered,
    other_convention,
    parameter_misnamed,
    parameters_swapped,
    twists_a_row_early,
    twists_a_row_late,
)
from exercises.grading.edits.work import EXCHANGED, Work
from kinematics.table import ANGLES, LENGTHS

ALL, NONE = frozenset({"alpha", "a", "d"}), frozenset[str]()
TWISTS, ALONG_X, SIZES = frozenset({"alpha"}), frozenset({"alpha", "a"}), frozenset(LENGTHS)


@dataclass(frozen=True, kw_only=True, slots=True)
class Misconception:
    """One entry of the catalogue.

    Attributes:
        code: stable identifier.
        changes: every way to undo it in a table.
        told_as: codes of the edits it may lead to, if not its own; the message of each is `repair-<code>`.
        hint: what is told of it from the help level `kind` on, where that is not the wrong facts of its row.
        cells: those of a row of which it concerns one by itself.
        counts: undoing it changes how many joints there are.
        types: to how many joints it gives another type at the least, if it does, and not how many there are.
        beforehand: it is undone first where it comes together with one that changed their number.
        sizes: the columns in which undoing it may put entries of another size.
    """

    code: str
    changes: Callable[[Work], Iterator[Change]]
    told_as: tuple[str, ...] = ()
    hint: str | None = None
    cells: tuple[str, ...] = ()
    counts: bool = False
    types: int = 0
    beforehand: bool = False
    sizes: frozenset[str] = ALL

    @property
    def codes(self) -> tuple[str, ...]:
        """The codes of the edits it may lead to."""
        return self.told_as or (self.code,)

    def may_be(self, slip: TableSlip) -> bool:
        """Return whether a slip may be this misconception."""
        return slip.cell in self.cells if slip.code is None else slip.code in self.codes


LENGTH_STORIES = ("a_value", "a_missing", "a_not_zero", "a_sign", "cell_length_unit", "cell_parameter")
OFFSET_STORIES = ("d_value", "d_missing", "d_not_zero", "d_sign", "d_offset", *LENGTH_STORIES[-2:])

CATALOGUE: tuple[Misconception, ...] = (
    Misconception(code="convention", changes=other_convention, hint="columns_throughout", beforehand=True),
    Misconception(
        code="angles_in_degrees",
        changes=all_in_degrees,
        hint="angles_throughout",
        beforehand=True,
        sizes=TWISTS,
    ),
    Misconception(
        code="angles_in_radians",
        changes=all_in_radians,
        hint="angles_throughout",
        beforehand=True,
        sizes=TWISTS,
    ),
    Misconception(
        code="length_unit",
        changes=all_in_other_length_unit,
        hint="lengths_throughout",
        beforehand=True,
        sizes=SIZES,
    ),
    Misconception(
        code="columns_late",
        changes=columns_a_row_late,
        hint="columns_throughout",
        beforehand=True,
        sizes=ALONG_X,
    ),
    Misconception(
        code="columns_early",
        changes=columns_a_row_early,
        hint="columns_throughout",
        beforehand=True,
        sizes=ALONG_X,
    ),
    Misconception(
        code="twists_late",
        changes=twists_a_row_late,
        hint="twists_out_of_place",
        beforehand=True,
        sizes=TWISTS,
    ),
    Misconception(
        code="twists_early",
        changes=twists_a_row_early,
        hint="twists_out_of_place",
        beforehand=True,
        sizes=TWISTS,
    ),
    Misconception(
        code="columns_exchanged", changes=columns_exchanged, hint="columns_in_disorder", beforehand=True
    ),
    Misconception(
        code="columns_reordered", changes=columns_reordered, hint="columns_in_disorder", beforehand=True
    ),
    Misconception(
        code="parameter_misnamed", changes=parameter_misnamed, hint="names_throughout", beforehand=True
    ),
    Misconception(code="cell_in_degrees", changes=angle_in_degrees, cells=ANGLES, sizes=TWISTS),
    Misconception(code="cell_in_radians", changes=angle_in_radians, cells=ANGLES, sizes=TWISTS),
    Misconception(code="alpha_sign", changes=alpha_sign, cells=("alpha",), sizes=NONE),
    Misconception(code="alpha_value", changes=alpha_value, cells=("alpha",), sizes=TWISTS),
    Misconception(
        code="twists_all_reversed",
        changes=all_twists_turned_round,
        hint="twists_throughout",
        beforehand=True,
        sizes=NONE,
    ),
    Misconception(code="a_sign", changes=sign_of_length, cells=("a",), sizes=NONE),
    Misconception(code="d_sign", changes=sign_of_offset, cells=("d",), sizes=NONE),
    Misconception(code="twists_swapped", changes=twists_swapped, sizes=TWISTS),
    Misconception(code="a_d_swapped", changes=cells_swapped),
    Misconception(
        code="parameters_swapped",
        changes=parameters_swapped,
        hint="names_throughout",
        beforehand=True,
    ),
    Misconception(code="cell_length_unit", changes=length_in_other_unit, cells=LENGTHS, sizes=SIZES),
    Misconception(
        code="a_value", changes=length_value, cells=("a",), told_as=LENGTH_STORIES, sizes=frozenset({"a"})
    ),
    Misconception(
        code="d_value", changes=offset_value, cells=("d",), told_as=OFFSET_STORIES, sizes=frozenset({"d"})
    ),
    Misconception(
        code="theta_value",
        changes=theta_value,
        cells=("theta",),
        told_as=("theta_value", "theta_offset"),
        sizes=NONE,
    ),
    Misconception(code="variable_sign", changes=sign_of_variable, cells=("theta", "d"), sizes=NONE),
    Misconception(
        code="turns_all_reversed", changes=all_turns_turned_round, hint="turns_throughout", sizes=NONE
    ),
    Misconception(code="joint_type", changes=joint_of_other_type, types=1, beforehand=True),
    Misconception(code="row_extra", changes=row_too_many, hint="row_not_needed", counts=True),
    Misconception(
        code="joint_fixed", changes=joint_left_out, told_as=("joint_fixed", "joint_moving"), counts=True
    ),
    Misconception(
        code="rows_swapped", changes=rows_swapped, hint="rows_out_of_order", types=EXCHANGED, beforehand=True
    ),
    Misconception(code="row_missing", changes=row_left_out, hint="row_missing", counts=True),
    Misconception(code="fixed_row_missing", changes=fixed_row_left_out, hint="row_missing", sizes=NONE),
)


RANKS = {
    code: rank for rank, entry in reversed(list(enumerate(CATALOGUE))) for code in (*entry.codes, entry.code)
}
"""The place of what is told in the catalogue; the earlier, the likelier."""

HINTS = {code: entry.hint for entry in CATALOGUE if entry.hint is not None for code in entry.codes}
"""By the code of an edit what is told of it before the edit itself is."""


def repair_codes() -> frozenset[str]:
    """Return the code of every edit that may be told."""
    return frozenset(code for entry in CATALOGUE for code in entry.codes)
