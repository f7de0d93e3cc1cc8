"""What is logged, and how: lines for people, or one JSON object a line for programs.

No line holds personal data: the access log has neither addresses nor queries, in which seeds name students,
and routes by their templates.
"""

import logging
import re
import time
from enum import StrEnum
from typing import TYPE_CHECKING, Any

import orjson

if TYPE_CHECKING:
    from service.settings import Settings

_access = logging.getLogger("framewise.access")
_DETAIL = re.compile(
    r"\n[ |]*DETAIL:.*?"
    r"(?=\n[ |]*(\[SQL: |HINT:|CONTEXT:|\(Background on|\n[ |]*(The above|During handling))|\Z)",
    re.DOTALL,
)
"""What PostgreSQL says of the row that it refused, as far as another line of the error follows."""
_QUERY = re.compile(r"(?<=[/\w])\?[^\s)\"'=]+=[^\s)\"']*")
_STANDARD = frozenset(vars(logging.makeLogRecord({}))) | {"message", "asctime", "color_message"}


class LogFormat(StrEnum):
    """How a line of the log is written."""

    TEXT = "text"
    JSON = "json"


class _Formatter(logging.Formatter):
    def formatException(self, ei: Any) -> str:
        """Write a stack trace without the row that a database refused: it may say who handed in what."""
        return _DETAIL.sub("", super().formatException(ei))


class TextFormatter(_Formatter):
    """Time in UTC, level, logger and message."""

    def __init__(self) -> None:
        super().__init__("{asctime}.{msecs:03.0f}Z {levelname} {name}: {message}", "%Y-%m-%dT%H:%M:%S", "{")
        self.converter = time.gmtime


class WithoutQueries(logging.Filter):
    """Takes the queries off the addresses that libraries write, such as a collector's: they may be secret."""

    def filter(self, record: logging.LogRecord) -> bool:
        """Change a record."""
        record.msg, record.args = _QUERY.sub("", record.getMessage()), None
        return True


class JsonFormatter(_Formatter):
    """One object a line; what a message is made with are members of its own."""

    def format(self, record: logging.LogRecord) -> str:
        """Write a record."""
        moment = time.strftime("%Y-%m-%dT%H:%M:%S", time.gmtime(record.created))
        entry: dict[str, object] = {
            "time": f"{moment}.{record.msecs:03.0f}Z",
            "level": record.levelname.lower(),
            "logger": record.name,
            "message": record.getMessage(),
            **{name: value for name, value in vars(record).items() if name not in _STANDARD},
        }
        if record.exc_info:
            entry["exception"] = self.formatException(record.exc_info)
        return orjson.dumps(entry, default=str).decode()


def log_configuration(settings: "Settings") -> dict[str, Any]:
    """Return the configuration of Python's logging, as `logging.config.dictConfig` takes it."""
    formatter = {LogFormat.TEXT: TextFormatter, LogFormat.JSON: JsonFormatter}[settings.log_format]
    return {
        "version": 1,
        "disable_existing_loggers": False,
        "formatters": {"line": {"()": formatter}},
        "filters": {"addresses": {"()": WithoutQueries}},
        "handlers": {
            "error": {"class": "logging.StreamHandler", "formatter": "line"},
            "libraries": {"class": "logging.StreamHandler", "formatter": "line", "filters": ["addresses"]},
        },
        "root": {"handlers": ["libraries"], "level": "WARNING"},
        "loggers": {
            name: {"handlers": ["error"], "level": "INFO", "propagate": False}
            for name in ("uvicorn", "framewise", "service")
        },
    }


def log_access(method: str, path: str, status: int, seconds: float, request_id: str) -> None:
    """Log a request that is over; status 0 says that the caller went away before its answer.

    The path is the route's template: addresses hold pseudonyms of students, and secrets of invitations.
    """
    milliseconds = round(1000 * seconds, 2)
    _access.info(
        "%s %s %d %.2f ms, request %s",
        method,
        path,
        status,
        milliseconds,
        request_id,
        extra={
            "method": method,
            "path": path,
            "status": status,
            "milliseconds": milliseconds,
            "request_id": request_id,
        },
    )
