"""The database goes and comes back, is full, or takes nothing: what was acknowledged stays, and no 500."""

import contextlib
import socket
import threading
import time
import uuid
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Any
from urllib.parse import parse_qs, urlsplit

import httpx
import pytest
import sqlalchemy as sa
from sqlalchemy import event

from courses.model import Role
from courses.people.enrolment import Arrival, arrive
from courses.refusals import StorageError, StorageUnavailableError
from courses.storage import records
from courses.storage.database import Store, open_store
from courses.storage.postgresql_connection import PostgresqlConnection, _Bounded
from service.course_resources import CourseResources, now
from service.settings import Settings
from tests.architecture.serving import reserved_port
from tests.courses.classroom import joined, platform, submitted
from tests.databases import frozen, new_database
from tests.live_service import running
from tests.lti.classes import eventually
from tests.lti.test_launches import RIGHT


class Cable:
    """A TCP address that leads to PostgreSQL's socket, and can be cut."""

    def __init__(self, url: str) -> None:
        asked = sa.make_url(url)
        folder = asked.query.get("host") or parse_qs(urlsplit(url).query)["host"][0]
        (self._socket,) = Path(str(folder)).glob(".s.PGSQL.*[0-9]")
        self._listener = socket.create_server(("127.0.0.1", 0))
        self._open: list[socket.socket] = []
        self._whole = True
        self._turn = threading.Lock()
        port = self._listener.getsockname()[1]
        self.url = asked.set(host="127.0.0.1", port=port, query={}).render_as_string(hide_password=False)
        threading.Thread(target=self._accept, daemon=True).start()

    def _accept(self) -> None:
        with contextlib.suppress(OSError):
            while True:
                near, _ = self._listener.accept()
                with self._turn:
                    if not self._whole:
                        near.close()
                        continue
                    far = socket.socket(socket.AF_UNIX)
                    far.connect(str(self._socket))
                    self._open += [near, far]
                for ends in ((near, far), (far, near)):
                    threading.Thread(target=self._carry, args=ends, daemon=True).start()

    @staticmethod
    def _carry(source: socket.socket, sink: socket.socket) -> None:
        with contextlib.suppress(OSError):
            while data := source.recv(65536):
                sink.sendall(data)
        for end in (source, sink):
            with contextlib.suppress(OSError):
                end.shutdown(socket.SHUT_RDWR)

    def cut(self) -> None:
        with self._turn:
            self._whole = False
            for end in self._open:
                with contextlib.suppress(OSError):
                    end.shutdown(socket.SHUT_RDWR)

    def mend(self) -> None:
        self._whole = True

    def close(self) -> None:
        self.cut()
        self._listener.close()
        for end in self._open:
            end.close()


@pytest.fixture
def cable(postgresql: str) -> Iterator[Cable]:
    with new_database(postgresql) as url:
        made = Cable(url)
        yield made
        made.close()


def test_a_database_that_goes_and_comes_back_loses_nothing(cable: Cable, tmp_path: Path) -> None:
    store = open_store(cable.url, tmp_path)
    told = {"role": Role.LEARNER, "deployment": "1", "context": "c", "resource": "r"}
    arrival = Arrival(platform=platform(store), subject="s", exercise_id="puma560", **told)
    token, _ = arrive(store, arrival, now())
    acknowledged: list[str] = []
    settings = Settings(storage="on", database_url=cable.url, data_folder=tmp_path)
    with running(settings, ahead=True) as origin:
        client = httpx.Client(base_url=origin, timeout=120, trust_env=False)
        client.headers["Authorization"] = f"Bearer {token}"

        def submit(key: str) -> httpx.Response:
            answer = client.post("/api/v1/session/attempts", json=RIGHT, headers={"Idempotency-Key": key})
            if answer.status_code == 200:
                acknowledged.append(key)
            return answer

        for number in range(3):
            lost = uuid.uuid4().hex
            assert submit(uuid.uuid4().hex).status_code == 200
            published = client.get("/lti/jwks").json() if number else None
            cable.cut()
            for _ in range(3):
                refused = submit(lost)
                assert (refused.status_code, refused.json()["code"]) == (503, "storage_unavailable")
                assert int(refused.headers["retry-after"]) >= 1
            assert client.get("/livez").status_code == 200
            keys = client.get("/lti/jwks")  # public, and the same as when they were read last
            assert keys.status_code == (200 if published else 503)
            assert keys.json() == published or not published
            if number == 0:  # what is known of a database lasts two seconds
                assert eventually_ready(client) == (503, "down")
                assert "framewise_storage_up 0" in client.get("/metrics").text
            alone = client.post("/api/v1/exercises/puma560/grade", json=RIGHT)
            assert alone.json()["correct"]
            cable.mend()
            deadline = time.monotonic() + 60
            while submit(lost).status_code != 200:
                assert time.monotonic() < deadline
                time.sleep(0.1)
            if number == 0:
                assert eventually_ready(client) == (200, "up")
        client.close()
    with store.reading() as connection:
        stored = list(connection.scalars(sa.select(records.attempt.c.key)))
    assert sorted(stored) == sorted(set(acknowledged))
    store.close()


def connected_soon(kind: type[_Bounded], address: str = "", /, **named: Any) -> Any:
    """A connection of a kind, for which the server has two seconds, whatever the address says."""
    return super(_Bounded, kind).connect(address, **{**named, "connect_timeout": 2})


@pytest.mark.parametrize("idle", [0.0, 1.5], ids=["in use", "idle before"])
def test_a_frozen_database_is_told_in_bounded_time_and_loses_nothing(
    postgresql: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, idle: float
) -> None:
    """How soon a server must answer is shortened only while none can: a busy machine's takes its time."""
    with new_database(postgresql) as url:
        store = open_store(url, tmp_path)
        told = {"role": Role.LEARNER, "deployment": "1", "context": "c", "resource": "r"}
        arrival = Arrival(platform=platform(store), subject="s", exercise_id="puma560", **told)
        token, _ = arrive(store, arrival, now())
        acknowledged: list[str] = []
        with (
            running(Settings(storage="on", database_url=url, data_folder=tmp_path)) as origin,
            httpx.Client(base_url=origin, timeout=120, trust_env=False) as client,
            ThreadPoolExecutor() as threads,
        ):
            client.headers["Authorization"] = f"Bearer {token}"

            def submit(key: str) -> httpx.Response:
                answer = client.post("/api/v1/session/attempts", json=RIGHT, headers={"Idempotency-Key": key})
                if answer.status_code == 200:
                    acknowledged.append(key)
                return answer

            def asked_at_once(*keys: str) -> list[httpx.Response]:
                asked = [
                    threads.submit(client.get, "/api/v1/session"),
                    threads.submit(client.put, "/api/v1/session/draft", json={"draft": RIGHT}),
                    *(threads.submit(submit, key) for key in keys),
                ]
                return [call.result() for call in asked]

            assert all(answer.is_success for answer in asked_at_once("a", "b"))
            time.sleep(idle)
            with frozen(postgresql), monkeypatch.context() as impatient:
                impatient.setattr(_Bounded, "connect", classmethod(connected_soon))
                impatient.setattr(_Bounded, "answer_seconds", 0.2)
                impatient.setattr(_Bounded, "cancel_seconds", 0.2)
                for _ in range(2):
                    refused = asked_at_once("b", "c", "d")
                    assert {answer.status_code for answer in refused} == {503}
                    assert {answer.json()["code"] for answer in refused} == {"storage_unavailable"}
                assert client.get("/livez").status_code == 200
            assert all(answer.is_success for answer in asked_at_once("a", "b", "c", "d"))
        with store.reading() as connection:
            keys = list(connection.scalars(sa.select(records.attempt.c.key)))
        assert sorted(keys) == sorted(set(acknowledged))
        store.close()


_ONLY_READS = "default_transaction_read_only"


@contextlib.contextmanager
def taking_no_writes(url: str) -> Iterator[None]:
    """A database as a standby offers it after a failover: new transactions and open ones can only read."""
    name = sa.make_url(url).database
    engine = sa.create_engine(sa.make_url(url).set(drivername="postgresql+psycopg", database="postgres"))

    def told(setting: str) -> None:
        with engine.connect().execution_options(isolation_level="AUTOCOMMIT") as connection:
            connection.execute(
                sa.text(f'ALTER DATABASE "{name}" SET default_transaction_read_only = {setting}')
            )

    try:
        told("on")
        with engine.connect() as connection:
            connection.execute(
                sa.text("SELECT pg_terminate_backend(pid) FROM pg_stat_activity WHERE datname = :name"),
                {"name": name},
            )
        yield
    finally:
        told("off")
        engine.dispose()


def test_a_server_that_only_reads_is_told_and_left_as_soon_as_another_one_writes(
    postgresql: str, tmp_path: Path
) -> None:
    """Each hand-in, draft and sign-in was answered 500, and so was /readyz."""
    with new_database(postgresql) as url:
        store = open_store(url, tmp_path)
        told = {"role": Role.LEARNER, "deployment": "1", "context": "c", "resource": "r"}
        arrival = Arrival(platform=platform(store), subject="s", exercise_id="puma560", **told)
        token, _ = arrive(store, arrival, now())
        store.close()
        with (
            running(Settings(storage="on", database_url=url, data_folder=tmp_path), ahead=True) as origin,
            httpx.Client(base_url=origin, timeout=120, trust_env=False) as client,
        ):
            client.headers["Authorization"] = f"Bearer {token}"

            def submit(key: str) -> httpx.Response:
                return client.post("/api/v1/session/attempts", json=RIGHT, headers={"Idempotency-Key": key})

            assert submit("before").status_code == 200
            with taking_no_writes(url):
                time.sleep(1.1)  # connections that were used later are believed to stand
                for refused in (
                    submit("later"),
                    client.put("/api/v1/session/draft", json={"draft": RIGHT}),
                    client.post("/api/v1/session/open", json={"code": "x"}),
                ):
                    assert (refused.status_code, refused.json()["code"]) == (503, "storage_unavailable")
                    assert refused.headers["retry-after"]
                assert client.get("/api/v1/session").status_code == 200
                assert eventually_ready(client) == (503, "down")
            assert submit("later").status_code == 200
            assert eventually_ready(client) == (200, "up")


_BEGUN, _ENOUGH = 1, 2
_WORK = f"""
    DO $$ BEGIN
        PERFORM pg_advisory_xact_lock({_BEGUN});
        WHILE NOT EXISTS (SELECT FROM pg_locks WHERE locktype = 'advisory' AND objid = {_ENOUGH}) LOOP
            PERFORM pg_sleep(0.05);
        END LOOP;
    END $$
"""
"""Work that the server says it has begun, and that it does until it is told that it is enough."""


def test_a_server_that_works_is_waited_for_and_one_that_waits_is_not(
    postgresql: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """It has to answer soon only while a statement that is known to have begun is waited for."""
    found_at_work, ask = threading.Event(), PostgresqlConnection._is_at_work

    def noted(connection: PostgresqlConnection) -> bool:
        if at_work := ask(connection):
            found_at_work.set()
        return at_work

    def soon(limit: str = "answer_seconds") -> None:
        impatient.setattr(PostgresqlConnection, limit, 0.3)

    monkeypatch.setattr(PostgresqlConnection, "_is_at_work", noted)
    with new_database(postgresql) as url, ThreadPoolExecutor() as threads:
        store, teller = open_store(url, tmp_path), open_store(url, tmp_path)
        store.bound_answers()
        platform(store)

        def worked() -> None:
            with store.reading() as connection:
                connection.execute(sa.text(_WORK))

        with teller.reading() as telling:
            work = threads.submit(worked)
            begun = sa.text(f"SELECT count(*) FROM pg_locks WHERE locktype = 'advisory' AND objid = {_BEGUN}")
            assert eventually(lambda: telling.scalar(begun))
            with monkeypatch.context() as impatient:
                soon()
                assert found_at_work.wait(120)
            telling.execute(sa.text(f"SELECT pg_advisory_xact_lock({_ENOUGH})"))
            work.result()
        with monkeypatch.context() as impatient:
            soon()
            soon("longest_seconds")
            with pytest.raises(StorageUnavailableError), store.reading() as connection:
                connection.execute(sa.text("SELECT pg_sleep(600)"))
        turn = sa.select(records.platform).with_for_update()
        with store.writing() as first:
            first.execute(turn)
            with monkeypatch.context() as impatient:
                soon()
                with pytest.raises(StorageUnavailableError), store.writing() as second:
                    second.execute(turn)
        store.close()
        teller.close()


def eventually_ready(client: httpx.Client) -> tuple[int, str]:
    """The state two seconds later, when what was known is asked again."""
    time.sleep(2.1)
    answer = client.get("/readyz")
    return answer.status_code, answer.json()["storage"]


@contextlib.contextmanager
def pragma(store: Store, text: str, back: str) -> Iterator[None]:
    """Every connection under a pragma; a new one after it."""

    def apply(connection: object, *_: object) -> None:
        connection.execute(text)  # type: ignore[attr-defined]

    store.engine.dispose()
    event.listen(store.engine, "connect", apply)
    try:
        yield
    finally:
        event.remove(store.engine, "connect", apply)
        store.engine.dispose()
        with store.writing() as connection:
            connection.exec_driver_sql(back)


@pytest.mark.parametrize(
    ("text", "back"),
    [
        pytest.param("PRAGMA max_page_count = 1", "PRAGMA max_page_count = 1000000", id="disk full"),
        pytest.param("PRAGMA query_only = ON", "PRAGMA query_only = OFF", id="read only"),
    ],
)
def test_a_disk_that_takes_nothing_refuses_and_loses_nothing(tmp_path: Path, text: str, back: str) -> None:
    store = open_store("", tmp_path)
    session = joined(store)
    first = submitted(store, session, 0.5, key="first", answer={"long": "x" * 10_000})
    with pragma(store, text, back):
        for n in range(3):
            with pytest.raises(StorageUnavailableError):
                submitted(store, session, 0.5, key=f"lost-{n}", answer={"long": "x" * 100_000})
    second = submitted(store, session, 1.0, key="second")
    assert (first.number, second.number) == (1, 2)
    with store.reading() as connection:
        assert connection.scalar(sa.text("PRAGMA integrity_check")) == "ok"
    store.close()


@pytest.mark.parametrize(
    ("text", "back"),
    [
        pytest.param("PRAGMA max_page_count = 1", "PRAGMA max_page_count = 1000000", id="disk full"),
        pytest.param("PRAGMA query_only = ON", "PRAGMA query_only = OFF", id="read only"),
    ],
)
def test_a_service_whose_disk_takes_nothing_is_not_ready(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, text: str, back: str
) -> None:
    monkeypatch.setattr("service.course_resources._ANSWER_LIVES", 0.0)
    courses = CourseResources(Settings(storage="on", data_folder=tmp_path))
    session = joined(courses.store)
    assert courses.answers()
    with pragma(courses.store, text, back):
        with pytest.raises(StorageUnavailableError):
            submitted(courses.store, session, 0.5, key="lost", answer={"long": "x" * 100_000})
        assert not courses.answers()
        with contextlib.suppress(StorageUnavailableError), courses.store.writing():
            pass  # as a look for scores that are due, which finds none: a full disk takes it
        assert not courses.answers()
        with pytest.raises(StorageUnavailableError):
            courses.outbox()
    assert courses.answers()
    assert courses.outbox().waiting == 0
    with courses.store.reading() as connection:
        assert connection.execute(sa.select(records.one_time_code)).first() is None
    courses.close()


def test_a_file_that_is_taken_away_is_noticed_and_nothing_is_acknowledged_into_it(tmp_path: Path) -> None:
    away = tmp_path / "away"
    away.mkdir()
    with running(Settings(storage="on", data_folder=tmp_path / "data"), ahead=True) as origin:
        store = open_store("", tmp_path / "data")
        told = {"role": Role.LEARNER, "deployment": "1", "context": "c", "resource": "r"}
        arrival = Arrival(platform=platform(store), subject="s", exercise_id="puma560", **told)
        token, _ = arrive(store, arrival, now())
        client = httpx.Client(base_url=origin, timeout=120, trust_env=False)
        client.headers["Authorization"] = f"Bearer {token}"

        def submit(key: str) -> tuple[int, str | None]:
            answer = client.post("/api/v1/session/attempts", json=RIGHT, headers={"Idempotency-Key": key})
            return answer.status_code, answer.json().get("code")

        assert submit("kept") == (200, None)
        for file in sorted((tmp_path / "data").glob("framewise.sqlite*")):
            file.rename(away / file.name)
        assert submit("lost") == (503, "storage_unavailable")
        assert eventually_ready(client) == (503, "down")
        assert client.get("/livez").status_code == 200
        assert not (tmp_path / "data" / "framewise.sqlite").exists()
        for file in away.iterdir():
            file.rename(tmp_path / "data" / file.name)
        assert submit("later") == (200, None)
        assert eventually_ready(client) == (200, "up")
        client.close()
        with store.reading() as connection:
            assert sorted(connection.scalars(sa.select(records.attempt.c.key))) == ["kept", "later"]
        store.close()


def test_a_file_that_is_replaced_during_a_transaction_undoes_it(tmp_path: Path) -> None:
    store, other = open_store("", tmp_path / "data"), open_store("", tmp_path / "other")
    session = joined(store)
    file = tmp_path / "data" / "framewise.sqlite"

    def forget_everybody() -> None:
        with store.writing() as connection:
            connection.execute(sa.delete(records.person))
            file.rename(tmp_path / "aside")
            (tmp_path / "other" / "framewise.sqlite").rename(file)

    with pytest.raises(StorageUnavailableError):
        forget_everybody()
    for use in (store.reading, store.asking, store.writing):
        with pytest.raises(StorageUnavailableError), use():
            pass
    (tmp_path / "aside").rename(file)
    assert submitted(store, session, 0.5, key="kept").number == 1
    store.close()
    other.close()


def test_a_file_that_is_damaged_is_trouble_of_the_database(tmp_path: Path) -> None:
    """It was an error of the program: status 500, and a traceback for each request."""
    store = open_store("", tmp_path)
    session = joined(store)
    submitted(store, session, 0.5, key="first")
    store.close()
    file = tmp_path / "framewise.sqlite"
    pages = file.read_bytes()
    file.write_bytes(pages[:4096] + bytes(len(pages) - 4096))
    with pytest.raises(StorageUnavailableError):
        submitted(store, session, 0.5, key="second")
    assert not store.takes_writes
    file.write_bytes(pages)
    store.close()
    assert submitted(store, session, 0.5, key="second").number == 2
    store.close()


def test_a_folder_that_cannot_be_written_is_said_at_the_start(tmp_path: Path) -> None:
    with pytest.raises(StorageError, match="storage_folder"):
        open_store("", Path("/proc/framewise"))
    (tmp_path / "file").touch()
    with pytest.raises(StorageError, match="storage_folder"):
        open_store("", tmp_path / "file")


def test_a_database_that_is_not_there_is_said_at_the_start(tmp_path: Path) -> None:
    with reserved_port() as port, pytest.raises(StorageError, match="storage_unusable"):
        open_store(f"postgresql://nobody:secret@127.0.0.1:{port}/none", tmp_path)
