"""The connections of the server: uvicorn's, with limits on what a caller may leave undone.

A caller who sends a request's head too slowly, or one that is too long, who doesn't read its answer, or
who holds a connection open for nothing costs a descriptor and some memory. Each is given up after a time;
and before the descriptors run out, the connection that has been idle longest makes room for a new one, or
else that whose body has stood still longest.

What a proxy could read in another way than this server is refused: a request of HTTP/1.1 names its host
once (RFC 9112, section 3.2), and its body comes whole or in chunks, in no other coding (section 6.1).
"""

import asyncio
import resource
from typing import Any

import httptools
from uvicorn.protocols.http.httptools_impl import HttpToolsProtocol

from service.settings import Settings

HEAD_BYTES = 64 * 1024
"""Longest head of a request: enough for an npy question in the address and every cookie of a portal."""
HEAD_FIELDS = 128  # Most header fields: browsers send twenty, chains of proxies add as many.
HEAD_SECONDS = 10.0
"""How long a head may take to arrive, from its first byte or from the opening of the connection."""
UNREAD_SECONDS = 30.0  # How long a caller may leave its answer unread once the buffers are full.
RESERVED_DESCRIPTORS = 96  # Descriptors that are left to files, worker processes and the database.

_TOO_LARGE = "431 Request Header Fields Too Large"
_BAD_HOST = "400 Bad Request"
_UNKNOWN_CODING = "501 Not Implemented"


def connection_limit() -> int:
    """Return how many connections may be open, from the descriptors that this process may have."""
    descriptors, _ = resource.getrlimit(resource.RLIMIT_NOFILE)
    if descriptors == resource.RLIM_INFINITY:
        return 1 << 16
    return max(descriptors // 2, descriptors - RESERVED_DESCRIPTORS)


class BoundedConnection(HttpToolsProtocol):
    """One connection."""

    _is_idle = False
    _heard_at = 0.0
    _held_bytes = 0
    _head_fields = 0
    _head_timer: asyncio.TimerHandle | None = None
    _unread_timer: asyncio.TimerHandle | None = None

    def connection_made(self, transport: asyncio.Transport) -> None:  # type: ignore[override]
        """Accept, and let the connection go that has been silent longest if there are too many."""
        super().connection_made(transport)
        if len(self.connections) > connection_limit():
            self._longest_silent().transport.abort()
        self._await_head()

    def connection_lost(self, exc: Exception | None) -> None:
        """Forget the connection."""
        self._stop_timers()
        super().connection_lost(exc)

    def data_received(self, data: bytes) -> None:
        """Take bytes in, as long as the parser need not hold many: a head, or fields after a body."""
        self._held_bytes += len(data)
        self._heard_at = self.loop.time()
        super().data_received(data)
        if self._is_idle and self._held_bytes and self._head_timer is None:
            self._await_head()  # the rest of it
        if self._held_bytes > HEAD_BYTES:
            self._refused(_TOO_LARGE)

    def on_message_begin(self) -> None:
        """Count the fields of each request by themselves, also if it comes before the last was answered."""
        self._head_fields = 0
        super().on_message_begin()

    def on_header(self, name: bytes, value: bytes) -> None:
        """Take a header field in, as long as there are not too many."""
        self._head_fields += 1
        if self._head_fields > HEAD_FIELDS or len(name) + len(value) > HEAD_BYTES:
            raise self._refused(_TOO_LARGE)
        super().on_header(name, value)

    def on_headers_complete(self) -> None:
        """Begin with the request."""
        hosts = sum(name == b"host" for name, _ in self.headers)
        if hosts > 1 or (hosts == 0 and self.parser.get_http_version() == "1.1"):
            raise self._refused(_BAD_HOST, "Send one Host field.")
        if any(name == b"transfer-encoding" and value.lower() != b"chunked" for name, value in self.headers):
            raise self._refused(_UNKNOWN_CODING, "Send the body whole or with Transfer-Encoding: chunked.")
        self._is_idle, self._held_bytes = False, 0
        self._stop_timers()
        super().on_headers_complete()

    def on_body(self, body: bytes) -> None:
        """Hand on a part of the body, which the application counts."""
        self._held_bytes = 0
        super().on_body(body)

    def on_message_complete(self) -> None:
        """Wait for the next request, if this one is answered already."""
        super().on_message_complete()
        if self.cycle.response_complete:
            self._await_head()

    def on_response_complete(self) -> None:
        """Rest until the next request begins, or uvicorn closes what was idle for too long."""
        super().on_response_complete()
        if self.transport.is_closing() or not self.cycle.response_complete:
            return
        if self.cycle.more_body:  # a rest that nobody reads may come, but not for ever
            self._head_timer = self.loop.call_later(HEAD_SECONDS, self.transport.close)
        else:
            self._stop_timers()
            self._is_idle, self._heard_at = True, self.loop.time()

    def pause_writing(self) -> None:
        """Give the caller so long to read."""
        super().pause_writing()
        if self._unread_timer is None:
            self._unread_timer = self.loop.call_later(UNREAD_SECONDS, self.transport.abort)

    def resume_writing(self) -> None:
        """Go on: the caller reads."""
        super().resume_writing()
        self._stop_timers()

    def _await_head(self) -> None:
        self._stop_timers()
        self._is_idle = True
        self._heard_at = self.loop.time()
        self._head_timer = self.loop.call_later(HEAD_SECONDS, self.transport.close)

    def _stop_timers(self) -> None:
        for timer in (self._head_timer, self._unread_timer):
            if timer is not None:
                timer.cancel()
        self._head_timer = self._unread_timer = None

    def _longest_silent(self) -> "BoundedConnection":
        """The connection that can go: idle ones before those whose callers owe the rest of a body."""
        silent = [one for one in self.connections if isinstance(one, BoundedConnection) and one._is_waiting]
        return min(silent, key=lambda one: (not one._is_idle, one._heard_at), default=self)

    @property
    def _is_waiting(self) -> bool:
        """Whether the next thing to come is to come from the caller."""
        return self._is_idle or (self.cycle is not None and self.cycle.more_body)

    def _refused(self, status: str, told: str = "") -> httptools.HttpParserError:
        """Refuse a head; raise what is returned where the parser has to stop."""
        if not self.transport.is_closing():
            if self.cycle is None or self.cycle.response_complete:  # else an answer is still under way
                fields = f"connection: close\r\ncontent-type: text/plain\r\ncontent-length: {len(told)}"
                self.transport.write(f"HTTP/1.1 {status}\r\n{fields}\r\n\r\n{told}".encode())
            self.transport.close()
        return httptools.HttpParserError(status)

    def _unsupported_upgrade_warning(self) -> None:
        """Go on without a word: a caller may offer another protocol, and the answer comes in this one."""

    def send_400_response(self, msg: str) -> None:
        """Refuse what is no HTTP, unless the refusal is sent already."""
        if not self.transport.is_closing():
            super().send_400_response(msg)


def server_options(settings: Settings) -> dict[str, Any]:
    """Return what uvicorn is told besides address and processes."""
    return {
        "http": BoundedConnection,
        "ws": "none",
        "proxy_headers": False,  # the outermost layer reads them, with the proxy's own address still at hand
        "server_header": False,
        "access_log": False,  # ours knows times and request ids
        "timeout_keep_alive": settings.keep_alive_seconds,
        "timeout_graceful_shutdown": settings.shutdown_seconds,
    }
