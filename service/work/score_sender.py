"""Sends scores to gradebooks: a few threads of each process, which take what is due from the outbox.

Several processes share the outbox: each score is leased to one of them. A process that dies loses its leases
after a minute, and another one sends what it had.
"""

import itertools
import logging
import random
import threading
import time
from collections import defaultdict
from concurrent.futures import ThreadPoolExecutor
from dataclasses import replace
from datetime import datetime, timedelta
from typing import TypeAlias
from urllib.parse import urlsplit

from sqlalchemy.exc import SQLAlchemyError

from courses.grades.outbox import (
    LINE_ITEM_GONE,
    bumped,
    delivered,
    hasten,
    keep_line_item,
    lease_scores,
    postponed,
    undeliverable,
)
from courses.model import Platform, ScoreToSend
from courses.people.platforms import platform_by_id
from courses.refusals import StorageUnavailableError
from service.course_resources import CourseResources, now
from service.lti.launch_errors import PlatformError, unreachable
from service.lti.scores import (
    Delivery,
    DeliveryReport,
    ScoreMessage,
    has_result,
    is_gone,
    line_item_for,
    post_score,
    put_off,
)
from service.work.threads import BackgroundThread

PAUSE = 1.0  # Time between two looks at the outbox [s].
LOOKS = 60  # So many looks apart, what the clock has put off is looked for.
SIMULTANEOUS = 8
"""Scores that a process sends at a time: a platform that takes 0.2 s for each then gets 40 a second."""
LONGEST_WAIT = 3600.0  # Seconds between two tries, at most.
MOST_TRIES = 40  # A platform that answers nothing useful for days is given up.
STALE_TRIES = 6  # Tries after which a score that the platform calls outdated is given up.

PATIENCE = 3.0
SILENCE = 15.0
"""A gradebook that took no score, and longer than the patience to say so, is left alone for so long [s]: else
thousands of scores that wait for it each take the time of a time-out from other platforms. One that asks for
a pause has it from all of its scores."""

_log = logging.getLogger("framewise.scores")


_Gradebook: TypeAlias = tuple[int, str]  # A platform, and one of its hosts.


class ScoreSender(BackgroundThread):
    """The sender of one process."""

    def __init__(self, resources: CourseResources, pause: float = PAUSE) -> None:
        super().__init__("scores")
        self._resources, self._pause = resources, pause
        self._threads = ThreadPoolExecutor(SIMULTANEOUS, thread_name_prefix="scores")
        self._finding: defaultdict[int, threading.Lock] = defaultdict(threading.Lock)
        self._silent: dict[_Gradebook, float] = {}

    def _run(self) -> None:
        with self._threads:
            self._send_until_stopped()

    def _send_until_stopped(self) -> None:
        for look in itertools.count(1):
            if self.stopping.wait(self._pause * random.uniform(0.75, 1.25)):  # noqa: S311
                return
            try:
                if look % LOOKS == 0:
                    hasten(self._resources.store, now())
                while not self.stopping.is_set() and self.send_due():
                    pass
            except StorageUnavailableError:
                continue  # logged where it was found; the database may be back at the next look
            except Exception:
                _log.exception("scores could not be sent")

    def send_due(self) -> int:
        """Send what is due now; return how many scores were tried."""
        items = lease_scores(self._resources.store, now(), SIMULTANEOUS)
        return len(list(self._threads.map(self.send, items)))

    def send(self, item: ScoreToSend) -> None:
        """Send one leased score, and write down what became of it."""
        try:
            report = self._heard(item)
        except (StorageUnavailableError, SQLAlchemyError):
            raise
        except Exception:  # what one platform answers must not hold up the scores of the others
            _log.exception("a score could not be sent to platform %d", item.platform_id)
            report = DeliveryReport(delivery=Delivery.LATER)
        if report.delivery is Delivery.TAKEN:
            delivered(self._resources.store, item, now())
        elif report.delivery is Delivery.REFUSED:
            undeliverable(self._resources.store, item, _problem(report))
        else:
            self._later(item, report)

    def _heard(self, item: ScoreToSend) -> DeliveryReport:
        """Send a score, unless its gradebook has kept silent a moment ago."""
        if silence := self._silence(item):
            return DeliveryReport(delivery=Delivery.LATER, retry_after=silence)
        began = time.monotonic()
        report = self._sent(item)
        if report.delivery is Delivery.LATER:
            ended = time.monotonic()
            alone = SILENCE if ended - began >= PATIENCE else 0.0
            alone = max(alone, min(report.retry_after or 0.0, LONGEST_WAIT))
            self._silent[_gradebook(item)] = max(ended + alone, self._silent.get(_gradebook(item), 0.0))
        return report

    def _silence(self, item: ScoreToSend) -> float:
        """How long the gradebook of a score is still left alone [s]."""
        return max(0.0, self._silent.get(_gradebook(item), 0.0) - time.monotonic())

    def _sent(self, item: ScoreToSend) -> DeliveryReport:
        platform = platform_by_id(self._resources.store, item.platform_id)
        try:
            line_item = item.line_item or self._found_line_item(platform, item)
        except PlatformError as error:
            return put_off(error)
        report = post_score(self._resources.services, platform, line_item, _message(item))
        if report.delivery is Delivery.STALE:
            return self._stale(platform, line_item, item)
        if item.line_items and is_gone(self._resources.services, platform, line_item, report):
            return replace(report, problem=LINE_ITEM_GONE)
        return report

    def _found_line_item(self, platform: Platform, item: ScoreToSend) -> str:
        with self._finding[platform.id]:  # two who find none would both make one
            if self._silence(item):
                raise unreachable(item.line_items or "", "silent")
            found = line_item_for(
                self._resources.services,
                platform,
                item.line_items or "",
                resource=item.resource,
                label=item.title,
                maximum=item.points,
            )
            keep_line_item(self._resources.store, item.link_id, found)
        return found

    def _stale(self, platform: Platform, line_item: str, item: ScoreToSend) -> DeliveryReport:
        """Send once more with a later timestamp; else see whether the gradebook has the score already."""
        services = self._resources.services
        later = bumped(self._resources.store, item, now())
        message = _message(later)
        report = post_score(services, platform, line_item, message)
        if report.delivery is not Delivery.STALE:
            return report
        try:
            if has_result(services, platform, line_item, message):
                return DeliveryReport(delivery=Delivery.TAKEN, status=report.status)
        except PlatformError:
            pass
        given_up = item.tries >= STALE_TRIES
        return DeliveryReport(delivery=Delivery.REFUSED if given_up else Delivery.LATER, status=report.status)

    def _later(self, item: ScoreToSend, report: DeliveryReport) -> None:
        if item.tries >= MOST_TRIES:
            undeliverable(self._resources.store, item, _problem(report))
            return
        postponed(self._resources.store, item, _problem(report), _next_try(item, report, now()))


def _gradebook(item: ScoreToSend) -> _Gradebook:
    """Where a score goes: platforms of several servers may have one that is down."""
    return item.platform_id, urlsplit(item.line_item or item.line_items or "").netloc


def _next_try(item: ScoreToSend, report: DeliveryReport, at: datetime) -> datetime:
    """Exponential back-off with jitter, and never before the platform asks for it."""
    wait = min(LONGEST_WAIT, 2.0 ** min(item.tries, 12)) * random.uniform(0.5, 1.0)  # noqa: S311
    return at + timedelta(seconds=max(wait, min(report.retry_after or 0.0, LONGEST_WAIT * 24)))


def _message(item: ScoreToSend) -> ScoreMessage:
    return ScoreMessage(
        user=item.subject,
        timestamp=item.timestamp,
        given=round(item.score * item.points, 6),
        maximum=item.points,
        submitted_at=item.submitted_at and min(item.submitted_at, item.timestamp),
    )


def _problem(report: DeliveryReport) -> str:
    """The stable code of what went wrong, with the platform's status."""
    return report.problem or (f"http_{report.status}" if report.status else "no_answer")
