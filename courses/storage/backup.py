"""A copy of the whole database in one file, and back: the same file for SQLite and PostgreSQL.

The file is gzipped JSON lines: the schema's revision first, then one row a line. It is taken in one
transaction, while the service runs.
"""

import gzip
import json
import os
import zlib
from collections.abc import Iterator, Mapping
from datetime import datetime
from pathlib import Path
from typing import IO, Any

import sqlalchemy as sa
from sqlalchemy.exc import SQLAlchemyError

from courses.refusals import StorageError
from courses.storage.column_types import UtcTime
from courses.storage.database import Store, newest_revision, revision_in, revisions
from courses.storage.records import metadata, prepared_answer
from courses.storage.troubles import reason_of
from kinematics.errors import Fault

FORMAT = "framewise-backup-1"
_BATCH = 500  # Rows that are in memory at a time.
_TABLES = tuple(table for table in metadata.sorted_tables if table is not prepared_answer)
"""What is copied; what was only prepared is made again where it is missing."""


def back_up(store: Store, file: Path) -> int:
    """Write every row to a file, which appears when it is complete; return how many rows there are.

    Nothing takes the place of a pipe or a device, such as /dev/stdout: the rows are written into it.

    Raises:
        StorageError: the file cannot be written.
    """
    try:
        if file.exists() and not file.is_file():
            with file.open("wb") as raw:
                return _compressed(store, raw)
        return _replaced(store, file.resolve())
    except OSError as error:
        raise _unreadable(file, error.strerror or "") from error


def _replaced(store: Store, file: Path) -> int:
    unfinished = file.with_name(file.name + ".part")
    try:
        with os.fdopen(os.open(unfinished, os.O_WRONLY | os.O_CREAT | os.O_TRUNC, 0o600), "wb") as raw:
            count = _compressed(store, raw)
            raw.flush()
            os.fsync(raw.fileno())
        unfinished.replace(file)
    finally:
        unfinished.unlink(missing_ok=True)
    return count


def _compressed(store: Store, raw: IO[bytes]) -> int:
    with gzip.open(raw, "wt", encoding="utf-8") as out:
        return _write(store, out)


def _write(store: Store, out: IO[str]) -> int:
    count = 0
    whole = {"isolation_level": "REPEATABLE READ"} if store.is_postgresql else {}
    with store.engine.connect().execution_options(**whole) as connection, connection.begin():
        out.write(json.dumps({"format": FORMAT, "revision": revision_in(connection)}) + "\n")
        for table in _TABLES:
            for row in connection.execute(sa.select(table).execution_options(yield_per=_BATCH)):
                entry = [table.name, dict(row._mapping)]
                out.write(json.dumps(entry, ensure_ascii=False, default=datetime.isoformat) + "\n")
                count += 1
    return count


def restore(store: Store, file: Path) -> int:
    """Put the rows of a backup into an empty database; return how many there are.

    A backup of an older schema is brought to this program's.

    Raises:
        StorageError: the file is not a backup, a newer program has written it, or the database is not empty.
    """
    try:
        with gzip.open(file, "rt", encoding="utf-8") as lines, store.writing() as connection:
            revision = _revision(next(lines, ""))
            _check_empty(connection)
            is_older = revision != newest_revision()
            tables = _older_tables(connection, revision) if is_older else metadata.tables
            count = 0
            for name, rows in _batches(lines, tables):
                connection.execute(sa.insert(tables[name]), rows)
                count += len(rows)
            if is_older:
                _advance(connection, "head")
            if store.is_postgresql:
                _advance_sequences(connection)
    except SQLAlchemyError as error:
        raise _unreadable(file, reason_of(error)) from error
    except (OSError, EOFError, ValueError, zlib.error) as error:
        raise _unreadable(file, getattr(error, "strerror", None) or str(error)) from error
    return count


def _revision(line: str) -> str:
    """Return the schema of a backup by its first line."""
    head = json.loads(line)
    if not isinstance(head, dict) or head.get("format") != FORMAT:
        raise ValueError(FORMAT)
    revision = str(head.get("revision"))
    if revision not in revisions():
        raise StorageError(Fault.at("schema_newer", found=revision, known=newest_revision()))
    return revision


def _older_tables(connection: sa.Connection, revision: str) -> Mapping[str, sa.Table]:
    """Make an empty database over again with an older schema, and return its relations."""
    metadata.drop_all(connection)
    sa.Table("alembic_version", sa.MetaData()).drop(connection)
    _advance(connection, revision)
    older = sa.MetaData()
    older.reflect(connection)
    for column in (column for table in older.tables.values() for column in table.c):
        if isinstance(column.type, sa.JSON):
            column.type = sa.JSON(none_as_null=bool(column.nullable))
    return older.tables


def _advance(connection: sa.Connection, target: str) -> None:
    from courses.storage.schema_history import advance  # takes memory, and few restores need it

    advance(connection, target)


def _check_empty(connection: sa.Connection) -> None:
    for table in _TABLES:
        if connection.execute(sa.select(sa.literal(1)).select_from(table).limit(1)).first() is not None:
            raise StorageError(Fault.at("storage_not_empty", table=table.name))


def _batches(
    lines: Iterator[str], tables: Mapping[str, sa.Table]
) -> Iterator[tuple[str, list[dict[str, Any]]]]:
    name, rows = "", list[dict[str, Any]]()
    for number, line in enumerate(lines, 2):
        try:
            table, values = json.loads(line)
            row = _read(tables[table], values)
        except (ValueError, KeyError, TypeError, AttributeError) as error:
            raise ValueError(f"line {number}: {type(error).__name__}") from error
        if rows and (table != name or len(rows) >= _BATCH):
            yield name, rows
            rows = []
        name = table
        rows.append(row)
    if rows:
        yield name, rows


def _read(table: sa.Table, values: dict[str, Any]) -> dict[str, Any]:
    return {
        name: datetime.fromisoformat(value)
        if value is not None and isinstance(table.c[name].type, UtcTime | sa.DateTime)
        else value
        for name, value in values.items()
    }


def _advance_sequences(connection: sa.Connection) -> None:
    """Let new ids follow those that were restored."""
    for table in metadata.sorted_tables:
        if "id" in table.c:
            largest = sa.select(sa.func.max(table.c.id)).scalar_subquery()
            sequence = sa.func.pg_get_serial_sequence(f'"{table.name}"', "id")
            connection.execute(sa.select(sa.func.setval(sequence, sa.func.coalesce(largest, 1))))


def _unreadable(file: Path, reason: str) -> StorageError:
    return StorageError(Fault.at("backup_unreadable", file=str(file), reason=reason))
