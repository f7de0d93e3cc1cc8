"""Login initiation (Security Framework 1.1 §5.1.1): a platform's request, and the redirect back to it."""

from __future__ import annotations

import secrets
from collections.abc import Mapping
from dataclasses import dataclass
from urllib.parse import urlencode

from kinematics.errors import Fault
from service.lti.fetching import origin_of
from service.lti.launch_errors import LoginError
from service.lti.platform_keys import LtiPlatform

REQUIRED = ("iss", "login_hint", "target_link_uri")
KNOWN = (*REQUIRED, "lti_message_hint", "lti_deployment_id", "client_id", "lti_storage_target")
LONGEST = 4096
"""Characters of a parameter; hints of platforms have a few hundred."""


@dataclass(frozen=True, kw_only=True, slots=True)
class LoginRequest:
    """What a platform asks at the beginning of a launch."""

    issuer: str
    login_hint: str
    target: str
    message_hint: str | None
    deployment: str | None
    client_id: str | None
    storage_target: str | None
    parameters: Mapping[str, str]


def read_login(parameters: Mapping[str, str], own_origin: str) -> LoginRequest:
    """Return the request in a query or form; parameters that the specification does not know are left out.

    Raises:
        LoginError: one is missing or too long, or the target is on another origin.
    """
    given = {name: value for name, value in parameters.items() if name in KNOWN and value}
    for name in REQUIRED:
        if name not in given:
            raise LoginError(Fault.at("lti_parameter_missing", name=name))
    for name, value in given.items():
        if len(value) > LONGEST:
            raise LoginError(Fault.at("lti_parameter_missing", name=name))
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
        deployment=given.get("lti_deployment_id"),
        client_id=given.get("client_id"),
        storage_target=given.get("lti_storage_target"),
        parameters=given,
    )


def new_secret() -> str:
    """Return 256 random bits: a state, a nonce, or what only one browser knows."""
    return secrets.token_urlsafe(32)


def authorization_address(
    request: LoginRequest, platform: LtiPlatform, *, redirect_uri: str, state: str, nonce: str
) -> str:
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
        "nonce": nonce,
    }
    if request.message_hint is not None:
        parameters["lti_message_hint"] = request.message_hint
    joint = "&" if "?" in platform.authorization_endpoint else "?"
    return f"{platform.authorization_endpoint}{joint}{urlencode(parameters)}"
