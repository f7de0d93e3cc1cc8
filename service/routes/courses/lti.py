"""LTI 1.3: login, launch, keys, and registration of platforms.

A launch ends in a redirect whose fragment holds a code; the page's script exchanges it once for a session
token. Fragments are sent to no server and stand in no log.
"""

from __future__ import annotations

import hmac
import logging
from collections.abc import Callable, Mapping
from datetime import timedelta
from functools import partial
from typing import Any, TypeVar
from urllib.parse import urlencode

from fastapi import APIRouter, Request, Response
from fastapi.responses import JSONResponse, RedirectResponse

from courses.enrolment import Arrival, arrive
from courses.model import Platform, PlatformStatus, Role
from courses.platforms import (
    LOGIN,
    Login,
    add_deployment,
    add_platform,
    check_invitation,
    deployments_of,
    platform_by_id,
    platforms_of,
    redeem_login,
    remember_login,
    use_invitation,
)
from courses.refusals import CourseError, NoExerciseError, StaffOnlyError
from courses.secrets import hashed, issue_code, redeem_code, remember_nonce
from courses.sessions import session_of
from kinematics.errors import Fault, KinematicsError
from service.course_resources import CourseResources, now
from service.http.forms import form_of, own_root
from service.http.middleware import REQUEST_ID
from service.http.problems import ServiceError, problem_of
from service.lti.fetching import http_address, origin_of
from service.lti.launch import Expected, Launch, read_launch
from service.lti.launch_errors import LaunchError, LoginError
from service.lti.login import LoginRequest, authorization_address, new_secret, read_login
from service.lti.registration import ToolRegistration, register
from service.lti.signing_keys import key_set
from service.messages import languages, sentence
from service.resources import resources_of
from service.web.responses import page_language, page_response
from service.web.shell import Page
from service.wire.courses.lti_custom import arrival_of
from service.wire.courses.session_views import seed_of
from service.work.limiters import WorkKind

router = APIRouter(include_in_schema=False)

LAUNCH = Page(name="launch", title="session-launch-title", messages=("session",), depth=1)
CHOOSE = Page(
    name="choose", title="lecturer-choose-title", messages=("lecturer",), depth=1, styles=("lecturer",)
)
COURSE = Page(
    name="course",
    title="lecturer-title",
    messages=("lecturer", "session", "kinds"),
    styles=("scene", "exercise", "lecturer"),
)
COOKIE = "__Host-framewise-login-"
CODE_LIFE = timedelta(seconds=60)
"""How long a code for a session in the address may be exchanged: the page does it at once."""
PENDING_LIFE = timedelta(seconds=120)
"""How long a launch waits for the browser to bring its stored state."""
CHOICE_LIFE = timedelta(hours=2)
"""How long a lecturer may take to choose an exercise."""

_log = logging.getLogger("framewise.lti")
_Result = TypeVar("_Result")


async def _in_thread(request: Request, work: Callable[..., _Result], *arguments: Any) -> _Result:
    limiter = resources_of(request).limiters[WorkKind.COURSES]
    return await limiter.run(partial(work, *arguments))


@router.api_route("/lti/login", methods=["GET", "POST"])
async def login(request: Request) -> Response:
    """Begin a launch: remember it, and send the browser to the platform's authorization endpoint."""
    given = dict(request.query_params) if request.method == "GET" else await form_of(request)
    return await _answered(request, partial(_login, request, given))


@router.post("/lti/launch")
async def launch(request: Request) -> Response:
    """Take a launch message: check it, open a session, and go to the exercise or the course."""
    try:
        given = await form_of(request)
    except ServiceError as error:
        return _refused(request, error)
    return await _answered(request, partial(_launch, request, given))


@router.post("/lti/confirm")
async def confirm(request: Request) -> Response:
    """Go on with a launch whose browser was recognised by what the platform stored for it."""
    given = await form_of(request)
    return await _answered(request, partial(_confirm, request, given))


@router.get("/lti/jwks")
async def jwks(request: Request) -> Response:
    """Return the public keys that this tool signs with."""
    courses = resources_of(request).with_courses()
    keys = await _in_thread(request, courses.keys)
    return JSONResponse(key_set(keys), headers={"Cache-Control": "public, max-age=600"})


@router.get("/lti/configuration")
async def configuration(request: Request) -> Response:
    """Return what platforms are told of this tool, for those that take it as JSON."""
    resources_of(request).with_courses()
    return JSONResponse(_tool(request).written(), headers={"Cache-Control": "no-cache"})


@router.get("/lti/register/{secret}")
async def register_platform(request: Request, secret: str) -> Response:
    """Register a platform that was invited; it stays pending until an administrator activates it."""
    return await _answered(request, partial(_register, request, secret))


@router.get("/course")
async def course_page(request: Request) -> Response:
    """Return the lecturers' page."""
    resources_of(request).with_courses()
    return page_response(request, COURSE)


@router.get("/lti/choose")
async def choose(request: Request) -> Response:
    """Return the page on which a teacher chooses the exercise of a link.

    Its answer is posted to the platform.
    """
    resources_of(request).with_courses()
    return page_response(request, CHOOSE, form_action="https: http:")


async def _answered(request: Request, work: Callable[[], Response]) -> Response:
    resources_of(request).with_courses()
    try:
        return await _in_thread(request, work)
    except (ServiceError, CourseError) as error:
        return _refused(request, error)


def _refused(request: Request, error: ServiceError | KinematicsError) -> Response:
    """A problem document, or a page for people; logged with its code and no secret."""
    problem = problem_of(error, request.scope.get(REQUEST_ID, ""))
    route = request.scope["route"].path  # an address may hold an invitation's secret
    _log.warning("refused %s: %s (%s)", route, error.faults[0].code, problem.request_id)
    if "text/html" not in request.headers.get("accept", ""):
        raise error
    fault = error.faults[0]
    again = error.members.get("again") if isinstance(error, ServiceError) else None
    text = sentence(page_language(request), f"error-{fault.code}", fault.params) or fault.code
    values = _step("window" if again else "refused", text=text, again=again or {})
    return _page(request, values, status=problem.status)


def _login(request: Request, given: Mapping[str, str]) -> Response:
    courses = resources_of(request).with_courses()
    root = own_root(request, resources_of(request).settings.public_url)
    asked = read_login(given, origin_of(root))
    platform = _platform_for(courses, asked)
    state, nonce, browser = new_secret(), new_secret(), new_secret()
    remembered = Login(
        platform_id=platform.id,
        nonce=nonce,
        browser_hash=hashed(browser),
        target=asked.target,
        request=asked.parameters,
    )
    remember_login(courses.store, state, remembered, now())
    address = authorization_address(
        asked, platform, redirect_uri=f"{root}lti/launch", state=state, nonce=nonce
    )
    if asked.storage_target:
        values = _step(
            "store",
            address=address,
            key=_storage_key(state),
            value=browser,
            frame=asked.storage_target,
            origin=origin_of(platform.authorization_endpoint),
        )
        response = _page(request, values)
    else:
        response = RedirectResponse(address, 302)
    response.headers["Cache-Control"] = "no-store"
    response.headers.append("Set-Cookie", _cookie(state, browser, int(LOGIN.total_seconds())))
    return response


def _platform_for(courses: CourseResources, asked: LoginRequest) -> Platform:
    found = platforms_of(courses.store, asked.issuer, asked.client_id)
    params = {"issuer": asked.issuer[:200]}
    if not found:
        raise LoginError(Fault.at("lti_platform_unknown", **params))
    if len(found) > 1:
        raise LoginError(Fault.at("lti_platform_ambiguous", **params))
    if found[0].status is not PlatformStatus.ACTIVE:
        raise LoginError(Fault.at("lti_platform_inactive", **params))
    try:
        http_address(found[0].authorization_endpoint)
    except ValueError:  # an earlier version has stored whatever was typed
        params = {"name": "authorization_endpoint"}
        raise LoginError(Fault.at("lti_configuration_invalid", **params)) from None
    return found[0]


def _launch(request: Request, given: Mapping[str, str]) -> Response:
    courses = resources_of(request).with_courses()
    state = given.get("state", "")
    met = redeem_login(courses.store, state, now()) if state else None
    if met is None:
        raise LaunchError(Fault.at("lti_state_unknown"))
    known = _is_browser(request.cookies.get(_cookie_name(state), ""), met)
    frame = met.request.get("lti_storage_target") or given.get("lti_storage_target")
    if not known and not frame:
        raise LaunchError(Fault.at("lti_browser_unknown"), members={"again": dict(met.request)})
    if "error" in given:
        reason = f"{given['error']} {given.get('error_description', '')}".strip()[:200]
        raise LaunchError(Fault.at("lti_launch_refused", reason=reason))
    if not given.get("id_token"):
        raise LoginError(Fault.at("lti_parameter_missing", name="id_token"))
    platform = platform_by_id(courses.store, met.platform_id)
    expected = Expected(
        platform=platform,
        nonce=met.nonce,
        target=met.target,
        use_nonce=partial(remember_nonce, courses.store, platform.id),
        knows_deployment=lambda deployment: deployment in deployments_of(courses.store, platform.id),
    )
    found = read_launch(given["id_token"], expected, courses.platform_keys, now())
    if known:
        return _opened(request, courses, _content(request, found, platform))
    pending = {
        "browser_hash": met.browser_hash,
        "request": dict(met.request),
        "launch": _content(request, found, platform),
    }
    code = issue_code(courses.store, "pending", pending, now(), PENDING_LIFE)
    values = _step(
        "compare",
        code=code,
        key=_storage_key(state),
        frame=str(frame),
        origin=origin_of(platform.authorization_endpoint),
    )
    return _page(request, values)


def _confirm(request: Request, given: Mapping[str, str]) -> Response:
    courses = resources_of(request).with_courses()
    pending = redeem_code(courses.store, "pending", given.get("code", ""), now())
    if not hmac.compare_digest(hashed(given.get("value", "")), pending["browser_hash"]):
        raise LaunchError(Fault.at("lti_browser_unknown"), members={"again": pending["request"]})
    return _opened(request, courses, pending["launch"])


def _content(request: Request, found: Launch, platform: Platform) -> dict[str, Any]:
    """A believed launch as JSON: an arrival, or what a deep link has to answer."""
    arrival = arrival_of(found, platform, resources_of(request).exercises)
    told = {name: getattr(arrival, name) for name in Arrival.__slots__ if name != "platform"}
    told["settings"] = dict(arrival.settings)
    return {
        "platform": platform.id,
        "arrival": told,
        "deep_linking": found.deep_linking and dict(found.deep_linking),
    }


def _opened(request: Request, courses: CourseResources, content: Mapping[str, Any]) -> Response:
    """Open the session of a launch, and go where it leads."""
    told = dict(content["arrival"])
    platform = platform_by_id(courses.store, content["platform"])
    arrival = Arrival(**{**told, "role": Role(told["role"])}, platform=platform)
    root = own_root(request, resources_of(request).settings.public_url)
    query = {"lang": language} if (language := _language(arrival.locale)) else {}
    if content["deep_linking"] is not None:
        if arrival.role is not Role.STAFF:
            raise StaffOnlyError
        kept = {
            "platform": platform.id,
            "deployment": arrival.deployment,
            "settings": content["deep_linking"],
        }
        code = issue_code(courses.store, "deep-link", kept, now(), CHOICE_LIFE)
        return _redirect(f"{root}lti/choose", query, f"choice={code}")
    token, _ = arrive(courses.store, arrival, now())
    code = issue_code(courses.store, "session", {"token": token}, now(), CODE_LIFE)
    session = session_of(courses.store, token, now())
    if session.role is Role.STAFF:
        return _redirect(f"{root}course", query, f"session={code}")
    chosen = session.link.settings
    if chosen.exercise_id is None:
        raise NoExerciseError
    query |= {"lang": chosen.language} if chosen.language else {}
    query |= {"seed": seed} if (seed := seed_of(session)) else {}
    return _redirect(f"{root}exercises/{chosen.exercise_id}", query, f"session={code}")


def _register(request: Request, secret: str) -> Response:
    courses = resources_of(request).with_courses()
    check_invitation(courses.store, secret, now())
    configuration = request.query_params.get("openid_configuration", "")
    if not configuration:
        params = {"name": "openid_configuration"}
        raise LoginError(Fault.at("lti_parameter_missing", **params))
    use_invitation(courses.store, secret, now())
    found = register(
        courses.fetcher, configuration, request.query_params.get("registration_token"), _tool(request)
    )
    platform = Platform(
        issuer=found.issuer,
        client_id=found.client_id,
        name=found.name,
        authorization_endpoint=found.authorization_endpoint,
        token_endpoint=found.token_endpoint,
        token_audience=found.token_audience,
        jwks_uri=found.jwks_uri,
        status=PlatformStatus.PENDING,
    )
    stored = add_platform(courses.store, platform, (), now())
    if found.deployment:
        add_deployment(courses.store, stored.id, found.deployment)
    text = sentence(page_language(request), "session-registered", {"issuer": found.issuer}) or ""
    return _page(request, _step("close", text=text))


def _tool(request: Request) -> ToolRegistration:
    root = own_root(request, resources_of(request).settings.public_url)
    description = sentence("en", "session-tool-description") or ""
    return ToolRegistration(name="Framewise", description=description, root=root)


def _redirect(address: str, query: Mapping[str, str], fragment: str) -> Response:
    joined = f"{address}?{urlencode(query)}" if query else address
    return RedirectResponse(f"{joined}#{fragment}", 303, {"Cache-Control": "no-store"})


def _language(locale: str | None) -> str | None:
    """The page's language for a platform's locale; None leaves it to the browser."""
    code = (locale or "").replace("_", "-").partition("-")[0].lower()
    return code if code in languages() else None


def _step(name: str, *, text: str = "", again: object = None, **values: str) -> dict[str, str]:
    """What the launch page does next, as its template takes it."""
    fields = {"address": "", "key": "", "value": "", "frame": "", "origin": "", "code": "", **values}
    fields["again"] = urlencode(again) if isinstance(again, Mapping) else ""
    return {"step": name, "text": text, **fields}


def _page(request: Request, values: Mapping[str, str], *, status: int = 200) -> Response:
    response = page_response(request, LAUNCH, values, status=status)
    response.headers["Cache-Control"] = "no-store"
    return response


def _storage_key(state: str) -> str:
    return f"state_{hashed(state)[:16]}"


def _cookie_name(state: str) -> str:
    return f"{COOKIE}{hashed(state)[:12]}"


def _cookie(state: str, value: str, life: int) -> str:
    """The field Set-Cookie: for this host alone, in a partition of the page that frames it."""
    attributes = f"Path=/; Max-Age={life}; Secure; HttpOnly; SameSite=None; Partitioned"
    return f"{_cookie_name(state)}={value}; {attributes}"


def _is_browser(value: str, met: Login) -> bool:
    return hmac.compare_digest(hashed(value), met.browser_hash)
