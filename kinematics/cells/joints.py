"""Which joint each row of a table holds, and where its variable stands.

Variables are numbered by joint, q1 … qn, fixed rows not counted; a table numbered by row throughout is
understood too. In a `d` cell, `d_i` is the variable of a prismatic row i and a parameter everywhere else.
"""

from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass
from enum import StrEnum

from kinematics.cells.syntax import Name, Node, names_in
from kinematics.cells.variables import uses, variable_index
from kinematics.errors import Fault
from kinematics.table import VARIABLE_CELLS, JointType

Syntax = Mapping[str, Node]
"""The syntax trees of a row's cells; a cell that could not be read, or is a plain number, is left out."""


class Numbering(StrEnum):
    """How the joint variables of a table are numbered."""

    BY_JOINT = "by_joint"
    BY_ROW = "by_row"


@dataclass(frozen=True, kw_only=True, slots=True)
class RowJoint:
    """The joint of a row.

    Attributes:
        number: the number that its variable has; of a fixed row, the one that it would have.
        stated: whether the table states the type, rather than leaving it to the cells.
    """

    joint: JointType
    number: int
    stated: bool

    def variable(self, name: str, cell: str) -> int | None:
        """Return the number of the joint variable that a name is in one of this row's cells, or None."""
        if cell == "d" and self.joint is JointType.PRISMATIC and name == f"d{self.number}":
            return self.number
        return variable_index(name)


def row_joints(
    stated: Sequence[JointType | None], syntax: Sequence[Syntax], *, by_row: bool = True
) -> tuple[tuple[RowJoint, ...], tuple[Fault, ...]]:
    """Return the joint of every row, and what is wrong with how the variables are numbered."""
    numberings = [_assigned(stated, syntax, Numbering.BY_JOINT)]
    if by_row and any(joint.joint is JointType.FIXED for joint in numberings[0]):
        numberings.append(_assigned(stated, syntax, Numbering.BY_ROW))
    candidates = [(joints, *_agreement(joints, syntax)) for joints in numberings]
    fitting = [(joints, named) for joints, named, foreign in candidates if not foreign]
    if fitting:
        return max(fitting, key=lambda candidate: candidate[1])[0], ()
    joints, _, foreign = min(candidates, key=lambda candidate: len(candidate[2]))
    return joints, _numbering_faults(numberings[0], numberings[-1], joints, syntax, foreign)


def variable_names(
    joints: Sequence[RowJoint], syntax: Sequence[Syntax], parameters: Collection[str]
) -> tuple[str, ...]:
    """Return the names of the joint variables as typed.

    The name is q_i where none was typed that says which joint it is.
    """
    names: list[str] = []
    for joint, cells in zip(joints, syntax, strict=True):
        if joint.joint is JointType.FIXED:
            continue
        cell, own = VARIABLE_CELLS[joint.joint], len(names) + 1
        typed = [name.name for name in _names(cells, cell) if joint.variable(name.name, cell) == own]
        names.append(typed[0] if typed and typed[0] not in parameters else f"q{own}")
    return tuple(names)


def _assigned(
    stated: Sequence[JointType | None], syntax: Sequence[Syntax], numbering: Numbering
) -> tuple[RowJoint, ...]:
    joints: list[RowJoint] = []
    count = 0
    for i, (given, cells) in enumerate(zip(stated, syntax, strict=True)):
        number = i + 1 if numbering is Numbering.BY_ROW else count + 1
        joint = given or _inferred(cells, number)
        count += joint is not JointType.FIXED
        joints.append(RowJoint(joint=joint, number=number, stated=given is not None))
    return tuple(joints)


def _inferred(cells: Syntax, number: int) -> JointType:
    if any(variable_index(name.name) is not None for name in _names(cells, "theta")):
        return JointType.REVOLUTE
    if any(variable_index(name.name) is not None or name.name == f"d{number}" for name in _names(cells, "d")):
        return JointType.PRISMATIC
    return JointType.FIXED


def _names(cells: Syntax, cell: str) -> tuple[Name, ...]:
    return tuple(names_in(cells[cell])) if cell in cells else ()


Place = tuple[int, str, Name]


def _agreement(joints: Sequence[RowJoint], syntax: Sequence[Syntax]) -> tuple[int, list[Place]]:
    """How many rows hold their own variable, and the variables that are not their row's."""
    named = 0
    foreign: list[Place] = []
    for i, (joint, cells) in enumerate(zip(joints, syntax, strict=True)):
        if joint.joint is JointType.FIXED:
            continue
        cell = VARIABLE_CELLS[joint.joint]
        numbers = [(joint.variable(name.name, cell), name) for name in _names(cells, cell)]
        named += any(number == joint.number for number, _ in numbers)
        foreign.extend((i, cell, name) for number, name in numbers if number not in {None, joint.number})
    return named, foreign


def _numbering_faults(
    by_joint: Sequence[RowJoint],
    by_row: Sequence[RowJoint],
    joints: Sequence[RowJoint],
    syntax: Sequence[Syntax],
    foreign: Sequence[Place],
) -> tuple[Fault, ...]:
    if all(variable_index(name.name) == by_row[i].number for i, _, name in _agreement(by_joint, syntax)[1]):
        i, cell, name = foreign[0]
        n = sum(joint.joint is not JointType.FIXED for joint in joints)
        code = "variable_numbering_mixed"
        return (Fault.at(code, "rows", i, cell, column=name.column, name=name.name, joints=n),)
    own = {
        joint.number
        for joint, cells in zip(joints, syntax, strict=True)
        if joint.joint is not JointType.FIXED and _holds_own(joint, cells)
    }
    found = []
    for i, cell, name in foreign:
        if not sound(joints[i], cell, syntax[i][cell]):
            continue  # how the variable enters is wrong already, and is said there
        repeated = joints[i].joint is not JointType.FIXED and not _holds_own(joints[i], syntax[i])
        twice = repeated and variable_index(name.name) in own
        params = {} if twice else {"expected": f"q{joints[i].number}"}
        code = "variable_twice" if twice else "variable_of_other_row"
        found.append(Fault.at(code, "rows", i, cell, column=name.column, name=name.name, **params))
    return tuple(found)


def _holds_own(joint: RowJoint, cells: Syntax) -> bool:
    cell = VARIABLE_CELLS[joint.joint]
    return any(joint.variable(name.name, cell) == joint.number for name in _names(cells, cell))


def sound(joint: RowJoint, cell: str, node: Node) -> bool:
    """Return whether every variable in a cell enters as ±q."""
    return all(use.fault is None for use in uses(node, lambda name: joint.variable(name, cell) is not None))
