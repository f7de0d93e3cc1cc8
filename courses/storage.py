"""The database: opened, brought to this program's schema under a lock, and used in transactions.

SQLite keeps a file in a data folder (WAL, every commit flushed to the disk); PostgreSQL is named by its URL.
A transaction that was committed survives the end of the process, however it ends.
"""

from __future__ import annotations

import fcntl
import json
import logging
import os
import secrets
import time
from collections.abc import Iterator
from contextlib import contextmanager
from datetime import UTC, datetime
from pathlib import Path
from typing import Any

import sqlalchemy as sa
from sqlalchemy import event
from sqlalchemy.exc import (
    ArgumentError,
    DisconnectionError,
    InterfaceError,
    OperationalError,
    SQLAlchemyError,
)
from sqlalchemy.exc import TimeoutError as PoolTimeoutError
from sqlalchemy.pool import ConnectionPoolEntry

from courses.records import one_time_code
from courses.refusals import StorageError, StorageUnavailableError
from kinematics.errors import Fault

MIGRATIONS = Path(__file__).resolve().parent / "migrations"
_REVISION = sa.table("alembic_version", sa.column("version_num"))
"""Where Alembic notes what it has applied."""
FILE_NAME = "framewise.sqlite"
BUSY_SECONDS = 30.0
"""How long a writer waits for another one on SQLite."""
CONNECTIONS = 16
"""Connections that stay open, and as many again under load: the threads that judge and store are fewer, and
PostgreSQL allows a hundred by default."""
_LOCK = 0x6672616D65776973  # "framewis", the advisory lock of migrations on PostgreSQL
CONNECT_SECONDS = 5
"""How long PostgreSQL may take to answer a new connection."""
TRUSTED_SECONDS = 1.0
"""A connection that was used so lately is not asked whether it still stands."""
_UNDONE = "40"
"""Class of the SQLSTATEs of a transaction that was undone for the sake of another one, such as a deadlock."""
_TRIED_BYTES = 65_536
"""What is written to see whether there is room again: more than most attempts take."""
_WRITES = "writes"
_USED = "used"
_log = logging.getLogger("framewise.storage")


class Store:
    """An open database.

    Attributes:
        engine: SQLAlchemy's.
        file: the SQLite file; None for PostgreSQL.
        takes_writes: whether the last transaction that changed something could be stored.
    """

    def __init__(self, engine: sa.Engine, file: Path | None) -> None:
        self.engine = engine
        self.file = file
        self.takes_writes = True
        self._inode = _inode(file) if file else None

    @property
    def location(self) -> str:
        """Where the data is, without a password."""
        return str(self.file) if self.file else self.engine.url.render_as_string(hide_password=True)

    @property
    def is_postgresql(self) -> bool:
        """Whether rows can be locked one by one."""
        return self.engine.dialect.name == "postgresql"

    def bound_answers(self) -> None:
        """Give up from now on where PostgreSQL keeps silent; migrations and backups may take longer."""
        if self.is_postgresql:
            self.engine.dispose()
            event.listen(self.engine, "do_connect", _connect_bounded)

    @contextmanager
    def reading(self) -> Iterator[sa.Connection]:
        """Open a transaction that sees one state of the database."""
        self._check_file()
        with _answering(), self.engine.connect() as connection, connection.begin():
            yield connection

    @contextmanager
    def asking(self) -> Iterator[sa.Connection]:
        """Open a single query, which sees one state of the database by itself: no round trip but its own."""
        self._check_file()
        with _answering(), self.engine.connect() as connection:
            yield connection.execution_options(isolation_level="AUTOCOMMIT")

    @contextmanager
    def writing(self) -> Iterator[sa.Connection]:
        """Open a transaction that changes something; on SQLite there is one at a time."""
        self._check_file()
        try:
            with _answering(), self.engine.connect() as connection:
                connection = connection.execution_options(**{_WRITES: True})
                with connection.begin():
                    yield connection
                    self._check_file()
        except StorageUnavailableError as error:
            self.takes_writes = self.takes_writes and not error.is_gone
            raise
        self.takes_writes = True

    def check(self) -> None:
        """Make sure that the database answers, and that it takes something again if it last did not.

        Raises:
            StorageUnavailableError: it does not.
        """
        with self.asking() as connection:
            connection.exec_driver_sql("SELECT 1")
        if not self.takes_writes:
            self._try_writing()

    def _try_writing(self) -> None:
        """Store a code that has expired, and remove it; only what is committed needs room on the disk."""
        code = secrets.token_hex()
        tried = {"purpose": "", "content": secrets.token_hex(_TRIED_BYTES // 2)}
        with self.writing() as connection:
            past = datetime.fromtimestamp(0, UTC)
            connection.execute(sa.insert(one_time_code).values(code_hash=code, expires=past, **tried))
        with self.writing() as connection:
            connection.execute(sa.delete(one_time_code).where(one_time_code.c.code_hash == code))

    def _check_file(self) -> None:
        """Make sure that the file is the one that was opened: what another name holds ends with the process.

        Raises:
            StorageUnavailableError: it was removed or replaced.
        """
        if self.file is not None and _inode(self.file) != self._inode:
            _log.error("%s was removed or replaced: put it back, or start again", self.file)
            raise StorageUnavailableError(is_gone=True)

    def close(self) -> None:
        """End every connection."""
        self.engine.dispose()


def _inode(file: Path) -> int | None:
    """Return the number of a file, whatever its name; None if there is none of this name."""
    try:
        return os.stat(file).st_ino
    except OSError:
        return None


@contextmanager
def _answering() -> Iterator[None]:
    """Refuse what failed for trouble of the database; let errors of the program through.

    Raises:
        StorageUnavailableError: the database is gone, full, read-only or overrun.
    """
    try:
        yield
    except (OperationalError, InterfaceError, DisconnectionError, PoolTimeoutError) as error:
        _log.error("the database does not answer: %s", reason_of(error))
        undone = str(getattr(getattr(error, "orig", None), "sqlstate", None)).startswith(_UNDONE)
        raise StorageUnavailableError(is_gone=not undone) from error


def open_store(url: str, folder: Path, *, only_if_there: bool = False) -> Store:
    """Open the database and bring it to the newest schema.

    Args:
        url: of a PostgreSQL database, or "" for SQLite.
        folder: where the SQLite file is or will be; made if it is not there.
        only_if_there: refuse to make a database where there is none.

    Raises:
        StorageError: it cannot be opened, is not there, or a newer program has written it.
    """
    if only_if_there and not url and not (folder / FILE_NAME).exists():
        raise _missing(str((folder / FILE_NAME).resolve()))
    store = connect(url, folder)
    try:
        with _alone(store):
            if only_if_there and not revision_of(store):
                raise _missing(store.location)
            migrate(store)
    except SQLAlchemyError as error:
        store.close()
        raise _unusable(store, error) from error
    except StorageUnavailableError as error:
        store.close()
        raise _unusable(store, error.__cause__) from error
    except StorageError:
        store.close()
        raise
    return store


def connect(url: str, folder: Path) -> Store:
    """Return a store as it is, without migration.

    Raises:
        StorageError: the address or the folder cannot be used.
    """
    if url:
        return Store(_postgresql(url), None)
    try:
        folder.mkdir(parents=True, exist_ok=True)
        (folder / FILE_NAME).open("a").close()
        (folder / FILE_NAME).chmod(0o600)
    except OSError as error:
        fault = Fault.at("storage_folder", folder=str(folder), reason=error.strerror or "")
        raise StorageError(fault) from error
    return Store(_sqlite((folder / FILE_NAME).resolve()), (folder / FILE_NAME).resolve())


def migrate(store: Store) -> None:
    """Apply what the database lacks of the schema's history.

    Raises:
        StorageError: the database's schema is not in this program's history.
    """
    with store.writing() as connection:
        if revision_in(connection) == newest_revision():
            return
        from courses.schema_history import advance  # few starts need what it takes

        advance(connection, "head")


def revisions() -> tuple[str, ...]:
    """Return the revisions of the schema, oldest first; the files of its history are named by them."""
    return tuple(sorted(path.name[1:5] for path in (MIGRATIONS / "versions").glob("r[0-9]*.py")))


def newest_revision() -> str:
    """Return the revision of this program's schema."""
    return revisions()[-1]


def revision_of(store: Store) -> str:
    """Return the revision of the database's schema; "" for an empty database."""
    with store.reading() as connection:
        return revision_in(connection)


def revision_in(connection: sa.Connection) -> str:
    """Return the revision of the schema that a transaction sees; "" for an empty database."""
    if not sa.inspect(connection).has_table(_REVISION.name):
        return ""
    return connection.scalar(sa.select(_REVISION.c.version_num)) or ""


@contextmanager
def _alone(store: Store) -> Iterator[None]:
    """One program at a time migrates: a file lock beside SQLite, an advisory lock on PostgreSQL."""
    if store.file is not None:
        with store.file.with_suffix(".lock").open("w") as lock:
            fcntl.flock(lock, fcntl.LOCK_EX)
            yield
        return
    with store.engine.connect() as connection:
        connection.execute(sa.select(sa.func.pg_advisory_lock(_LOCK)))
        connection.commit()
        try:
            yield
        finally:
            connection.execute(sa.select(sa.func.pg_advisory_unlock(_LOCK)))
            connection.commit()


def _postgresql(url: str) -> sa.Engine:
    try:
        address = sa.make_url(url)
    except ArgumentError as error:
        raise StorageError(Fault.at("storage_address")) from error
    if address.get_backend_name() not in ("postgresql", "postgres"):
        raise StorageError(Fault.at("storage_address"))
    address = address.set(drivername="postgresql+psycopg")
    engine = sa.create_engine(
        address,
        pool_size=CONNECTIONS,
        max_overflow=CONNECTIONS,
        connect_args={"connect_timeout": CONNECT_SECONDS, "client_encoding": "utf8"},
        json_serializer=_written,
    )
    event.listen(engine, "checkin", _note_use)
    event.listen(engine, "checkout", _check_idle)
    return engine


def _connect_bounded(
    _dialect: sa.Dialect, _record: ConnectionPoolEntry, arguments: tuple[Any, ...], named: dict[str, Any]
) -> Any:
    from courses import postgresql_connection  # a service on SQLite does without the driver

    return postgresql_connection.PostgresqlConnection.connect(*arguments, **named)


def _note_use(_: Any, record: ConnectionPoolEntry) -> None:
    record.info[_USED] = time.monotonic()


def _check_idle(connection: Any, record: ConnectionPoolEntry, _: Any) -> None:
    """Replace a connection that has ended while it was idle; one that was just used costs no round trip.

    Raises:
        DisconnectionError: it has ended; the pool opens another.
    """
    now = time.monotonic()
    if now - record.info.get(_USED, now) < TRUSTED_SECONDS:
        return
    try:
        connection.execute("SELECT 1")
        connection.rollback()
    except connection.Error as error:
        raise DisconnectionError from error


def _sqlite(file: Path) -> sa.Engine:
    engine = sa.create_engine(
        sa.URL.create("sqlite+pysqlite", database=str(file)),
        connect_args={"timeout": BUSY_SECONDS, "check_same_thread": False},
        pool_size=CONNECTIONS,
        max_overflow=CONNECTIONS,
        json_serializer=_written,
    )
    event.listen(engine, "connect", _prepare)
    event.listen(engine, "begin", _begin)
    return engine


def _prepare(connection: Any, _: ConnectionPoolEntry) -> None:
    """Let SQLAlchemy begin transactions itself, and flush every commit."""
    connection.isolation_level = None
    for pragma in ("journal_mode = WAL", "synchronous = FULL", "foreign_keys = ON"):
        connection.execute(f"PRAGMA {pragma}")


def _begin(connection: sa.Connection) -> None:
    """A writer takes its turn at once: a reader that turns writer could be refused."""
    immediate = connection.get_execution_options().get(_WRITES)
    connection.exec_driver_sql("BEGIN IMMEDIATE" if immediate else "BEGIN")


def _written(value: object) -> str:
    return json.dumps(value, ensure_ascii=False, separators=(",", ":"), allow_nan=False)


def _unusable(store: Store, error: BaseException | None) -> StorageError:
    params = {"location": store.location, "reason": reason_of(error)}
    return StorageError(Fault.at("storage_unusable", **params))


def _missing(location: str) -> StorageError:
    return StorageError(Fault.at("storage_missing", location=location))


def reason_of(error: BaseException | None) -> str:
    """Return what the database says in one line, without the rows that it was given."""
    return str(getattr(error, "orig", None) or type(error).__name__).splitlines()[0]
