"""Under the signed context of a link the API itself hides what is off."""

from collections.abc import Iterator
from pathlib import Path
from typing import Any

import httpx
import pytest
from hypothesis import given
from hypothesis import strategies as st
from pydantic import SecretStr

from exercises.access import Tool
from exercises.grading import HelpLevel
from service.http.link_context import HEADER, LinkContext, signed, verified
from service.http.problems import ForbiddenError
from service.messages import sentence
from service.settings import Settings
from tests.examples import SCARA_BY_THE_BOOK
from tests.exercises.folders import TWO_LINKS, folder
from tests.live_service import running

SECRET = b"the secret of this installation, thirty-two or more"
ALL_OFF = LinkContext(exercise="scara", off=frozenset(Tool), help=HelpLevel.ROW, attempt=2, attempts=3)
LADDER = """
[access]
catalogue = false
attempts = 4

[help]
ladder = ["verdict", "row", "repair"]
"""


@pytest.fixture(scope="module")
def service(tmp_path_factory: pytest.TempPathFactory) -> Iterator[httpx.Client]:
    root = tmp_path_factory.mktemp("own")
    folder(root, TWO_LINKS + LADDER)
    settings = Settings(secret=SecretStr(SECRET.decode()), exercise_folders=(Path(root),))
    with running(settings) as url, httpx.Client(base_url=url, timeout=120) as client:
        yield client


def under(context: LinkContext) -> dict[str, str]:
    return {HEADER: signed(context, SECRET)}


contexts = st.builds(
    LinkContext,
    exercise=st.text(min_size=1, max_size=64),
    off=st.frozensets(st.sampled_from(list(Tool))),
    help=st.none() | st.sampled_from(list(HelpLevel)),
    attempt=st.none() | st.integers(1, 1000),
    attempts=st.none() | st.integers(1, 1000),
    seed=st.none() | st.text(max_size=200),
)


@given(context=contexts)
def test_a_context_comes_back_as_it_was_signed(context: LinkContext) -> None:
    assert verified(signed(context, SECRET), SECRET) == context


@given(context=contexts, place=st.integers(0, 10**6), character=st.sampled_from("AZaz09-_."))
def test_whoever_changes_a_context_has_none(context: LinkContext, place: int, character: str) -> None:
    token = signed(context, SECRET)
    place %= len(token)
    changed = token[:place] + character + token[place + 1 :]
    if changed != token:
        with pytest.raises(ForbiddenError):
            verified(changed, SECRET)
    with pytest.raises(ForbiddenError):
        verified(token, b"of another installation")


def test_a_context_ends() -> None:
    token = signed(LinkContext(exercise="scara", expires=100), SECRET)
    assert verified(token, SECRET, now=99).expires == 100
    with pytest.raises(ForbiddenError, match="context_expired"):
        verified(token, SECRET, now=101)


def test_no_call_gives_away_what_is_off(service: httpx.Client) -> None:
    """Every address of the API and every page, with a student's context: a refusal or nothing of the key."""
    open_calls = {"/api/v1/exercises", "/api/v1/understand", "/api/v1/problems/{code}", "/healthz"}
    tried = 0
    for path, methods in service.get("/api/v1/openapi.json").json()["paths"].items():
        if path in open_calls or path.startswith(("/api/v1/exercises/{exercise_id}", "/lti")):
            continue
        address = path.replace("{robot_id}", "scara")
        for method in methods:
            answer = service.request(method, address, headers=under(ALL_OFF), json={})
            assert (answer.status_code, answer.json()["code"]) == (403, "switched_off"), address
            tried += 1
    assert tried > 15
    for page in ("/", "/playground", "/trainer/scara", "/exercises/puma560", "/api/v1/exercises/puma560"):
        assert service.get(page, headers=under(ALL_OFF)).status_code == 403
    assert service.get("/exercises/scara", headers=under(ALL_OFF)).status_code == 200


def test_the_exercise_is_shown_and_graded_with_the_help_of_the_link(service: httpx.Client) -> None:
    seen = service.get("/api/v1/exercises/scara", headers=under(ALL_OFF)).json()
    assert (seen["help"], seen["access"]["attempt"], seen["access"]["attempts"]) == ("row", 2, 3)
    assert seen["access"]["off"] == ["catalogue", "matrices", "playground", "trainer"]
    listed = service.get("/api/v1/exercises", headers=under(ALL_OFF)).json()["exercises"]
    assert [entry["id"] for entry in listed] == ["scara"]
    wrong = {
        **SCARA_BY_THE_BOOK,
        "rows": [{**SCARA_BY_THE_BOOK["rows"][0], "alpha": 90}, *SCARA_BY_THE_BOOK["rows"][1:]],
    }
    body: dict[str, Any] = {"table": wrong, "help": "repair", "attempt": 1}
    answer = service.post("/api/v1/exercises/scara/grade", json=body, headers=under(ALL_OFF)).json()
    assert (answer["help"], answer["repairs"], answer["correct"]) == ("row", [], False)
    body = {"table": {**SCARA_BY_THE_BOOK}}
    understood = service.post("/api/v1/understand", json=body, headers=under(ALL_OFF)).json()
    assert all(row["link"] is None for row in understood["rows"])


def test_the_last_attempt_is_the_last(service: httpx.Client) -> None:
    beyond = LinkContext(exercise="scara", attempt=4, attempts=3)
    body = {"table": SCARA_BY_THE_BOOK}
    answer = service.post("/api/v1/exercises/scara/grade", json=body, headers=under(beyond))
    assert (answer.status_code, answer.json()["code"]) == (403, "attempts_used_up")
    assert answer.json()["attempt_counted"] is False


def test_a_link_may_fix_the_seed(service: httpx.Client) -> None:
    ana = service.get("/api/v1/exercises/scara?seed=ana").json()["parameters"]
    fixed = under(LinkContext(exercise="scara", seed="ana"))
    assert service.get("/api/v1/exercises/scara?seed=other", headers=fixed).json()["parameters"] == ana


def test_a_page_keeps_the_context_for_what_is_opened_from_it(service: httpx.Client) -> None:
    with httpx.Client(base_url=service.base_url, timeout=120) as browser:
        page = browser.get("/exercises/scara", params={"context": signed(ALL_OFF, SECRET)})
        assert page.status_code == 200
        assert browser.get("/api/v1/robots/scara").status_code == 403
        assert browser.get("/playground").status_code == 403


def test_a_link_that_has_ended_keeps_nobody_out(service: httpx.Client) -> None:
    """Its cookie stood in the way of all pages and launches until the browser was closed."""
    ended = signed(LinkContext(exercise="scara", expires=1), SECRET)
    for token in (ended, f"{ended[:-1]}_", "changed"):
        with httpx.Client(base_url=service.base_url, timeout=120) as browser:
            browser.cookies.set("framewise_context", token)
            page = browser.get("/")
            assert page.status_code == 200
            assert page.headers["set-cookie"].startswith("framewise_context=;")
            assert page.headers["set-cookie"].endswith("Max-Age=0")
    assert service.get("/exercises/scara", params={"context": ended}).status_code == 403


def test_a_person_reads_on_a_page_why_a_link_opens_nothing(service: httpx.Client) -> None:
    """Their browser showed a problem document; and a page that is off led to others that are."""
    reader = {"Accept": "text/html,application/xhtml+xml,*/*;q=0.8", "Accept-Language": "fr"}
    ended = {"context": signed(LinkContext(exercise="scara", expires=1), SECRET)}
    page = service.get("/exercises/scara", params=ended, headers=reader)
    assert (page.status_code, page.headers["content-language"]) == (403, "fr")
    assert page.headers["content-type"] == "text/html; charset=utf-8"
    assert sentence("fr", "error-context_expired") in page.text
    assert 'class="button primary" href="../?lang=fr"' in page.text
    off = service.get("/playground", headers={**reader, **under(ALL_OFF)})
    assert (off.status_code, off.headers["content-type"]) == (403, "text/html; charset=utf-8")
    assert 'class="button primary"' not in off.text
    called = service.get("/api/v1/exercises/scara", params=ended, headers=reader)
    assert (called.status_code, called.json()["code"]) == (403, "context_expired")


def test_a_forged_context_opens_nothing(service: httpx.Client) -> None:
    forged = {HEADER: signed(LinkContext(exercise="scara"), b"guessed")}
    answer = service.get("/api/v1/exercises/scara", headers=forged)
    assert (answer.status_code, answer.json()["code"]) == (403, "context_invalid")


@pytest.mark.parametrize(
    ("attempt", "told"), [(None, "verdict"), (1, "verdict"), (2, "row"), (3, "repair"), (4, "repair")]
)
def test_help_rises_with_the_attempts(service: httpx.Client, attempt: int | None, told: str) -> None:
    rows = [{"theta": "q1", "d": 0, "a": "L1", "alpha": 90}, {"theta": "q2", "d": 0, "a": "L2", "alpha": 0}]
    body = {"table": {"convention": "standard", "angle_unit": "deg", "rows": rows}, "attempt": attempt}
    answer = service.post("/api/v1/exercises/two/grade", json=body).json()
    assert (answer["correct"], answer["help"], bool(answer["repairs"])) == (False, told, told == "repair")


def test_an_exercise_of_its_own_switches_off(service: httpx.Client) -> None:
    bound = under(LinkContext(exercise="two"))
    assert service.get("/api/v1/robots", headers=bound).status_code == 403
    assert service.get("/playground", headers=bound).status_code == 200
    rows = [{"theta": "q1", "d": 0, "a": "L1", "alpha": 0}]
    over = {"table": {"convention": "standard", "rows": rows}, "attempt": 5}
    assert service.post("/api/v1/exercises/two/grade", json=over).json()["code"] == "attempts_used_up"
