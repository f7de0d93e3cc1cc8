"""POST /exercises/{exercise_id}/links: links that carry a lecturer's settings, signed."""

import time
from typing import Annotated
from urllib.parse import urlencode

from fastapi import Request
from pydantic import Field

from exercises.access import Tool
from exercises.instance import SEED_CHARACTERS
from service.http.link_context import QUERY, LinkContext, signed
from service.http.openapi import problems
from service.http.routing import api_router
from service.resources import AppResources
from service.routes.exercises.exercises import Id
from service.schemas.base import WHOLE, OneOf, Wire
from service.schemas.exercises.verdicts import Help
from service.secret import installation_secret
from service.wire.exercises.ungraded import known_exercise

MOST_DAYS = 3660  # Ten years: longer than any course.

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


router = api_router("exercises")

_DAY = 24 * 3600


@router.post(
    "/exercises/{exercise_id}/links",
    response_model=SignedLink,
    responses=problems(404),
    summary="A link to an exercise that carries settings, signed",
)
async def make_link(
    request: Request, exercise_id: Id, body: SignedLinkRequest, resources: AppResources
) -> SignedLink:
    """Return the address of the exercise's page under settings that only restrict what its students may use.

    Anybody may make one: it opens nothing that is not open already. Receipts say which settings were in
    force, so a student who leaves the link behind has a receipt without them.
    """
    with known_exercise():
        found = resources.exercises.exercise(exercise_id)
    context = LinkContext(
        exercise=found.id,
        off=frozenset(body.off),
        help=body.help,
        attempts=body.attempts,
        seed=body.seed,
        expires=None if body.days is None else int(time.time()) + body.days * _DAY,
    )
    token = signed(context, installation_secret(resources.settings))
    page = request.url_for("exercise_page", exercise_id=found.id)
    return SignedLink(context=token, url=f"{page}?{urlencode({QUERY: token})}")
