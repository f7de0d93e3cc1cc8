"""Exercises and answers to them on the wire."""

from typing import Annotated, Any, Literal, TypeAlias

from pydantic import Field, PlainValidator, WithJsonSchema, create_model
from pydantic_core import PydanticCustomError

from exercises.access import Tool
from exercises.answers import RawAnswer
from exercises.departure import Departure
from exercises.drawings import KeyPose
from exercises.grading import Basis, HelpLevel, Verdict
from exercises.parts.registry import part_type, part_types
from exercises.parts.report import PartReport
from exercises.parts.task import FieldShape
from service.schemas.base import WHOLE, Real, Vector3, Wire
from service.schemas.choices import forbidding, together
from service.schemas.derived import model_of, raw_of, wire_type
from service.schemas.exercises.verdicts import Help, PolicyModel
from service.schemas.tables import Units

Kind: TypeAlias = Annotated[
    str, WithJsonSchema({"type": "string", "enum": list(part_types()), "description": "kind of part"})
]


def _seed(value: object) -> str | None:
    """The seed as text; a whole number is as good."""
    if value is None or isinstance(value, str):
        return value
    if isinstance(value, int | float) and not isinstance(value, bool) and value == int(value):
        return str(int(value))
    raise PydanticCustomError("seed_invalid", "a seed is a text or a whole number")


Seed: TypeAlias = Annotated[
    Any,
    PlainValidator(_seed),
    WithJsonSchema({"anyOf": [{"type": "string", "maxLength": 200}, {"type": "integer"}, {"type": "null"}]}),
]


class AnswerBase(Wire):
    """What a student hands in: any of what the exercise asks, at least one of it."""

    model_config = forbidding(together(without=part_types()))

    seed: Seed = Field(None, description="the seed that the student's values were drawn from")
    help: Help | None = Field(None, description="less help than the exercise allows; more is not given")
    attempt: Annotated[int, Field(ge=1), WHOLE] | None = Field(
        None, description="which attempt this is, for a help ladder; a link's own count goes before it"
    )

    def raw(self) -> RawAnswer:
        """Return the answer as the parts read it."""
        found = {kind: getattr(self, kind) for kind in part_types()}
        return RawAnswer(
            **{kind: raw_of(value, part_type(kind).raw) for kind, value in found.items() if value is not None}
        )


_ANSWERS: dict[str, Any] = {
    kind: (wire_type(found.raw) | None, Field(None, description=found.meaning))
    for kind, found in part_types().items()
}
ExerciseAnswer = create_model("ExerciseAnswer", __base__=AnswerBase, __doc__=AnswerBase.__doc__, **_ANSWERS)


class ExerciseEntry(Wire):
    """An exercise in the list."""

    id: str
    version: int = Field(description="raised whenever right answers or values change")
    title: str
    summary: str = Field(description="the statement's first sentence")
    joints: int
    parts: list[Kind] = Field(description="what is asked")
    points: Real


class ExerciseList(Wire):
    """All exercises."""

    language: str
    languages: list[str] = Field(description="the languages that every exercise speaks")
    exercises: list[ExerciseEntry]


class StatementModel(Wire):
    """A statement."""

    markdown: str
    html: str = Field(description="the same, safe to put into a page")


class DimensionValue(Wire):
    """A dimension of the robot."""

    name: str
    value: Real
    unit: str
    needed: bool = Field(description="every right answer contains it; false: frames may be chosen without")
    aliases: list[str] = Field(description="other names that an answer may use for it")


class JointName(Wire):
    """A joint of the robot."""

    name: str = Field(description="what its variable is called in cells")
    type: Literal["revolute", "prismatic"]


class FormOption(Wire):
    """Something that may be chosen."""

    value: str
    label: str = Field(description="what it is called, in the caller's language")


class FormFieldModel(Wire):
    """A field of an answer."""

    name: str = Field(description="key in the answer")
    label: str = Field(description="what it is called, in the caller's language")
    shape: FieldShape = Field(
        description="a cell, a vector (row of cells), a matrix, a list (of as many rows as needed), a choice"
    )
    labels: list[str] = Field(description="what the cells of a row are called; as many as there are")
    rows: int = Field(description="of a matrix how many rows it has, of a list how many it may have")
    options: list[FormOption] = Field(description="what may be chosen")


class GivenNumbersModel(Wire):
    """Numbers that a task is about."""

    name: str
    label: str = Field(description="what they are, in the caller's language")
    labels: list[str] = Field(description="what the columns are called; empty if they need no name")
    rows: list[list[Real | str]] = Field(description="the numbers, or cells of a table, row by row")


class AskedPartBase(Wire):
    """Something that is asked, with the data that its task is about."""

    kind: Kind
    points: Real
    task: str = Field(description="what to do, in the caller's language")
    form: list[FormFieldModel] = Field(
        description="fields of the answer; empty for kinds whose answer has a form of its own"
    )
    numbers: list[GivenNumbersModel] = Field(description="what the task is about, in numbers")


def _given() -> dict[str, Any]:
    """Return the fields of all records that tasks show; each part has those of its own kind."""
    found: dict[str, Any] = {}
    for entry in part_types().values():
        if entry.given is None:
            continue
        for name, field in model_of(entry.given).model_fields.items():
            found[name] = (field.annotation | None, Field(None, description=field.description))  # type: ignore[operator]
    return found


TASK_FIELDS = _given()
AskedPart = create_model("AskedPart", __base__=AskedPartBase, __doc__=AskedPartBase.__doc__, **TASK_FIELDS)


class FigureAxis(Wire):
    """The axis of a joint."""

    joint: int
    type: Literal["revolute", "prismatic"]
    point: Vector3 = Field(description="where the joint's body stands")
    direction: Vector3 = Field(description="unit vector; its sense means something only if signed")
    signed: bool = Field(description="the sense is that of the positive joint variable")


class FigureDimension(Wire):
    """A named length."""

    name: str
    from_: Vector3 = Field(alias="from")
    to: Vector3


class FigurePoint(Wire):
    """A marked point."""

    name: str
    at: Vector3


class FigureGround(Wire):
    """Where the robot is fixed."""

    at: Vector3
    normal: Vector3


class FigureFrame(Wire):
    """A frame that is drawn."""

    origin: Vector3
    x: Vector3
    y: Vector3 = Field(description="as it is drawn; not z × x, if that is the mistake")
    z: Vector3


class NumberedFrame(FigureFrame):
    """A frame that the figure shows."""

    number: int


class FigureModel(Wire):
    """The geometry of the figure, lengths in metres, z up."""

    axes: list[FigureAxis]
    links: list[list[Vector3]] = Field(description="polylines")
    dimensions: list[FigureDimension]
    points: list[FigurePoint]
    ground: FigureGround | None
    size: Real = Field(description="diagonal of the box that holds the robot")
    frames: list[NumberedFrame] = Field(
        description="those that the policy prescribes; or frame 0 … N, one wrong, if that is asked for"
    )
    description: str = Field(description="the figure in words, in the caller's language")
    file: str | None = Field(
        None, description="path of the drawing below /api/v1; what is there never changes"
    )


class AccessModel(Wire):
    """What students may use beside the exercise."""

    off: list[Tool] = Field(description="what is switched off")
    ladder: list[HelpLevel] = Field(description="the most that is told at attempt 1, 2, …")
    attempts: int | None = Field(description="how many attempts there are, if they are limited")
    attempt: int | None = Field(description="which attempt it is, where a link counts them")


class ExerciseModel(Units):
    """An exercise with one student's values. It never holds the key."""

    id: str
    version: int
    seed: str | None
    language: str
    text_language: str = Field(description="language of title and statement, if they lack the caller's")
    note: str | None = Field(description="says so, in the caller's language")
    title: str
    statement: StatementModel
    rules: list[str] = Field(description="what is free and what is fixed, in the caller's language")
    conventions: list[Literal["standard", "modified"]] = Field(description="conventions that are accepted")
    policy: PolicyModel
    help: HelpLevel = Field(description="the most that a verdict tells")
    access: AccessModel
    parameters: dict[str, Real] = Field(description="values of the dimensions, in the exercise's units")
    dimensions: list[DimensionValue] = Field(description="the same with units, in the order of the table")
    joints: list[JointName]
    parts: list[AskedPart]
    points: Real = Field(description="what all parts together are worth")
    figure: FigureModel


class TotalModel(Wire):
    """The points of an answer."""

    points: Real
    max_points: Real
    score: Real = Field(ge=0, le=1)
    missing: list[Kind] = Field(description="parts that are asked and were not handed in")


_WITHOUT_TABLE: dict[str, Any] = {
    "correct": (bool, Field(description="of the table; without one, of all parts that were handed in")),
    "score": (Real, Field(description="of the table; without one, of the parts that were handed in")),
    "basis": (
        Basis | None,
        Field(description="what the verdict on the table rests on: proved, verified or refuted"),
    ),
}
_BESIDE_THE_VERDICT: dict[str, Any] = {
    "parts": (dict[Kind, model_of(PartReport)], Field(description="by kind of part")),  # type: ignore[misc]
    "total": (TotalModel, Field(description="the points")),
    "help": (HelpLevel, Field(description="how much was told")),
    "seed": (str | None, Field(description="from what the student's values were drawn")),
    "version": (int, Field(description="of the exercise")),
    "figure": (model_of(KeyPose) | None, Field(description="told with an accepted table only")),
    "departure": (
        model_of(Departure) | None,
        Field(description="of a wrong table, from the help level `kind` on, where it can be drawn"),
    ),
    "remarks": (list[str], Field(description="the lecturer's own words on what was found")),
}
GradedModel = create_model(
    "Graded",
    __base__=model_of(Verdict),
    __doc__="The verdict on the table, and what is said of every part that was handed in.",
    **_WITHOUT_TABLE,
    **_BESIDE_THE_VERDICT,
)
