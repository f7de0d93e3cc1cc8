"""Engines of the databases: how connections are opened and checked, and how transactions begin."""

import json
import time
from pathlib import Path
from typing import Any

import sqlalchemy as sa
from sqlalchemy import event
from sqlalchemy.engine import ExceptionContext
from sqlalchemy.exc import ArgumentError, DisconnectionError
from sqlalchemy.pool import ConnectionPoolEntry

from courses.refusals import StorageError
from courses.storage.column_types import WrittenJson
from courses.storage.troubles import READ_ONLY, sqlstate_of
from kinematics.errors import Fault

BUSY_SECONDS = 15.0
"""How long a writer on SQLite waits for its turn, and then for a program that takes no turns."""
CONNECTIONS = 16
"""Connections that stay open, and as many again under load: the threads that judge and store are fewer, and
PostgreSQL allows a hundred by default."""
CONNECT_SECONDS = 5  # How long PostgreSQL may take to answer a new connection.
TRUSTED_SECONDS = 1.0  # A connection that was used so lately is not asked whether it still stands.
WRITES = "writes"  # Option of a connection whose transactions change something.
ALONE = "alone"  # Option of a connection that asks a single query, which needs no transaction on SQLite.
_USED = "used"


def postgresql(url: str) -> sa.Engine:
    """Return the engine of a PostgreSQL database.

    Raises:
        StorageError: the address is not that of one.
    """
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
        hide_parameters=True,  # an error that is logged must not tell names and answers
    )
    event.listen(engine, "checkin", _note_use)
    event.listen(engine, "checkout", _check_idle)
    event.listen(engine, "handle_error", _leave_who_only_reads)
    return engine


def bound_connections(engine: sa.Engine) -> None:
    """Open connections to PostgreSQL from now on that give up where it keeps silent."""
    event.listen(engine, "do_connect", _connect_bounded)


def _connect_bounded(
    _dialect: sa.Dialect, _record: ConnectionPoolEntry, arguments: tuple[Any, ...], named: dict[str, Any]
) -> Any:
    from courses.storage import postgresql_connection  # a service on SQLite does without the driver

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


def _leave_who_only_reads(context: ExceptionContext) -> None:
    """Open new connections once a server takes no writes: after a failover the address leads to another."""
    if sqlstate_of(context.original_exception) == READ_ONLY:
        context.is_disconnect = True


def sqlite(file: Path) -> sa.Engine:
    """Return the engine of an SQLite file."""
    engine = sa.create_engine(
        sa.URL.create("sqlite+pysqlite", database=str(file)),
        connect_args={"timeout": BUSY_SECONDS, "check_same_thread": False},
        pool_size=CONNECTIONS,
        max_overflow=CONNECTIONS,
        json_serializer=_written,
        hide_parameters=True,
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
    """A writer takes its turn at once: a reader that turns writer could be refused.

    A query alone sees one state without.
    """
    options = connection.get_execution_options()
    if not options.get(ALONE):
        connection.exec_driver_sql("BEGIN IMMEDIATE" if options.get(WRITES) else "BEGIN")


def _written(value: object) -> str:
    if isinstance(value, WrittenJson):
        return value.text
    return json.dumps(value, ensure_ascii=False, separators=(",", ":"), allow_nan=False)
