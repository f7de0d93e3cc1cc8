"""Which robot a call speaks of, a table or one of the catalogue; and whether the answer is in numbers."""

from __future__ import annotations

from typing import Annotated, Literal, Self, TypeAlias

from pydantic import BeforeValidator, Field, model_validator
from pydantic_core import PydanticCustomError

from service.schemas.base import Wire
from service.schemas.choices import forbidding, not_one_of
from service.schemas.tables import Parameters, Table

NO_ROBOT = not_one_of("table", "robot")


class RobotQuestion(Wire):
    """Base of the calls that take a robot: exactly one of `table` and `robot`."""

    model_config = forbidding(*NO_ROBOT)

    table: Table | None = Field(None, description="the robot's DH table")
    robot: str | None = Field(None, max_length=64, description="or the id of a robot of the catalogue")
    parameters: Parameters = Field(default_factory=dict)

    @model_validator(mode="after")
    def _one_robot(self) -> Self:
        if (self.table is None) == (self.robot is None):
            raise PydanticCustomError("table_or_robot", "give either table or robot, exactly one of them")
        return self


_FORMS = ("numeric", "symbolic")


def _known_form(form: object) -> object:
    if form not in _FORMS:
        expected = " or ".join(map(repr, _FORMS))
        raise PydanticCustomError("value_not_allowed", "this must be {expected}", {"expected": expected})
    return form


NumericForm: TypeAlias = Annotated[Literal["numeric"], BeforeValidator(_known_form)]
"""The form of an answer in numbers; a fault names the symbolic one too."""
