"""Settings: every limit and every choice of the operator, from the environment (`FRAMEWISE_…`)."""

from enum import StrEnum
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Literal, Self

from pydantic import Field, NonNegativeInt, PositiveFloat, PositiveInt, SecretStr, model_validator
from pydantic_settings import BaseSettings, SettingsConfigDict

from service.logs import LogFormat
from service.setting_types import (
    Ancestors,
    CollectorAddress,
    DatabaseAddress,
    DataFolder,
    Folders,
    Hosts,
    ListeningAddress,
    Networks,
    Origins,
    Platforms,
    ProxyPath,
    PublicAddress,
    WebForm,
)

if TYPE_CHECKING:
    from kinematics.cells import Limits

KIB = 1024
MIB = 1024 * KIB

LONGEST_DAYS = 36_500  # A hundred years: what is kept longer is kept for ever.

LONGEST_SECONDS = 86_400  # A day: longer times are no limits, and timers of the system do not take infinity.
LARGEST_MEMORY = 1 << 60  # Bytes: more than any machine has, and few enough for a limit of the system.
MOST_WORKERS = 1024  # Processes: more than the cores of one machine, and few enough for it to start them all.
LONGEST_NUMBER = 1000  # Digits: a few milliseconds to read, and less than Python converts at all (4300).
Seconds = Annotated[float, Field(gt=0, le=LONGEST_SECONDS)]


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

    host: ListeningAddress = Field("127.0.0.1", description="address that the server listens on")
    port: int = Field(8000, ge=0, le=65535, description="port that the server listens on; 0 takes a free one")
    workers: int = Field(1, gt=0, le=MOST_WORKERS, description="server processes, at most 1024")
    access_log: bool = Field(False, description="log a line for each request")
    log_format: LogFormat = Field(LogFormat.TEXT, description="how the log is written: text, or json")
    metrics: Literal["on", "off"] = Field("on", description="serve Prometheus metrics at /metrics")
    traces: CollectorAddress = Field(
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
    prefix: ProxyPath = Field("", description="path under which a reverse proxy serves this, such as /dh")
    trusted_proxies: Networks = Field(
        ("127.0.0.1",),
        description="addresses and networks (CIDR) whose X-Forwarded-Proto, -For and -Prefix headers are "
        "believed; * for all: of several addresses in -For the first is believed, whoever wrote it",
    )
    frame_ancestors: Ancestors = Field(
        ("'self'",), description="origins that may show the pages in a frame (CSP frame-ancestors)"
    )
    cors_origins: Origins = Field((), description="origins whose pages may call the API from a browser")
    static_directory: WebForm = Field(None, description="folder of the web form; none: the packaged one")

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
        20.0, description="time that a request may wait for its turn, except for a drawing [s]"
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
    data_folder: DataFolder = Field(Path("data"), description="folder of the SQLite file")
    database_url: DatabaseAddress = Field(
        "", description="PostgreSQL instead of SQLite: postgresql://user:password@host/database"
    )
    public_url: PublicAddress = Field(
        "",
        description="address under which browsers and platforms reach the service; none: that of the request",
    )
    lti_trusted_origins: Platforms = Field(
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
    exercise_folders: Folders = Field(
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
        64, description="waiting answers beyond which a wrong one is explained more briefly"
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
    callback_hosts: Hosts = Field(
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

    @model_validator(mode="after")
    def _limits_agree(self) -> Self:
        if self.batch_body_limit < self.body_limit:
            raise ValueError("FRAMEWISE_BATCH_BODY_LIMIT is below FRAMEWISE_BODY_LIMIT")
        if self.publishing is Publishers.KEY and self.api_keys is None:
            raise ValueError("FRAMEWISE_PUBLISHING=key needs FRAMEWISE_API_KEYS: nobody could publish")
        if self.number_smallest >= self.number_largest:
            raise ValueError("FRAMEWISE_NUMBER_SMALLEST is not below FRAMEWISE_NUMBER_LARGEST")
        return self

    @cached_property
    def cell_limits(self) -> "Limits":
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
