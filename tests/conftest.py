"""Settings of the property tests, and what several folders share.

The default run draws the same examples every time, so that it passes or fails for everybody alike.
Exploring with fresh seeds (`make explore`) is a long search for faults; what it finds becomes an example. A
test with numbers of its own takes the smaller one here and the larger one there (`EXPLORE`).
"""

import functools
import gc
import importlib
import os
from collections.abc import Generator, Iterator
from contextlib import suppress
from pathlib import Path

import httpx
import pytest
from hypothesis import HealthCheck, settings
from hypothesis.internal.conjecture import providers

from tests.databases import postgresql_server, without_waiting_for_the_disk

# The machine that runs the tests may be busy: time is measured by the benchmarks, not by tests.
UNTIMED = settings(deadline=None, suppress_health_check=[HealthCheck.too_slow])
settings.register_profile("framewise", UNTIMED, max_examples=40, derandomize=True, database=None)
settings.register_profile("explore", UNTIMED, max_examples=300)
EXPLORE = bool(os.environ.get("FRAMEWISE_EXPLORE"))
settings.load_profile("explore" if EXPLORE else "framewise")
if not EXPLORE:
    # Hypothesis also draws numbers that stand in the modules loaded so far: which are loaded depends on the
    # tests that ran before, and with them what is drawn. Without these a test draws the same in any order.
    providers._get_local_constants = lambda: providers._local_constants


ENOUGH = 2 * 1024**3
"""Bytes that are free in memory, of which the tests' folders take some tens of millions."""


def folders_in_memory(folder: str = "/dev/shm") -> None:
    """Have pytest make its folders in memory, where there is room and programs in them may be run.

    SQLite waits for the disk at each commit, some milliseconds in which nothing is computed; no test asks for
    what a power failure leaves.
    """
    if not os.access(folder, os.W_OK):
        return
    found = os.statvfs(folder)
    if not found.f_flag & os.ST_NOEXEC and found.f_bavail * found.f_frsize >= ENOUGH:
        os.environ.setdefault("PYTEST_DEBUG_TEMPROOT", folder)


folders_in_memory()

LONG = ("web", "lti", "service", "fuzz", "kinematics", "mued")
"""Folders that start first, so that no worker is left with a long file at the end: the last files of the
others take a few seconds each."""


def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    rank = {room: place for place, room in enumerate(LONG)}
    depth = len(Path(__file__).parent.parts)
    items.sort(key=lambda item: rank.get(item.path.parts[depth], len(LONG)))


def import_from_another_end(config: pytest.Config) -> None:
    """Have the second process import all test modules from the last one on, the others from the middle on.

    They do so before they collect. In a fresh clone pytest first rewrites the asserts of each module and
    keeps the result: processes that begin at different modules find most of them done, where side by side
    each does all of it. What cannot be imported is told when it is collected.
    """
    worker = getattr(config, "workerinput", {}).get("workerid")
    if worker not in ("gw1", "gw2", "gw3"):
        return
    root = Path(__file__).parent.parent
    folders = [config.invocation_params.dir / argument for argument in config.args]
    paths = [path for folder in folders if folder.is_dir() for path in sorted(folder.rglob("test_*.py"))]
    middle = len(paths) // 2
    in_turn = {
        "gw1": reversed(paths),
        "gw2": paths[middle:] + paths[:middle],
        "gw3": reversed(paths[middle:] + paths[:middle]),
    }
    for path in in_turn[worker]:
        with suppress(Exception, pytest.skip.Exception):
            importlib.import_module(".".join(path.relative_to(root).with_suffix("").parts))


@pytest.hookimpl(wrapper=True)
def pytest_collection(session: pytest.Session) -> Generator[None, object, object]:
    """Ten thousand collected tests stay until the end: no garbage collection looks at them, then or later.

    With it, collecting takes half as long again; and looking through what was made after each 700 objects,
    the usual number, takes a twentieth of what formulas and searches of the checker cost.
    """
    gc.disable()
    import_from_another_end(session.config)
    try:
        return (yield)
    finally:
        gc.collect()
        gc.freeze()
        gc.set_threshold(50_000, 20, 20)
        gc.enable()


@pytest.fixture(scope="session", autouse=True)
def no_lane_stands_back() -> Iterator[None]:
    """On a busy machine a process that stands back behind all others starts in half a minute."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr("service.work.workers.SLOW_NICENESS", 0)
        patch.setattr("service.work.regrading_processes.NICENESS", 0)
        yield


@pytest.fixture(scope="session", autouse=True)
def workers_may_start_slowly() -> Iterator[None]:
    """On a busy machine a worker process takes longer to start than the service gives it."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr("service.work.workers.START_SECONDS", 300.0)
        yield


@pytest.fixture(scope="session", autouse=True)
def certificates_are_read_once() -> Iterator[None]:
    """Reading whom to trust costs each client 25 ms, as much as several answers."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(
            "httpx._transports.default.create_ssl_context", functools.cache(httpx.create_ssl_context)
        )
        yield


@pytest.fixture(scope="session")
def postgresql() -> Iterator[str]:
    """URL of a PostgreSQL server, which on a busy machine may take its time for a connection or an answer."""
    with postgresql_server() as url, pytest.MonkeyPatch.context() as patch:
        patch.setattr("courses.storage.engines.CONNECT_SECONDS", 120)
        patch.setattr("courses.storage.postgresql_connection._Bounded.answer_seconds", 60.0)
        without_waiting_for_the_disk(url)
        yield url
