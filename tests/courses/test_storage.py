"""Opening, migrating, backing up and restoring, on both databases."""

import gzip
import json
import os
import subprocess
import threading
from collections.abc import Iterator
from contextlib import ExitStack, contextmanager
from datetime import UTC, datetime
from pathlib import Path

import psycopg
import pytest
import sqlalchemy as sa
from alembic.autogenerate import compare_metadata
from alembic.migration import MigrationContext
from psycopg.errors import AdminShutdown, DeadlockDetected, SerializationFailure
from sqlalchemy.exc import IntegrityError, OperationalError

from courses.refusals import StorageError, StorageUnavailableError
from courses.storage.backup import back_up, restore
from courses.storage.column_types import WrittenJson
from courses.storage.database import Store, connect, newest_revision, open_store, revision_of
from courses.storage.records import metadata, prepared_answer
from courses.storage.schema_history import advance
from courses.teaching.statistics import class_overview
from tests.courses.classroom import attempts_of, joined, submitted
from tests.databases import new_database


def test_errors_of_the_database_do_not_tell_what_it_was_given(store: Store) -> None:
    """They are logged with their tracebacks, and rows hold names, e-mail addresses and answers."""
    joined(store)
    wrong = sa.insert(metadata.tables["person"]).values(name="Ada Lovelace", key=None)
    with store.writing() as connection, pytest.raises(IntegrityError) as caught:
        connection.execute(wrong)
    assert "INSERT INTO person" in str(caught.value)
    assert "Lovelace" not in str(caught.value).split("DETAIL")[0]


def test_what_was_read_from_json_is_stored_as_it_was_written(store: Store) -> None:
    """To write it again takes longer than to write a report in the first place."""
    text = '{"code": "é",  "residual": 1e-16}'
    details, record = WrittenJson(json.loads(text), text), metadata.tables["access"]
    entry = {"at": datetime(2026, 1, 1, tzinfo=UTC), "actor": "", "action": "test", "details": details}
    with store.writing() as connection:
        connection.execute(sa.insert(record).values(**entry))
    with store.reading() as connection:
        stored = connection.scalar(sa.select(sa.cast(record.c.details, sa.Text)))
        assert stored == text
        assert connection.scalar(sa.select(record.c.details)) == details


def test_the_history_ends_at_the_schema_of_the_program(store: Store) -> None:
    with store.reading() as connection:
        context = MigrationContext.configure(connection, opts={"compare_type": True})
        assert compare_metadata(context, metadata) == []
        assert context.get_current_revision() == newest_revision()


def test_processes_that_start_together_migrate_once(database: str, tmp_path: Path) -> None:
    opened: list[Store] = []
    threads = [
        threading.Thread(target=lambda: opened.append(open_store(database, tmp_path / "data")))
        for _ in range(4)
    ]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert len(opened) == 4
    for store in opened:
        store.close()


def test_a_newer_schema_is_refused(database: str, tmp_path: Path) -> None:
    store = open_store(database, tmp_path / "data")
    with store.writing() as connection:
        connection.execute(sa.text("UPDATE alembic_version SET version_num = '9999'"))
    store.close()
    with pytest.raises(StorageError) as caught:
        open_store(database, tmp_path / "data")
    assert caught.value.code == "schema_newer"


def test_sqlite_writes_ahead_and_flushes(tmp_path: Path) -> None:
    store = open_store("", tmp_path)
    with store.reading() as connection:
        assert connection.exec_driver_sql("PRAGMA journal_mode").scalar() == "wal"
        assert connection.exec_driver_sql("PRAGMA synchronous").scalar() == 2
        assert connection.exec_driver_sql("PRAGMA foreign_keys").scalar() == 1
    assert store.location == str((tmp_path / "framewise.sqlite").resolve())
    store.close()


def test_nobody_else_opens_what_is_stored(tmp_path: Path) -> None:
    """Any account of the machine could lock the file by which migrations wait for each other."""
    (tmp_path / "framewise.lock").touch(0o644)
    open_store("", tmp_path).close()
    assert {file.name for file in tmp_path.iterdir() if file.stat().st_mode & 0o077} == set()


def test_where_the_data_is_is_told_without_a_password() -> None:
    """The log said it at each start."""
    for address in ("postgresql://ada:lovelace@host/d", "postgresql://host/d?user=ada&password=lovelace"):
        store = connect(address, Path())
        assert "lovelace" not in store.location
        assert "host/d" in store.location


def test_a_single_query_on_sqlite_is_all_that_is_carried_out(tmp_path: Path) -> None:
    store = open_store("", tmp_path)
    carried_out: list[str] = []
    with store.asking() as connection:
        held = connection.connection.driver_connection
        assert held is not None
        held.set_trace_callback(carried_out.append)
        assert connection.scalar(sa.text("SELECT 1")) == 1
    held.set_trace_callback(None)
    assert carried_out == ["SELECT 1"]
    assert held.isolation_level is None
    store.close()


@pytest.mark.parametrize(
    ("cause", "is_gone"),
    [(DeadlockDetected("a"), False), (SerializationFailure("b"), False), (AdminShutdown("c"), True)],
)
def test_a_transaction_undone_for_another_one_is_no_database_that_is_gone(
    store: Store, cause: psycopg.Error, *, is_gone: bool
) -> None:
    with pytest.raises(StorageUnavailableError) as told, store.reading():
        raise OperationalError("", {}, cause)
    assert told.value.is_gone == is_gone


@pytest.mark.parametrize("url", ["mysql://somewhere/db", "no address", "sqlite:///x"])
def test_other_databases_are_refused(url: str, tmp_path: Path) -> None:
    with pytest.raises(StorageError) as caught:
        open_store(url, tmp_path)
    assert caught.value.code == "storage_address"


def test_a_database_that_cannot_be_reached_is_refused(tmp_path: Path) -> None:
    with pytest.raises(StorageError) as caught:
        open_store("postgresql://nobody:secret@127.0.0.1:9/none", tmp_path)
    assert caught.value.code == "storage_unusable"
    assert "secret" not in str(caught.value.faults)


def test_a_database_that_names_no_encoding_holds_every_language(postgresql: str, tmp_path: Path) -> None:
    with new_database(postgresql, "template0", "ENCODING 'SQL_ASCII' LC_COLLATE 'C' LC_CTYPE 'C'") as url:
        store = open_store(url, tmp_path)
        session = joined(store)
        answer = {"table": {"rows": [["θ₁ + π/2", "кут", "𝛼"]]}}
        submitted(store, session, 0.5, answer=answer)
        assert [attempt.answer for attempt in attempts_of(store, session)] == [answer]
        store.close()


def test_a_backup_restores_on_either_database(store: Store, postgresql: str, tmp_path: Path) -> None:
    session = joined(store)
    submitted(store, session, 0.5, answer={"table": {"rows": [["θ₁ + π/2", "\u0000", "𝛼"]]}})
    file = tmp_path / "backup.gz"
    written = back_up(store, file)
    with new_database(postgresql) as url:
        for number, address in enumerate(("", url)):
            copy = open_store(address, tmp_path / f"copy{number}")
            assert restore(copy, file) == written
            assert class_overview(copy, session.course.id) == class_overview(store, session.course.id)
            with pytest.raises(StorageError) as caught:
                restore(copy, file)
            assert caught.value.code == "storage_not_empty"
            again = joined(copy, "another", resource="link-2")
            assert again.link.id > session.link.id
            copy.close()


def test_a_file_that_is_no_backup_is_refused(store: Store, tmp_path: Path) -> None:
    file = tmp_path / "backup.gz"
    file.write_bytes(b"nothing")
    with pytest.raises(StorageError) as caught:
        restore(store, file)
    assert caught.value.code == "backup_unreadable"


def lines_of(file: Path) -> list[str]:
    with gzip.open(file, "rt", encoding="utf-8") as lines:
        return list(lines)


def written(file: Path, lines: list[str]) -> Path:
    with gzip.open(file, "wt", encoding="utf-8") as out:
        out.writelines(lines)
    return file


def test_a_damaged_backup_is_refused_without_the_rows_that_it_holds(
    store: Store, tmp_path: Path, request: pytest.FixtureRequest
) -> None:
    """What the one before had left behind would keep the next one from being looked at."""
    submitted(store, joined(store), 0.5, answer={"table": {"rows": ["what a student typed"]}})
    whole = tmp_path / "whole.gz"
    back_up(store, whole)
    lines = lines_of(whole)
    attempts = [line for line in lines if line.startswith('["attempt"')]
    damaged = {
        "twice": [*lines, attempts[-1]],
        "shape": [*lines, '["person",5]\n'],
        "value": [*lines, attempts[-1].replace('"number": 1', '"number": {}')],
        "head": ["[]\n"],
        "relation": [*lines, '["nothing",{}]\n'],
        "column": [*lines, '["secret",{"none":1}]\n'],
    }
    files = [written(tmp_path / f"{name}.gz", content) for name, content in damaged.items()]
    content = bytearray(whole.read_bytes())
    content[40:80] = bytes(40)
    files.append(tmp_path / "bytes.gz")
    files[-1].write_bytes(content)
    with empty_store(store, request, tmp_path) as empty:
        for file in files:
            with pytest.raises(StorageError) as caught:
                restore(empty, file)
            assert caught.value.code == "backup_unreadable", file.name
            assert "student" not in str(caught.value.faults), file.name
        assert restore(empty, whole) == len(lines) - 1


@contextmanager
def empty_store(store: Store, request: pytest.FixtureRequest, folder: Path) -> Iterator[Store]:
    """Another store on the same kind of database, with nothing in it."""
    with ExitStack() as stack:
        url = ""
        if store.is_postgresql:
            server, template = (request.getfixturevalue(name) for name in ("postgresql", "migrated"))
            url = stack.enter_context(new_database(server, template))
        opened = open_store(url, folder / "empty")
        yield opened
        opened.close()


def test_a_backup_of_an_older_schema_is_brought_to_this_one(
    store: Store, postgresql: str, tmp_path: Path
) -> None:
    session = joined(store)
    kept = submitted(store, session, 0.5, answer={"table": {"rows": [["θ₁ + π/2", "𝛼"]]}})
    back_up(store, tmp_path / "new.gz")
    head, *rows = lines_of(tmp_path / "new.gz")
    head = json.dumps({**json.loads(head), "revision": "0001"}) + "\n"
    file = written(tmp_path / "old.gz", [head, *(row for row in rows if '["publication"' not in row)])
    with new_database(postgresql) as url:
        copy = open_store(url if store.is_postgresql else "", tmp_path / "copy")
        assert restore(copy, file) == len(rows)
        with copy.reading() as connection:
            context = MigrationContext.configure(connection, opts={"compare_type": True})
            assert compare_metadata(context, metadata) == []
        assert revision_of(copy) == newest_revision()
        assert attempts_of(copy, session) == [kept]
        with copy.reading() as connection:
            assert connection.scalar(sa.text("SELECT count(*) FROM participation WHERE draft IS NULL")) == 1
        back_up(copy, tmp_path / "again.gz")
        assert lines_of(tmp_path / "again.gz") == lines_of(tmp_path / "new.gz")
        assert submitted(copy, joined(copy), 1.0, key="more").number == 2
        copy.close()


def test_a_backup_of_a_newer_schema_is_refused(store: Store, tmp_path: Path) -> None:
    back_up(store, tmp_path / "new.gz")
    head, *rows = lines_of(tmp_path / "new.gz")
    head = json.dumps({**json.loads(head), "revision": "9999"}) + "\n"
    with pytest.raises(StorageError) as caught:
        restore(store, written(tmp_path / "newer.gz", [head, *rows]))
    assert caught.value.code == "schema_newer"


def test_what_only_reads_makes_no_database(database: str, tmp_path: Path) -> None:
    for _ in range(2):
        with pytest.raises(StorageError) as caught:
            open_store(database, tmp_path / "data", only_if_there=True)
        assert caught.value.code == "storage_missing"
    assert not (tmp_path / "data").exists()
    open_store(database, tmp_path / "data").close()
    open_store(database, tmp_path / "data", only_if_there=True).close()


def test_a_backup_goes_into_a_pipe_and_replaces_none(store: Store, tmp_path: Path) -> None:
    submitted(store, joined(store), 0.5, answer={"table": {"rows": []}})
    pipe, received = tmp_path / "pipe", tmp_path / "received.gz"
    os.mkfifo(pipe)
    with received.open("wb") as into, subprocess.Popen(["cat", str(pipe)], stdout=into) as reader:
        written = back_up(store, pipe)
        reader.wait(timeout=60)
    assert pipe.is_fifo()
    copy = open_store("", tmp_path / "copy")
    assert restore(copy, received) == written > 0
    copy.close()


def test_a_backup_that_cannot_be_finished_leaves_nothing(
    store: Store, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def full(*_: object) -> int:
        raise OSError(28, "No space left on device")

    monkeypatch.setattr("courses.storage.backup._write", full)
    with pytest.raises(StorageError) as caught:
        back_up(store, tmp_path / "backup.gz")
    assert caught.value.code == "backup_unreadable"
    assert not list(tmp_path.glob("backup.gz*"))


def test_a_backup_goes_where_a_link_leads(store: Store, tmp_path: Path) -> None:
    link, file = tmp_path / "latest.gz", tmp_path / "monday.gz"
    link.symlink_to(file)
    back_up(store, link)
    assert link.is_symlink()
    assert file.is_file()


def test_a_backup_is_restored_beside_what_was_only_prepared(store: Store, tmp_path: Path) -> None:
    submitted(store, joined(store), 0.5, answer={"table": {"rows": []}})
    written = back_up(store, tmp_path / "backup.gz")
    copy = open_store("", tmp_path / "copy")
    with copy.writing() as connection:
        connection.execute(
            sa.insert(prepared_answer).values(address="a", content=b"a figure", made=datetime.now(UTC))
        )
    assert restore(copy, tmp_path / "backup.gz") == written
    copy.close()


@pytest.mark.parametrize("before", ["0001"])
def test_an_upgrade_keeps_what_the_version_before_has_stored(
    database: str, tmp_path: Path, before: str
) -> None:
    """A database with the schema of an earlier version, and its data, under the program of this one."""
    old = connect(database, tmp_path / "data")
    with old.writing() as connection:
        advance(connection, before)
    assert revision_of(old) == before
    session = joined(old)
    kept = submitted(old, session, 0.5, key="kept")
    old.close()
    new = open_store(database, tmp_path / "data")
    assert revision_of(new) > before
    assert attempts_of(new, session) == [kept]
    assert submitted(new, joined(new), 1.0, key="more").number == 2
    new.close()
