"""Settings: every limit and every choice of the operator, from the environment (`FRAMEWISE_…`)."""

from __future__ import annotations

import os
import re
from enum import StrEnum
from ipaddress import ip_network
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Literal, Self

from pydantic import (
    Field,
    NonNegativeInt,
    PositiveFloat,
    PositiveInt,
    SecretStr,
    ValidationInfo,
    field_validator,
    model_validator,
)
from pydantic_settings import BaseSettings, NoDecode, SettingsConfigDict

from service.logs import LogFormat

if TYPE_CHECKING:
    from kinematics.cells import Limits

KIB = 1024
MIB = 1024 * KIB

_PORT = r"(6553[0-5]|655[0-2]\d|65[0-4]\d\d|6[0-4]\d{3}|[1-5]?\d{1,4})"
_HOST = r"(\*\.)?[A-Za-z0-9-]+(\.[A-Za-z0-9-]+)*"
_ORIGIN = re.compile(rf"\*|null|https?://({_HOST}|\[[0-9A-Fa-f:.]+\])(:{_PORT})?")
_ANCESTOR = re.compile(
    rf"'self'|'none'|\*|https?:|(?!(self|none)$)(https?://)?({_HOST}|\[[0-9A-Fa-f:.]+\])(:({_PORT}|\*))?/?"
)
"""A source of a policy; self and none without quotation marks would be hosts of these names."""
PREFIX = re.compile(r"(/(?!\.{1,2}(/|$))[A-Za-z0-9._~-]+)+")
"""A path under which a proxy may serve: nothing in it needs an escape, or is resolved by who calls."""
_NAMED = rf"([A-Za-z0-9_-]+(\.[A-Za-z0-9_-]+)*|\[[0-9A-Fa-f:.]+\])(:{_PORT})?"
_LISTENING = re.compile(r"[A-Za-z0-9_-]+(\.[A-Za-z0-9_-]+)*|[0-9A-Fa-f:.]*:[0-9A-Fa-f:.]*(%[A-Za-z0-9._-]+)?")
_CALLED = re.compile(_NAMED)
_PLATFORM = re.compile(f"https?://{_NAMED}/?")
_PUBLIC = re.compile(f"https?://{_NAMED}({PREFIX.pattern})?/?")
_DATABASE = re.compile(r"postgres(ql)?(\+[a-z0-9]+)?://\S*")
_COLLECTOR = re.compile(r"https?://[^/\s]+\S*")
_SECRET_ADDRESSES = {
    "database_url": (_DATABASE, "postgresql://user:password@host/database"),
    "traces": (_COLLECTOR, "http://collector:4318/v1/traces"),
}
_LISTS = {
    "frame_ancestors": (_ANCESTOR, "'self', 'none' or an origin such as https://a.example"),
    "cors_origins": (_ORIGIN, "*, null, or an origin such as https://a.example"),
    "lti_trusted_origins": (_PLATFORM, "an origin such as https://lms.example"),
    "callback_hosts": (_CALLED, "a host such as lms.example, or lms.example:8443"),
}
"""What each entry of these lists must be, as a pattern and in words."""
LONGEST_DAYS = 36_500
"""A hundred years: what is kept longer is kept for ever."""

LONGEST_SECONDS = 86_400
"""A day: longer times are no limits, and timers of the system do not take infinity."""
LARGEST_MEMORY = 1 << 60
"""Bytes: more than any machine has, and few enough for a limit of the system."""
MOST_WORKERS = 1024
"""Processes: more than the cores of one machine, and few enough for it to start them all."""
LONGEST_NUMBER = 1000
"""Digits: a few milliseconds to read, and less than Python converts at all (4300)."""
Seconds = Annotated[float, Field(gt=0, le=LONGEST_SECONDS)]
Names = Annotated[tuple[str, ...], NoDecode]


class Publishers(StrEnum):
    """Who may publish exercises on this service, where it has storage.

    ANYONE: whoever opens the page or calls the API.
    STAFF: staff of a course, signed in or choosing an exercise for it, and keys with the scope publish.
    KEY: keys with the scope publish.
    NOBODY: nobody; exercises come in the operator's folders.
    """

    ANYONE = "anyone"
    STAFF = "staff"
    KEY = "key"
    NOBODY = "nobody"


class Settings(BaseSettings):
    """Everything that may differ between two installations.

    Read from environment variables with the prefix `FRAMEWISE_`; lists are separated by spaces or commas.
    """

    model_config = SettingsConfigDict(env_prefix="FRAMEWISE_", frozen=True, extra="forbid")

    host: str = Field("127.0.0.1", description="address that the server listens on")
    port: int = Field(8000, ge=0, le=65535, description="port that the server listens on; 0 takes a free one")
    workers: int = Field(1, gt=0, le=MOST_WORKERS, description="server processes, at most 1024")
    access_log: bool = Field(False, description="log a line for each request")
    log_format: LogFormat = Field(LogFormat.TEXT, description="how the log is written: text, or json")
    metrics: Literal["on", "off"] = Field("on", description="serve Prometheus metrics at /metrics")
    traces: str = Field(
        "", description="OpenTelemetry collector (OTLP over HTTP) for traces; needs the extra telemetry"
    )
    shutdown_seconds: int = Field(
        10,
        ge=1,
        le=LONGEST_SECONDS,
        description="time for requests to finish when the server is told to stop [s]",
    )
    keep_alive_seconds: int = Field(
        75,
        ge=1,
        le=LONGEST_SECONDS,
        description="time a connection may be idle before the server closes it [s]; longer than a proxy "
        "keeps its own (nginx and AWS: 60 s), or a request may meet a connection that is being closed",
    )
    prefix: str = Field("", description="path under which a reverse proxy serves this, such as /dh")
    trusted_proxies: Names = Field(
        ("127.0.0.1",),
        description="addresses and networks (CIDR) whose X-Forwarded-Proto, -For and -Prefix headers are "
        "believed; * for all: of several addresses in -For the first is believed, whoever wrote it",
    )
    frame_ancestors: Names = Field(
        ("'self'",), description="origins that may show the pages in a frame (CSP frame-ancestors)"
    )
    cors_origins: Names = Field((), description="origins whose pages may call the API from a browser")
    static_directory: Path | None = Field(None, description="folder of the web form; none: the packaged one")

    body_limit: PositiveInt = Field(1 * MIB, description="largest request body [byte]")
    batch_body_limit: PositiveInt = Field(
        32 * MIB, description="largest request body of a call that takes batches [byte]"
    )
    read_seconds: Seconds = Field(
        10.0, description="time that a body may take to arrive, and a second more for each 16 KiB of it [s]"
    )
    batch_limit: PositiveInt = Field(200_000, description="most configurations in one request")
    batch_threads: int = Field(
        2, gt=0, le=MOST_WORKERS, description="batches that are computed at the same time, at most 1024"
    )
    batch_queue: NonNegativeInt = Field(64, description="batches that may wait for their turn")
    row_limit: int = Field(64, ge=1, le=256, description="most rows of a DH table, at most 256")
    parameter_limit: PositiveInt = Field(64, description="most different parameters of a DH table")
    cell_characters: PositiveInt = Field(200, description="longest expression in a cell [character]")
    table_characters: PositiveInt = Field(
        8192, description="length of all cells of a table together [character]"
    )
    cell_depth: int = Field(32, ge=1, le=100, description="deepest nesting of an expression, at most 100")
    cell_symbols: PositiveInt = Field(16, description="most different names in a cell")
    exponent_limit: PositiveInt = Field(16, description="largest exponent in a cell, and its denominator")
    number_digits: int = Field(
        32, ge=1, le=LONGEST_NUMBER, description="most digits of a number in a cell, at most 1000"
    )
    number_smallest: PositiveFloat = Field(
        5e-324, allow_inf_nan=False, description="smallest size of a number in a cell that is not 0"
    )
    number_largest: PositiveFloat = Field(
        1e15, allow_inf_nan=False, description="largest size of a number in a cell"
    )
    fault_limit: PositiveInt = Field(
        50, le=50, description="most faults listed in one problem document, at most 50"
    )
    table_cache: PositiveInt = Field(512, description="parsed tables in the cache")
    symbolic_workers: int = Field(
        1, gt=0, le=MOST_WORKERS, description="processes for closed forms, at most 1024"
    )
    symbolic_queue: NonNegativeInt = Field(256, description="closed forms that may wait for their turn")
    symbolic_seconds: Seconds = Field(5.0, description="processor time that one closed form may take [s]")
    queue_seconds: Seconds = Field(
        20.0, description="time that a request may wait for its turn, wherever it waits [s]"
    )
    symbolic_memory: int = Field(
        1024 * MIB,
        ge=256 * MIB,
        le=LARGEST_MEMORY,
        description="memory that one process for closed forms may take, at least 256 MiB [byte]",
    )

    storage: Literal["on", "off"] = Field(
        "on", description="store courses and attempts; off: serve only what needs no storage"
    )
    data_folder: Path = Field(Path("data"), description="folder of the SQLite file")
    database_url: str = Field(
        "", description="PostgreSQL instead of SQLite: postgresql://user:password@host/database"
    )
    public_url: str = Field(
        "",
        description="address under which browsers and platforms reach the service; none: that of the request",
    )
    lti_trusted_origins: Names = Field(
        (), description="origins of platforms that may be called although they are not public or not https"
    )
    people_days: int = Field(
        400, ge=1, le=LONGEST_DAYS, description="time to keep a person's data after their last visit [day]"
    )
    access_days: int = Field(
        400, ge=1, le=LONGEST_DAYS, description="time to keep lines of the audit log [day]"
    )

    purge: Literal["daily", "by_hand"] = Field(
        "daily", description="when older data is deleted; by_hand: by framewise people purge"
    )

    publishing: Publishers = Field(
        Publishers.ANYONE,
        description="who may publish exercises: anyone; staff of a course, and keys with the scope publish; "
        "key, such keys alone; nobody",
    )
    exercise_folders: Annotated[tuple[Path, ...], NoDecode] = Field(
        (), description="folders with your own exercises, which override packaged ones of the same id"
    )
    grading_threads: int = Field(
        2,
        gt=0,
        le=MOST_WORKERS,
        description="wrong answers that are explained at the same time, at most 1024",
    )
    grading_queue: NonNegativeInt = Field(
        4096, description="answers, figures and sign-ins that may wait for their turn, counted by kind"
    )
    explained_queue: NonNegativeInt = Field(
        64, description="waiting answers beyond which a wrong one is only told which of its rows are wrong"
    )

    secret: SecretStr | None = Field(
        None,
        min_length=32,
        description="secret of the installation, the same for all its processes: signs receipts, links and "
        "tickets of answers that are to be sent again; without it, what was signed is void after a restart",
    )
    receipt_keys: Path | None = Field(
        None, description="file of the keys that sign receipts (framewise receipts rotate), if not the secret"
    )
    api_keys: Path | None = Field(
        None, description="file of the keys with which programs call (framewise keys); none: no key needed"
    )
    cost_per_minute: NonNegativeInt = Field(
        0,
        description="cost of the calls of one key, person of a course or address in a minute; a pose is 1; "
        "0: no limit",
    )
    callback_hosts: Names = Field(
        (), description="hosts (host or host:port) to which feedback requested for later may be sent"
    )

    @property
    def calling_origins(self) -> tuple[str, ...]:
        """Origins whose pages may call the API from a browser.

        Where other sites may frame the pages, a page in a sandboxed frame may call it too: it has no origin
        of its own and calls itself "null". The API keeps nothing and reads no cookie: nothing is given away.
        """
        framed = set(self.frame_ancestors) - {"'self'", "'none'"}
        return tuple(dict.fromkeys((*self.cors_origins, *(("null",) if framed else ()))))

    @field_validator("exercise_folders", "trusted_proxies", *_LISTS, mode="before")
    @classmethod
    def _split(cls, value: object) -> object:
        return tuple(value.replace(",", " ").split()) if isinstance(value, str) else value

    @field_validator("data_folder", mode="before")
    @classmethod
    def _named_folder(cls, value: object) -> object:
        if value == "":
            raise ValueError("a folder is needed, such as data")
        return value

    @field_validator("host")
    @classmethod
    def _listened(cls, value: str) -> str:
        return _matching(_LISTENING, value, "an address or a name, such as 127.0.0.1; 0.0.0.0 for all")

    @field_validator("prefix")
    @classmethod
    def _a_path(cls, value: str) -> str:
        trimmed = value.strip("/")
        if not trimmed:
            return ""
        return _matching(PREFIX, f"/{trimmed}", "a path of letters, digits and . _ ~ -, such as /dh")

    @field_validator("trusted_proxies")
    @classmethod
    def _addresses(cls, value: tuple[str, ...]) -> tuple[str, ...]:
        if "*" in value:
            if len(value) > 1:
                raise ValueError("* stands for every address, so it stands alone")
            return value
        for entry in value:
            ip_network(entry)  # says what is wrong, such as bits outside the mask
        return value

    @field_validator(*_LISTS)
    @classmethod
    def _each_matching(cls, value: tuple[str, ...], info: ValidationInfo) -> tuple[str, ...]:
        pattern, wanted = _LISTS[str(info.field_name)]
        for one in value:
            _matching(pattern, one, wanted)
        if "'none'" in value and len(value) > 1:  # only an ancestor may be none
            raise ValueError("'none' stands alone")
        return value

    @field_validator("database_url", "traces")
    @classmethod
    def _with_a_password(cls, value: str, info: ValidationInfo) -> str:
        """Refuse what is no address without repeating it: a password may stand in it."""
        pattern, example = _SECRET_ADDRESSES[str(info.field_name)]
        if value and not pattern.fullmatch(value):
            raise ValueError(f"this is not an address such as {example}")
        return value

    @field_validator("public_url")
    @classmethod
    def _an_address(cls, value: str) -> str:
        return _matching(_PUBLIC, value, "an address such as https://a.example/dh") if value else ""

    @field_validator("static_directory")
    @classmethod
    def _a_folder(cls, value: Path | None) -> Path | None:
        if value is not None and not (value / "js").is_dir():
            shown = os.fsencode(value).decode(errors="replace")
            raise ValueError(f"{shown} is no folder of the web form: it has no folder js")
        return value

    @model_validator(mode="after")
    def _limits_agree(self) -> Self:
        if self.batch_body_limit < self.body_limit:
            raise ValueError("FRAMEWISE_BATCH_BODY_LIMIT is below FRAMEWISE_BODY_LIMIT")
        if self.publishing is Publishers.KEY and self.api_keys is None:
            raise ValueError("FRAMEWISE_PUBLISHING=key needs FRAMEWISE_API_KEYS: nobody could publish")
        if self.number_smallest >= self.number_largest:
            raise ValueError("FRAMEWISE_NUMBER_SMALLEST is not below FRAMEWISE_NUMBER_LARGEST")
        return self

    @property
    def cell_limits(self) -> Limits:
        """The bounds on DH tables, as their reader takes them."""
        from kinematics.cells import Limits  # what looks after several servers reads no tables

        return Limits(
            rows=self.row_limit,
            table_parameters=self.parameter_limit,
            cell_characters=self.cell_characters,
            cell_depth=self.cell_depth,
            cell_symbols=self.cell_symbols,
            table_characters=self.table_characters,
            exponent=self.exponent_limit,
            digits=self.number_digits,
            smallest=self.number_smallest,
            largest=self.number_largest,
        )


def _matching(pattern: re.Pattern[str], value: str, wanted: str) -> str:
    if not pattern.fullmatch(value):
        raise ValueError(f"{value!r} is not {wanted}")
    return value
