"""Login initiation (Security Framework 1.1 §5.1.1): a platform's request, and the redirect back to it.

Anybody may begin a login, so nothing is stored of it: its state carries what the launch has to meet, sealed,
by way of the browser and the platform. The nonce is stored once a platform's signature has been verified.
"""

from collections.abc import Mapping
from dataclasses import dataclass
from datetime import datetime, timedelta
from urllib.parse import urlencode

from courses.model import Platform, PlatformStatus
from courses.people.secrets import hashed, sealed, unsealed
from courses.refusals import platform_inactive
from courses.storage.database import Store
from kinematics.errors import Fault
from service.lti.fetching import origin_of
from service.lti.launch_errors import LoginError

REQUIRED = ("iss", "login_hint", "target_link_uri")
KNOWN = (*REQUIRED, "lti_message_hint", "lti_deployment_id", "client_id", "lti_storage_target")
LONGEST = 4096  # Characters of a parameter; hints of platforms have a few hundred.
LOGIN = timedelta(minutes=10)  # Time between login and launch: a person may have to sign in to the platform.
LONGEST_ADDRESS = 2048
"""Characters of an address up to which its state repeats the request: what stands in it twice is long.

IIS takes queries of 2 KiB and Apache requests of 8 KiB; some platforms put a signed token into their hints.
"""
_PURPOSE = "logins"


@dataclass(frozen=True, kw_only=True, slots=True)
class LoginRequest:
    """What a platform asks at the beginning of a launch."""

    issuer: str
    login_hint: str
    target: str
    message_hint: str | None
    client_id: str | None
    storage_target: str | None
    parameters: Mapping[str, str]


@dataclass(frozen=True, kw_only=True, slots=True)
class Login:
    """What the launch of a login has to meet.

    Attributes:
        browser_hash: of the secret that only the browser of the login knows.
        target: where the platform wants to go.
        storage_target: the frame in which the platform stores that secret, if it does.
        again: the parameters of the login, to begin it again in a window of its own; none if the address
            would be long.
    """

    platform_id: int
    browser_hash: str
    target: str
    storage_target: str | None
    again: Mapping[str, str]


def check_active(platform: Platform) -> None:
    """Make sure that a platform may launch.

    Raises:
        LoginError: it was not activated, or was switched off.
    """
    if platform.status is not PlatformStatus.ACTIVE:
        raise LoginError(platform_inactive(platform.issuer))


def redirection(
    store: Store, platform: Platform, request: LoginRequest, browser: str, redirect_uri: str, now: datetime
) -> tuple[str, str]:
    """Return the state of a login, and the address where the browser goes with it."""
    state = address = ""
    for again in (request.parameters, {}):
        state = state_of(store, platform.id, request, browser, now, again)
        address = authorization_address(request, platform, redirect_uri=redirect_uri, state=state)
        if len(address) <= LONGEST_ADDRESS:
            break
    return state, address


def state_of(
    store: Store,
    platform_id: int,
    request: LoginRequest,
    browser: str,
    now: datetime,
    again: Mapping[str, str],
) -> str:
    """Return a state that carries a login: sealed, and good for `LOGIN`."""
    content = {
        "platform_id": platform_id,
        "browser_hash": hashed(browser),
        "target": request.target,
        "storage_target": request.storage_target,
        "again": dict(again),
        "expires": (now + LOGIN).timestamp(),
    }
    return sealed(store, _PURPOSE, content)


def login_of(store: Store, state: str, now: datetime) -> Login | None:
    """Return the login that a state carries; None if it is too old, or was never given out."""
    content = unsealed(store, _PURPOSE, state)
    if content is None or content.pop("expires") <= now.timestamp():
        return None
    return Login(**content)


def nonce_of(state: str) -> str:
    """Return the nonce of a login, which nobody can guess before its state is known."""
    return hashed(state)


def read_login(parameters: Mapping[str, str], own_origin: str) -> LoginRequest:
    """Return the request in a query or form; parameters that the specification does not know are left out.

    Raises:
        LoginError: one is missing or too long, or the target is on another origin.
    """
    given = {name: value for name, value in parameters.items() if name in KNOWN and value}
    missing = [name for name in REQUIRED if name not in given]
    if wrong := missing or [name for name, value in given.items() if len(value) > LONGEST]:
        raise LoginError(Fault.at("lti_parameter_missing", name=wrong[0]))
    try:
        same = origin_of(given["target_link_uri"]) == own_origin
    except ValueError:
        same = False
    if not same:
        raise LoginError(Fault.at("lti_target_foreign"))
    return LoginRequest(
        issuer=given["iss"],
        login_hint=given["login_hint"],
        target=given["target_link_uri"],
        message_hint=given.get("lti_message_hint"),
        client_id=given.get("client_id"),
        storage_target=given.get("lti_storage_target"),
        parameters=given,
    )


def authorization_address(request: LoginRequest, platform: Platform, *, redirect_uri: str, state: str) -> str:
    """Return where the browser goes next.

    It is the platform's authorization endpoint, with the parameters of §5.1.1.2.
    """
    parameters = {
        "scope": "openid",
        "response_type": "id_token",
        "response_mode": "form_post",
        "prompt": "none",
        "client_id": platform.client_id,
        "redirect_uri": redirect_uri,
        "login_hint": request.login_hint,
        "state": state,
        "nonce": nonce_of(state),
    }
    if request.message_hint is not None:
        parameters["lti_message_hint"] = request.message_hint
    joint = "&" if "?" in platform.authorization_endpoint else "?"
    return f"{platform.authorization_endpoint}{joint}{urlencode(parameters)}"
