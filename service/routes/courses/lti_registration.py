"""What platforms are told of this tool, and their dynamic registration."""

from functools import partial

from fastapi import APIRouter, Request, Response
from fastapi.responses import JSONResponse

from courses.model import PlatformStatus
from courses.people.platforms import add_platform, check_invitation, use_invitation
from courses.refusals import StorageUnavailableError
from kinematics.errors import Fault
from service.course_resources import now
from service.http.forms import own_root
from service.lti.launch_errors import LoginError
from service.lti.registration import ToolRegistration, register
from service.lti.signing_keys import key_set
from service.messages import sentence
from service.resources import resources_of
from service.web.launch_page import REGISTRATION, answered, launch_page, step
from service.web.responses import page_language
from service.work.limiters import WorkKind

router = APIRouter(include_in_schema=False)


@router.get("/lti/jwks")
async def jwks(request: Request) -> Response:
    """Return the public keys that this tool signs with; without the database, as they were read last."""
    resources = resources_of(request)
    courses = resources.with_courses()
    try:
        courses.key_set = key_set(await resources.limiters[WorkKind.COURSES].run(courses.keys))
    except StorageUnavailableError:
        if not courses.key_set:
            raise
    return JSONResponse(courses.key_set, headers={"Cache-Control": "public, max-age=600"})


@router.get("/lti/configuration")
async def configuration(request: Request) -> Response:
    """Return what platforms are told of this tool, for those that take it as JSON."""
    resources_of(request).with_courses()
    return JSONResponse(_tool(request).written(), headers={"Cache-Control": "no-cache"})


@router.get("/lti/register/{secret}")
async def register_platform(request: Request, secret: str) -> Response:
    """Register a platform that was invited; a new one stays pending until an administrator activates it."""
    return await answered(request, partial(_register, request, secret), REGISTRATION)


def _register(request: Request, secret: str) -> Response:
    courses = resources_of(request).with_courses()
    check_invitation(courses.store, secret, now())
    configuration = request.query_params.get("openid_configuration", "")
    if not configuration:
        raise LoginError(Fault.at("lti_parameter_missing", name="openid_configuration"))
    platform, deployment = register(
        courses.fetcher, configuration, request.query_params.get("registration_token"), _tool(request)
    )
    use_invitation(courses.store, secret, now())
    stored = add_platform(courses.store, platform, (deployment,) if deployment else (), now())
    message = "session-registered-again" if stored.status is PlatformStatus.ACTIVE else "session-registered"
    text = sentence(page_language(request), message, {"issuer": platform.issuer}) or ""
    return launch_page(request, step("close", text=text), REGISTRATION)


def _tool(request: Request) -> ToolRegistration:
    root = own_root(request, resources_of(request).settings.public_url)
    description = sentence("en", "session-tool-description") or ""
    return ToolRegistration(name="Framewise", description=description, root=root)
