"""Assignment and Grade Services 2.0: scores, results and line items."""

from collections.abc import Mapping
from dataclasses import dataclass
from datetime import UTC, datetime
from enum import StrEnum
from typing import Any
from urllib.parse import urlencode, urlsplit, urlunsplit

from courses.model import Platform
from service.lti import claims as names
from service.lti.fetching import FetchedAnswer
from service.lti.launch_errors import PlatformError, TokenError, unreachable
from service.lti.services import Services

PAGES = 20  # Pages that are followed, so that a platform cannot lead round in circles.
_CLOSE = 1e-6
"""Share of the maximum within which a score that is read back is the one that was sent: it was rounded on
the way."""
LONGEST_LABEL = 100
"""Characters of a column's title that every gradebook keeps; Open edX refuses longer ones."""
_NONE = 404  # Answer of platforms that have no line item yet.
_GONE = (404, 410)  # Answers of platforms that have a line item no more.
TOKEN_REFUSED = "token_refused"  # noqa: S105
"""Stable code of a score for which the platform gives no access token: it concerns no single score."""
_UNLINKED = (400, 404, 412, 422)  # Answers of platforms whose links take no line item of ours.


class Delivery(StrEnum):
    """What became of a score."""

    TAKEN = "taken"
    LATER = "later"
    STALE = "stale"
    REFUSED = "refused"


@dataclass(frozen=True, kw_only=True, slots=True)
class ScoreMessage:
    """A score: points of so many, at a whole second."""

    user: str
    timestamp: datetime
    given: float
    maximum: float
    submitted_at: datetime | None = None

    def written(self) -> dict[str, Any]:
        """Return the message as the specification writes it.

        It is never pending: some gradebooks then forget a score.
        """
        message: dict[str, Any] = {
            "userId": self.user,
            "timestamp": _written(self.timestamp),
            "activityProgress": "Completed",
            "gradingProgress": "FullyGraded",
            "scoreGiven": self.given,
            "scoreMaximum": self.maximum,
        }
        if self.submitted_at is not None:
            message["submission"] = {"submittedAt": _written(self.submitted_at)}
        return message


@dataclass(frozen=True, kw_only=True, slots=True)
class DeliveryReport:
    """What became of a score, with the platform's status and how long it asks to be left alone [s].

    `problem` is the stable code of what went wrong, where the status does not say it.
    """

    delivery: Delivery
    status: int | None = None
    retry_after: float | None = None
    problem: str | None = None


def put_off(error: PlatformError) -> DeliveryReport:
    """Return the report of a score that the platform could not be asked to take."""
    problem = TOKEN_REFUSED if isinstance(error, TokenError) else None
    return DeliveryReport(
        delivery=Delivery.LATER, status=error.status, retry_after=error.retry_after, problem=problem
    )


def post_score(
    services: Services, platform: Platform, line_item: str, message: ScoreMessage
) -> DeliveryReport:
    """Send a score; whatever happens is a report.

    409, and 400 where a platform says so of its timestamp, mean that the platform has one that is not older.
    """
    try:
        answer = services.call(
            platform,
            names.SCORE_SCOPE,
            "POST",
            below(line_item, "scores"),
            accept="application/json",
            content=message.written(),
            content_type=names.SCORE,
        )
    except PlatformError as error:
        return put_off(error)
    return DeliveryReport(delivery=_delivery(answer), status=answer.status, retry_after=answer.retry_after)


def is_gone(services: Services, platform: Platform, line_item: str, report: DeliveryReport) -> bool:
    """Return whether a score was refused because its line item is gone: 404 may also mean its user."""
    if report.status not in _GONE:
        return False
    try:
        answer = services.call(platform, names.LINE_ITEM_SCOPE, "GET", line_item, accept=names.LINE_ITEM)
    except PlatformError:
        return False
    return answer.status in _GONE


def _delivery(answer: FetchedAnswer) -> Delivery:
    status = answer.status
    if status // 100 == 3 or _is_page(answer):
        return Delivery.LATER
    if status // 100 == 2:
        return Delivery.TAKEN
    if status in (400, 409):
        return Delivery.STALE
    rate_limited = status == 403 and answer.headers.get("x-rate-limit-remaining") in ("0", "0.0")
    if status in (401, 408, 425, 429) or status >= 500 or rate_limited:
        return Delivery.LATER
    return Delivery.REFUSED


def _is_page(answer: FetchedAnswer) -> bool:
    """Whether something before the gradebook has answered, with a page to sign in, say, or to wait."""
    is_html = answer.headers.get("content-type", "").lower().startswith(("text/html", "application/xhtml"))
    return answer.is_success and is_html and bool(answer.body.strip())


def has_result(services: Services, platform: Platform, line_item: str, message: ScoreMessage) -> bool:
    """Return whether the gradebook holds the message's score already.

    Raises:
        PlatformError: the results cannot be read.
    """
    address = _with_query(below(line_item, "results"), {"user_id": message.user})
    answer = services.call(platform, names.RESULT_SCOPE, "GET", address, accept=names.RESULTS)
    found = answer.succeeded().json()
    for result in found if isinstance(found, list) else ():
        if not isinstance(result, Mapping) or result.get("userId") != message.user:
            continue
        score, maximum = result.get("resultScore"), result.get("resultMaximum") or 1
        if isinstance(score, (int, float)) and isinstance(maximum, (int, float)):
            off = abs(score * message.maximum - message.given * maximum)
            return off <= _CLOSE * abs(maximum * message.maximum)
    return False


def line_item_for(
    services: Services, platform: Platform, line_items: str, *, resource: str, label: str, maximum: float
) -> str:
    """Return the line item of a resource: the one that is there, and a new one only if there is none.

    Creating one is not idempotent: it is always looked for first, and where the platform does not tell what
    there is, none is made. A new one names its link,
    without which Open edX never publishes its grades; where a platform refuses that, it stands alone.

    Returns:
        Address of the line item.

    Raises:
        PlatformError: the platform gives none.
    """
    page: str | None = _with_query(line_items, {"resource_id": resource})
    for _ in range(PAGES):
        if page is None:
            break
        answer = services.call(platform, names.LINE_ITEM_SCOPE, "GET", page, accept=names.LINE_ITEMS)
        if answer.status == _NONE:
            break
        found = answer.succeeded().json()
        if not isinstance(found, list):
            raise unreachable(page, "line items")
        for item in found:
            if isinstance(item, Mapping) and item.get("resourceId") == resource and item.get("id"):
                return str(item["id"])
        page = answer.next_page()
    content = {"label": (label or resource)[:LONGEST_LABEL], "scoreMaximum": maximum, "resourceId": resource}
    answer = _new_line_item(services, platform, line_items, {**content, "resourceLinkId": resource})
    if answer.status in _UNLINKED:
        answer = _new_line_item(services, platform, line_items, content)
    made = answer.succeeded().json()
    if not isinstance(made, Mapping) or not isinstance(made.get("id"), str):
        raise unreachable(line_items, "id")
    return str(made["id"])


def _new_line_item(
    services: Services, platform: Platform, line_items: str, content: Mapping[str, Any]
) -> FetchedAnswer:
    return services.call(
        platform,
        names.LINE_ITEM_SCOPE,
        "POST",
        line_items,
        accept=names.LINE_ITEM,
        content=content,
        content_type=names.LINE_ITEM,
    )


def below(address: str, name: str) -> str:
    """Return an address below another one; a query stays where it is (Moodle: `…/lineitem?type_id=1`)."""
    parts = urlsplit(address)
    return urlunsplit(parts._replace(path=f"{parts.path.rstrip('/')}/{name}"))


def _with_query(address: str, values: Mapping[str, str]) -> str:
    parts = urlsplit(address)
    return urlunsplit(parts._replace(query="&".join(filter(None, (parts.query, urlencode(values))))))


def _written(instant: datetime) -> str:
    return instant.astimezone(UTC).isoformat(timespec="milliseconds").replace("+00:00", "Z")
