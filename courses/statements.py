"""Statements that SQLite and PostgreSQL write alike, and SQLAlchemy writes twice."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import sqlalchemy as sa
from sqlalchemy.dialects import postgresql, sqlite


def insert_once(connection: sa.Connection, table: sa.Table, values: Mapping[str, Any]) -> bool:
    """Insert a row unless one with its key is there; return whether it was inserted."""
    statement = _insert(connection, table).values(values).on_conflict_do_nothing()
    return connection.execute(statement.returning(sa.literal(1))).first() is not None


def upsert(
    connection: sa.Connection,
    table: sa.Table,
    key: Mapping[str, Any],
    values: Mapping[str, Any],
    otherwise: Mapping[str, Any] | None = None,
) -> None:
    """Insert a row, or change the one that has its key.

    Args:
        connection: in a transaction that writes.
        table: which.
        key: columns that identify the row, under a unique constraint.
        values: what it holds from now on.
        otherwise: what a new row holds besides.
    """
    statement = _insert(connection, table).values({**(otherwise or {}), **values, **key})
    if values:
        statement = statement.on_conflict_do_update(index_elements=list(key), set_=dict(values))
    else:
        statement = statement.on_conflict_do_nothing()
    connection.execute(statement)


def _insert(connection: sa.Connection, table: sa.Table) -> Any:
    maker = postgresql.insert if connection.dialect.name == "postgresql" else sqlite.insert
    return maker(table)


def record_of(row: Any) -> dict[str, Any]:
    """A row by the names of its columns, which are plain text and no kind of it."""
    return {str(name): value for name, value in row._mapping.items()}
