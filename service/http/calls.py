"""Calls: an address, what OpenAPI says of it, and a plain function from the request's model to the answer's.

The function asks by the names of its parameters for what it needs: `body`, and beside it

robot       the body's robot, prepared (`service.wire.kinematics.prepared_robots`)
language    in which to answer
limits      of the cells of a table
settings, resources, request   of the application, and of HTTP

It is done where its call says: at once if the body is small and in a thread if it is not, or in turn in the
threads of one kind of work. One that waits for worker processes is `async`, and waits in the event loop.
"""

from collections.abc import Callable, Mapping
from functools import partial
from inspect import iscoroutinefunction
from types import UnionType
from typing import Any, TypeVar, Union, get_args, get_type_hints

from fastapi import APIRouter, Response

from service.http.languages import language_of
from service.http.openapi import problems
from service.http.routing import API_PREFIX, ApiRequest, ApiRoute
from service.work.limiters import WorkKind

_Function = TypeVar("_Function", bound=Callable[..., Any])

_GIVEN: Mapping[str, Callable[[ApiRequest], Any]] = {
    "language": language_of,
    "limits": lambda request: request.settings.cell_limits,
    "settings": lambda request: request.settings,
    "resources": lambda request: request.resources,
    "request": lambda request: request,
}


class CallRouter(APIRouter):
    """A router under /api/v1 whose calls are functions."""

    def __init__(self, tag: str, route_class: type[ApiRoute] = ApiRoute) -> None:
        super().__init__(prefix=API_PREFIX, tags=[tag], route_class=route_class)

    def judge(self, path: str, summary: str) -> Callable[[_Function], _Function]:
        """Return what makes a function answer POST at a path in the threads in which answers are judged."""
        return self.call(path, summary, kind=WorkKind.GRADING)

    def call(
        self,
        path: str,
        summary: str,
        *,
        kind: WorkKind | None = None,
        answer: Any = None,
        exclude_none: bool = False,
    ) -> Callable[[_Function], _Function]:
        """Return what makes a function answer POST at a path.

        Args:
            path: below /api/v1.
            summary: of the call, for OpenAPI; the function's docstring describes it.
            kind: in whose threads it is done; left out, it takes a few milliseconds for a small body.
            answer: the answer's shape, if the function returns nothing but a response.
            exclude_none: whether fields without a value are left out of the answer.
        """

        def declare(function: _Function) -> _Function:
            hints = get_type_hints(function, include_extras=True)
            asked, told = hints["body"], _answer_in(hints["return"]) if answer is None else answer
            waits = iscoroutinefunction(function)
            prepared = "robot" in hints
            given = {name: _GIVEN[name] for name in hints if name not in ("body", "robot", "return")}

            async def endpoint(body: Any, request: ApiRequest) -> Any:
                values: dict[str, Any] = {"body": body}
                if prepared:
                    values["robot"] = await request.in_turn(partial(request.resources.robots.prepare, body))
                for name, of in given.items():
                    values[name] = of(request)
                if waits:
                    return await function(**values)
                work = partial(function, **values)
                if kind is None:
                    return await request.in_turn(work)
                return await request.resources.limiters[kind].run(work)

            endpoint.__name__, endpoint.__doc__ = function.__name__, function.__doc__
            endpoint.__annotations__ = {"body": asked, "request": ApiRequest}
            self.post(
                path,
                summary=summary,
                response_model=told,
                response_model_exclude_none=exclude_none,
                responses=problems(503) if waits or kind is not None else None,
            )(endpoint)
            return function

        return declare


def _answer_in(returned: Any) -> Any:
    """What a function returns besides responses that are written already."""
    shapes = get_args(returned) if isinstance(returned, UnionType) else (returned,)
    told = [shape for shape in shapes if not (isinstance(shape, type) and issubclass(shape, Response))]
    return Union[tuple(told)]  # noqa: UP007 - made at run time
