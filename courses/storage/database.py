"""The database: opened, brought to this program's schema under a lock, and used in transactions.

SQLite keeps a file in a data folder (WAL, every commit flushed to the disk); PostgreSQL is named by its URL.
A transaction that was committed survives the end of the process, however it ends.
"""

import fcntl
import logging
import os
import secrets
from collections.abc import Iterator
from contextlib import contextmanager, nullcontext
from datetime import UTC, datetime
from pathlib import Path

import sqlalchemy as sa
from sqlalchemy.exc import SQLAlchemyError

from courses.refusals import StorageError, StorageUnavailableError
from courses.storage.engines import ALONE, BUSY_SECONDS, WRITES, bound_connections, postgresql, sqlite
from courses.storage.records import one_time_code
from courses.storage.troubles import TROUBLES, is_trouble, reason_of, was_undone
from courses.storage.turns import Turns
from kinematics.errors import Fault

MIGRATIONS = Path(__file__).resolve().parent / "migrations"
_REVISION = sa.table("alembic_version", sa.column("version_num"))  # Where Alembic notes what it has applied.
FILE_NAME = "framewise.sqlite"
_LOCK = 0x6672616D65776973  # "framewis", the advisory lock of migrations on PostgreSQL
_TRIED_BYTES = 65_536  # What is written to see whether there is room again: more than most attempts take.
_log = logging.getLogger("framewise.storage")


class Store:
    """An open database.

    Attributes:
        engine: SQLAlchemy's.
        file: the SQLite file; None for PostgreSQL.
        takes_writes: whether nothing was refused since a trial last found room.
    """

    def __init__(self, engine: sa.Engine, file: Path | None) -> None:
        self.engine, self.file = engine, file
        self.takes_writes = True
        self._inode = _inode(file) if file else None
        self._turns = Turns(file.with_suffix(".turns"), BUSY_SECONDS) if file else None

    @property
    def location(self) -> str:
        """Where the data is, without a password."""
        return str(self.file) if self.file else self.engine.url.set(query={}).render_as_string()

    @property
    def is_postgresql(self) -> bool:
        """Whether rows can be locked one by one."""
        return self.engine.dialect.name == "postgresql"

    def bound_answers(self) -> None:
        """Give up from now on where PostgreSQL keeps silent; migrations and backups may take longer."""
        if self.is_postgresql:
            self.engine.dispose()
            bound_connections(self.engine)

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
        alone = {"isolation_level": "AUTOCOMMIT"} if self.is_postgresql else {ALONE: True}
        with _answering(), self.engine.connect() as connection:
            yield connection.execution_options(**alone)

    @contextmanager
    def writing(self) -> Iterator[sa.Connection]:
        """Open a transaction that changes something; on SQLite there is one at a time."""
        self._check_file()
        try:
            turn = self._turns.taken() if self._turns else nullcontext()
            with _answering(), turn, self.engine.connect() as connection:
                connection = connection.execution_options(**{WRITES: True})
                with connection.begin():
                    yield connection
                    self._check_file()
        except StorageUnavailableError as error:
            self.takes_writes = self.takes_writes and not error.is_gone
            raise

    def check(self) -> None:
        """Make sure that the database answers, and that it takes something again if it once did not.

        What changes little or nothing is stored on a full disk, too, and says nothing of the next attempt.

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
        self.takes_writes = True

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
        if self._turns:
            self._turns.close()


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
        StorageUnavailableError: the database is gone, full, read-only, damaged or overrun.
    """
    try:
        yield
    except TROUBLES as error:
        if not is_trouble(error):
            raise
        _log.error("the database does not answer: %s", reason_of(error))
        raise StorageUnavailableError(is_gone=not was_undone(error)) from error


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
        return Store(postgresql(url), None)
    try:
        folder.mkdir(parents=True, exist_ok=True)
        (folder / FILE_NAME).open("a").close()
        (folder / FILE_NAME).chmod(0o600)
        return Store(sqlite((folder / FILE_NAME).resolve()), (folder / FILE_NAME).resolve())
    except OSError as error:
        fault = Fault.at("storage_folder", folder=str(folder), reason=error.strerror or "")
        raise StorageError(fault) from error


def migrate(store: Store) -> None:
    """Apply what the database lacks of the schema's history.

    Raises:
        StorageError: the database's schema is not in this program's history.
    """
    with store.writing() as connection:
        if revision_in(connection) == newest_revision():
            return
        from courses.storage.schema_history import advance  # few starts need what it takes

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
        file = store.file.with_suffix(".lock")
        file.touch()
        file.chmod(0o600)  # whoever could read it could lock it, and keep the service from starting
        with file.open("w") as lock:
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


def _unusable(store: Store, error: BaseException | None) -> StorageError:
    return StorageError(Fault.at("storage_unusable", location=store.location, reason=reason_of(error)))


def _missing(location: str) -> StorageError:
    return StorageError(Fault.at("storage_missing", location=location))
