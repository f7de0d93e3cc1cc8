"""What the operator watches: Prometheus metrics of one server process, or of all that share a folder.

Nothing here names a person: routes are counted by their templates, refusals by their codes.
"""

import os
import tempfile
import threading
import time
from collections.abc import Callable, Iterable, Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any

from prometheus_client import (
    CollectorRegistry,
    Counter,
    Gauge,
    Histogram,
    ProcessCollector,
    disable_created_metrics,
    generate_latest,
)
from prometheus_client.core import GaugeMetricFamily
from prometheus_client.metrics_core import Metric
from prometheus_client.multiprocess import MultiProcessCollector, mark_process_dead
from prometheus_client.registry import Collector

from courses.refusals import StorageUnavailableError
from service import __version__

if TYPE_CHECKING:
    from courses.grades.outbox import OutboxState

SHARED = "PROMETHEUS_MULTIPROC_DIR"
"""Names the folder in which the processes of one server keep their figures; the library's own variable."""
SECONDS = (0.001, 0.0025, 0.005, 0.01, 0.025, 0.05, 0.1, 0.25, 0.5, 1.0, 2.5, 5.0, 10.0, 30.0)
"""Bounds of the buckets: from a pose to the longest wait for a turn."""
OUTBOX_SECONDS = 5.0  # The outbox is asked at most so often, however often the metrics are.
UNMATCHED = "none"
METHODS = frozenset({"GET", "HEAD", "POST", "PUT", "DELETE", "OPTIONS", "PATCH"})
"""Callers may invent further ones; each would be a series of its own."""

Occupancy = Mapping[str, tuple[int, int]]  # Tasks that run and that wait, by the name of their lane.


class Metrics:
    """The metrics of one application."""

    def __init__(
        self, occupancy: Callable[[], Occupancy], outbox: "Callable[[], OutboxState] | None"
    ) -> None:
        """Make them; without storage there is no outbox."""
        disable_created_metrics()  # type: ignore[no-untyped-call]
        self._occupancy = occupancy
        self._asked = time.monotonic()
        self._registry = CollectorRegistry()
        self._outbox = OutboxCollector(outbox) if outbox else None
        own: dict[str, Any] = {"registry": self._registry}
        gauge = {**own, "multiprocess_mode": "livesum"}
        self._requests = Histogram(
            "framewise_request_seconds",
            "Time from a request's head to the end of its answer",
            ("method", "route", "status"),
            buckets=SECONDS,
            **own,
        )
        self._refusals = Counter(
            "framewise_refusals", "Requests that were refused, by the code of the problem", ("code",), **own
        )
        self._grades = Counter("framewise_grades", "Answers that were judged", ("outcome", "kept"), **own)
        self._running = Gauge("framewise_lane_running", "Tasks that are being done", ("lane",), **gauge)
        self._waiting = Gauge("framewise_lane_waiting", "Tasks that wait for a turn", ("lane",), **gauge)
        self._build = Gauge(
            "framewise_build",
            "The version that runs",
            ("version",),
            **{**gauge, "multiprocess_mode": "livemax"},
        )
        self._build.labels(__version__).set(1)
        if SHARED not in os.environ:
            ProcessCollector(registry=self._registry)

    def requested(self, method: str, route: str, status: int, seconds: float) -> None:
        """Count a request that is over; status 0 says that the caller went away before its answer."""
        self._asked = time.monotonic()
        self._requests.labels(method if method in METHODS else UNMATCHED, route, str(status)).observe(seconds)

    def refused(self, code: str) -> None:
        """Count a refusal."""
        self._refusals.labels(code).inc()

    def graded(self, *, correct: bool, score: float, kept: bool) -> None:
        """Count a judgement: right, wrong, or earning a part of its points; kept in a course, or not."""
        outcome = "right" if correct else "partial" if score > 0 else "wrong"
        self._grades.labels(outcome, "yes" if kept else "no").inc()

    @property
    def idle_seconds(self) -> float:
        """Time since the last request of this process was over [s]; none while anything runs or waits."""
        is_busy = any(running or waiting for running, waiting in self._occupancy().values())
        return 0.0 if is_busy else time.monotonic() - self._asked

    def note_occupancy(self) -> None:
        """Record what runs and waits in this process now."""
        for lane, (running, waiting) in self._occupancy().items():
            self._running.labels(lane).set(running)
            self._waiting.labels(lane).set(waiting)

    def exposition(self) -> bytes:
        """Return the figures of all processes in Prometheus's text format."""
        self.note_occupancy()
        registry = self._registry
        if folder := os.environ.get(SHARED):
            _forget_dead(Path(folder))
            registry = CollectorRegistry()
            MultiProcessCollector(registry, folder)  # type: ignore[no-untyped-call]
        told = generate_latest(registry)
        if self._outbox is not None:
            asked = CollectorRegistry()
            asked.register(self._outbox)
            told += generate_latest(asked)
        return told


class OutboxCollector(Collector):
    """Asks the database, when it is asked."""

    def __init__(self, ask: "Callable[[], OutboxState]") -> None:
        self._ask = ask
        self._lock = threading.Lock()
        self._found: OutboxState | None = None
        self._until = float("-inf")

    def collect(self) -> Iterable[Metric]:
        """Yield the state of the outbox, and whether the database answers."""
        found = self._state()
        up = "Whether the database answers, and takes what is written"
        yield GaugeMetricFamily("framewise_storage_up", up, value=0.0 if found is None else 1.0)
        if found is not None:
            waiting = "Scores that wait to be sent to gradebooks"
            yield GaugeMetricFamily("framewise_outbox_waiting", waiting, value=found.waiting)
            dead = "Scores that a platform has refused for good"
            yield GaugeMetricFamily("framewise_outbox_dead", dead, value=found.dead)
            oldest = "How long ago the oldest attempt whose score waits was handed in"
            yield GaugeMetricFamily("framewise_outbox_oldest_seconds", oldest, value=found.oldest)

    def _state(self) -> "OutboxState | None":
        with self._lock:
            if time.monotonic() >= self._until:
                try:
                    self._found = self._ask()
                except StorageUnavailableError:
                    self._found = None
                self._until = time.monotonic() + OUTBOX_SECONDS
            return self._found


def share_metrics() -> Path:
    """Give the processes that this one is going to start a folder for their figures."""
    folder = Path(os.environ.get(SHARED) or tempfile.mkdtemp(prefix="framewise-metrics-"))
    os.environ[SHARED] = str(folder)
    return folder


def _forget_dead(folder: Path) -> None:
    """Leave the gauges of processes out that have ended; their counts stay."""
    for file in folder.glob("gauge_live*_*.db"):
        process = file.stem.rpartition("_")[2]
        if process.isdecimal() and not Path(f"/proc/{process}").exists():
            mark_process_dead(int(process), str(folder))  # type: ignore[no-untyped-call]
