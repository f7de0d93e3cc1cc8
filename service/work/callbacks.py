"""Feedback sent later to a caller's own address: allow-listed hosts, signed bodies, a few tries."""

import asyncio
import logging
from collections.abc import Callable
from typing import Any
from urllib.parse import urlsplit

import orjson

from service.work.threads import in_thread

SIGNATURE = "X-Framewise-Signature"
_MOST_AT_ONCE = 64
_TRIES = 3
_TIMEOUT_SECONDS = 10.0
"""Callbacks at a time, tries for each and seconds for a try: a host that is down costs half a minute, and
no more than 64 wait for it."""
_LOOPBACK = ("127.0.0.1", "[::1]", "localhost")

_log = logging.getLogger("framewise")


class Callbacks:
    """Sends what was computed to addresses that the operator allows.

    Args:
        hosts: `host` or `host:port` of the addresses that may be called; https alone, but for loopback.
        sign: returns the detached signature of a body.
    """

    def __init__(self, hosts: tuple[str, ...], sign: Callable[[bytes], str]) -> None:
        self._hosts = frozenset(host.lower() for host in hosts)
        self._sign = sign
        self._running: set[asyncio.Task[None]] = set()

    def allows(self, address: str) -> bool:
        """Return whether an address may be called."""
        try:
            parts = urlsplit(address)
            name = parts.hostname or ""
            name = f"[{name}]" if ":" in name else name
            host = f"{name}:{parts.port}" if parts.port else name
        except ValueError:
            return False
        secure = parts.scheme == "https" or (parts.scheme == "http" and name in _LOOPBACK)
        return secure and host in self._hosts and parts.username is None

    def has_room(self) -> bool:
        """Return whether one more may be sent now."""
        return len(self._running) < _MOST_AT_ONCE

    def send(self, address: str, request_id: str, compute: Callable[[], Any]) -> None:
        """Compute in a thread, and send the outcome when it is there."""
        task = asyncio.get_running_loop().create_task(self._deliver(address, request_id, compute))
        self._running.add(task)
        task.add_done_callback(self._running.discard)

    async def _deliver(self, address: str, request_id: str, compute: Callable[[], Any]) -> None:
        try:
            body = orjson.dumps(await in_thread(compute))
        except Exception:
            _log.exception("what was asked for with request %s could not be computed", request_id)
            return
        headers = {
            "Content-Type": "application/json",
            "X-Request-Id": request_id,
            SIGNATURE: self._sign(body),
        }
        import httpx  # few services are asked to call back, and it is large

        async with httpx.AsyncClient(timeout=_TIMEOUT_SECONDS, follow_redirects=False) as client:
            for number in range(_TRIES):
                try:
                    answer = await client.post(address, content=body, headers=headers)
                except httpx.HTTPError as error:
                    _log.warning("callback of request %s: %s", request_id, type(error).__name__)
                else:
                    if answer.status_code < 500:
                        return
                await asyncio.sleep(2**number)
