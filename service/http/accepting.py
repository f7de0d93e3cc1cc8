"""The event loop of one of several server processes: how it takes connections from the socket that all share.

A process that takes all that wait whenever it looks may come by many more than the others, in the second in
which a class opens an exercise; students stay where they came to, so one process works on while another has
nothing to do. Here each takes one connection between two looks at those it has: who has more to do looks
less often, and takes fewer.
"""

from __future__ import annotations

import asyncio
import logging
import socket
from collections.abc import Callable
from typing import Any

import uvloop

PAUSE = 1.0
"""Seconds in which no connection is taken after one could not be, for want of descriptors."""
_log = logging.getLogger("framewise")


class SharingLoop(uvloop.Loop):
    """uvloop's loop, but for how it listens on a socket that it is given."""

    async def create_server(  # type: ignore[override]
        self, protocol_factory: Callable[[], asyncio.BaseProtocol], *where: Any, **options: Any
    ) -> asyncio.AbstractServer | Listening:
        """Listen; arguments as of asyncio."""
        given: socket.socket | None = options.get("sock")
        if given is None or options.get("ssl") is not None:
            return await super().create_server(protocol_factory, *where, **options)
        return Listening(self, protocol_factory, given, options.get("backlog", 100))


class Listening:
    """Takes connections, one each time that the loop looks."""

    def __init__(
        self,
        loop: asyncio.AbstractEventLoop,
        factory: Callable[[], asyncio.BaseProtocol],
        listener: socket.socket,
        backlog: int,
    ) -> None:
        self._loop, self._factory, self._listener = loop, factory, listener
        self._opening: set[asyncio.Task[Any]] = set()
        self._timer: asyncio.TimerHandle | None = None
        self._is_open = True
        listener.setblocking(False)
        listener.listen(backlog)
        loop.add_reader(listener, self._take_one)

    def close(self) -> None:
        """Take no more connections; those that there are stay."""
        if self._is_open:
            self._is_open = False
            self._loop.remove_reader(self._listener)
            if self._timer is not None:
                self._timer.cancel()

    async def wait_closed(self) -> None:
        """Wait until it listens no more, which it does not after `close`."""

    def _take_one(self) -> None:
        try:
            connection, _ = self._listener.accept()
        except (BlockingIOError, InterruptedError, ConnectionAbortedError):
            return  # another process was quicker, or the caller has gone
        except OSError as error:
            _log.error("no connection can be taken: %s", error.strerror)
            self._loop.remove_reader(self._listener)
            self._timer = self._loop.call_later(PAUSE, self._go_on)
            return
        connection.setblocking(False)
        opening = self._loop.create_task(self._loop.connect_accepted_socket(self._factory, connection))
        self._opening.add(opening)
        opening.add_done_callback(self._opened)

    def _opened(self, opening: asyncio.Task[Any]) -> None:
        self._opening.discard(opening)
        if not opening.cancelled() and (error := opening.exception()) is not None:
            _log.error("a connection could not be opened", exc_info=error)

    def _go_on(self) -> None:
        self._timer = None
        self._loop.add_reader(self._listener, self._take_one)
