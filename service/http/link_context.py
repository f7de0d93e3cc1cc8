"""The signed context of a link: what the students who come by it may use, whatever they call.

A link to an exercise (from a course, from a learning platform) carries a context: the exercise, what is
switched off, how much is told, which attempt it is. It is signed with the installation's secret
(HMAC-SHA-256), so nobody can change it, and it is obeyed by the API itself: a student with such a link gets
no table from the catalogue, no matrix and no repair from any call. It travels in the header
`X-Framewise-Context`, in the query parameter `context`, or in the cookie `framewise_context` that a page
with such a query sets.
"""

import base64
import hashlib
import hmac
import time
from collections.abc import Mapping
from dataclasses import dataclass
from http.cookies import CookieError, SimpleCookie
from typing import Any
from urllib.parse import parse_qs

import orjson

from exercises.access import Tool
from exercises.grading import HelpLevel
from kinematics.errors import Fault
from service.http.problems import ForbiddenError, RequestPart

HEADER = "X-Framewise-Context"
QUERY = "context"
COOKIE = "framewise_context"
LONGEST = 2000  # Characters of a context, which has to fit into a header and an address.
_VERSION = 1
_PURPOSE = b"framewise link context\0"
"""Keeps a signature of this kind from being taken for one of another kind made with the same secret."""


@dataclass(frozen=True, kw_only=True, slots=True)
class LinkContext:
    """What the students of a link may use.

    Attributes:
        exercise: id of the only exercise that they are shown.
        off: what is switched off, beside what the exercise itself switches off.
        help: the most that is told; None: as much as the exercise tells.
        attempt: number of the attempt, from 1; None: it is not counted.
        attempts: how many there are; None: as many as the exercise has.
        seed: the only seed that the exercise is shown with; None: any.
        expires: when the context ends [s since 1970-01-01 UTC]; None: never.
    """

    exercise: str
    off: frozenset[Tool] = frozenset()
    help: HelpLevel | None = None
    attempt: int | None = None
    attempts: int | None = None
    seed: str | None = None
    expires: int | None = None


def signed(context: LinkContext, secret: bytes) -> str:
    """Return a context as a token that `verified` takes, in letters, digits, `-`, `_` and one dot."""
    body = {
        "v": _VERSION,
        "exercise": context.exercise,
        "off": sorted(tool.value for tool in context.off),
        "help": context.help,
        "attempt": context.attempt,
        "attempts": context.attempts,
        "seed": context.seed,
        "expires": context.expires,
    }
    payload = _base64(orjson.dumps({name: value for name, value in body.items() if value is not None}))
    return f"{payload}.{_signature(payload, secret)}"


def verified(token: str, secret: bytes, now: float | None = None) -> LinkContext:
    """Return the context of a token.

    Args:
        token: as `signed` made it.
        secret: of the installation.
        now: the time [s since 1970-01-01 UTC]; left out: this moment.

    Raises:
        ForbiddenError: it was not signed here, has been changed, or has ended.
    """
    payload, _, signature = token.partition(".")
    genuine = token.isascii() and hmac.compare_digest(signature, _signature(payload, secret))
    if len(token) > LONGEST or not genuine:
        raise _refusal("context_invalid")
    body: Mapping[str, Any] = orjson.loads(base64.urlsafe_b64decode(payload + "=" * (-len(payload) % 4)))
    if body.get("v") != _VERSION:
        raise _refusal("context_invalid")
    context = LinkContext(
        exercise=body["exercise"],
        off=frozenset(Tool(name) for name in body["off"]),
        help=HelpLevel(body["help"]) if "help" in body else None,
        attempt=body.get("attempt"),
        attempts=body.get("attempts"),
        seed=body.get("seed"),
        expires=body.get("expires"),
    )
    if context.expires is not None and context.expires < (time.time() if now is None else now):
        raise _refusal("context_expired")
    return context


def token_of(fields: Mapping[bytes, bytes], query: bytes) -> str | None:
    """Return the token that a request names, in its header, or else in its query."""
    header = fields.get(HEADER.lower().encode())
    if header is not None:
        return header.decode("latin-1")
    if QUERY.encode() in query:
        found = parse_qs(query.decode("latin-1")).get(QUERY)
        if found:
            return found[-1]
    return None


def kept_token(fields: Mapping[bytes, bytes]) -> str | None:
    """Return the token that a browser has kept in its cookie."""
    cookie = fields.get(b"cookie", b"")
    if COOKIE.encode() not in cookie:
        return None
    try:
        morsel = SimpleCookie(cookie.decode("latin-1")).get(COOKIE)
    except CookieError:
        return None
    return morsel.value if morsel is not None and morsel.value else None


def _refusal(code: str) -> ForbiddenError:
    return ForbiddenError(Fault.at(code, HEADER), part=RequestPart.HEADER)


def _signature(payload: str, secret: bytes) -> str:
    return _base64(hmac.new(secret, _PURPOSE + payload.encode(), hashlib.sha256).digest())


def _base64(data: bytes) -> str:
    return base64.urlsafe_b64encode(data).rstrip(b"=").decode()
