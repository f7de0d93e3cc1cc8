"""Who calls, and how much: keys of programs, and limits that count what a call costs.

Nothing here is on until the operator sets it: without `FRAMEWISE_API_KEYS` every call is open, and without
`FRAMEWISE_COST_PER_MINUTE` none is counted. Each server process counts for itself.
"""

import math
from datetime import UTC, datetime

from starlette.types import ASGIApp, Message, Receive, Scope, Send

from kinematics.errors import Fault
from service.http.api_keys import PREFIX, ApiKey, KeyFile, KeyScope
from service.http.cost_window import CostWindow
from service.http.problem_answers import refuse
from service.http.problems import ForbiddenError, RateError, RequestPart, ServiceError, UnauthorizedError
from service.settings import Settings
from service.work.fair_queue import Name, Proven, current_client, proven

_COSTS = {
    "symbolic": 20,
    "dynamics": 20,
    "inverse-kinematics": 10,
    "workspace": 20,
    "scm": 10,
    "grade": 5,
    "evaluate": 5,
    "receipts": 5,
    "author": 20,
    "assign-frames": 2,
    "check-frames": 2,
    "check-inverse-kinematics": 10,
    "plant-mistake": 20,
    "plant-matrix-mistake": 20,
    "plant-frame-mistake": 20,
    "compare-tables": 5,
    "other-tables": 20,
    "check-screws": 10,
    "check-jacobian": 2,
    "check-jacobian-form": 20,
    "check-singularities": 40,
    "check-dynamics": 20,
    "rotations": 2,
    "check-rotation": 1,
}
"""What a call costs beside one of forward kinematics: the ratios of their times, rounded."""
_BODY_UNIT = 64 * 1024  # Bytes of a body that cost as much as a call of forward kinematics.
_ONE_ANSWER, _ANSWER_UNIT = 4 * 1024, 512
"""Bytes of a body with one answer and its key, and of each further answer (six rows take 400): many
submissions in one body cost about as much as each by itself."""
_SCOPES = {"grade": KeyScope.GRADE, "evaluate": KeyScope.GRADE, "receipts": KeyScope.GRADE}
_PUBLISH = "/author/publish"
_HANDING_IN = "/api/v1/session/attempts"
REFUSED = (401, 403, 429)  # Statuses of the refusals here; links refuse with the second, too.
EXCESS = "rate_exceeded"
"""Where the scope of a hand-in says that it costs too much: its refusal is the route's."""
_SAME_ORIGIN = b"same-origin"
_READING = ("GET", "HEAD", "OPTIONS")


class MeteringMiddleware:
    """Refuse callers without a valid key, and callers that ask for too much."""

    def __init__(self, app: ASGIApp, settings: Settings) -> None:
        self._app, self._settings = app, settings
        self._keys = KeyFile(settings.api_keys) if settings.api_keys else None
        self._window = CostWindow()
        self._heard = CostWindow()

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Serve one connection."""
        if scope["type"] != "http" or not is_api(path_of(scope)):
            await self._app(scope, receive, send)
            return
        told: list[tuple[bytes, bytes]] = []
        try:
            key = self._key(scope)
            scope["api_key"] = key
            if key is not None:
                proven(Proven("key", key.id))
            most = (key.cost_per_minute if key else None) or self._settings.cost_per_minute
            caller = current_client.get()[0]
            if most:
                told = self._charge(caller, _cost(scope, _said_size(scope) or 0), most)
        except ServiceError as error:
            if not (isinstance(error, RateError) and self._hears(scope, caller, most)):
                await refuse(error, scope, receive, send)
                return
            scope[EXCESS], most = error, 0
        size = 0

        async def receive_charged() -> Message:
            """Charge a body as it comes: it did not say how long it is."""
            nonlocal size, told
            message = await receive()
            before = _cost(scope, size)
            size += len(message.get("body", b""))
            if more := _cost(scope, size) - before:
                told = self._charge(caller, more, most)
            return message

        async def send_with_limits(message: Message) -> None:
            if message["type"] == "http.response.start":
                given = {name for name, _ in message.get("headers", ())}
                added = [field for field in told if field[0] not in given]
                message["headers"] = [*message.get("headers", ()), *added]
            await send(message)

        unsaid = most and scope["method"] == "POST" and _said_size(scope) is None
        await self._app(scope, receive_charged if unsaid else receive, send_with_limits if told else send)

    def _hears(self, scope: Scope, caller: Name, most: int) -> bool:
        """Return whether an answer that costs too much is read, so that its refusal can tell when it came.

        Who sends as many of them in a minute as the minute may cost hands in nothing: that is a flood.
        """
        size = _said_size(scope)
        is_answer = scope["method"] == "POST" and path_of(scope) == _HANDING_IN
        return (
            is_answer
            and size is not None
            and size <= _BODY_UNIT
            and self._heard.charge(caller, 1, most).allowed
        )

    def _key(self, scope: Scope) -> ApiKey | None:
        """Return the caller's key; None where none is needed.

        The pages of this service call without one: their browser says so in Sec-Fetch-Site. A program could
        say so, too; keys account for programs, they are no wall around what everybody may use in a page.
        """
        if self._keys is None or not self._keys.all():
            return None
        fields = dict(scope["headers"])
        given = fields.get(b"authorization", b"").decode("latin-1").rpartition(" ")[2]
        text = given if given.startswith(PREFIX) else fields.get(b"x-api-key", b"").decode("latin-1")
        if not text:
            if fields.get(b"sec-fetch-site") == _SAME_ORIGIN or scope["method"] in _READING:
                return None
            raise _unauthorized("api_key_missing")
        key = self._keys.find(text)
        if key is None or not key.is_valid(datetime.now(UTC)):
            raise _unauthorized("api_key_invalid")
        needed = _scope_of(path_of(scope), scope["method"])
        if needed not in key.scopes:
            params = {"needed": needed.value, "scopes": tuple(found.value for found in key.scopes)}
            fault = Fault.at("api_key_scope", "Authorization", **params)
            raise ForbiddenError(fault, part=RequestPart.HEADER)
        return key

    def _charge(self, caller: Name, cost: int, most: int) -> list[tuple[bytes, bytes]]:
        """Count what a call costs; return the headers that say what is left.

        Raises:
            RateError: it is more than is left.
        """
        charged = self._window.charge(caller, min(cost, most), most)
        wait = max(1, math.ceil(charged.wait))
        headers = {"ratelimit-limit": most, "ratelimit-remaining": charged.left, "ratelimit-reset": wait}
        if not charged.allowed:
            fault = Fault.at("rate_exceeded", limit=most, seconds=wait)
            told = {name: str(value) for name, value in headers.items()}
            raise RateError(fault, headers={**told, "Retry-After": str(wait)})
        return [(name.encode(), str(value).encode()) for name, value in headers.items()]


def path_of(scope: Scope) -> str:
    """Return a request's path below the prefix under which a proxy serves us."""
    path: str = scope["path"]
    return path.removeprefix(scope.get("root_path", ""))


def is_api(path: str) -> bool:
    """Return whether what is at a path may need a key, and costs something."""
    return path.startswith("/api/") or path in ("/evaluate", "/evaluate/lambda-feedback")


def _said_size(scope: Scope) -> int | None:
    """Return the length that a request says its body has; None if it says none."""
    length = dict(scope["headers"]).get(b"content-length", b"")
    return int(length) if length.isdigit() and len(length) < 16 else None


def _cost(scope: Scope, size: int) -> int:
    """Return what a request costs with so many bytes of body."""
    steps = path_of(scope).split("/")
    if scope["method"] != "POST":
        return 1
    cost = max((_COSTS.get(step, 1) for step in steps), default=1)
    if _SCOPES.keys() & set(steps):
        return cost * (1 + max(size - _ONE_ANSWER, 0) // _ANSWER_UNIT)
    return cost * (1 + size // _BODY_UNIT)


def _scope_of(path: str, method: str) -> KeyScope:
    if method in _READING:
        return KeyScope.READ
    if path.endswith(_PUBLISH):
        return KeyScope.PUBLISH
    return next((_SCOPES[step] for step in path.split("/") if step in _SCOPES), KeyScope.COMPUTE)


def _unauthorized(code: str) -> UnauthorizedError:
    fault = Fault.at(code, "Authorization")
    return UnauthorizedError(fault, part=RequestPart.HEADER, headers={"WWW-Authenticate": "Bearer"})
