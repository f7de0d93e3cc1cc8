"""What a worker process does for a symbolic answer: closed forms, written in the wanted formats, as JSON."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from enum import StrEnum
from fractions import Fraction
from itertools import chain
from typing import Any, Generic, TypeVar

import orjson

from kinematics.errors import Fault, FormSizeError
from kinematics.expressions import pi_fraction
from kinematics.jacobian import JacobianFrame
from kinematics.printing import LIMIT, Format, MatrixPrinter, Notation, Purpose
from kinematics.rotations.sequences import EulerSequence
from kinematics.symbolic import Matrix, Workings, count_operations
from kinematics.symbolic.analytic import analytic_form
from kinematics.symbolic.size import bottom_up
from kinematics.table import CELLS, SymbolicTable, table_parameters

AnyFormat = TypeVar("AnyFormat")
JACOBIANS = {JacobianFrame.BASE: "J0", JacobianFrame.END: "Jn"}
"""What Jacobians are called, by the frame in whose axes they are."""
QUICK_COST = 300.0
QUICK_NODES = 500
"""Terms that a product may have and nodes that the cells may have to be answered at once; what is larger is
computed in a process of its own."""


class FormPart(StrEnum):
    """A matrix, or a list of them, that may be asked for."""

    LINKS = "links"
    FRAMES = "frames"
    TRANSFORM = "transform"
    INVERSE = "inverse"
    JACOBIAN = "jacobian"


@dataclass(frozen=True, kw_only=True, slots=True)
class FormTask(Generic[AnyFormat]):
    """Something of a robot that is to be derived and written.

    Values are substituted; joint variables are q1, q2, … if nothing is said.
    """

    table: SymbolicTable
    variables: tuple[str, ...] = ()
    formats: tuple[AnyFormat, ...]
    notation: Notation
    base: Matrix | None = None
    tool: Matrix | None = None
    head: Mapping[str, Any]

    @property
    def parameters(self) -> tuple[str, ...]:
        """Names of the parameters that are left."""
        return table_parameters(self.table)

    def writing(self: "FormTask[Format]", parameters: tuple[str, ...]) -> "Writing":
        """Return what writes its matrices, whose functions take these parameters."""
        return Writing(self.formats, self.notation, self.table.n_joints, parameters, self.variables)


@dataclass(frozen=True, kw_only=True, slots=True)
class SymbolicTask(FormTask[Format]):
    """Matrices in closed form to be written."""

    parts: tuple[FormPart, ...]
    frames: tuple[JacobianFrame, ...] = tuple(JacobianFrame)
    angles: EulerSequence | None = None

    def is_quick(self) -> bool:
        """Return whether the answer is certain to be small.

        The number of operations in an entry grows by a factor of about 5/3 with each joint whose axis is
        perpendicular to the one before, and of about 8/3 with each general twist.
        """
        cost, nodes = 1.0, 0
        for row in self.table.rows:
            turns = pi_fraction(row.alpha)
            if turns is None or (2 * turns).denominator != 1:
                cost *= 8 / 3
            elif turns % 1 == Fraction(1, 2):
                cost *= 5 / 3
            nodes += len(bottom_up(getattr(row, cell) for cell in CELLS))
        return cost <= QUICK_COST and nodes <= QUICK_NODES


class Writing:
    """What writes the matrices of one answer."""

    def __init__(
        self,
        formats: Sequence[Format],
        notation: Notation,
        n_joints: int,
        parameters: Sequence[str],
        variables: Sequence[str],
    ) -> None:
        self._printer = MatrixPrinter(
            n_joints=n_joints, parameters=parameters, variables=variables, notation=notation
        )
        self._formats, self._notation = formats, notation
        self._written: list[Matrix] = []

    def matrix(self, matrix: Matrix, purpose: Purpose) -> dict[str, Any]:
        """Return a matrix in the formats that were asked for.

        Raises:
            FormSizeError: it has too many operations to be written out.
        """
        self._written.append(matrix)
        return self._printer.write(matrix, self._formats, purpose)

    def answer(self, **found: Any) -> bytes:
        """Return the answer as JSON, with the meaning of short names.

        Raises:
            FormSizeError: an entry is nested too deeply for JSON.
        """
        if self._notation is Notation.SHORT:
            found["symbols"] = self._printer.symbols(self._written)
        try:
            return orjson.dumps(found)
        except orjson.JSONEncodeError as error:
            if "ecursion" not in str(error):
                raise
            raise FormSizeError(Fault.at("closed_form_too_deep")) from None


def written_answer(task: SymbolicTask) -> bytes:
    """Return the answer to a task, as JSON.

    Raises:
        FormSizeError: a matrix has too many operations to be written out.
    """
    writing = task.writing(task.parameters)
    return writing.answer(**task.head, **_parts(task, writing.matrix))


def written_jacobians(task: SymbolicTask) -> bytes:
    """Return J0, Jn and the analytic Jacobian as JSON, with what the answer says besides.

    Raises:
        FormSizeError: a matrix has too many operations to be written out.
    """
    answer: dict[str, Any] = orjson.loads(written_answer(task))
    jacobians = answer.pop("jacobian")
    return orjson.dumps(answer | jacobians)


def _parts(task: SymbolicTask, write: Any) -> dict[str, Any]:
    last = str(len(task.table.rows))
    end, end_name = ("the tool", "tool") if task.tool is not None else (f"frame {last}", last)
    world, world_name = ("the world", "world") if task.base is not None else ("frame 0", "0")
    workings = Workings(task.table, base=task.base, tool=task.tool)
    answer: dict[str, Any] = {}
    if {FormPart.LINKS, FormPart.FRAMES, FormPart.TRANSFORM} & set(task.parts):
        operations = count_operations(chain.from_iterable(workings.transform))
        if operations <= LIMIT:
            answer["operations"] = operations
    if FormPart.LINKS in task.parts:
        answer["links"] = [
            write(link, Purpose(name=f"T_{i - 1}_{i}", meaning=f"Pose of frame {i} in frame {i - 1}."))
            for i, link in enumerate(workings.links, start=1)
        ]
    if FormPart.FRAMES in task.parts:
        answer["frames"] = [
            write(frame, Purpose(name=f"T_{world_name}_{i}", meaning=f"Pose of frame {i} in {world}."))
            for i, frame in enumerate(workings.frames, start=1)
        ]
    if FormPart.TRANSFORM in task.parts:
        purpose = Purpose(name=f"T_{world_name}_{end_name}", meaning=f"Pose of {end} in {world}.")
        answer["transform"] = write(workings.transform, purpose)
    if FormPart.INVERSE in task.parts:
        purpose = Purpose(name=f"T_{end_name}_{world_name}", meaning=f"Pose of {world} in {end}.")
        answer["inverse"] = write(workings.inverse, purpose)
    if FormPart.JACOBIAN in task.parts:
        axes = {JacobianFrame.BASE: world, JacobianFrame.END: end}
        answer["jacobian"] = {
            JACOBIANS[frame]: write(
                workings.jacobian(frame),
                Purpose(
                    name=JACOBIANS[frame],
                    meaning=f"Jacobian of {end}, in the axes of {axes[frame]}, linear rows first.",
                    result="J",
                ),
            )
            for frame in task.frames
        }
    if task.angles is not None:
        analytic = analytic_form(task.table, task.angles, base=task.base, tool=task.tool)
        purpose = Purpose(
            name="Ja",
            meaning=f"Rates of x, y, z and three angles of {end} in {world}, for those of the joints.",
            result="J",
        )
        answer["analytic"] = None if analytic is None else write(analytic, purpose)
    return answer
