"""Stores on both databases, and a class of students."""

import shutil
from collections.abc import Iterator
from pathlib import Path

import pytest

from courses.storage.database import FILE_NAME, Store, open_store
from tests.databases import either_database, new_database


@pytest.fixture(params=["sqlite", "postgresql"])
def database(request: pytest.FixtureRequest) -> Iterator[str]:
    """Address of an empty database: "" for SQLite."""
    with either_database(request) as url:
        yield url


@pytest.fixture(scope="session")
def migrated(postgresql: str) -> Iterator[str]:
    """Name of an empty PostgreSQL database with the newest schema."""
    with new_database(postgresql) as url:
        open_store(url, Path()).close()
        yield url.rpartition("/")[2].partition("?")[0]


@pytest.fixture(scope="session")
def migrated_file(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """An empty SQLite file with the newest schema, which takes twelve times as long to make as to copy."""
    folder = tmp_path_factory.mktemp("migrated")
    open_store("", folder).close()
    return folder / FILE_NAME


@pytest.fixture(params=["sqlite", "postgresql"])
def store(request: pytest.FixtureRequest, tmp_path: Path) -> Iterator[Store]:
    """An open, empty store."""
    if request.param == "sqlite":
        (tmp_path / "data").mkdir()
        shutil.copy(request.getfixturevalue("migrated_file"), tmp_path / "data")
        opened = open_store("", tmp_path / "data")
        yield opened
        opened.close()
        return
    server, template = (request.getfixturevalue(name) for name in ("postgresql", "migrated"))
    with new_database(server, template) as url:
        opened = open_store(url, tmp_path)
        yield opened
        opened.close()
