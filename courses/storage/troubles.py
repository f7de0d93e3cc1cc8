"""What is trouble of the database, and what an error of the program: the one may pass, the other does not.

Drivers sort their errors by other lines: a server of PostgreSQL that only reads (a standby, after a failover)
or is damaged, and a damaged file of SQLite, are errors of kinds that are otherwise the program's.
"""

import sqlite3

from sqlalchemy.exc import DatabaseError, DisconnectionError, InterfaceError, OperationalError
from sqlalchemy.exc import TimeoutError as PoolTimeoutError

from courses.storage.turns import TurnError

TROUBLES = (DatabaseError, InterfaceError, DisconnectionError, PoolTimeoutError, TurnError)
"""Kinds of errors among which are all those that are trouble of the database."""
READ_ONLY = "25006"  # SQLSTATE of a PostgreSQL server that takes no writes.
_TIMED_OUT = ("25P03", "25P04")
"""Those of a transaction that the server ended because it stood still, or took too long."""
_DAMAGED = "XX"  # Class of the SQLSTATEs of a server that finds itself or its data damaged.
_UNDONE = "40"
"""Class of those of a transaction that was undone for the sake of another one, such as a deadlock."""
_DAMAGED_FILE = (sqlite3.SQLITE_CORRUPT, sqlite3.SQLITE_NOTADB)


def is_trouble(error: BaseException) -> bool:
    """Return whether one of `TROUBLES` is trouble of the database itself."""
    if not isinstance(error, DatabaseError) or isinstance(error, OperationalError):
        return True
    state = sqlstate_of(error.orig)
    damaged_file = getattr(error.orig, "sqlite_errorcode", 0) & 0xFF in _DAMAGED_FILE
    return state in (READ_ONLY, *_TIMED_OUT) or state.startswith(_DAMAGED) or damaged_file


def was_undone(error: BaseException) -> bool:
    """Return whether a transaction failed for the sake of another one, so that it may succeed at once."""
    return sqlstate_of(getattr(error, "orig", None)).startswith(_UNDONE)


def sqlstate_of(error: BaseException | None) -> str:
    """Return what PostgreSQL says of an error; "" if it says nothing."""
    return getattr(error, "sqlstate", None) or ""


def reason_of(error: BaseException | None) -> str:
    """Return what the database says in one line, without the rows that it was given."""
    return str(getattr(error, "orig", None) or type(error).__name__).splitlines()[0]
