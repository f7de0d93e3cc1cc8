"""A platform and a service with storage on either database."""

from collections.abc import Callable, Iterator
from pathlib import Path

import pytest

from courses.storage.database import Store, open_store
from service.settings import Settings
from tests.databases import either_database
from tests.live_service import running
from tests.lti.classes import PLATFORM_SECONDS, Browser, Lms, lms_process


@pytest.fixture(scope="module", autouse=True)
def platforms_may_take_their_time() -> Iterator[None]:
    """On a busy machine the platform takes more seconds than the service gives it."""
    with pytest.MonkeyPatch.context() as patch:
        for name in ("fetching.TIMEOUT", "fetching.WHOLE_ANSWER", "memberships.LONGEST"):
            patch.setattr(f"service.lti.{name}", PLATFORM_SECONDS)
        yield


@pytest.fixture(scope="session")
def lms() -> Iterator[Lms]:
    """A platform in a process of its own; it begins anew with every service."""
    with lms_process() as started:
        yield started


@pytest.fixture(scope="module", params=["sqlite", "postgresql"])
def address(request: pytest.FixtureRequest) -> Iterator[str]:
    """Address of an empty database: "" for SQLite."""
    with either_database(request) as url:
        yield url


@pytest.fixture(params=["sqlite", "postgresql"])
def database(request: pytest.FixtureRequest) -> Iterator[str]:
    """The same, a new one for each test."""
    with either_database(request) as url:
        yield url


@pytest.fixture(scope="module")
def settings(address: str, lms: Lms, tmp_path_factory: pytest.TempPathFactory) -> Settings:
    """Settings of a service that trusts the platform's origin."""
    folder: Path = tmp_path_factory.mktemp("data")
    return Settings(storage="on", data_folder=folder, database_url=address, lti_trusted_origins=(lms.root,))


@pytest.fixture(scope="module")
def store(settings: Settings, lms: Lms) -> Iterator[Store]:
    """The service's database, with the platform written down."""
    opened = open_store(settings.database_url, settings.data_folder)
    lms.register(opened)
    yield opened
    opened.close()


@pytest.fixture(scope="module")
def service(settings: Settings, store: Store, lms: Lms) -> Iterator[str]:
    """Origin of a running service."""
    with running(settings) as origin:
        lms.control(tool=origin)
        yield origin


@pytest.fixture
def browser(lms: Lms, service: str) -> Iterator[Browser]:
    """A browser that has visited nothing."""
    opened = Browser(lms, service)
    yield opened
    opened.client.close()


@pytest.fixture
def another_browser(lms: Lms, service: str) -> Iterator[Callable[[], Browser]]:
    """Makes further browsers."""
    opened: list[Browser] = []

    def open_() -> Browser:
        opened.append(Browser(lms, service))
        return opened[-1]

    yield open_
    for browser in opened:
        browser.client.close()
