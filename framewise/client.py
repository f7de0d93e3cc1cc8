"""Clients of the service, for programs that wait and for programs that do not."""

import json
from collections.abc import AsyncIterator, Coroutine, Iterator, Mapping
from types import TracebackType
from typing import Any

import httpx

from framewise.exercise_calls import ExerciseCalls
from framewise.sender import ApiCall, Json

API = "/api/v1/"
_TIMEOUT_SECONDS = 60.0
"""Seconds that a call may take: more than a closed form may wait for its turn and then compute."""
_NDJSON = {"Accept": "application/x-ndjson"}


class ProblemError(Exception):
    """A refusal of the service (RFC 9457).

    Attributes:
        status: the HTTP status.
        code: the first fault's stable code.
        document: the whole problem document.
        retry_after: seconds after which to try again, where the service names them.
    """

    def __init__(self, status: int, document: Mapping[str, Any], retry_after: float | None = None) -> None:
        self.status = status
        self.code = str(document.get("code", "unknown"))
        self.document = dict(document)
        self.retry_after = retry_after
        super().__init__(f"{status} {self.code}: {document.get('detail', '')}")


class Client(ExerciseCalls[Json, bytes, Iterator[Json]]):
    """Call the service and wait for its answers.

    Args:
        base_url: where the service is, such as `http://127.0.0.1:8000`, with its prefix if it has one.
        api_key: key of a program, where the service asks for one.
        language: language of messages.
        transport: another transport of httpx, such as one that calls an application in this process.
        timeout: of each call [s].
    """

    def __init__(
        self,
        base_url: str,
        *,
        api_key: str | None = None,
        language: str | None = None,
        transport: httpx.BaseTransport | None = None,
        timeout: float = _TIMEOUT_SECONDS,
    ) -> None:
        self._http = httpx.Client(
            base_url=base_url.rstrip("/") + API,
            headers=_headers(api_key, language),
            transport=transport,
            timeout=timeout,
        )

    def __enter__(self) -> "Client":
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self._http.close()

    def send(self, call: ApiCall) -> Json:
        """Send a call and return its JSON."""
        return _answer(self._http.request(**_request(call)))

    def fetch(self, call: ApiCall) -> bytes:
        """Send a call and return what comes, such as a picture or a package."""
        return _accepted(self._http.request(**_request(call))).content

    def stream(self, call: ApiCall) -> Iterator[Json]:
        """Send a call and yield its answers as they come, line by line."""
        with self._http.stream(**_request(call, _NDJSON)) as response:
            if not response.is_success:
                response.read()
            yield from map(json.loads, _accepted(response).iter_lines())


class AsyncClient(ExerciseCalls[Coroutine[Any, Any, Json], Coroutine[Any, Any, bytes], AsyncIterator[Json]]):
    """Call the service from a program that does other things meanwhile; the same calls as `Client`."""

    def __init__(
        self,
        base_url: str,
        *,
        api_key: str | None = None,
        language: str | None = None,
        transport: httpx.AsyncBaseTransport | None = None,
        timeout: float = _TIMEOUT_SECONDS,
    ) -> None:
        self._http = httpx.AsyncClient(
            base_url=base_url.rstrip("/") + API,
            headers=_headers(api_key, language),
            transport=transport,
            timeout=timeout,
        )

    async def __aenter__(self) -> "AsyncClient":
        return self

    async def __aexit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        await self._http.aclose()

    async def send(self, call: ApiCall) -> Json:
        """Send a call and return its JSON."""
        return _answer(await self._http.request(**_request(call)))

    async def fetch(self, call: ApiCall) -> bytes:
        """Send a call and return what comes, such as a picture or a package."""
        return _accepted(await self._http.request(**_request(call))).content

    async def stream(self, call: ApiCall) -> AsyncIterator[Json]:
        """Send a call and yield its answers as they come, line by line."""
        async with self._http.stream(**_request(call, _NDJSON)) as response:
            if not response.is_success:
                await response.aread()
            async for line in _accepted(response).aiter_lines():
                yield json.loads(line)


def _headers(api_key: str | None, language: str | None) -> dict[str, str]:
    key = {"Authorization": f"Bearer {api_key}"} if api_key else {}
    return {**key, **({"Accept-Language": language} if language else {})}


def _request(call: ApiCall, headers: Mapping[str, str] | None = None) -> dict[str, Any]:
    query = {name: value for name, value in call.query.items() if value is not None}
    sent = dict(headers or {})
    content = None
    if call.body is not None:
        sent["Content-Type"] = "application/json"
        content = json.dumps(call.body, default=_plain, allow_nan=False).encode()
    return {"method": call.method, "url": call.path, "params": query, "headers": sent, "content": content}


def _plain(value: Any) -> Any:
    """An array, or a number of an array's type, as JSON writes it."""
    listed = getattr(value, "tolist", None)
    if listed is None:
        raise TypeError(f"JSON has no {type(value).__name__}: {value!r}")
    return listed()


def _answer(response: httpx.Response) -> Json:
    answer: Json = _accepted(response).json()
    return answer


def _accepted(response: httpx.Response) -> httpx.Response:
    """Return a response that is no refusal."""
    if response.is_success:
        return response
    try:
        document = response.json()
    except ValueError:
        document = {"detail": response.reason_phrase}
    wait = response.headers.get("Retry-After", "")
    raise ProblemError(response.status_code, document, float(wait) if wait.isdecimal() else None)
