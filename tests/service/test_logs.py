"""The log repeats no row that a database refused and no secret, and is written in one way."""

import json
import logging.config
from collections.abc import Iterator

import pytest

from service.logs import JsonFormatter, LogFormat, TextFormatter, log_configuration
from service.settings import Settings

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


@pytest.fixture
def logging_as_it_was() -> Iterator[None]:
    """What a configuration changes of Python's logging, undone."""
    root = logging.getLogger()
    handlers, level = root.handlers[:], root.level
    named = {name: logging.getLogger(name) for name in ("uvicorn", "framewise", "service")}
    before = {name: (each.handlers[:], each.level, each.propagate) for name, each in named.items()}
    yield
    root.handlers[:] = handlers
    root.setLevel(level)
    for name, each in named.items():
        each.handlers[:], each.level, each.propagate = before[name]


def test_what_a_library_says_is_a_line_like_others_and_holds_no_query(
    logging_as_it_was: None, capfd: pytest.CaptureFixture[str]
) -> None:
    """A collector that was away left lines that were no JSON, with its token in them."""
    logging.config.dictConfig(log_configuration(Settings(log_format=LogFormat.JSON)))
    library = logging.getLogger("opentelemetry.exporter")
    library.warning("Transient error at port=%d: url: /v1/traces?token=secret (Caused by X)", 9119)
    library.info("not worth a line")
    (line,) = capfd.readouterr().err.splitlines()
    told = json.loads(line)
    assert told["message"] == "Transient error at port=9119: url: /v1/traces (Caused by X)"
    assert (told["level"], told["logger"]) == ("warning", "opentelemetry.exporter")
