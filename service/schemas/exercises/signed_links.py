"""Links that a lecturer makes, on the wire."""

from __future__ import annotations

from typing import Annotated

from pydantic import Field

from exercises.access import Tool
from exercises.instance import SEED_CHARACTERS
from service.schemas.base import WHOLE, OneOf, Wire
from service.schemas.exercises.verdicts import Help

MOST_DAYS = 3660
"""Ten years: longer than any course."""

Switched = OneOf[Tool]


class SignedLinkRequest(Wire):
    """What the students of a link may use."""

    off: list[Switched] = Field(
        default_factory=list,
        max_length=len(Tool),
        description="what is switched off, beside what the exercise itself switches off",
    )
    help: Help | None = Field(None, description="the most that is told; null: as much as the exercise tells")
    attempts: Annotated[int, Field(ge=1, le=1000), WHOLE] | None = Field(
        None, description="how many attempts there are; null: as many as the exercise has"
    )
    seed: Annotated[str, Field(max_length=SEED_CHARACTERS)] | None = Field(
        None, description="the only seed that the exercise is shown with; null: any"
    )
    days: Annotated[int, Field(ge=1, le=MOST_DAYS), WHOLE] | None = Field(
        None, description="after how many days the link ends; null: never"
    )


class SignedLink(Wire):
    """A link that carries its settings, signed."""

    context: str = Field(description="the settings, signed by this installation (X-Framewise-Context)")
    url: str = Field(description="the exercise's page under these settings")
