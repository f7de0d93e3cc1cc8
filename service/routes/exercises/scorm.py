"""SCORM packages of exercises, for courses whose administrator nobody waits for."""

from typing import Annotated
from urllib.parse import urlencode

from fastapi import Query, Request, Response

from exercises.access import Tool
from service.adapters.scorm import ScormPackage, ScormVersion, package
from service.http.languages import Language, language_of
from service.http.link_context import QUERY, LinkContext, signed
from service.http.openapi import problems
from service.http.routing import api_router
from service.messages import sentence
from service.resources import AppResources
from service.routes.exercises.exercises import Id
from service.schemas.exercises.verdicts import Help
from service.secret import installation_secret
from service.wire.exercises.ungraded import known_exercise

router = api_router("exercises")

ZIP = "application/zip"
_SENTENCES = {"no_script": "scorm-no-script", "no_lms": "scorm-no-lms"}


@router.get(
    "/exercises/{exercise_id}/scorm.zip",
    responses={200: {"content": {ZIP: {"schema": {"type": "string", "format": "binary"}}}}, **problems(404)},
    response_class=Response,
    summary="The exercise as a SCORM package",
)
async def scorm_package(
    request: Request,
    exercise_id: Id,
    resources: AppResources,
    version: Annotated[ScormVersion, Query(description="1.2, or 2004 (4th edition)")] = ScormVersion.V1_2,
    per_student: Annotated[bool, Query(description="every student gets values of their own")] = True,
    pass_mark: Annotated[
        float,
        Query(alias="pass", gt=0, le=1, allow_inf_nan=False, description="share of the points that passes"),
    ] = 0.5,
    help_level: Annotated[
        Help | None, Query(alias="help", description="less help than the exercise allows")
    ] = None,
    off: Annotated[
        list[Tool] | None, Query(description="what its students may not use beside the exercise")
    ] = None,
    attempts: Annotated[
        int | None,
        Query(ge=1, le=1000, description="how many attempts there are; left out: as many as one likes"),
    ] = None,
    lang: Language = None,
) -> Response:
    """Return a package that an LMS plays.

    It shows the exercise from this service and records score and answer.

    What an LMS learns through SCORM comes from the student's browser and can be forged there; the receipt
    that the package leaves in the comments cannot.
    """
    with known_exercise():
        found = resources.exercises.exercise(exercise_id)
    language = language_of(request)
    query = {"embed": "scorm", "lang": language}
    if help_level or off or attempts:
        limits = LinkContext(exercise=found.id, off=frozenset(off or ()), help=help_level, attempts=attempts)
        query[QUERY] = signed(limits, installation_secret(resources.settings))
    page = request.url_for("exercise_page", exercise_id=exercise_id)
    what = ScormPackage(
        version=version,
        identifier=found.id,
        title=found.title(language),
        language=language,
        url=f"{page}?{urlencode(query)}",
        per_student=per_student,
        pass_mark=pass_mark,
        sentences={name: sentence(language, message) or "" for name, message in _SENTENCES.items()},
    )
    name = f"{found.id}-scorm-{version.value}.zip"
    headers = {"Content-Disposition": f'attachment; filename="{name}"', "Cache-Control": "no-cache"}
    return Response(package(what), media_type=ZIP, headers=headers)
