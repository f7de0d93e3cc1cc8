"""Scores arrive whatever the platform does: failures, lost answers; none is lost, none out of order."""

import random
import threading
import time
from dataclasses import replace
from datetime import datetime, timedelta
from functools import partial
from types import SimpleNamespace
from typing import Any

import orjson
import pytest

from courses.grades.outbox import resend
from courses.model import ScoreToSend
from courses.storage import records
from courses.storage.database import Store
from service.course_resources import CourseResources, now
from service.lti.fetching import FetchedAnswer
from service.lti.launch_errors import PlatformError, unreachable
from service.lti.scores import Delivery, DeliveryReport, ScoreMessage, has_result, line_item_for, post_score
from service.lti.services import Services
from service.settings import Settings
from service.work import score_sender
from service.work.score_sender import SIMULTANEOUS, ScoreSender
from tests.courses.classroom import submitted
from tests.lti.classes import Lms, eventually
from tests.lti.delivery import enrolled

STUDENTS = 12
SCORES = 4


@pytest.fixture
def resources(settings: Settings, store: Store, service: str) -> CourseResources:
    return CourseResources(settings)


def test_every_line_item_ends_at_the_right_score(resources: CourseResources, store: Store, lms: Lms) -> None:
    chance = random.Random(3)
    lms.control(faults=0.4)
    sessions = [enrolled(store, lms, f"student-{n}") for n in range(STUDENTS)]
    senders = [ScoreSender(resources, pause=0.05) for _ in range(2)]
    for sender in senders:
        sender.start()
    best = dict.fromkeys((session.person.subject for session in sessions), 0.0)
    try:
        for number in range(SCORES):
            for session in sessions:
                score = round(chance.random(), 3)
                submitted(store, session, score, key=f"k{number}")
                best[session.person.subject] = max(best[session.person.subject], score)
            time.sleep(0.2)
        lms.control(faults=0.2)
        assert eventually(lambda: _hurried(store) and _settled(lms, best), timeout=300)
    finally:
        for sender in senders:
            sender.stop()
        resources.close()
        lms.control(faults=0.0)
    sent = [entry for entry in lms.state()["scores"] if entry["resource"] == "delivery"]
    for user in best:
        stamps = [entry["stamp"] for entry in sent if entry["user"] == user]
        given = [entry["given"] for entry in sent if entry["user"] == user]
        assert stamps == sorted(set(stamps))
        assert given == sorted(given)
    assert lms.state()["refused"] == []


def _settled(lms: Lms, best: dict[str | None, float]) -> bool:
    found = {
        entry["user"]: entry["given"] / entry["maximum"]
        for entry in lms.state()["results"]
        if entry["resource"] == "delivery"
    }
    return all(found.get(str(user)) == pytest.approx(score) for user, score in best.items())


def _hurried(store: Store) -> bool:
    """Time passes faster here: what waits for another try is due now."""
    outbox = records.score_to_send
    waiting = outbox.c.lease.is_(None) & (outbox.c.revision > outbox.c.sent_revision)
    with store.writing() as connection:
        links = set(connection.scalars(outbox.select().with_only_columns(outbox.c.link_id)))
        connection.execute(outbox.update().where(waiting).values(due=now() - timedelta(seconds=1)))
    for link in links:
        resend(store, link, now())
    return True


def test_two_senders_send_each_score_once(resources: CourseResources, store: Store, lms: Lms) -> None:
    link = f"once-{store.is_postgresql}"
    for n in range(20):
        submitted(store, enrolled(store, lms, f"once-{n}", resource=link), 0.5, key="k")
    _hurried(store)
    senders = [ScoreSender(resources, pause=0.01) for _ in range(4)]

    def send(sender: ScoreSender) -> None:
        while sender.send_due():
            pass

    threads = [threading.Thread(target=send, args=(sender,)) for sender in senders]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    resources.close()
    sent = eventually(lambda: len([e for e in lms.state()["scores"] if e["resource"] == link]) >= 20)
    assert sent
    users = [entry["user"] for entry in lms.state()["scores"] if entry["resource"] == link]
    assert sorted(users) == sorted(set(users))


def test_a_slow_platform_is_sent_several_scores_at_a_time(
    resources: CourseResources, monkeypatch: pytest.MonkeyPatch
) -> None:
    """All of one wave have to be under way before any of them goes on."""
    together, sent = threading.Barrier(SIMULTANEOUS, timeout=120), []
    here, lease = threading.current_thread(), score_sender.lease_scores

    def leased(store: Store, at: datetime, limit: int) -> list[Any]:
        return list(range(limit)) if threading.current_thread() is here else lease(store, at, limit)

    class Waiting(ScoreSender):
        def send(self, item: Any) -> None:
            together.wait()
            sent.append(item)

    monkeypatch.setattr(score_sender, "lease_scores", leased)
    sender = Waiting(resources)
    assert sender.send_due() == SIMULTANEOUS
    assert sorted(sent) == list(range(SIMULTANEOUS))
    sender.stop()
    resources.close()


def test_a_score_that_ends_in_an_error_holds_up_no_other(
    resources: CourseResources, store: Store, lms: Lms, monkeypatch: pytest.MonkeyPatch
) -> None:
    link = f"odd-{store.is_postgresql}"
    for user in ("odd", "even"):
        submitted(store, enrolled(store, lms, user, resource=link), 0.5, key="k")
    post = score_sender.post_score

    def odd(services: Services, platform: Any, line_item: str, message: ScoreMessage) -> DeliveryReport:
        if message.user == "odd":
            raise AttributeError("no platform should be able to cause this")
        return post(services, platform, line_item, message)

    monkeypatch.setattr(score_sender, "post_score", odd)
    sender = ScoreSender(resources, pause=0.01)
    sender.start()
    _hurried(store)
    assert eventually(lambda: lms.result("even", link) == 0.5)
    later = records.score_to_send.select().where(records.score_to_send.c.problem == "no_answer")

    def is_put_off() -> bool:
        with store.reading() as connection:  # a transaction of its own: each sees one state
            return connection.execute(later).first() is not None

    assert eventually(is_put_off)
    submitted(store, enrolled(store, lms, "late", resource=link), 0.5, key="k")
    _hurried(store)
    assert eventually(lambda: lms.result("late", link) == 0.5)
    sender.stop()
    resources.close()


@pytest.mark.parametrize("known", [True, False])
def test_a_silent_gradebook_holds_up_no_other(
    resources: CourseResources, store: Store, lms: Lms, monkeypatch: pytest.MonkeyPatch, known: bool
) -> None:
    """Each of its scores took the time of a time-out, and all platforms waited for one line item."""
    platform = enrolled(store, lms, "ann").person.platform_id
    hosts = [f"https://{name}.example.edu/items" for name in ("silent", "other")]
    asked: list[str] = []

    def silent(_: Services, __: Any, address: str, *___: Any, **____: Any) -> str:
        asked.append(address)
        raise unreachable(address, "ReadTimeout")

    def unheard(*told: Any) -> DeliveryReport:
        with pytest.raises(PlatformError):
            silent(*told)
        return DeliveryReport(delivery=Delivery.LATER)

    monkeypatch.setattr(score_sender, "PATIENCE", 0.0)
    monkeypatch.setattr(score_sender, "SILENCE", 3600.0)
    monkeypatch.setattr(score_sender, "line_item_for", silent)
    monkeypatch.setattr(score_sender, "post_score", unheard)
    sender = ScoreSender(resources)
    for host in hosts:
        for person in range(SIMULTANEOUS):
            sender.send(to_send(person, platform, host, known=known))
    assert [address for address in asked if address in hosts] == hosts
    sender.stop()
    resources.close()


def test_a_gradebook_that_asks_to_be_left_alone_is_asked_by_no_other_score(
    resources: CourseResources, store: Store, lms: Lms, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Only the score that was told to wait did so; those of the rest of the class went on asking."""
    platform = enrolled(store, lms, "ann").person.platform_id
    hosts = [f"https://{name}.example.edu/items" for name in ("full", "other")]
    asked: list[str] = []

    def full(_: Services, __: Any, address: str, *___: Any) -> DeliveryReport:
        asked.append(address)
        return DeliveryReport(delivery=Delivery.LATER, status=429, retry_after=600.0)

    monkeypatch.setattr(score_sender, "post_score", full)
    sender = ScoreSender(resources)
    for host in hosts:
        for person in range(SIMULTANEOUS):
            sender.send(to_send(person, platform, host, known=True))
    assert asked == hosts
    sender.stop()
    resources.close()


@pytest.mark.parametrize(
    ("column", "problem"), [(404, "line_item_gone"), (200, "http_404"), (403, "http_404")]
)
def test_a_column_that_was_deleted_is_told_apart_from_a_student_who_has_left(
    resources: CourseResources,
    store: Store,
    lms: Lms,
    monkeypatch: pytest.MonkeyPatch,
    column: int,
    problem: str,
) -> None:
    """A platform may answer 404 for either, and only the first is mended by another column."""
    platform = enrolled(store, lms, "ann").person.platform_id
    told: list[str] = []

    def call(_: Any, __: str, method: str, address: str, **___: Any) -> FetchedAnswer:
        status = 404 if method == "POST" else column
        return FetchedAnswer(address=address, status=status, headers={}, body=b"{}")

    monkeypatch.setattr(resources.services, "call", call)
    monkeypatch.setattr(score_sender, "undeliverable", lambda *given: told.append(given[-1]))
    item = to_send(1, platform, "https://lms.example.edu/items", known=True)
    sender = ScoreSender(resources)
    for line_items in (item.line_items, None):  # where the platform lists none, none can be made
        sender.send(replace(item, line_items=line_items))
    assert told == [problem, "http_404"]
    sender.stop()
    resources.close()


@pytest.mark.parametrize(
    ("status", "told"), [(400, "token_refused"), (401, "token_refused"), (429, None), (503, None)]
)
def test_a_tool_that_gets_no_token_is_told_apart_from_a_score_that_is_refused(
    monkeypatch: pytest.MonkeyPatch, status: int, told: str | None
) -> None:
    """Moodle answers 400 to an unknown tool: lecturers were told that the student may have left."""
    answer = FetchedAnswer(address="https://lms.example/token", status=status, headers={}, body=b"{}")
    monkeypatch.setattr("service.lti.services.signed", lambda *_: "assertion")
    fetcher: Any = SimpleNamespace(send=lambda *_, **__: answer)
    key: Any = lambda: None  # noqa: E731
    message = ScoreMessage(user="ann", timestamp=now(), given=5.0, maximum=10.0)
    platform: Any = SimpleNamespace(id=1, client_id="c", token_audience=None, token_endpoint=answer.address)
    report = post_score(Services(fetcher, key), platform, "https://lms.example/item", message)
    assert (report.delivery, report.status, report.problem) == (Delivery.LATER, status, told)


def test_a_platform_with_the_number_of_a_removed_one_is_not_sent_its_token(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """SQLite gives the number of the last platform again; its token is valid for an hour."""
    monkeypatch.setattr("service.lti.services.signed", lambda *_: "assertion")
    sent: list[str | None] = []

    def send(_: str, address: str, *, headers: dict[str, str], content: bytes | None) -> FetchedAnswer:
        sent.append(headers.get("Authorization"))
        body = orjson.dumps({"access_token": address, "expires_in": 3600})
        return FetchedAnswer(address=address, status=200, headers={}, body=body)

    fetcher: Any = SimpleNamespace(send=send)
    key: Any = lambda: None  # noqa: E731
    services = Services(fetcher, key)
    for name in ("removed", "new"):
        address = f"https://{name}.example/token"
        platform: Any = SimpleNamespace(id=1, client_id="c", token_audience=None, token_endpoint=address)
        services.call(platform, "scope", "GET", f"https://{name}.example/items", accept="")
    tokens = [f"Bearer https://{name}.example/token" for name in ("removed", "new")]
    assert list(filter(None, sent)) == tokens


@pytest.mark.parametrize(
    ("status", "body", "made"),
    [(200, b"[]", 1), (404, b"", 1), (503, b"", 0), (429, b"", 0), (403, b"", 0), (200, b"{}", 0)],
)
def test_no_column_is_made_where_the_platform_does_not_say_which_there_are(
    resources: CourseResources, monkeypatch: pytest.MonkeyPatch, status: int, body: bytes, made: int
) -> None:
    """An overloaded platform refused the look and took the new line item: the second column of a link."""
    new: list[object] = []

    def call(_: Any, __: str, method: str, address: str, **given: Any) -> FetchedAnswer:
        if method == "POST":
            new.append(given["content"])
            return FetchedAnswer(
                address=address, status=201, headers={}, body=b'{"id": "https://lms/items/2"}'
            )
        return FetchedAnswer(address=address, status=status, headers={"retry-after": "7"}, body=body)

    monkeypatch.setattr(resources.services, "call", call)
    ask = partial(line_item_for, resources.services, None, "https://lms/items", resource="r", label="l")
    if made:
        assert ask(maximum=1.0) == "https://lms/items/2"
    else:
        with pytest.raises(PlatformError) as refused:
            ask(maximum=1.0)
        assert refused.value.retry_after == (7 if status != 200 else None)
    assert len(new) == made
    resources.close()


def to_send(person: int, platform: int, address: str, *, known: bool) -> ScoreToSend:
    """A score that nobody has leased: what becomes of it is written down nowhere."""
    return ScoreToSend(
        link_id=0,
        person_id=person,
        platform_id=platform,
        subject=str(person),
        line_item=address if known else None,
        line_items=address,
        resource="r",
        title="",
        score=0.5,
        points=1.0,
        revision=1,
        tries=1,
        timestamp=now(),
        submitted_at=None,
        lease="none",
    )


class Platform:
    """Answers every call with the same body."""

    def __init__(self, body: object) -> None:
        self.body = orjson.dumps(body)

    def call(self, *_: Any, **__: Any) -> FetchedAnswer:
        return FetchedAnswer(address="https://lms.example/results", status=200, headers={}, body=self.body)


@pytest.mark.parametrize(
    ("results", "holds"),
    [([], False), ({}, False), (None, False), (["x"], False), ([None, 3], False),
     ([{"userId": "ann", "resultScore": 1, "resultMaximum": "1"}], False),
     ([{"userId": "ann", "resultScore": "4", "resultMaximum": 8}], False),
     ([{"userId": "ann", "resultScore": None}], False),
     ([{"userId": "bob", "resultScore": 4, "resultMaximum": 8}], False),
     ([{"userId": "ann", "resultScore": 3, "resultMaximum": 8}], False),
     (["x", {"userId": "ann", "resultScore": 4, "resultMaximum": 8}], True),
     ([{"userId": "ann", "resultScore": 0.5}], True),
     ([{"userId": "ann", "resultScore": 0.5, "resultMaximum": 0}], True)],
)  # fmt: skip
def test_what_a_gradebook_holds_is_read_whatever_it_is(results: object, holds: bool) -> None:
    message = ScoreMessage(user="ann", timestamp=now(), given=5.0, maximum=10.0)
    told: Any = Platform(results)
    known: Any = None
    assert has_result(told, known, "https://lms.example/item", message) is holds


@pytest.mark.parametrize(
    ("status", "headers", "body", "delivery"),
    [
        (
            200,
            {"content-type": "text/html; charset=UTF-8"},
            b"<title>Log in</title>",
            Delivery.LATER,
        ),
        (302, {"location": "https://lms.example/maintenance"}, b"", Delivery.LATER),
        (503, {"content-type": "text/html"}, b"<h1>Back soon</h1>", Delivery.LATER),
        (200, {"content-type": "text/html; charset=UTF-8"}, b"", Delivery.TAKEN),
        (
            200,
            {"content-type": "application/json"},
            b'{"resultUrl": "https://a.b/1"}',
            Delivery.TAKEN,
        ),
        (201, {}, b"", Delivery.TAKEN),
        (204, {}, b"", Delivery.TAKEN),
        (404, {"content-type": "text/html"}, b"<h1>Not found</h1>", Delivery.REFUSED),
    ],
)
def test_a_page_that_stands_before_a_gradebook_has_not_taken_the_score(
    status: int, headers: dict[str, str], body: bytes, delivery: Delivery
) -> None:
    """The page to sign in counted as success, and one that says to wait as the end of all tries."""
    answer = FetchedAnswer(address="https://lms.example/scores", status=status, headers=headers, body=body)
    told: Any = SimpleNamespace(call=lambda *_, **__: answer)
    known: Any = None
    message = ScoreMessage(user="ann", timestamp=now(), given=5.0, maximum=10.0)
    assert post_score(told, known, "https://lms.example/item", message).delivery is delivery


def test_a_score_of_no_points_is_held() -> None:
    message = ScoreMessage(user="ann", timestamp=now(), given=0.0, maximum=0.0)
    told: Any = Platform([{"userId": "ann", "resultScore": 0, "resultMaximum": 0}])
    known: Any = None
    assert has_result(told, known, "https://lms.example/item", message)
