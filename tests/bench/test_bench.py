"""The benchmark framework: ratios, bars and the page, without measuring anything that matters."""

import asyncio
import importlib
import math
import re
import subprocess
import sys
from pathlib import Path

import httpx
import pytest

from bench import Better, Row, Skipped, measured, race
from bench.__main__ import modules
from bench.empty_endpoint import application
from bench.machine import describe
from bench.measure import SAMPLE_SECONDS, _loops
from bench.report import quantity, section, terminal, write

ROOT = Path(__file__).resolve().parents[2]


def row(ours, theirs, bar=None, better=Better.LESS):
    return Row(work="work", peer="peer", ours=ours, theirs=theirs, bar=bar, better=better)


def test_the_ratio_says_how_many_times_better_we_are():
    assert row(1.0, 3.0).ratio == 3.0
    assert row(50.0, 100.0, better=Better.MORE).ratio == 0.5
    assert row(0.0, 1.0).ratio == math.inf


@pytest.mark.parametrize(
    ("ratio", "bar", "met"), [(3.0, 2.0, True), (2.0, 2.0, True), (1.0, 2.0, False), (1.0, None, None)]
)
def test_a_bar_is_met_or_not_or_was_never_set(ratio, bar, met):
    assert row(1.0, ratio, bar).met is met


def test_a_stall_in_the_first_call_does_not_make_samples_of_one_call(monkeypatch):
    times = iter([1.0])
    monkeypatch.setattr("bench.measure._time", lambda function, loops: next(times, 1e-6))
    assert _loops(lambda: None) * 1e-6 >= SAMPLE_SECONDS


def test_a_race_times_everybody_and_reports_per_item():
    called = set()
    rows = race(
        "nothing",
        lambda: called.add("ours"),
        {"a": lambda: called.add("a"), "b": lambda: called.add("b")},
        bars={"a": 1e-9},
        items={"ours": 1000, "a": 10, "b": 10},
        rounds=1,
    )
    assert called == {"ours", "a", "b"}
    assert [one.peer for one in rows] == ["a", "b"]
    assert rows[0].met is True
    assert rows[1].met is None
    assert rows[0].ours == rows[1].ours > 0


@pytest.mark.parametrize(
    ("value", "unit", "text"),
    [
        (2.5e-8, "s", "25 ns"),
        (1.5e-6, "s", "1.5 µs"),
        (0.25, "s", "250 ms"),
        (3.0, "s", "3 s"),
        (9200.0, "requests/s", "9,200 requests/s"),
    ],
)
def test_quantities_are_readable(value, unit, text):
    assert quantity(value, unit) == text


def test_the_report_says_what_was_missed_and_what_was_skipped():
    outcomes = [row(2.0, 1.0, bar=1.0), Skipped(work="requests", reason="wrk is not installed")]
    text = terminal(outcomes)
    assert "NO" in text
    assert "wrk is not installed" in text
    page = section("name", "Title", "About.", outcomes)
    assert "| work | 2 s | peer | 1 s | 0.5 | ≥ 1 | NO |" in page
    assert "wrk is not installed" in page


def test_sections_replace_their_older_selves_and_leave_the_others(tmp_path):
    page = tmp_path / "page.md"
    write("b", section("b", "B", "First.", []), page)
    write("a", section("a", "A", "Other.", []), page)
    write("b", section("b", "B", "Second.", []), page)
    text = page.read_text(encoding="utf-8")
    assert "First." not in text
    assert text.index("## A") < text.index("## B") < text.index("Second.")
    assert text.count("<!-- bench:") == text.count("<!-- /bench:") == 2
    assert [path.name for path in tmp_path.iterdir()] == ["page.md"]


def test_the_page_begins_with_the_bars_that_are_not_met(tmp_path):
    page = tmp_path / "page.md"
    write("a", section("a", "An A, first", "About.", [row(2.0, 1.0, bar=1.0), row(0.5, 1.0, bar=1.0)]), page)
    head = page.read_text(encoding="utf-8").partition("<!-- bench:a -->")[0]
    assert "| [An A, first](#an-a-first) | `make bench ONLY=a` | 1 | 1 |" in head
    assert "- [An A, first](#an-a-first): work: 2 s" in head
    assert "500 ms" not in head


def test_the_machine_is_described_without_being_named():
    facts = describe()
    assert "CPython" in facts
    assert not re.search(r"/|\\|\.local|" + re.escape(__import__("socket").gethostname()), facts)


@pytest.mark.parametrize("name", modules())
def test_every_module_can_be_listed_without_its_peers(name):
    """A module imports its peers when it measures, so that this environment, which has none, can load it."""
    module = importlib.import_module(f"bench.bench_{name}")
    assert module.TITLE
    assert module.ABOUT.strip()
    assert callable(module.rows)


def test_an_unknown_module_is_refused_with_the_known_ones():
    done = subprocess.run(
        [sys.executable, "-m", "bench", "nonsense"], cwd=ROOT, capture_output=True, text=True, check=False
    )
    assert done.returncode == 2
    assert "forward" in done.stderr


def test_measured_rows_carry_their_unit():
    one = measured(
        "load", peer="empty endpoint", ours=70.0, theirs=100.0, unit="requests/s", better=Better.MORE, bar=0.6
    )
    assert one.met is True
    assert one.unit == "requests/s"


@pytest.mark.parametrize("path", ["/empty", "/bare"])
def test_the_endpoints_that_do_nothing_answer(path):
    """The service starts with them in a process of its own, where nobody sees why it did not."""

    async def answer() -> object:
        transport = httpx.ASGITransport(app=application())
        async with httpx.AsyncClient(transport=transport, base_url="http://here") as client:
            return (await client.post(path, json={})).json()

    assert asyncio.run(answer()) == {}
