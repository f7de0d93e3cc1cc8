"""The outermost layer: proxies, request ids, security headers, HEAD, the access log, and no unhandled error.

Pure ASGI and thin, because every request passes through it.
"""

import asyncio
import itertools
import logging
import re
import secrets
import time
from collections.abc import Callable, Mapping
from typing import Any

from starlette.requests import ClientDisconnect
from starlette.routing import BaseRoute, Match
from starlette.types import ASGIApp, Message, Receive, Scope, Send
from uvicorn.middleware.proxy_headers import ProxyHeadersMiddleware

from kinematics.errors import Fault
from service.http.addresses import caller_at
from service.http.compression import accepts_gzip, compressing
from service.http.problem_answers import REQUEST_ID, refuse
from service.http.problems import ServiceError, busy
from service.http.shortages import shortage
from service.http.uploads import HELD, Upload, may_be_under_way
from service.logs import log_access
from service.metrics import UNMATCHED
from service.setting_types import PREFIX
from service.settings import Settings
from service.work.fair_queue import current_client, proven

ROUTE = "route_template"
"""Where a scope says, once the request is over, which route served it: a template without names."""
PEER = "peer"
"""Where a request's scope says which address the connection comes from: the client's, or a proxy's."""
_SANE_REQUEST_ID = re.compile(rb"[A-Za-z0-9._:-]{1,64}")
_REQUEST_ID = b"x-request-id"
_POLICY = b"content-security-policy"
_REFUSED = 400
_HEADERS = ((b"x-content-type-options", b"nosniff"), (b"referrer-policy", b"same-origin"))

_log = logging.getLogger("framewise")


class OuterMiddleware:
    """Wraps the application."""

    def __init__(self, app: ASGIApp, settings: Settings) -> None:
        self._app, self._settings = app, settings
        self._next_id = _request_ids()
        self._behind_proxies = ProxyHeadersMiddleware(self._serve, list(settings.trusted_proxies))
        ancestors = " ".join(settings.frame_ancestors)
        self._policy = (_POLICY, f"default-src 'none'; frame-ancestors {ancestors}".encode("latin-1"))

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Serve one connection: note who asks, before a trusted proxy tells for whom."""
        if scope["type"] != "http":
            await self._app(scope, receive, send)
            return
        scope[PEER] = scope["client"][0] if scope.get("client") else ""
        await self._behind_proxies(scope, receive, send)  # type: ignore[arg-type]

    async def _serve(self, scope: Any, receive: Any, send: Any) -> None:
        begun = time.perf_counter()
        fields = dict(scope["headers"])
        host, port = scope.get("client") or ("", 0)
        current_client.set((caller_at(host), port))
        self._name_person(scope, fields.get(b"authorization"))
        request_id = self._open(scope, fields)
        original = scope
        is_head = scope["method"] == "HEAD"
        if is_head:
            scope = {**scope, "method": "GET"}
        elif accepts_gzip(fields.get(b"accept-encoding", b"")):
            send = compressing(send)
        resources = scope["app"].state.resources
        upload = Upload(receive, 2 * self._settings.batch_body_limit) if may_be_under_way(fields) else None
        status = 0

        async def send_with_headers(message: Message) -> None:
            nonlocal status
            if message["type"] == "http.response.start":
                status = message["status"]
                if upload and status >= _REFUSED:
                    await upload.drain()
                headers = message["headers"] = [
                    *message.get("headers", ()),
                    *_HEADERS,
                    (_REQUEST_ID, request_id),
                ]
                if _POLICY not in dict(headers):
                    headers.append(self._policy)
            elif is_head and message["type"] == "http.response.body":
                message = {**message, "body": b""}
            await send(message)

        resources.under_way += 1
        try:
            await self._app(scope, upload or receive, send_with_headers)
        except ClientDisconnect:
            _log.info("request %s: the caller went away", request_id.decode())
        except asyncio.CancelledError:  # the server ends, and has waited for as long as it may
            _log.warning("request %s: given up, because the server ends", request_id.decode())
            if not status:
                await refuse(busy(), scope, receive, send_with_headers)
        except Exception as error:
            refusal = _unexpected(error, scope[REQUEST_ID])
            if status:
                raise
            await refuse(refusal, scope, receive, send_with_headers)
        finally:
            resources.under_way -= 1
            if HELD in scope:
                resources.uploads.release(scope)
            route = original[ROUTE] = _template(scope)
            seconds = time.perf_counter() - begun
            resources.metrics.requested(original["method"], route, status, seconds)
            if self._settings.access_log:
                log_access(original["method"], route, status, seconds, request_id.decode())

    def _name_person(self, scope: Scope, field: bytes | None) -> None:
        """Have a request wait in the turn of the person whose session it names, if that is known."""
        courses = scope["app"].state.resources.courses if field else None
        who = courses.person(field.decode("latin-1")) if courses and field else None
        if who is not None:
            proven(who)

    def _open(self, scope: Scope, fields: Mapping[bytes, bytes]) -> bytes:
        """Read what a proxy says about the request; name the request."""
        request_id = fields.get(_REQUEST_ID, b"")
        if request_id and not _SANE_REQUEST_ID.fullmatch(request_id):
            request_id = b""
        request_id = request_id or self._next_id()
        scope[REQUEST_ID] = request_id.decode()
        prefix = self._settings.prefix or self._believed_prefix(scope, fields.get(b"x-forwarded-prefix"))
        if prefix:
            _place_under(scope, prefix)
        return request_id

    def _believed_prefix(self, scope: Scope, forwarded: bytes | None) -> str:
        if not forwarded or scope[PEER] not in self._behind_proxies.trusted_hosts:
            return ""
        prefix = forwarded.decode("latin-1").split(",")[0].strip().rstrip("/")
        return prefix if PREFIX.fullmatch(prefix) else ""


def _unexpected(error: Exception, request_id: str) -> ServiceError:
    """Return what a caller is told of an error that nothing expects; the log is told the rest."""
    if (refusal := shortage(error, request_id)) is not None:
        return refusal
    _log.exception("request %s: unhandled error", request_id)
    return ServiceError(Fault.at("internal_error", id=request_id))


def _template(scope: Scope) -> str:
    """Return the path of the route that a request is for, with names for what differs from call to call."""
    route = scope.get("route")
    if route is None and "router" not in scope:  # another layer has answered, before any route was looked for
        route = _route_for(scope)
    path = getattr(route, "path", None)
    return path if isinstance(path, str) else UNMATCHED


def _route_for(scope: Scope) -> BaseRoute | None:
    """Return the route that would serve a request, or else one that serves its path by another method."""
    found: BaseRoute | None = None
    routes: list[BaseRoute] = scope["app"].routes
    for route in routes:
        match, _ = route.matches(scope)
        if match is Match.FULL:
            return route
        if match is Match.PARTIAL and found is None:
            found = route
    return found


def _place_under(scope: Scope, prefix: str) -> None:
    """Tell the application its prefix, whether or not the proxy has already taken it off the path."""
    scope["root_path"] = prefix
    if not scope["path"].startswith(prefix + "/") and scope["path"] != prefix:
        scope["path"] = prefix + scope["path"]


def _request_ids() -> Callable[[], bytes]:
    """Names for requests: unique to this process, cheap, and not guessable from outside."""
    process = secrets.token_hex(6).encode()
    counter = itertools.count(1)
    return lambda: b"%s-%x" % (process, next(counter))
