"""What a refused caller is still sending: taken in and thrown away, so that the refusal arrives.

A server that closes a connection while a body is under way resets it, and the caller sees a broken pipe where
the sentence should be. What is taken in is bounded in size and in time.
"""

from collections.abc import Mapping

import anyio
from starlette.types import Message, Receive, Scope

from service.http.problems import busy

HELD = "held_bytes"  # Where a request's scope says how much of it is in memory.
SECONDS = 5.0  # How long a refused caller is listened to: enough for what is on its way over any usual line.
_SMALL = 5  # A body whose length has no more digits than this fits into the buffers of a connection.


class UploadBudget:
    """How many bytes of large bodies are in memory, over all requests."""

    def __init__(self, limit: int) -> None:
        self._limit = limit
        self._held = 0

    def hold(self, scope: Scope, size: int) -> None:
        """Note that a request holds so many bytes by now.

        Raises:
            BusyError: all requests together would hold more than may be held.
        """
        more = size - scope.get(HELD, 0)
        if self._held + more > self._limit:
            raise busy()
        scope[HELD] = size
        self._held += more

    def release(self, scope: Scope) -> None:
        """Note that the request is over."""
        self._held -= scope.pop(HELD, 0)


class Upload:
    """A request's body, and how much of it has come."""

    def __init__(self, receive: Receive, limit: int) -> None:
        self._receive, self._limit = receive, limit
        self._received = 0
        self._more = True

    async def __call__(self) -> Message:
        """The next message of the connection."""
        message = await self._receive()
        self._received += len(message.get("body", b""))
        self._more = bool(message.get("more_body", False))
        return message

    async def drain(self) -> None:
        """Throw the rest of the body away, as long as it is not too much and does not take too long."""
        with anyio.move_on_after(SECONDS):
            while self._more and self._received <= self._limit:
                await self()


def may_be_under_way(fields: Mapping[bytes, bytes]) -> bool:
    """Return whether a body may still be on its way when the request is refused.

    A caller that waits to be told to go on (Expect: 100-continue) sends nothing before.
    """
    if b"expect" in fields:
        return False
    return len(fields.get(b"content-length", b"")) > _SMALL or b"transfer-encoding" in fields
