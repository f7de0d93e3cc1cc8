"""LTI 1.3: login and launch.

A launch ends in a redirect whose fragment holds a code; the page's script exchanges it once for a session
token. Fragments are sent to no server and stand in no log.
"""

import hmac
from collections.abc import Mapping
from datetime import timedelta
from functools import partial
from typing import Any
from urllib.parse import urlencode

from fastapi import APIRouter, Request, Response
from fastapi.responses import RedirectResponse

from courses.model import Platform, PlatformStatus, Role
from courses.people.enrolment import Arrival, arrive
from courses.people.platforms import deployments_of, platform_by_id, platforms_of
from courses.people.secrets import hashed, issue_code, new_token, redeem_code, remember_nonce
from courses.people.sessions import session_of
from courses.refusals import NoExerciseError, StaffOnlyError
from kinematics.errors import Fault
from service.course_resources import CourseResources, now
from service.http.forms import form_of, own_root
from service.http.link_guard import no_cookie
from service.http.problems import MethodError, ServiceError
from service.lti.fetching import http_address, origin_of
from service.lti.launch import Expected, Launch, read_launch
from service.lti.launch_errors import LaunchError, LoginError
from service.lti.login import LOGIN, LoginRequest, check_active, login_of, nonce_of, read_login, redirection
from service.messages import languages, sentence
from service.resources import resources_of
from service.web.launch_page import answered, launch_page, refused, step
from service.web.responses import page_language
from service.wire.courses.lti_custom import arrival_of
from service.wire.courses.session_views import seed_of

router = APIRouter(include_in_schema=False)

COOKIE = "__Host-framewise-login-"
CODE_LIFE = timedelta(seconds=60)
"""How long a code for a session in the address may be exchanged: the page does it at once."""
PENDING_LIFE = timedelta(seconds=120)  # How long a launch waits for the browser to bring its stored state.
CHOICE_LIFE = timedelta(hours=2)  # How long a lecturer may take to choose an exercise.


@router.api_route("/lti/login", methods=["GET", "POST"])
async def login(request: Request) -> Response:
    """Begin a launch: send the browser to the platform's authorization endpoint."""
    given = dict(request.query_params) if request.method == "GET" else await form_of(request)
    return await answered(request, partial(_login, request, given))


@router.post("/lti/launch")
async def launch(request: Request) -> Response:
    """Take a launch message: check it, open a session, and go to the exercise or the course."""
    try:
        given = await form_of(request)
    except ServiceError as error:
        return refused(request, error)
    return await answered(request, partial(_launch, request, given))


@router.get("/lti/launch")
async def launch_by_hand(request: Request) -> Response:
    """Say to a person that learning platforms open this address, and to a program that it takes POST."""
    resources_of(request).with_courses()
    allowed = ("OPTIONS", "POST")
    headers = {"Allow": ", ".join(allowed)}
    if "text/html" not in request.headers.get("accept", ""):
        fault = Fault.at("method_not_allowed", method=request.method, allowed=allowed)
        raise MethodError(fault, headers=headers)
    text = sentence(page_language(request), "session-launch-by-hand") or ""
    page = launch_page(request, step("refused", text=text), status=405)
    page.headers.update(headers)
    return page


@router.post("/lti/confirm")
async def confirm(request: Request) -> Response:
    """Go on with a launch whose browser was recognised by what the platform stored for it."""
    given = await form_of(request)
    return await answered(request, partial(_confirm, request, given))


def _login(request: Request, given: Mapping[str, str]) -> Response:
    courses = resources_of(request).with_courses()
    root = own_root(request, resources_of(request).settings.public_url)
    asked = read_login(given, origin_of(root))
    platform = _platform_for(courses, asked)
    browser = new_token()
    state, address = redirection(courses.store, platform, asked, browser, f"{root}lti/launch", now())
    if asked.storage_target:
        values = step(
            "store",
            address=address,
            key=_storage_key(state),
            value=browser,
            frame=asked.storage_target,
            origin=origin_of(platform.authorization_endpoint),
        )
        response = launch_page(request, values)
    else:
        response = RedirectResponse(address, 302)
    response.headers["Cache-Control"] = "no-store"
    response.headers.append("Set-Cookie", _cookie(state, browser, int(LOGIN.total_seconds())))
    return response


def _platform_for(courses: CourseResources, asked: LoginRequest) -> Platform:
    found = platforms_of(courses.store, asked.issuer, asked.client_id)
    params = {"issuer": asked.issuer[:200]}
    if not found and asked.client_id and platforms_of(courses.store, asked.issuer, None):
        raise LoginError(Fault.at("lti_client_unknown", **params, client=asked.client_id[:200]))
    if not found:
        raise LoginError(Fault.at("lti_platform_unknown", **params))
    active = [each for each in found if each.status is PlatformStatus.ACTIVE]
    if len(active) > 1:
        raise LoginError(Fault.at("lti_platform_ambiguous", **params))
    platform = (active or found)[0]
    check_active(platform)
    try:
        http_address(platform.authorization_endpoint)
    except ValueError:  # an earlier version has stored whatever was typed
        params = {"name": "authorization_endpoint"}
        raise LoginError(Fault.at("lti_configuration_invalid", **params)) from None
    return platform


def _launch(request: Request, given: Mapping[str, str]) -> Response:
    courses = resources_of(request).with_courses()
    state = given.get("state", "")
    met = login_of(courses.store, state, now())
    if met is None:
        raise LaunchError(Fault.at("lti_state_unknown"))
    browser = request.cookies.get(_cookie_name(state), "")
    known = hmac.compare_digest(hashed(browser), met.browser_hash)
    frame = met.storage_target or given.get("lti_storage_target")
    if not known and not frame:
        raise LaunchError(Fault.at("lti_browser_unknown"), members={"again": dict(met.again)})
    if "error" in given:
        reason = f"{given['error']} {given.get('error_description', '')}".strip()[:200]
        raise LaunchError(Fault.at("lti_launch_refused", reason=reason))
    if not given.get("id_token"):
        raise LoginError(Fault.at("lti_parameter_missing", name="id_token"))
    platform = platform_by_id(courses.store, met.platform_id)
    expected = Expected(
        platform=platform,
        nonce=nonce_of(state),
        target=met.target,
        use_nonce=partial(remember_nonce, courses.store, platform.id),
        knows_deployment=lambda deployment: deployment in deployments_of(courses.store, platform.id),
    )
    found = read_launch(given["id_token"], expected, courses.platform_keys, now())
    if known:
        return _opened(request, courses, _content(request, found, platform))
    pending = {
        "browser_hash": met.browser_hash,
        "request": dict(met.again),
        "launch": _content(request, found, platform),
    }
    code = issue_code(courses.store, "pending", pending, now(), PENDING_LIFE)
    values = step(
        "compare",
        code=code,
        key=_storage_key(state),
        frame=str(frame),
        origin=origin_of(platform.authorization_endpoint),
    )
    return launch_page(request, values)


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
    check_active(platform)  # it may have been switched off since the login
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
        return _redirect(request, f"{root}lti/choose", query, f"choice={code}")
    token, _ = arrive(courses.store, arrival, now())
    code = issue_code(courses.store, "session", {"token": token}, now(), CODE_LIFE)
    session = session_of(courses.store, token, now())
    if session.role is Role.STAFF:
        return _redirect(request, f"{root}course", query, f"session={code}")
    chosen = session.link.settings
    if chosen.exercise_id is None:
        raise NoExerciseError
    query |= {"lang": chosen.language} if chosen.language else {}
    query |= {"seed": seed} if (seed := seed_of(session)) else {}
    return _redirect(request, f"{root}exercises/{chosen.exercise_id}", query, f"session={code}")


def _redirect(request: Request, address: str, query: Mapping[str, str], fragment: str) -> Response:
    """Go where a launch leads; a link that the browser came by before has no say there."""
    joined = f"{address}?{urlencode(query)}" if query else address
    headers = {"Cache-Control": "no-store", "Set-Cookie": no_cookie(request.url.scheme)}
    return RedirectResponse(f"{joined}#{fragment}", 303, headers)


def _language(locale: str | None) -> str | None:
    """The page's language for a platform's locale; None leaves it to the browser."""
    code = (locale or "").replace("_", "-").partition("-")[0].lower()
    return code if code in languages() else None


def _storage_key(state: str) -> str:
    return f"state_{hashed(state)[:16]}"


def _cookie_name(state: str) -> str:
    return f"{COOKIE}{hashed(state)[:12]}"


def _cookie(state: str, value: str, life: int) -> str:
    """The field Set-Cookie: for this host alone, in a partition of the page that frames it."""
    attributes = f"Path=/; Max-Age={life}; Secure; HttpOnly; SameSite=None; Partitioned"
    return f"{_cookie_name(state)}={value}; {attributes}"
