"""One call of the API, and what sends it, now or later."""

from abc import ABC, abstractmethod
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any, Generic, TypeAlias, TypeVar
from urllib.parse import quote

Answer = TypeVar("Answer", covariant=True)
Content = TypeVar("Content", covariant=True)
Answers = TypeVar("Answers", covariant=True)

Json: TypeAlias = dict[str, Any]
Table: TypeAlias = Mapping[str, Any]
Chain: TypeAlias = Mapping[str, Any] | str  # An SCM chain, or the id of a robot of the catalogue.


@dataclass(frozen=True, kw_only=True, slots=True)
class ApiCall:
    """One request.

    Attributes:
        method: GET or POST.
        path: path below /api/v1.
        body: JSON body, None for none.
        query: query parameters; those that are None are left out.
    """

    method: str
    path: str
    body: Json | None = None
    query: Mapping[str, str | None] = field(default_factory=dict)


class Sender(ABC, Generic[Answer, Content, Answers]):
    """What sends a call, now or later, and how calls are told it."""

    @abstractmethod
    def send(self, call: ApiCall, /) -> Answer:
        """Send a call and return its JSON.

        Raises:
            ProblemError: the service refuses.
            httpx.HTTPError: the service cannot be reached.
        """

    @abstractmethod
    def fetch(self, call: ApiCall, /) -> Content:
        """Send a call and return what comes, such as a picture or a package; raises as `send` does."""

    @abstractmethod
    def stream(self, call: ApiCall, /) -> Answers:
        """Send a call and yield its answers as they come, line by line; raises as `send` does."""

    def post(self, path: str, **members: Any) -> Answer:
        """Return the answer of any call that takes a body, by its path below /api/v1.

        Args:
            path: such as `check-inverse-kinematics`.
            members: of the body; those that are None are left out.
        """
        return self.send(posted(path, **members))

    def get(self, path: str, **query: str | None) -> Answer:
        """Return the answer of any call that takes none, by its path below /api/v1 and its query."""
        return self.send(ApiCall(method="GET", path=path, query=query))

    def _of_robot(self, path: str, robot: Table | str, **members: Any) -> Answer:
        named = {"robot": robot} if isinstance(robot, str) else {"table": dict(robot)}
        return self.post(path, **named, **members)

    def _of_chain(self, path: str, chain: Chain, **members: Any) -> Answer:
        named = {"robot": chain} if isinstance(chain, str) else {"chain": dict(chain)}
        return self.post(f"scm/{path}", **named, **members)


def posted(path: str, **members: Any) -> ApiCall:
    """Return a call with a body; members that are None are left out."""
    given = {name: value for name, value in members.items() if value is not None}
    return ApiCall(method="POST", path=path, body=given)


def step(name: str) -> str:
    """Return a name as one step of a path, whatever stands in it."""
    return quote(name, safe="")
