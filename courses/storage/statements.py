"""Statements that SQLite and PostgreSQL write alike, and SQLAlchemy writes twice."""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import fields
from functools import cache, lru_cache
from importlib import import_module
from typing import Any, TypeVar, cast

import sqlalchemy as sa

Record = TypeVar("Record")


def insert_once(connection: sa.Connection, table: sa.Table, values: Mapping[str, Any]) -> bool:
    """Insert a row unless one with its key is there; return whether it was inserted."""
    statement = _insert(connection.dialect.name, table).values(values).on_conflict_do_nothing()
    return connection.execute(statement.returning(sa.literal(1))).first() is not None


def insert_all_once(connection: sa.Connection, table: sa.Table, rows: Sequence[Mapping[str, Any]]) -> None:
    """Insert the rows whose keys are not there yet."""
    connection.execute(
        _insert(connection.dialect.name, table).on_conflict_do_nothing(), [dict(row) for row in rows]
    )


def upsert(
    connection: sa.Connection,
    table: sa.Table,
    key: Mapping[str, Any],
    values: Mapping[str, Any],
    otherwise: Mapping[str, Any] | None = None,
) -> sa.Row[Any]:
    """Insert a row, or change the one that has its key; return its primary key.

    The key is columns under a unique constraint; a new row also holds what `otherwise` says.
    """
    statement = _insert(connection.dialect.name, table).values({**(otherwise or {}), **values, **key})
    statement = statement.on_conflict_do_update(index_elements=list(key), set_=dict(values or key))
    return connection.execute(statement.returning(*table.primary_key)).one()


def _nothing(_: Any) -> Mapping[str, Any]:
    return {}


def upsert_all(
    connection: sa.Connection,
    table: sa.Table,
    key: Sequence[str],
    rows: Sequence[Mapping[str, Any]],
    changed: Callable[[Any], Mapping[str, Any]] = _nothing,
) -> None:
    """Insert rows, or change those that have their keys.

    The key is columns under a unique constraint. All rows have the same columns; given the columns of a new
    row, `changed` says which values one that was there gets instead.
    """
    statement = _upserting(connection.dialect.name, table, tuple(key), tuple(rows[0]), changed)
    connection.execute(statement, [dict(row) for row in rows])


@lru_cache(maxsize=64)
def _upserting(
    dialect: str,
    table: sa.Table,
    key: tuple[str, ...],
    columns: tuple[str, ...],
    changed: Callable[[Any], Mapping[str, Any]],
) -> Any:
    """What `upsert_all` carries out: to write it takes ten times as long as to carry it out."""
    statement = _insert(dialect, table)
    new = {name: statement.excluded[name] for name in columns if name not in key}
    values = {**new, **changed(statement.excluded)}
    return statement.on_conflict_do_update(index_elements=list(key), set_=values)


def _insert(dialect: str, table: sa.Table) -> Any:
    """Start an INSERT of the database that is used; what the other one needs is not loaded."""
    return import_module(f"sqlalchemy.dialects.{dialect}").insert(table)


def of_student(table: sa.FromClause, link_id: Any, person_id: Any) -> sa.ColumnElement[bool]:
    """Return the condition that a row is of a link and a person: of these ids, or of another row's."""
    return sa.and_(table.c.link_id == link_id, table.c.person_id == person_id)


def filled(kind: type[Record], row: Any, **others: Any) -> Record:
    """Return a record with what a row has in the columns of its fields; others stand instead, or besides."""
    found = row._mapping
    columns = {name: found[name] for name in _names(cast(Any, kind)) if name not in others and name in found}
    return kind(**columns, **others)


@cache
def _names(kind: Any) -> tuple[str, ...]:
    return tuple(entry.name for entry in fields(kind))


def record_of(row: Any) -> dict[str, Any]:
    """Return a row by the names of its columns, which are plain text and no kind of it."""
    return {str(name): value for name, value in row._mapping.items()}
