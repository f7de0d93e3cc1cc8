"""The platforms of an installation, for its administrator."""

from collections.abc import Callable, Mapping
from typing import Any, TypeVar

from fastapi import Response

from courses.model import Platform, PlatformStatus
from courses.people.administration import admit_administrator, check_administrator
from courses.people.platforms import (
    add_deployment,
    add_platform,
    deployments_of,
    invitations,
    invite,
    platforms,
    remove_platform,
    set_status,
)
from service.course_callers import (
    course_router,
    in_thread,
    json_response,
    object_body,
    record_number,
    refused_setting,
)
from service.course_resources import CourseResources, bearer_token, now
from service.http.forms import own_root
from service.http.routing import ApiRequest
from service.lti.fetching import http_address

router = course_router()

_REQUIRED = ("issuer", "client_id", "authorization_endpoint", "token_endpoint", "jwks_uri")
_ADDRESSES = ("authorization_endpoint", "token_endpoint", "jwks_uri")
_LONGEST = 2000  # Characters of a field of a form; addresses of platforms are the longest.
_Result = TypeVar("_Result")


async def _run(request: ApiRequest, work: Callable[[CourseResources], _Result]) -> _Result:
    """Do an administrator's work."""
    courses = request.resources.with_courses()
    token = bearer_token(request.headers.get("authorization", ""))

    def checked() -> _Result:
        check_administrator(courses.store, token, now())
        return work(courses)

    return await in_thread(request, checked)


@router.post("/administration/open")
async def open_administration(request: ApiRequest) -> Response:
    """Exchange the code of `framewise lti administer` for a token, once."""
    courses = request.resources.with_courses()
    code = str((await object_body(request)).get("code"))
    token = await in_thread(request, admit_administrator, courses.store, code, now())
    return json_response({"token": token})


@router.get("/administration/platforms")
async def list_platforms(request: ApiRequest) -> Response:
    """Return the platforms, and the invitations to register one."""

    def work(courses: CourseResources) -> dict[str, Any]:
        found = [_written(courses, platform) for platform in platforms(courses.store)]
        sent = [
            {
                "note": each.note,
                "created": each.created.isoformat(),
                "expires": each.expires.isoformat(),
                "used": each.used_at is not None,
                "open": each.used_at is None and each.expires > now(),
            }
            for each in invitations(courses.store)
        ]
        return {"platforms": found, "invitations": sent}

    return json_response(await _run(request, work))


def _written(courses: CourseResources, platform: Platform) -> dict[str, Any]:
    names = ("id", "issuer", "client_id", "name", "status", "names_shared", "token_audience", *_ADDRESSES)
    told = {name: getattr(platform, name) for name in names}
    return {
        **told,
        "origins": platform.origins,
        "deployments": deployments_of(courses.store, platform.id),
        "not_fetched": list(filter(courses.fetcher.refuses, platform.called)),
    }


@router.post("/administration/platforms")
async def register_by_hand(request: ApiRequest) -> Response:
    """Register a platform, or change the one of this issuer and client."""
    body = await object_body(request)
    told: dict[str, Any] = {name: _text(body, name) for name in _REQUIRED}
    for name in ("issuer", *_ADDRESSES):
        try:
            http_address(told[name])
        except ValueError:
            raise refused_setting(name, "https://…") from None
    deployment = _text(body, "deployment", required=False)
    asked = Platform(
        **told,
        name=_text(body, "name", required=False),
        token_audience=_text(body, "token_audience", required=False) or None,
        names_shared=body.get("names_shared") is True,
        status=PlatformStatus.ACTIVE,
    )

    def work(courses: CourseResources) -> dict[str, Any]:
        stored = add_platform(courses.store, asked, (deployment,) if deployment else (), now())
        courses.forget_origins()
        return _written(courses, stored)

    return json_response(await _run(request, work), status=201)


def _text(body: Mapping[str, Any], name: str, *, required: bool = True) -> str:
    value = body.get(name, "")
    if not isinstance(value, str) or len(value) > _LONGEST or (required and not value.strip()):
        raise refused_setting(name, f"1 … {_LONGEST}")
    return value.strip()


@router.put("/administration/platforms/{platform}")
async def change_platform(request: ApiRequest) -> Response:
    """Let a platform launch or no longer, and let one more of its deployments launch."""
    body = await object_body(request)
    status = body.get("status")
    if status is not None and status not in list(PlatformStatus):
        raise refused_setting("status", ", ".join(PlatformStatus))
    deployment = _text(body, "deployment", required=False)

    def work(courses: CourseResources) -> None:
        number = record_number(request, "platform")
        if status is not None:
            set_status(courses.store, number, PlatformStatus(status))
            courses.forget_origins()
        if deployment:
            add_deployment(courses.store, number, deployment)

    await _run(request, work)
    return Response(status_code=204)


@router.delete("/administration/platforms/{platform}")
async def forget_platform(request: ApiRequest) -> Response:
    """Remove a platform with all of its courses, attempts and grades."""

    def work(courses: CourseResources) -> None:
        remove_platform(courses.store, record_number(request, "platform"))
        courses.forget_origins()

    await _run(request, work)
    return Response(status_code=204)


@router.post("/administration/invitations")
async def invite_platform(request: ApiRequest) -> Response:
    """Return an address at which a platform may register itself once, within a week."""
    note = _text(await object_body(request), "note", required=False)
    root = own_root(request, request.settings.public_url)
    secret = await _run(request, lambda courses: invite(courses.store, note, now()))
    return json_response({"address": f"{root}lti/register/{secret}"}, status=201)
