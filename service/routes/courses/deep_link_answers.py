"""A lecturer's choice of an exercise, signed for the platform that asked."""

from fastapi import Response

from courses.people.platforms import platform_by_id
from courses.people.secrets import redeem_code
from service.course_callers import course_router, in_thread, json_response, object_body, settings_in
from service.course_resources import now
from service.http.forms import own_root
from service.http.languages import language_of
from service.http.routing import ApiRequest
from service.lti.deep_links import ContentItem, response_token, takes_line_items
from service.lti.login import check_active
from service.wire.courses.lti_custom import custom_of
from service.work.session_grading import asked_exercise

router = course_router()


@router.post("/deep-links")
async def answer_deep_link(request: ApiRequest) -> Response:
    """Return the signed answer to a platform that asked for a link: an exercise with its rules."""
    courses = request.resources.with_courses()
    body = await object_body(request)
    choice = str(body.get("choice"))
    chosen = {name: value for name, value in body.items() if name != "choice"}
    settings = settings_in(request, chosen)
    exercise = asked_exercise(request.resources.exercises, settings)
    rules = {name: value for name, value in chosen.items() if name != "exercise"}
    title = exercise.title(language_of(request))
    root = own_root(request, request.settings.public_url)

    def work() -> dict[str, str]:
        asked = redeem_code(courses.store, "deep-link", choice, now())
        platform = platform_by_id(courses.store, asked["platform"])
        check_active(platform)
        item = ContentItem(
            address=f"{root}lti/launch",
            title=title,
            text="",
            custom=custom_of(exercise.id, rules),
            points=settings.points if takes_line_items(asked["settings"]) else None,
            tag=exercise.id,
        )
        token = response_token(
            platform, asked["deployment"], asked["settings"], [item], courses.signing(), now()
        )
        return {"address": asked["settings"]["deep_link_return_url"], "jwt": token}

    return json_response(await in_thread(request, work))
