"""What is logged of an error says nothing of the row that a database refused."""

from __future__ import annotations

import logging

import pytest

from service.logs import JsonFormatter, TextFormatter

REFUSED = """(psycopg.errors.UniqueViolation) duplicate key value violates unique constraint "person_subject"
DETAIL:  Key (subject, name)=(ann@example.org, Ann

Lee) already exists.
[SQL: INSERT INTO person VALUES (%(subject)s)]"""


@pytest.mark.parametrize("formatter", [TextFormatter(), JsonFormatter()], ids=["text", "json"])
@pytest.mark.parametrize(
    "ending", ["", "\nHINT:  Try another.", "\n(Background on this error at: https://x)"]
)
def test_the_row_that_a_database_refused_is_not_logged(formatter: logging.Formatter, ending: str) -> None:
    error = ValueError(REFUSED + ending)
    error.__cause__ = LookupError(REFUSED.partition("\n[")[0] + ending)
    record = logging.LogRecord("service", logging.ERROR, "a.py", 1, "failed", (), (ValueError, error, None))
    logged = formatter.format(record)
    assert "Ann" not in logged
    assert "Lee" not in logged
    for kept in ("person_subject", "INSERT INTO person", ending[-6:], "The above exception", "ValueError"):
        assert kept in logged
