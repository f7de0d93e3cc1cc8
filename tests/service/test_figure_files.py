"""Figures under addresses made from what they show: shared, and the same for ever."""

import threading
import time
import zlib
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from pathlib import Path
from typing import Any
from unittest.mock import patch

import httpx
import pytest
import sqlalchemy as sa

from courses.storage.database import Store, open_store
from courses.storage.records import prepared_answer
from exercises.instance import generate
from exercises.library import packaged
from service.settings import Settings
from service.wire import answer_cache
from service.wire.exercises import figure_files
from service.work import limiters
from service.work.shared_answers import SharedAnswers
from service.work.workers import Workers
from tests.live_service import running
from tests.lti.classes import eventually

API = "/api/v1"
SOON = 0.2
"""Time after which a request that waits for its turn is refused [s]."""


@dataclass
class Sharing:
    """Two services on one database."""

    first: httpx.Client
    second: httpx.Client
    store: Store

    def wait(self, count: int) -> None:
        """Until so many answers have been written down."""
        wanted = sa.select(sa.func.count()).select_from(prepared_answer)

        def enough() -> bool:
            with self.store.reading() as connection:
                return (connection.scalar(wanted) or 0) >= count

        assert eventually(enough)


@pytest.fixture
def shared(tmp_path: Path) -> Iterator[Sharing]:
    settings = Settings(storage="on", data_folder=tmp_path)
    store = open_store("", tmp_path)
    with (
        running(settings) as one,
        running(settings) as other,
        httpx.Client(base_url=one, trust_env=False, timeout=120) as first,
        httpx.Client(base_url=other, trust_env=False, timeout=120) as second,
    ):
        yield Sharing(first, second, store)
    store.close()


def test_the_exercise_tells_an_address_that_caches_keep(client: httpx.Client) -> None:
    told = client.get(f"{API}/exercises/puma560", params={"seed": "ada"}).json()["figure"]["file"]
    answer = client.get(f"{API}/{told}")
    assert answer.headers["cache-control"] == "public, max-age=31536000, immutable"
    assert answer.content == client.get(f"{API}/exercises/puma560/figure.svg?seed=ada").content
    plain = client.get(f"{API}/{told}", headers={"Accept-Encoding": "identity"})
    assert "content-encoding" not in plain.headers
    assert plain.content == answer.content
    again = client.get(f"{API}/{told}", headers={"If-None-Match": answer.headers["etag"]})
    assert again.status_code == 304


def test_the_page_loads_the_figure_from_that_address(client: httpx.Client) -> None:
    told = client.get(f"{API}/exercises/scara?seed=ada&lang=fr").json()["figure"]["file"]
    page = client.get("/exercises/scara?seed=ada&lang=fr").text
    assert f'src="../api/v1/{told.partition("?")[0]}?' in page
    assert client.get(f"/exercises/scara?seed={'x' * 300}").status_code == 200


def test_who_opens_an_exercise_is_not_refused_while_figures_are_drawn(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """Pages stood behind the figures of others, and all were refused who had waited for long."""
    monkeypatch.setattr(limiters, "LIGHT", float("inf"))
    drawn, draw = threading.Event(), figure_files.figure_drawing

    def slowly(*what: Any) -> Any:
        drawn.wait()
        return draw(*what)

    def asked(path: str) -> int:
        return client.get(path).status_code

    with (
        running(Settings(storage="off", queue_seconds=SOON)) as origin,
        httpx.Client(base_url=origin, trust_env=False, timeout=120) as client,
        ThreadPoolExecutor() as threads,
    ):
        opened = ["/exercises/puma560?seed={}", f"{API}/exercises/puma560?seed={{}}"]
        for seed in range(limiters.TRIED):
            assert [asked(path.format(seed)) for path in opened] == [200, 200]
        monkeypatch.setattr(figure_files, "figure_drawing", slowly)
        try:
            pictures = [
                threads.submit(asked, f"{API}/exercises/puma560/figure.svg?seed={seed}") for seed in range(3)
            ]
            time.sleep(3 * SOON)
            assert [asked(path.format("late")) for path in opened] == [200, 200]
        finally:
            drawn.set()
        assert [picture.result() for picture in pictures] == [200, 200, 200]


def test_an_address_that_is_no_longer_leads_to_the_one_that_is(client: httpx.Client) -> None:
    told = client.get(f"{API}/exercises/puma560?seed=ada").json()["figure"]["file"]
    address = told.rpartition("/")[2].partition(".")[0]
    old = client.get(f"{API}/{told.replace(address, '0' * 40)}", follow_redirects=False)
    assert (old.status_code, old.headers["cache-control"]) == (307, "no-store")
    assert client.get(f"{API}/{told.replace(address, '0' * 40)}", follow_redirects=True).status_code == 200
    assert old.headers["location"] == told.rpartition("/")[2]


def test_an_address_says_what_is_drawn_and_nothing_else() -> None:
    figures = SharedAnswers("figure", None)

    def address(exercise_id: str, seed: str | None, language: str = "en") -> str:
        return figure_files.figure_address(
            figures, generate(packaged().exercise(exercise_id), seed), language
        )

    seeds = [f"s{n}" for n in range(300)]
    found = {}
    for seed in seeds:
        instance = generate(packaged().exercise("twolink"), seed)
        found.setdefault(repr(dict(instance.exact)), set()).add(address("twolink", seed))
    assert all(len(addresses) == 1 for addresses in found.values())
    assert len({next(iter(addresses)) for addresses in found.values()}) == len(found) < len(seeds)
    assert len({address("puma560", "ada", language) for language in ("en", "fr", "uk")}) == 3
    assert address("puma560", None) != address("puma560-inverse", None)


def test_what_one_process_has_drawn_another_does_not_draw(shared: Sharing) -> None:
    first, second = shared.first, shared.second
    told = first.get(f"{API}/exercises/puma560?seed=ada").json()["figure"]["file"]
    drawn = first.get(f"{API}/{told}")
    shared.wait(1)
    with patch.object(figure_files, "figure_drawing", side_effect=AssertionError("drawn again")):
        assert second.get(f"{API}/exercises/puma560?seed=ada").json()["figure"]["file"] == told
        assert second.get(f"{API}/{told}").content == drawn.content


def test_closed_forms_are_shared_however_they_are_asked_for(shared: Sharing) -> None:
    first, second = shared.first, shared.second
    one = first.post(f"{API}/symbolic", json={"robot": "scara", "notation": "short"})
    assert one.status_code == 200
    shared.wait(1)
    with patch.object(Workers, "run", side_effect=AssertionError("computed again")):
        other = second.post(
            f"{API}/symbolic",
            content=b'{ "notation" : "short", "robot" : "scara" }',
            headers={"Content-Type": "application/json"},
        )
    assert other.content == one.content


def test_memory_is_bounded_by_bytes(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(answer_cache, "TOTAL_BYTES", 10_000)
    figures = SharedAnswers("figure", None)
    for number in range(100):
        figures.keep(figures.address(str(number)), bytes(1000))
    kept = [number for number in range(100) if figures.known(figures.address(str(number)))]
    assert kept == list(range(100 - len(kept), 100))
    assert 8 <= len(kept) <= 10


def test_a_database_that_is_gone_costs_time_alone(tmp_path: Path) -> None:
    store = open_store("", tmp_path)
    figures = SharedAnswers("figure", store)
    store.close()
    (tmp_path / "framewise.sqlite").unlink()
    (tmp_path / "framewise.sqlite").mkdir()
    assert figures.stored("a" * 40) is None
    figures.keep("a" * 40, b"svg")
    figures.write_down()
    assert figures.known("a" * 40) == b"svg"
    store.close()


@pytest.mark.parametrize("language", ["en", "uk"])
def test_a_figure_put_together_from_parts_is_one_gzip_file(language: str) -> None:
    """Browsers read the first member of a gzip file and nothing after it."""
    figures, instance = SharedAnswers("figure", None), generate(packaged().exercise("puma560"), "somebody")
    reading = zlib.decompressobj(zlib.MAX_WBITS + 16)
    file = reading.decompress(figure_files.packed_figure(figures, instance, language))
    assert reading.eof
    assert not reading.unused_data
    assert file == figure_files.figure_file(instance, language)
