"""A launch message: believed or refused, check by check (Security Framework 1.1 §5.1.3, LTI 1.3)."""

import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from datetime import UTC, datetime, timedelta
from typing import Any

from joserfc import jws, jwt
from joserfc.errors import JoseError

from courses.model import Platform
from kinematics.errors import Fault
from service.lti import claims as names
from service.lti.launch_errors import LaunchError, missing_claim, wrong_claim
from service.lti.platform_keys import PlatformKeys
from service.lti.signing_keys import ALGORITHM

LEEWAY = timedelta(seconds=60)  # How far the clocks of a platform and of this service may differ.
OLDEST = timedelta(minutes=10)  # A token issued earlier is refused, whatever end it states.
NONCE_LIFE = timedelta(minutes=90)  # A nonce is remembered longer than any token may live.
LONGEST_TOKEN = 64 * 1024  # Characters of an ID token, which also has to pass through a browser's form.
LONGEST_ID = 255  # Characters of a subject and of a deployment id (LTI 1.3 Core).
_MESSAGES = (names.RESOURCE_LINK_REQUEST, names.DEEP_LINKING_REQUEST)


@dataclass(frozen=True, kw_only=True, slots=True)
class Launch:
    """A launch message that was believed.

    Attributes:
        subject: who comes; None for an anonymous launch.
        deep_linking: the settings of a deep linking request; None of a resource link.
    """

    subject: str | None
    name: str | None
    is_staff: bool
    is_test_user: bool
    deployment: str
    context: str
    context_title: str
    resource: str
    resource_title: str
    target: str
    custom: Mapping[str, str] = field(default_factory=dict)
    line_item: str | None = None
    line_items: str | None = None
    memberships_url: str | None = None
    deep_linking: Mapping[str, Any] | None = None
    locale: str | None = None
    return_url: str | None = None


@dataclass(frozen=True, kw_only=True, slots=True)
class Expected:
    """What a launch has to meet.

    Attributes:
        platform: to whom the login went.
        nonce: the one of the login.
        target: where the login wanted to go.
        use_nonce: remembers a nonce from a time on for some time; says False if it was used before.
        knows_deployment: whether a deployment may launch.
    """

    platform: Platform
    nonce: str
    target: str
    use_nonce: Callable[[str, datetime, timedelta], bool]
    knows_deployment: Callable[[str], bool]


def read_launch(token: str, expected: Expected, keys: PlatformKeys, now: datetime) -> Launch:
    """Return the launch that a token holds.

    Raises:
        LaunchError: it is not believed.
        PlatformError: the platform's keys cannot be fetched.
    """
    claims = _verified(token, expected.platform, keys)
    _check_parties(claims, expected.platform)
    _check_times(claims, now)
    _check_nonce(claims, expected, now)
    subject = claims.get("sub")
    if subject is not None and (not isinstance(subject, str) or not 0 < len(subject) <= LONGEST_ID):
        raise wrong_claim("sub")
    return _message(claims, subject, expected)


def _verified(token: str, platform: Platform, keys: PlatformKeys) -> Mapping[str, Any]:
    """The claims of a token whose signature is the platform's. Its header chooses a key, and nothing else."""
    if len(token) > LONGEST_TOKEN:
        raise LaunchError(Fault.at("lti_token_malformed"))
    try:
        header = jws.extract_compact(token.encode()).headers()
    except (JoseError, ValueError, TypeError, RecursionError):
        raise LaunchError(Fault.at("lti_token_malformed")) from None
    algorithm, kid = header.get("alg"), header.get("kid")
    if algorithm != ALGORITHM:
        raise LaunchError(Fault.at("lti_token_algorithm", algorithm=str(algorithm)[:20]))
    if not isinstance(kid, str) or not kid:
        raise LaunchError(Fault.at("lti_token_key"))
    key = keys.key(platform, kid)
    try:
        claims = jwt.decode(token, key, [ALGORITHM]).claims
    except (JoseError, ValueError, TypeError, RecursionError):
        raise LaunchError(Fault.at("lti_token_signature")) from None
    try:
        _check_identifiers(claims)
        told: Mapping[str, Any] = _well_formed(claims)
    except RecursionError:
        raise LaunchError(Fault.at("lti_token_malformed")) from None
    return told


def _check_identifiers(claims: Mapping[str, Any]) -> None:
    """Refuse what tells users, courses and links apart where it is no text that can be written down."""
    named = {
        "sub": claims.get("sub"),
        "deployment_id": claims.get(f"{names.LTI}deployment_id"),
        "context": _object(claims, "context").get("id"),
        "resource_link": _object(claims, "resource_link").get("id"),
    }
    for name, value in named.items():
        if value != _well_formed(value):
            raise wrong_claim(name)


def _well_formed(value: Any) -> Any:
    """Return JSON with U+FFFD for each half of a pair that stands alone, as in a title that was cut off."""
    if isinstance(value, str):
        return value.encode("utf-16", "surrogatepass").decode("utf-16", "replace")
    if isinstance(value, Mapping):
        return {_well_formed(key): _well_formed(each) for key, each in value.items()}
    return [_well_formed(each) for each in value] if isinstance(value, list) else value


def _check_parties(claims: Mapping[str, Any], platform: Platform) -> None:
    if claims.get("iss") != platform.issuer:
        raise wrong_claim("iss")
    audience = claims.get("aud")
    audiences = audience if isinstance(audience, list) else [audience]
    if platform.client_id not in audiences:
        raise wrong_claim("aud")
    party = claims.get("azp")
    if len(audiences) > 1 and party is None:
        raise missing_claim("azp")
    if party is not None and party != platform.client_id:
        raise wrong_claim("azp")


def _check_times(claims: Mapping[str, Any], now: datetime) -> None:
    expires, issued = _instant(claims, "exp"), _instant(claims, "iat")
    if expires <= now - LEEWAY:
        raise LaunchError(Fault.at("lti_token_expired"))
    if issued > now + LEEWAY or issued < now - OLDEST:
        raise LaunchError(Fault.at("lti_token_early"))


def _instant(claims: Mapping[str, Any], name: str) -> datetime:
    value = claims.get(name)
    if type(value) not in (int, float) or not math.isfinite(value):  # type: ignore[arg-type]
        raise missing_claim(name)
    try:
        return datetime.fromtimestamp(float(value), UTC)  # type: ignore[arg-type]
    except (OverflowError, OSError, ValueError):
        raise wrong_claim(name) from None


def _check_nonce(claims: Mapping[str, Any], expected: Expected, now: datetime) -> None:
    nonce = claims.get("nonce")
    if not isinstance(nonce, str) or nonce != expected.nonce:
        raise wrong_claim("nonce")
    if not expected.use_nonce(nonce, now, NONCE_LIFE):
        raise LaunchError(Fault.at("lti_nonce_used"))


def _message(claims: Mapping[str, Any], subject: str | None, expected: Expected) -> Launch:
    if claims.get(f"{names.LTI}version") != "1.3.0":
        raise wrong_claim("version")
    message_type = claims.get(f"{names.LTI}message_type")
    if message_type not in _MESSAGES:
        raise wrong_claim("message_type")
    deployment = claims.get(f"{names.LTI}deployment_id")
    if not isinstance(deployment, str) or not 0 < len(deployment) <= LONGEST_ID:
        raise missing_claim("deployment_id")
    if not expected.knows_deployment(deployment):
        raise LaunchError(Fault.at("lti_deployment_unknown", deployment=deployment))
    target = claims.get(f"{names.LTI}target_link_uri")
    if message_type == names.RESOURCE_LINK_REQUEST and target != expected.target:
        raise wrong_claim("target_link_uri")
    roles = claims.get(f"{names.LTI}roles")
    if not isinstance(roles, list):
        raise missing_claim("roles")
    if subject is None and message_type == names.DEEP_LINKING_REQUEST:
        raise missing_claim("sub")
    context, resource = _object(claims, "context"), _object(claims, "resource_link")
    if message_type == names.RESOURCE_LINK_REQUEST and not _text(resource, "id"):
        raise missing_claim("resource_link")
    return Launch(
        subject=subject,
        name=_text(claims, "name"),
        is_staff=names.is_staff(str(role) for role in roles),
        is_test_user=names.is_test_user(roles),
        deployment=deployment,
        context=_text(context, "id") or "",
        context_title=_text(context, "title") or _text(context, "label") or "",
        resource=_text(resource, "id") or "",
        resource_title=_text(resource, "title") or "",
        target=str(target or expected.target),
        custom={str(key): str(value) for key, value in _object(claims, "custom").items()},
        deep_linking=_deep_linking(claims, str(message_type)),
        **_services(claims, subject),
        **_presentation(claims),
    )


def _services(claims: Mapping[str, Any], subject: str | None) -> dict[str, Any]:
    """Grade and membership services; there are no scores of nobody."""
    grades = claims.get(names.ENDPOINT)
    members = claims.get(names.NAMES_AND_ROLES)
    found: dict[str, Any] = {}
    if isinstance(grades, Mapping) and subject is not None:
        found["line_item"] = _text(grades, "lineitem")
        found["line_items"] = _text(grades, "lineitems")
    if isinstance(members, Mapping):
        found["memberships_url"] = _text(members, "context_memberships_url")
    return found


def _presentation(claims: Mapping[str, Any]) -> dict[str, Any]:
    shown = _object(claims, "launch_presentation")
    address = _text(shown, "return_url")
    if address and not address.startswith(("https://", "http://")):
        address = None
    return {"locale": _text(shown, "locale"), "return_url": address}


def _deep_linking(claims: Mapping[str, Any], message_type: str) -> Mapping[str, Any] | None:
    if message_type != names.DEEP_LINKING_REQUEST:
        return None
    settings = claims.get(f"{names.DEEP_LINKING}deep_linking_settings")
    if not isinstance(settings, Mapping):
        raise missing_claim("deep_linking_settings")
    address = _text(settings, "deep_link_return_url") or ""
    if not address.startswith(("https://", "http://")):
        raise missing_claim("deep_link_return_url")
    return dict(settings)


def _object(claims: Mapping[str, Any], name: str) -> Mapping[str, Any]:
    found = claims.get(f"{names.LTI}{name}")
    return found if isinstance(found, Mapping) else {}


def _text(values: Mapping[str, Any], name: str) -> str | None:
    found = values.get(name)
    return found[:2000] if isinstance(found, str) and found else None
