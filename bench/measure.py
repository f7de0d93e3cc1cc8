"""Timing of rivals side by side: interleaved, repeated, medians.

A bare number of seconds says more about the machine than about the program. So every row of a benchmark holds
two figures that were taken in one process, in turns, on one thread, and the ratio of the two.
"""

import gc
import statistics
import time
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from enum import StrEnum

ROUNDS = 15
SAMPLE_SECONDS = 0.04

Work = Callable[[], object]


class Better(StrEnum):
    """Which way a figure should go."""

    LESS = "less"
    MORE = "more"


@dataclass(frozen=True, kw_only=True, slots=True)
class Row:
    """One line of a report: our figure, a peer's figure of the same run, and what was promised.

    Attributes:
        work: what was done.
        peer: what it is compared with.
        ours: our figure in `unit`.
        theirs: the peer's figure in `unit`.
        unit: "s" (printed as ns, µs, ms or s), or any other such as "requests/s" or "% solved".
        better: whether a smaller or a larger figure is better.
        bar: the least ratio that was promised, or None where nothing was.
    """

    work: str
    peer: str
    ours: float
    theirs: float
    unit: str = "s"
    better: Better = Better.LESS
    bar: float | None = None

    @property
    def ratio(self) -> float:
        """How many times better than the peer: 2 is twice as fast (or twice as many), 0.5 half as fast."""
        top, bottom = (self.theirs, self.ours) if self.better is Better.LESS else (self.ours, self.theirs)
        return top / bottom if bottom else float("inf")

    @property
    def met(self) -> bool | None:
        """Whether the bar was reached; None where there is none."""
        return None if self.bar is None else self.ratio >= self.bar


@dataclass(frozen=True, kw_only=True, slots=True)
class Skipped:
    """Work that could not be measured here, and why."""

    work: str
    reason: str


Outcome = Row | Skipped


def race(
    work: str,
    ours: Work,
    peers: Mapping[str, Work],
    *,
    bars: Mapping[str, float] | None = None,
    items: Mapping[str, int] | int = 1,
    rounds: int = ROUNDS,
) -> list[Outcome]:
    """Time our way and the peers' ways of doing the same work, in turns.

    Args:
        work: what is done, for the report.
        ours: does it our way.
        peers: does it the peers' way, by the peer's name.
        bars: the least ratio (peer's time / our time) that is promised against a peer.
        items: how many items one call handles; the times reported are per item. By name ("ours" for our own)
            where they differ, for a peer too slow to be given all of them.
        rounds: how many samples each gets; the median counts.

    Returns:
        One row per peer.
    """
    contestants: dict[str, Work] = {"ours": ours, **peers}
    loops = {name: _loops(function) for name, function in contestants.items()}
    samples: dict[str, list[float]] = {name: [] for name in contestants}
    names = list(contestants)
    gc.collect()
    gc.disable()
    try:
        for turn in range(rounds):
            shift = turn % len(names)
            for name in names[shift:] + names[:shift]:
                samples[name].append(_time(contestants[name], loops[name]))
    finally:
        gc.enable()
    count = items if isinstance(items, Mapping) else dict.fromkeys(names, items)
    times = {name: statistics.median(values) / count.get(name, 1) for name, values in samples.items()}
    bars = bars or {}
    return [
        Row(work=work, peer=peer, ours=times["ours"], theirs=times[peer], bar=bars.get(peer))
        for peer in peers
    ]


def measured(
    work: str, *, peer: str, ours: float, theirs: float, unit: str, better: Better, bar: float | None = None
) -> Row:
    """A row whose figures were taken elsewhere: requests per second by a load tool, a share of cases."""
    return Row(work=work, peer=peer, ours=ours, theirs=theirs, unit=unit, better=better, bar=bar)


def _loops(function: Work) -> int:
    """How many calls fill one sample; the calls made to find out warm everything up.

    The faster of two tries counts: a stall in the first call alone would make a sample of one call.
    """
    loops = 1
    while True:
        seconds = min(_time(function, loops), _time(function, loops)) * loops
        if seconds >= SAMPLE_SECONDS:
            return loops
        loops = max(loops + 1, min(loops * 10, int(loops * 1.2 * SAMPLE_SECONDS / max(seconds, 1e-9))))


def _time(function: Work, loops: int) -> float:
    start = time.perf_counter()
    for _ in range(loops):
        function()
    return (time.perf_counter() - start) / loops
