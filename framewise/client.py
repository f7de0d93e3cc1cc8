"""Clients of the service, for programs that wait and for programs that do not."""

from __future__ import annotations

import functools
import json
from collections.abc import AsyncIterator, Callable, Coroutine, Iterator, Mapping
from types import TracebackType
from typing import Any, Concatenate, ParamSpec

import httpx

from framewise import calls, exercise_calls
from framewise.calls import ApiCall, Json

_Arguments = ParamSpec("_Arguments")

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


def _now_bytes(
    describe: Callable[_Arguments, ApiCall],
) -> Callable[Concatenate[Client, _Arguments], bytes]:
    @functools.wraps(describe)
    def method(self: Client, /, *args: _Arguments.args, **kwargs: _Arguments.kwargs) -> bytes:
        return self.fetch(describe(*args, **kwargs))

    return method


def _later_bytes(
    describe: Callable[_Arguments, ApiCall],
) -> Callable[Concatenate[AsyncClient, _Arguments], Coroutine[Any, Any, bytes]]:
    @functools.wraps(describe)
    async def method(self: AsyncClient, /, *args: _Arguments.args, **kwargs: _Arguments.kwargs) -> bytes:
        return await self.fetch(describe(*args, **kwargs))

    return method


def _now_one_by_one(
    describe: Callable[_Arguments, ApiCall],
) -> Callable[Concatenate[Client, _Arguments], Iterator[Json]]:
    @functools.wraps(describe)
    def method(self: Client, /, *args: _Arguments.args, **kwargs: _Arguments.kwargs) -> Iterator[Json]:
        return self.stream(describe(*args, **kwargs))

    return method


def _later_one_by_one(
    describe: Callable[_Arguments, ApiCall],
) -> Callable[Concatenate[AsyncClient, _Arguments], AsyncIterator[Json]]:
    @functools.wraps(describe)
    def method(
        self: AsyncClient, /, *args: _Arguments.args, **kwargs: _Arguments.kwargs
    ) -> AsyncIterator[Json]:
        return self.stream(describe(*args, **kwargs))

    return method


class Client:
    """Call the service and wait for its answers; the calls are those of `calls` and `exercise_calls`.

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

    def fetch(self, call: ApiCall) -> bytes:
        """Send a call and return what comes, such as a picture or a package; raises as `send` does."""
        return _accepted(self._http.request(**_request(call))).content

    def stream(self, call: ApiCall) -> Iterator[Json]:
        """Send a call and yield its answers as they come, line by line; raises as `send` does."""
        with self._http.stream(**_request(call, _NDJSON)) as response:
            if not response.is_success:
                response.read()
            yield from map(json.loads, _accepted(response).iter_lines())

    forward_kinematics = _now(calls.forward_kinematics)
    jacobian = _now(calls.jacobian)
    inverse_kinematics = _now(calls.inverse_kinematics)
    check_inverse_kinematics = _now(calls.check_inverse_kinematics)
    symbolic = _now(calls.symbolic)
    dynamics = _now(calls.dynamics)
    rates = _now(calls.rates)
    trajectory = _now(calls.trajectory)
    workspace = _now(calls.workspace)
    understand = _now(calls.understand)
    convert = _now(calls.convert)
    assign_frames = _now(calls.assign_frames)
    check_frames = _now(calls.check_frames)
    rotations = _now(calls.rotations)
    check_jacobian = _now(calls.check_jacobian)
    check_jacobian_form = _now(calls.check_jacobian_form)
    check_singularities = _now(calls.check_singularities)
    check_dynamics = _now(calls.check_dynamics)
    check_screws = _now(calls.check_screws)
    trees = _now(calls.trees)
    check_rotation = _now(calls.check_rotation)
    scm_forward_kinematics = _now(calls.scm_forward_kinematics)
    scm_inverse_transform = _now(calls.scm_inverse_transform)
    scm_jacobian = _now(calls.scm_jacobian)
    scm_inverse_kinematics = _now(calls.scm_inverse_kinematics)
    scm_random_configuration = _now(calls.scm_random_configuration)
    scm_products = _now(calls.scm_products)
    robots = _now(calls.robots)
    robot = _now(calls.robot)
    exercises = _now(calls.exercises)
    exercise = _now(calls.exercise)
    grade = _now(calls.grade)
    grade_all = _now(calls.grade_all)
    grade_exercise = _now(calls.grade_exercise)
    receipt = _now(calls.receipt)
    verify_receipts = _now(calls.verify_receipts)
    receipt_keys = _now(calls.receipt_keys)
    problem = _now(calls.problem)
    compare_tables = _now(exercise_calls.compare_tables)
    other_tables = _now(exercise_calls.other_tables)
    plant_mistake = _now(exercise_calls.plant_mistake)
    plant_matrix_mistake = _now(exercise_calls.plant_matrix_mistake)
    plant_frame_mistake = _now(exercise_calls.plant_frame_mistake)
    signed_link = _now(exercise_calls.signed_link)
    author_start = _now(exercise_calls.author_start)
    author_import = _now(exercise_calls.author_import)
    author_preview = _now(exercise_calls.author_preview)
    author_check = _now(exercise_calls.author_check)
    author_right_answers = _now(exercise_calls.author_right_answers)
    author_mistakes = _now(exercise_calls.author_mistakes)
    author_grade = _now(exercise_calls.author_grade)
    receipt_page = _now_bytes(exercise_calls.receipt_page)
    author_folder = _now_bytes(exercise_calls.author_folder)
    post = _now(calls.post)
    get = _now(calls.get)
    figure = _now_bytes(calls.figure)
    scorm_package = _now_bytes(calls.scorm_package)
    grade_each = _now_one_by_one(calls.grade_all)


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

    async def fetch(self, call: ApiCall) -> bytes:
        """Send a call and return what comes, such as a picture or a package; raises as `send` does."""
        return _accepted(await self._http.request(**_request(call))).content

    async def stream(self, call: ApiCall) -> AsyncIterator[Json]:
        """Send a call and yield its answers as they come, line by line; raises as `send` does."""
        async with self._http.stream(**_request(call, _NDJSON)) as response:
            if not response.is_success:
                await response.aread()
            async for line in _accepted(response).aiter_lines():
                yield json.loads(line)

    forward_kinematics = _later(calls.forward_kinematics)
    jacobian = _later(calls.jacobian)
    inverse_kinematics = _later(calls.inverse_kinematics)
    check_inverse_kinematics = _later(calls.check_inverse_kinematics)
    symbolic = _later(calls.symbolic)
    dynamics = _later(calls.dynamics)
    rates = _later(calls.rates)
    trajectory = _later(calls.trajectory)
    workspace = _later(calls.workspace)
    understand = _later(calls.understand)
    convert = _later(calls.convert)
    assign_frames = _later(calls.assign_frames)
    check_frames = _later(calls.check_frames)
    rotations = _later(calls.rotations)
    check_jacobian = _later(calls.check_jacobian)
    check_jacobian_form = _later(calls.check_jacobian_form)
    check_singularities = _later(calls.check_singularities)
    check_dynamics = _later(calls.check_dynamics)
    check_screws = _later(calls.check_screws)
    trees = _later(calls.trees)
    check_rotation = _later(calls.check_rotation)
    scm_forward_kinematics = _later(calls.scm_forward_kinematics)
    scm_inverse_transform = _later(calls.scm_inverse_transform)
    scm_jacobian = _later(calls.scm_jacobian)
    scm_inverse_kinematics = _later(calls.scm_inverse_kinematics)
    scm_random_configuration = _later(calls.scm_random_configuration)
    scm_products = _later(calls.scm_products)
    robots = _later(calls.robots)
    robot = _later(calls.robot)
    exercises = _later(calls.exercises)
    exercise = _later(calls.exercise)
    grade = _later(calls.grade)
    grade_all = _later(calls.grade_all)
    grade_exercise = _later(calls.grade_exercise)
    receipt = _later(calls.receipt)
    verify_receipts = _later(calls.verify_receipts)
    receipt_keys = _later(calls.receipt_keys)
    problem = _later(calls.problem)
    compare_tables = _later(exercise_calls.compare_tables)
    other_tables = _later(exercise_calls.other_tables)
    plant_mistake = _later(exercise_calls.plant_mistake)
    plant_matrix_mistake = _later(exercise_calls.plant_matrix_mistake)
    plant_frame_mistake = _later(exercise_calls.plant_frame_mistake)
    signed_link = _later(exercise_calls.signed_link)
    author_start = _later(exercise_calls.author_start)
    author_import = _later(exercise_calls.author_import)
    author_preview = _later(exercise_calls.author_preview)
    author_check = _later(exercise_calls.author_check)
    author_right_answers = _later(exercise_calls.author_right_answers)
    author_mistakes = _later(exercise_calls.author_mistakes)
    author_grade = _later(exercise_calls.author_grade)
    receipt_page = _later_bytes(exercise_calls.receipt_page)
    author_folder = _later_bytes(exercise_calls.author_folder)
    post = _later(calls.post)
    get = _later(calls.get)
    figure = _later_bytes(calls.figure)
    scorm_package = _later_bytes(calls.scorm_package)
    grade_each = _later_one_by_one(calls.grade_all)


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
