"""Links that carry a lecturer's settings, signed, so that no student changes them unseen."""

from __future__ import annotations

import time
from typing import Annotated, Any
from urllib.parse import urlencode

from fastapi import Request

from service.http.link_context import QUERY, LinkContext, signed
from service.http.openapi import body_with, problems
from service.http.routing import api_router
from service.resources import AppResources
from service.routes.exercises.exercises import Id
from service.schemas.exercises.signed_links import SignedLink, SignedLinkRequest
from service.secret import installation_secret
from service.wire.exercises.ungraded import known_exercise

router = api_router("exercises")

_DAY = 24 * 3600
_LINK: dict[str, Any] = {
    "an exam": {"off": ["catalogue", "playground", "matrices", "trainer"], "help": "verdict", "attempts": 3}
}


@router.post(
    "/exercises/{exercise_id}/links",
    response_model=SignedLink,
    responses=problems(404),
    summary="A link to an exercise that carries settings, signed",
)
async def make_link(
    request: Request,
    exercise_id: Id,
    body: Annotated[SignedLinkRequest, body_with(_LINK)],
    resources: AppResources,
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
