"""Connections whose every operation ends with the request's time: what drips is given up wherever it is."""

import ssl
import threading
import time
from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager
from typing import Any

import httpcore
import httpx

Remaining = Callable[[float | None], float]
"""Returns how long an operation may take of those seconds that it would have by itself [s]."""


class BoundedTransport(httpx.HTTPTransport):
    """Sends requests; all that a thread does `within` a time ends with it.

    A timeout of reading alone begins anew with every byte, be it one of a header.
    """

    def __init__(self) -> None:
        certificates = httpx.create_ssl_context(trust_env=False)
        super().__init__(verify=certificates)
        self._ends = threading.local()
        self._pool = httpcore.ConnectionPool(
            ssl_context=certificates,
            max_connections=100,
            max_keepalive_connections=20,
            keepalive_expiry=5.0,
            network_backend=_Backend(self._remaining),
        )

    @contextmanager
    def within(self, seconds: float) -> Iterator[None]:
        """End what this thread sends and reads meanwhile after so many seconds."""
        self._ends.at = time.monotonic() + seconds
        try:
            yield
        finally:
            del self._ends.at

    def _remaining(self, timeout: float | None) -> float:
        left = float(self._ends.at) - time.monotonic()
        if left <= 0.0:
            raise httpcore.ReadTimeout("the whole answer takes too long")
        return left if timeout is None else min(left, timeout)


class _Backend(httpcore.NetworkBackend):
    def __init__(self, remaining: Remaining) -> None:
        self._inner = httpcore.SyncBackend()
        self._remaining = remaining

    def connect_tcp(
        self,
        host: str,
        port: int,
        timeout: float | None = None,
        local_address: str | None = None,
        socket_options: Iterable[Any] | None = None,
    ) -> httpcore.NetworkStream:
        stream = self._inner.connect_tcp(host, port, self._remaining(timeout), local_address, socket_options)
        return _Stream(stream, self._remaining)


class _Stream(httpcore.NetworkStream):
    def __init__(self, inner: httpcore.NetworkStream, remaining: Remaining) -> None:
        self._inner, self._remaining = inner, remaining

    def read(self, max_bytes: int, timeout: float | None = None) -> bytes:
        return self._inner.read(max_bytes, self._remaining(timeout))

    def write(self, buffer: bytes, timeout: float | None = None) -> None:
        self._inner.write(buffer, self._remaining(timeout))

    def close(self) -> None:
        self._inner.close()

    def start_tls(
        self, ssl_context: ssl.SSLContext, server_hostname: str | None = None, timeout: float | None = None
    ) -> httpcore.NetworkStream:
        stream = self._inner.start_tls(ssl_context, server_hostname, self._remaining(timeout))
        return _Stream(stream, self._remaining)

    def get_extra_info(self, info: str) -> Any:
        return self._inner.get_extra_info(info)
