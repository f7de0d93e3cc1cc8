"""Clients of the service, for programs that wait and for programs that do not."""

from __future__ import annotations

import functools
from collections.abc import Callable, Coroutine, Mapping
from types import TracebackType
from typing import Any, Concatenate, ParamSpec

import httpx

from framewise import calls
from framewise.calls import ApiCall, Json

_Arguments = ParamSpec("_Arguments")

API = "/api/v1/"
_TIMEOUT_SECONDS = 60.0


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


def _now(
    describe: Callable[_Arguments, ApiCall],
) -> Callable[Concatenate[Client, _Arguments], Json]:
    @functools.wraps(describe)
    def method(self: Client, /, *args: _Arguments.args, **kwargs: _Arguments.kwargs) -> Json:
        return self.send(describe(*args, **kwargs))

    return method


def _later(
    describe: Callable[_Arguments, ApiCall],
) -> Callable[Concatenate[AsyncClient, _Arguments], Coroutine[Any, Any, Json]]:
    @functools.wraps(describe)
    async def method(self: AsyncClient, /, *args: _Arguments.args, **kwargs: _Arguments.kwargs) -> Json:
        return await self.send(describe(*args, **kwargs))

    return method


class Client:
    """Call the service and wait for its answers; the calls are those of `framewise.calls`.

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

    def __enter__(self) -> Client:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self._http.close()

    def send(self, call: ApiCall) -> Json:
        """Send a call and return its JSON.

        Raises:
            ProblemError: the service refuses.
            httpx.HTTPError: the service cannot be reached.
        """
        return _answer(self._http.request(**_request(call)))

    forward_kinematics = _now(calls.forward_kinematics)
    jacobian = _now(calls.jacobian)
    inverse_kinematics = _now(calls.inverse_kinematics)
    symbolic = _now(calls.symbolic)
    robots = _now(calls.robots)
    exercises = _now(calls.exercises)
    exercise = _now(calls.exercise)
    grade = _now(calls.grade)
    grade_all = _now(calls.grade_all)
    grade_exercise = _now(calls.grade_exercise)
    verify_receipts = _now(calls.verify_receipts)


class AsyncClient:
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

    async def __aenter__(self) -> AsyncClient:
        return self

    async def __aexit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        await self._http.aclose()

    async def send(self, call: ApiCall) -> Json:
        """Send a call and return its JSON.

        Raises:
            ProblemError: the service refuses.
            httpx.HTTPError: the service cannot be reached.
        """
        return _answer(await self._http.request(**_request(call)))

    forward_kinematics = _later(calls.forward_kinematics)
    jacobian = _later(calls.jacobian)
    inverse_kinematics = _later(calls.inverse_kinematics)
    symbolic = _later(calls.symbolic)
    robots = _later(calls.robots)
    exercises = _later(calls.exercises)
    exercise = _later(calls.exercise)
    grade = _later(calls.grade)
    grade_all = _later(calls.grade_all)
    grade_exercise = _later(calls.grade_exercise)
    verify_receipts = _later(calls.verify_receipts)


def _headers(api_key: str | None, language: str | None) -> dict[str, str]:
    key = {"Authorization": f"Bearer {api_key}"} if api_key else {}
    return {**key, **({"Accept-Language": language} if language else {})}


def _request(call: ApiCall) -> dict[str, Any]:
    query = {name: value for name, value in call.query.items() if value is not None}
    return {"method": call.method, "url": call.path, "json": call.body, "params": query}


def _answer(response: httpx.Response) -> Json:
    if response.is_success:
        answer: Json = response.json()
        return answer
    try:
        document = response.json()
    except ValueError:
        document = {"detail": response.reason_phrase}
    wait = response.headers.get("Retry-After", "")
    raise ProblemError(response.status_code, document, float(wait) if wait.isdecimal() else None)
