"""Answers that were made before: kept once, found by all, the oldest ones making room."""

from datetime import timedelta

import pytest
import sqlalchemy as sa

from courses.storage import prepared_answers
from courses.storage.database import Store
from courses.storage.prepared_answers import keep_prepared, prepared
from courses.storage.records import prepared_answer
from tests.courses.classroom import NOW


def test_what_was_kept_is_found_and_stays(store: Store) -> None:
    keep_prepared(store, {"a": b"\x00\xff", "b": b"2"}, NOW)
    keep_prepared(store, {"a": b"other"}, NOW)
    assert [prepared(store, address) for address in ("a", "b", "c")] == [b"\x00\xff", b"2", None]


def test_the_oldest_make_room(store: Store, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(prepared_answers, "MOST", 10)
    for minute in range(25):
        keep_prepared(store, {str(minute): b"x"}, NOW + timedelta(minutes=minute))
    with store.reading() as connection:
        left = set(connection.scalars(sa.select(prepared_answer.c.address)))
    assert left == {str(minute) for minute in range(15, 25)}
