"""Routes that read their requests strictly, before FastAPI validates them."""

import asyncio
import warnings
from collections.abc import AsyncGenerator, Awaitable, Callable, Coroutine, Sequence
from enum import Enum
from functools import cached_property, partial
from typing import TYPE_CHECKING, Any, ClassVar, TypeVar

from fastapi import APIRouter, Response
from fastapi.routing import APIRoute
from pydantic.warnings import UnsupportedFieldAttributeWarning
from starlette.requests import ClientDisconnect, Request
from starlette.types import Receive, Scope, Send

from kinematics.errors import Fault
from service.http.decoding import JsonLimits, decode_json
from service.http.negotiation import preferred_media_type
from service.http.problems import (
    BodySizeError,
    BodyTimeoutError,
    MediaTypeError,
    NotAcceptableError,
    RequestPart,
)
from service.settings import Settings
from service.work.collection import with_large_lists

if TYPE_CHECKING:
    from service.resources import Resources

# FastAPI, which gives a body this name, silences the same while it declares a route; models are built later.
warnings.filterwarnings("ignore", "The 'alias' attribute with value 'body'", UnsupportedFieldAttributeWarning)

API_PREFIX = "/api/v1"
JSON = "application/json"
NPY = "application/x-npy"
LARGE_BODY = 256 * 1024
"""A body of this size [byte] is read in a thread, so that others are served meanwhile."""

SMALL_BODY = 3 * 1024
"""Length of a body [byte] whose table is read and computed with in a few milliseconds, whatever it holds: the
event loop does that itself. A question about an arm of six joints has half of it."""
SLOWEST_UPLOAD = 16 * 1024
"""Bytes a second that a caller must send on average, after the time that every body has."""
VALUES_A_CONFIGURATION = 16
"""Joint values for which a batch has room; arms of more joints come in smaller batches."""
QUOTES_BESIDE_A_BATCH = 64_000
"""Quotation marks of a robot and its parameters: the longest table has a tenth as many."""

_Result = TypeVar("_Result")
_JSON = JSON.encode()
_NPY = NPY.encode()
_ANYTHING = b"*/*"
_UTF8 = ("", "utf-8", "utf8", "us-ascii", "ascii")


ONE_ROBOT = JsonLimits(objects=2_000, lists=4_000, values=20_000, colons=8_000)
"""Several times what rows, parameters and limits of one robot hold, each list as long as it may be; colons of
addresses in a URDF file count, too."""


class ApiRequest(Request):
    """A request whose body is bounded and whose JSON is read strictly."""

    body_limit: int = 0
    json_limits = JsonLimits()

    @cached_property
    def resources(self) -> "Resources":
        """The resources of the application that serves this request."""
        resources: Resources = self.scope["app"].state.resources
        return resources

    @property
    def settings(self) -> Settings:
        """The settings of the application that serves this request."""
        return self.resources.settings

    def expect_batch(self) -> None:
        """Allow a body that holds a batch of joint values."""
        count = self.settings.batch_limit
        self.body_limit = self.settings.batch_body_limit
        self.json_limits = JsonLimits(
            objects=ONE_ROBOT.objects,
            lists=ONE_ROBOT.lists + count,
            values=JsonLimits.values + VALUES_A_CONFIGURATION * count,
            quotes=QUOTES_BESIDE_A_BATCH,
            long=frozenset({"joints"}),
        )

    async def in_thread(self, work: Callable[[], _Result]) -> _Result:
        """Do work in a thread: one request at a time, and clients in turn."""
        if len(await self.body()) >= LARGE_BODY:
            work = partial(with_large_lists, work)
        return await self.resources.reading.run(work)

    async def in_turn(self, work: Callable[[], _Result], *, heavy: bool = False) -> _Result:
        """Do the work that follows from the body: that of a small one at once, of any other in a thread.

        Args:
            heavy: whether it may take long although the body is small.
        """
        small = len(await self.body()) <= SMALL_BODY and not heavy
        return work() if small else await self.in_thread(work)

    @cached_property
    def fields(self) -> dict[bytes, bytes]:
        """The header fields by their names in lower case; of a repeated one, the last."""
        return dict(self.scope["headers"])

    async def body(self) -> bytes:
        """Return the whole body; what is done with it waits for the client's turn.

        Raises:
            BodySizeError: it is, or says that it is, longer than this route's limit.
            BodyTimeoutError: it comes too slowly.
            BusyError: as much is being received as may be.
        """
        if not hasattr(self, "_body"):
            self._body = await self._bounded(self.body_limit or self.settings.body_limit)
            await self.resources.turns.turn()
        return self._body

    async def stream(self) -> AsyncGenerator[bytes, None]:
        """Yield the body in one piece, bounded like `body`."""
        yield await self.body()

    async def _bounded(self, limit: int) -> bytes:
        announced = self.fields.get(b"content-length", b"")
        if len(announced) > len(str(limit)) or (announced.isdigit() and int(announced) > limit):
            raise _too_large(limit)
        loop = asyncio.get_running_loop()
        timeout = self.settings.read_seconds
        start = loop.time()
        pieces: list[bytes] = []
        received = 0
        more = True
        while more:
            try:
                async with asyncio.timeout_at(start + timeout + received / SLOWEST_UPLOAD):
                    message = await self._receive()
            except TimeoutError:
                raise BodyTimeoutError(Fault.at("body_timed_out", seconds=timeout)) from None
            if message["type"] == "http.disconnect":
                raise ClientDisconnect
            piece = message.get("body", b"")
            received += len(piece)
            if received > limit:
                raise _too_large(limit)
            if received >= LARGE_BODY:
                self.resources.uploads.hold(self.scope, received)
            pieces.append(piece)
            more = message.get("more_body", False)
        self.body_seconds = loop.time() - start
        return pieces[0] if len(pieces) == 1 else b"".join(pieces)

    @property
    def brings_npy(self) -> bool:
        """Whether the body says that it is an npy file."""
        return self.fields.get(b"content-type", b"").partition(b";")[0].strip().lower() == _NPY

    def media_type(self) -> str:
        """Return the media type of the body, without parameters.

        Raises:
            MediaTypeError: the body is compressed, or in a character set other than UTF-8.
        """
        if self.headers.get("content-encoding", "identity") != "identity":
            raise MediaTypeError(
                Fault.at("content_encoding_unsupported", "Content-Encoding"),
                part=RequestPart.HEADER,
                headers={"Accept-Encoding": "identity"},
            )
        media_type, _, parameters = self.headers.get("content-type", "").partition(";")
        for parameter in parameters.split(";"):
            name, _, value = parameter.partition("=")
            if name.strip().lower() == "charset" and value.strip(' "').lower() not in _UTF8:
                raise MediaTypeError(
                    Fault.at("charset_unsupported", "Content-Type", charset=value.strip(' "')),
                    part=RequestPart.HEADER,
                )
        return media_type.strip().lower()

    async def json(self, *others: str) -> Any:
        """Return the body's value, from a body that says it is JSON.

        Args:
            others: further media types that the call reads, for the refusal to name.

        Raises:
            MediaTypeError: the body does not say that it is JSON.
            BodyError: it is not JSON.
        """
        if not hasattr(self, "_json"):
            if self.fields.get(b"content-type") != _JSON or b"content-encoding" in self.fields:
                self._require_json(others)
            body = await self.body()
            decode = partial(decode_json, body, self.json_limits)
            self._json = decode() if len(body) < LARGE_BODY else await self.in_thread(decode)
        return self._json

    def accepts(self, *offers: str) -> str:
        """Return the offered media type that the caller prefers.

        Raises:
            NotAcceptableError: the caller accepts none of them.
        """
        if self.fields.get(b"accept", _ANYTHING) == _ANYTHING:
            return offers[0]
        chosen = preferred_media_type(", ".join(self.headers.getlist("accept")), offers)
        if chosen is None:
            raise NotAcceptableError(
                Fault.at("not_acceptable", "Accept", offers=offers), part=RequestPart.HEADER
            )
        return chosen

    def _require_json(self, others: Sequence[str]) -> None:
        media_type = self.media_type()
        is_json = media_type == JSON or (
            media_type.startswith("application/") and media_type.endswith("+json")
        )
        if not is_json:
            raise unsupported_media_type(media_type, JSON, *others)


class BytesResponse(Response):
    """A response of known bytes, made with no more work than that."""

    def __init__(self, body: bytes, media_type: str = JSON) -> None:
        self.status_code = 200
        self.body = body
        self.background = None
        self.raw_headers = [
            (b"content-length", b"%d" % len(body)),
            (b"content-type", media_type.encode("latin-1")),
        ]


class ApiRoute(APIRoute):
    """A route of the API: strict JSON in, JSON out.

    Attributes:
        json_limits: how much a body may hold, whatever it means.
    """

    json_limits: ClassVar[JsonLimits] = JsonLimits()

    def get_route_handler(self) -> Callable[[Request], Coroutine[Any, Any, Response]]:
        """Return the handler that FastAPI made, given a request whose body has been read strictly."""
        inner = super().get_route_handler()
        has_body = self.body_field is not None

        async def handler(request: Request) -> Response:
            strict = ApiRequest(request.scope, request.receive, request._send)
            strict.json_limits = self.json_limits
            if has_body:
                await strict.json()
            return await inner(strict)

        return handler


class OneRobotRoute(ApiRoute):
    """A route of a call about one robot: no more is read than can be said of one."""

    json_limits = ONE_ROBOT


class DirectRoute(ApiRoute):
    """A route whose endpoint takes an `ApiRequest` and gives a `Response`, with nothing in between.

    For the calls whose own work takes microseconds. What OpenAPI says of them is declared beside the endpoint
    (`service.http.openapi.request_body` and `response_model`).
    """

    def __init__(self, path: str, endpoint: Callable[..., Awaitable[Response]], **options: Any) -> None:
        super().__init__(path, endpoint, **options)

        async def direct(scope: Scope, receive: Receive, send: Send) -> None:
            response = await endpoint(ApiRequest(scope, receive, send))
            await response(scope, receive, send)

        self.app = direct


def api_router(*tags: str | Enum, route_class: type[ApiRoute] = ApiRoute) -> APIRouter:
    """Return a router under /api/v1 whose routes read their requests strictly."""
    return APIRouter(prefix=API_PREFIX, tags=list(tags), route_class=route_class)


def unsupported_media_type(media_type: str, *offers: str) -> MediaTypeError:
    """Return the refusal of a body in a media type that a call does not read."""
    return MediaTypeError(
        Fault.at("media_type_unsupported", "Content-Type", given=media_type or "none", offers=offers),
        part=RequestPart.HEADER,
        headers={"Accept-Post": ", ".join(offers)},
    )


def _too_large(limit: int) -> BodySizeError:
    return BodySizeError(Fault.at("body_too_large", limit=limit))
