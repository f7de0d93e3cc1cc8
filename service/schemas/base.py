"""What every shape on the wire shares: unknown keys and numbers in disguise are refused."""

from typing import Annotated, Any, Self, TypeAlias, TypeVar

from pydantic import (
    BaseModel,
    BeforeValidator,
    ConfigDict,
    Discriminator,
    Field,
    GetJsonSchemaHandler,
    Tag,
    WithJsonSchema,
)
from pydantic_core import CoreSchema

from kinematics.frames.axes import MAX_COORDINATE
from service.http.validation import CHOICE


class Wire(BaseModel):
    """Base of all request and response models.

    Strict: `false` is no number and `"1"` is no integer. For an enumeration, write the field's type as
    `OneOf[TheEnum]`; for a sequence, use `list`.
    """

    model_config = ConfigDict(
        extra="forbid",
        strict=True,
        frozen=True,
        allow_inf_nan=False,
        defer_build=True,  # a service is ready sooner, and never builds most of its models
    )

    @classmethod
    def from_record(cls, record: Any, **others: Any) -> Self:
        """Return a record of the domain as it goes out: the fields that it has as attributes, and others."""
        named = {name: getattr(record, name) for name in cls.model_fields if name not in others}
        return cls.model_validate({**named, **others}, from_attributes=True, strict=False)


LONGEST_LIST = 256
"""Most items of a list in a request, and most names of an object: far above any robot, and few enough to be
validated in a millisecond whatever they are. What a list means usually sets a narrower limit."""


_FEW, _MANY = CHOICE + "few", CHOICE + "many"
_Item = TypeVar("_Item")

OneOf: TypeAlias = Annotated[_Item, Field(strict=False)]  # An enumeration, given by its value.


def by_size(items: int, wide: int) -> Discriminator:
    """Return what tells a short list of small items from any other: all that is wrong with it is told.

    Pydantic collects every finding before any is told, so those of lists in lists are as many as the
    product of their lengths: of a list that is none of the usual, the first item that is wrong is enough.

    Args:
        items: most items of a short list.
        wide: most fields or items of a small item.
    """

    def size(given: Any) -> str:
        if not isinstance(given, list):
            return _FEW
        large = len(given) > items or any(isinstance(i, list | dict) and len(i) > wide for i in given)
        return _MANY if large else _FEW

    return Discriminator(size)


class _OneForm:
    """Describes a choice whose branches look alike as one of them."""

    def __get_pydantic_json_schema__(
        self, schema: CoreSchema, handler: GetJsonSchemaHandler
    ) -> dict[str, Any]:
        (form,) = handler(schema)["oneOf"]
        return dict(form)


Listed: TypeAlias = Annotated[
    Annotated[list[_Item], Field(max_length=LONGEST_LIST), Tag(_FEW)]
    | Annotated[list[_Item], Field(max_length=LONGEST_LIST, fail_fast=True), Tag(_MANY)],
    by_size(16, 32),
    _OneForm(),
]
"""A list of objects, such as rows or links."""


def _whole(value: Any) -> Any:
    return int(value) if isinstance(value, float) and value.is_integer() else value


WHOLE = BeforeValidator(_whole)
"""Makes an integer what JSON Schema calls one: any number without a fraction, so that 2.0 is one. It stands
behind the bounds, which the document would lack otherwise."""
Whole: TypeAlias = Annotated[int, WHOLE]

_WHOLE, _TEXT = CHOICE + "whole", CHOICE + "text"
WholeOrText: TypeAlias = Annotated[
    Annotated[Whole, Tag(_WHOLE)] | Annotated[str, Tag(_TEXT)],
    Discriminator(lambda value: _TEXT if isinstance(value, str) else _WHOLE),
    WithJsonSchema({"anyOf": [{"type": "integer"}, {"type": "string"}]}),
]
"""A number as a page sends it, too; what is neither is told at its own place, not at both choices."""

Real: TypeAlias = Annotated[float, Field(strict=True, allow_inf_nan=False)]
Share: TypeAlias = Annotated[Real, Field(gt=0, le=0.1)]  # A tolerance: of a size, or [rad].
Vector3: TypeAlias = Annotated[list[Real], Field(min_length=3, max_length=3)]

Coordinate: TypeAlias = Annotated[
    Real, Field(json_schema_extra={"minimum": -MAX_COORDINATE, "maximum": MAX_COORDINATE})
]
Coordinates: TypeAlias = Annotated[list[Coordinate], Field(min_length=3, max_length=3)]
"""A point or a direction of an axis or a frame; `kinematics.frames.axes` refuses larger ones."""

Vector6: TypeAlias = Annotated[list[Real], Field(min_length=6, max_length=6)]
Matrix6: TypeAlias = Annotated[
    list[list[Real]],
    Field(min_length=6, max_length=6, description="6×n: three linear rows, three angular rows"),
]

_FOUR = {"minItems": 4, "maxItems": 4}
_MATRIX4 = WithJsonSchema(
    {
        "type": "array",
        "items": {"type": "array", "items": {"type": "number"}, **_FOUR},
        **_FOUR,
        "description": "4×4, row by row",
    }
)
_Numbers = Annotated[list[Real], Field(max_length=LONGEST_LIST)]
_SomeNumbers = Annotated[list[Real], Field(max_length=LONGEST_LIST, fail_fast=True)]
Matrix4: TypeAlias = Annotated[list[_Numbers], Field(max_length=LONGEST_LIST), _MATRIX4]
GivenMatrix4: TypeAlias = Annotated[
    Annotated[list[_Numbers], Field(max_length=LONGEST_LIST), Tag(_FEW)]
    | Annotated[list[_SomeNumbers], Field(max_length=LONGEST_LIST, fail_fast=True), Tag(_MANY)],
    by_size(4, 4),
    _MATRIX4,
]
"""A pose of a request. Its shape is checked with its meaning, by `kinematics.se3.check_transform`."""


class FaultEntry(Wire):
    """One thing that is wrong."""

    code: str = Field(description="stable identifier, in snake_case")
    pointer: str = Field(description="JSON pointer (RFC 6901) into the request's body; empty: all of it")
    detail: str = Field(description="what is wrong and what would be right, in the caller's language")
    params: dict[str, str | int | float | list[str]] = Field(description="the values in the detail")
    in_: str | None = Field(None, alias="in", description="query, path or header, if it is not in the body")
    name: str | None = Field(None, description="the query parameter, path parameter or header")


class ProblemDocument(Wire):
    """A refusal (RFC 9457, application/problem+json)."""

    type: str = Field(description="where the code is explained")
    title: str = Field(description="what kind of refusal it is")
    status: int = Field(description="the HTTP status")
    detail: str = Field(description="the first fault's sentence")
    code: str = Field(description="the first fault's code")
    pointer: str = Field(description="the first fault's place")
    errors: list[FaultEntry] = Field(description="every fault that was found")
    errors_total: int | None = Field(None, description="number of faults, if more were found than are listed")
    request_id: str | None = Field(None, description="what the server's log calls this request")
    attempt_counted: bool | None = Field(None, description="false, if an answer was handed in and not graded")
    note: str | None = Field(None, description="what else the caller should know, in their language")
