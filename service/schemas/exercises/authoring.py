"""Drafts of exercises on the wire."""

from base64 import b64decode
from typing import Annotated, Any

from pydantic import BaseModel, Field, GetJsonSchemaHandler, PlainValidator, WithJsonSchema
from pydantic.json_schema import JsonSchemaValue
from pydantic_core import CoreSchema, PydanticCustomError

from exercises.authoring.admission import PolicyAdmission
from exercises.authoring.draft import ID_PATTERN, LONGEST_ID, ExerciseDraft
from exercises.authoring.sources import FORMS
from exercises.authoring.trials import MOST_ANSWERS
from exercises.selftest.rehearsal import RehearsedAnswer
from service.schemas.base import WHOLE, Vector3, Wire
from service.schemas.derived import model_of
from service.schemas.exercises.exercises import ExerciseAnswer, ExerciseModel

Languages = Annotated[dict[str, str], Field(max_length=64)]


ExerciseId = Annotated[
    str,
    Field(
        max_length=100,
        description="name of its folder: letters, digits and single hyphens",
        json_schema_extra={"pattern": f"^{ID_PATTERN}$", "maxLength": LONGEST_ID},
    ),
]
"""`exercises.authoring.draft.check_id` refuses others."""


class DraftModel(Wire):
    """An exercise as its author holds it."""

    id: ExerciseId
    definition: dict[str, Any] = Field(
        description="the keys of exercise.toml, as a reader of TOML gives them (docs/authoring.md)"
    )
    statements: Languages = Field(
        description="statements in Markdown, by language", json_schema_extra={"minProperties": 1}
    )

    def draft(self) -> ExerciseDraft:
        """Return the draft as the reader takes it."""
        return ExerciseDraft(id=self.id, definition=self.definition, statements=self.statements)


class StartRequest(Wire):
    """From what an exercise is started."""

    id: ExerciseId
    source: dict[str, Any] = Field(
        description="one of `robot` (id of the catalogue), `table` (a DH table, with values under "
        "`parameters`), `axes` (joint axes as they are drawn), `scm` (an SCM chain) and `urdf` (a text)",
        json_schema_extra={"minProperties": 1, "maxProperties": 1, "propertyNames": {"enum": list(FORMS)}},
    )


class DraftRequest(Wire):
    """A draft."""

    draft: DraftModel


class PublishRequest(DraftRequest):
    """A draft, and by what its author may publish it."""

    choice: Annotated[str, Field(max_length=200)] | None = Field(
        None, description="the code with which a platform asked for a link; it stays good"
    )


class CheckRequest(DraftRequest):
    """A draft, and whose values it is tested with."""

    seed: Annotated[int, Field(ge=0, le=1_000_000), WHOLE] | None = Field(
        None, description="the seed of this round; left out, the usual values"
    )


class RightAnswersRequest(DraftRequest):
    """A draft, and how many right answers are wanted."""

    count: Annotated[int, Field(ge=1, le=MOST_ANSWERS), WHOLE] = Field(10, description="how many")


class _DescribedBy:
    """Described by a model that it is checked with only when the rest of the request is known to be right."""

    def __init__(self, model: type[BaseModel]) -> None:
        self._model = model

    def __get_pydantic_json_schema__(self, _: CoreSchema, handler: GetJsonSchemaHandler) -> JsonSchemaValue:
        return handler(self._model.__pydantic_core_schema__)


class TryRequest(DraftRequest):
    """A draft, and an answer as a student would hand it in."""

    answer: Annotated[dict[str, Any], _DescribedBy(ExerciseAnswer)] = Field(
        description="as for POST /exercises/{id}/grade"
    )


def _decoded(value: object) -> bytes:
    if isinstance(value, str):
        try:
            return b64decode(value, validate=True)
        except ValueError:
            pass
    raise PydanticCustomError("archive_not_zip", "an archive is written in base64")


class ImportRequest(Wire):
    """The folder of an exercise."""

    archive: Annotated[
        bytes, PlainValidator(_decoded), WithJsonSchema({"type": "string", "contentEncoding": "base64"})
    ] = Field(description="a zip archive, in base64")


class DraftAnswer(Wire):
    """A draft."""

    draft: DraftModel


class PlacedAxis(Wire):
    """A joint axis in space."""

    joint: str = Field(description="revolute or prismatic")
    point: Vector3 = Field(description="a point on the axis")
    direction: Vector3 = Field(description="unit vector")


class StartAnswer(DraftAnswer):
    """A new draft, and what it was made from."""

    axes: list[PlacedAxis] = Field(description="the axes, where they were drawn; empty otherwise")


AdmissionBase: Any = model_of(PolicyAdmission)


class AdmissionModel(AdmissionBase):  # type: ignore[misc]
    """What a policy leaves free for one robot."""

    message: str = Field(description="the same in a sentence, in the caller's language")


class PreviewAnswer(Wire):
    """A draft as students will see it."""

    exercise: ExerciseModel
    figure: str = Field(description="the figure as SVG")
    statements: Languages = Field(description="the statements as HTML, safe to put into a page, by language")
    policy: AdmissionModel
    key: dict[str, Any] = Field(description="the key, as a DH table")
    dimensions: dict[str, Any] = Field(
        description="the figure's dimensions as a definition has them (`mark`), where their lines stand in "
        "the units of the SVG, and in which directions (`ways`) and how far (`distances`) they may be moved"
    )
    kinds: list[dict[str, Any]] = Field(
        description="the kinds of part: with what a definition begins, what else it may say, and which other "
        "kinds cannot be asked beside it, because it shows their answer (`gives_away`)"
    )


class SelfTestLine(Wire):
    """What a self-test has to say."""

    check: str = Field(description="what was checked")
    params: dict[str, Any] = Field(description="the values in the sentence")
    message: str = Field(description="the sentence, in the caller's language")


class SelfTestAnswer(Wire):
    """A round of an exercise's own tests."""

    seed: int | None
    passed: int = Field(description="how many checks passed")
    failures: list[SelfTestLine]
    warnings: list[SelfTestLine]


_Rehearsed = model_of(RehearsedAnswer)


class RehearsalAnswer(Wire):
    """Answers as somebody might hand them in."""

    answers: list[_Rehearsed]  # type: ignore[valid-type]


class PublishedAnswer(Wire):
    """Where a version of an exercise is."""

    id: str = Field(description="the id of the exercise on this service, for good")
    digest: str = Field(description="SHA-256 of its content")
