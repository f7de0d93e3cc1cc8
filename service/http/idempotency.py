"""Idempotency keys: a POST that is sent again with its `Idempotency-Key` gets the answer it got.

The header is that of draft-ietf-httpapi-idempotency-key-header. Calls are pure functions but for receipts and
callbacks, so the answers are kept in memory, by each server process; attempts of courses keep their keys with
them in the storage.
"""

import hashlib
import time
from collections import OrderedDict
from dataclasses import dataclass, field
from typing import TypeAlias

from starlette.types import ASGIApp, Message, Receive, Scope, Send

from kinematics.errors import Fault
from service.http.link_context import HEADER as LINK_HEADER
from service.http.metering import path_of
from service.http.problem_answers import refuse
from service.http.problems import BodyError, ConflictError, RequestError, RequestPart, ServiceError

REPLAYED = "Idempotency-Replayed"  # Header of an answer that was given before.
LONGEST_KEY = 255  # Characters of a key; a UUID has 36.
LARGEST_ANSWER = 4 * 1024 * 1024  # Bytes of an answer that is kept: the verdicts of a class of a few hundred.
MOST_BYTES = 64 * 1024 * 1024  # Bytes that all kept answers take together; the oldest go first.
LONGEST_LIFE = 24 * 60 * 60
"""Seconds for which an answer is kept: a job that failed at night is begun again in the morning."""
_CALLER = (b"authorization", b"x-api-key", b"cookie", LINK_HEADER.lower().encode())
_FORM = (b"accept", b"accept-language", b"content-type")
_OVERHEAD = 1024  # Bytes that an answer is counted for beside its body: headers, digests, its place.
_DURABLE = "/api/v1/session/"  # Attempts of a course: their keys are stored with them, by the routes.
_NOT_STORED = (408, 409, 429)  # Refusals that say "not now", as every 5xx does: the next try may succeed.

_Slot: TypeAlias = bytes


@dataclass(slots=True)
class _GivenAnswer:
    """An answer, while it is given and after."""

    begun: float = field(default_factory=time.monotonic)
    asked: bytes = b""
    start: Message | None = None
    pieces: list[bytes] = field(default_factory=list)
    size: int = 0


class IdempotencyMiddleware:
    """Replay the stored response to a repeated Idempotency-Key."""

    def __init__(self, app: ASGIApp) -> None:
        self._app = app
        self._answers: OrderedDict[_Slot, _GivenAnswer] = OrderedDict()
        self._bytes = 0

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Serve one connection."""
        fields = dict(scope["headers"]) if scope["type"] == "http" and scope["method"] == "POST" else {}
        key = fields.get(b"idempotency-key")
        if key is None or path_of(scope).startswith(_DURABLE):
            await self._app(scope, receive, send)
            return
        try:
            if not 0 < len(key) <= LONGEST_KEY:
                raise BodyError(
                    Fault.at("idempotency_key_length", *_WHERE, limit=LONGEST_KEY), part=RequestPart.HEADER
                )
            slot = _slot(scope, fields, key)
            answer = self._known(slot)
            if answer is None:
                await self._answer(slot, scope, receive, send)
            elif not answer.asked:
                raise _conflict()
            elif await _digest(receive) != answer.asked:
                raise RequestError(Fault.at("idempotency_key_reused", *_WHERE), part=RequestPart.HEADER)
            else:
                await _replay(answer, send)
        except ServiceError as error:
            await refuse(error, scope, receive, send)

    def _known(self, slot: _Slot) -> _GivenAnswer | None:
        oldest = time.monotonic() - LONGEST_LIFE
        while self._answers and next(iter(self._answers.values())).begun < oldest:
            self._forget(next(iter(self._answers)))
        return self._answers.get(slot)

    async def _answer(self, slot: _Slot, scope: Scope, receive: Receive, send: Send) -> None:
        """Have a request answered, and keep the answer if it is final and came to its end."""
        answer = self._answers[slot] = _GivenAnswer()
        digest = hashlib.sha256()
        read = False

        async def read_on() -> Message:
            nonlocal read
            message = await receive()
            digest.update(message.get("body", b""))
            read |= message["type"] == "http.request" and not message.get("more_body", False)
            return message

        async def send_on(message: Message) -> None:
            if message["type"] == "http.response.start":
                answer.start = {**message, "headers": list(message.get("headers", ()))}
            else:
                answer.size += len(message.get("body", b""))
                if answer.size <= LARGEST_ANSWER:
                    answer.pieces.append(message.get("body", b""))
                final = answer.start is not None and _is_final(answer.start["status"])
                if read and final and not message.get("more_body", False):
                    self._keep(slot, answer, digest.digest())
            await send(message)

        try:
            await self._app(scope, read_on, send_on)
        finally:
            if not answer.asked:
                self._answers.pop(slot, None)

    def _keep(self, slot: _Slot, answer: _GivenAnswer, asked: bytes) -> None:
        """Keep a whole answer, before its caller has the end of it and may ask again."""
        if answer.size > LARGEST_ANSWER:
            return
        answer.asked = asked
        self._answers[slot] = answer
        self._bytes += answer.size + _OVERHEAD
        while self._bytes > MOST_BYTES:
            self._forget(next(iter(self._answers)))

    def _forget(self, slot: _Slot) -> None:
        answer = self._answers.pop(slot)
        self._bytes -= answer.size + _OVERHEAD if answer.asked else 0


_WHERE = ("Idempotency-Key",)


def _slot(scope: Scope, fields: dict[bytes, bytes], key: bytes) -> _Slot:
    """Return what makes a request the same: who asks, where, in which form, by which key."""
    client = (scope.get("client") or ("",))[0]
    named = tuple(fields.get(name, b"") for name in (*_CALLER, *_FORM))
    return hashlib.sha256(repr((client, scope["path"], scope["query_string"], named, key)).encode()).digest()


def _is_final(status: int) -> bool:
    return status < 500 and status not in _NOT_STORED


def _conflict() -> ConflictError:
    fault = Fault.at("idempotency_key_in_use", *_WHERE)
    return ConflictError(fault, part=RequestPart.HEADER, headers={"Retry-After": "1"})


async def _digest(receive: Receive) -> bytes:
    """Read a body to its end, keeping nothing of it."""
    digest = hashlib.sha256()
    while True:
        message = await receive()
        digest.update(message.get("body", b""))
        if message["type"] != "http.request" or not message.get("more_body", False):
            return digest.digest()


async def _replay(answer: _GivenAnswer, send: Send) -> None:
    assert answer.start is not None
    headers = [*answer.start["headers"], (REPLAYED.lower().encode(), b"true")]
    await send({**answer.start, "headers": headers})
    await send({"type": "http.response.body", "body": b"".join(answer.pieces)})
