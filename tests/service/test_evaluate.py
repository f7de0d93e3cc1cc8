"""µEd 0.1.0 over HTTP."""

import http.server
import json
import threading
from collections.abc import Iterator
from typing import Any

import httpx
import pytest
from joserfc import jws
from joserfc.jwk import OKPKey

from service.receipts.keys import REGISTRY
from service.settings import Settings
from service.work.callbacks import Callbacks
from tests.live_service import running

ROWS = [{"theta": "q1", "d": 0, "a": "L1", "alpha": 0}, {"theta": "q2", "d": 0, "a": "L2", "alpha": 0}]
TABLE = {"convention": "standard", "rows": ROWS}
WRONG = {"convention": "standard", "rows": [{**ROWS[0], "alpha": 1}, ROWS[1]]}


def request(content: Any = TABLE, **members: Any) -> dict[str, Any]:
    submission = {"type": "MODEL", "format": "dh_table", "content": content}
    return {"submission": submission, "task": {"taskId": "twolink"}, **members}


def evaluate(client: httpx.Client, body: Any, **headers: str) -> httpx.Response:
    return client.post("/evaluate", json=body, headers=headers)


def test_a_right_table(client: httpx.Client) -> None:
    response = evaluate(client, request(), **{"X-Request-Id": "abc-1", "X-Api-Version": "0.1.0"})
    assert response.status_code == 200
    assert response.headers["x-request-id"] == "abc-1"
    assert response.headers["x-api-version"] == "0.1.0"
    first = response.json()[0]
    assert first["awardedPoints"] > 0
    assert all(entry["feedbackId"] and entry["title"] and entry["message"] for entry in response.json())


def test_a_wrong_table_names_the_place(client: httpx.Client) -> None:
    french = {"user": {"preference": {"language": "fr-CA", "detail": "DETAILED"}}}
    response = evaluate(client, request(WRONG, **french))
    assert response.headers["content-language"] == "fr"
    located = [entry["target"]["locator"] for entry in response.json() if "target" in entry]
    assert any(place["row"] == 1 for place in located)
    assert any(place.get("column") == "alpha" for place in located)


def test_detail_limits_what_is_told(client: httpx.Client) -> None:
    brief = {"user": {"preference": {"detail": "BRIEF"}}}
    entries = evaluate(client, request(WRONG, **brief)).json()
    assert not any("suggestedAction" in entry for entry in entries)


@pytest.mark.parametrize(
    ("language", "titles"),
    [
        ("en", ["Not right yet", "DH table", "DH table · row 1, Twist α", "α has the wrong value"]),
        (
            "fr",
            ["Pas encore juste", "Tableau DH", "Tableau DH · ligne 1, Torsion α", "α a une valeur fausse"],
        ),
        (
            "uk",
            [
                "Ще не правильно",
                "Таблиця DH",
                "Таблиця DH · рядок 1, Скручення α",
                "α має неправильне значення",
            ],
        ),
    ],
)
def test_titles_say_what_feedback_is_about_in_the_learner_s_language(
    client: httpx.Client, language: str, titles: list[str]
) -> None:
    learner = {"user": {"preference": {"language": language, "detail": "DETAILED"}}}
    assert [entry["title"] for entry in evaluate(client, request(WRONG, **learner)).json()] == titles


@pytest.mark.parametrize("content", [TABLE, WRONG])
def test_a_check_tells_nothing_of_right_or_wrong(client: httpx.Client, content: Any) -> None:
    checked = evaluate(client, request(content, preSubmissionFeedback={"enabled": True})).json()
    assert [entry["feedbackId"] for entry in checked] == ["readable"]
    assert "awardedPoints" not in checked[0]


def test_what_cannot_be_graded_is_feedback(client: httpx.Client) -> None:
    entries = evaluate(client, request({"convention": "standard", "rows": []})).json()
    assert entries[0]["feedbackId"] == "fault-1"


@pytest.mark.parametrize(
    "task",
    [
        {"task": None, "submission": {"type": "MODEL", "content": TABLE, "taskId": "twolink"}},
        {"task": {"metadata": {"exercise": "Two Link"}, "referenceSolution": None}},
        {"task": {}, "submission": {"type": "OTHER", "content": {"table": TABLE, "exercise": "twolink"}}},
        {"task": {}, "submission": {"type": "MODEL", "content": {**TABLE, "exercise": "twolink"}}},
        {"task": {}, "submission": {"type": "MODEL", "content": {"model": TABLE, "exercise": "twolink"}}},
        {"task": {}, "submission": {"type": "MODEL", "content": {"model": {**TABLE, "exercise": "twolink"}}}},
    ],
)
def test_an_exercise_may_be_named_in_any_member(client: httpx.Client, task: dict[str, Any]) -> None:
    response = evaluate(client, {**request(), **task})
    assert response.status_code == 200, response.text
    assert response.json()[0]["awardedPoints"] > 0


@pytest.mark.parametrize(
    ("body", "code"),
    [
        ([], "body_invalid"),
        ({}, "body_invalid"),
        ({"submission": {"type": "SONG", "content": {}}}, "body_invalid"),
        ({"submission": {"type": "TEXT", "content": {"text": "x"}}}, "artefact_unknown"),
        ({"submission": {"type": "MODEL", "content": TABLE}}, "exercise_not_named"),
        (request(callbackUrl="https://evil.example/x"), "callback_not_allowed"),
        (request(callbackUrl="http://[::1"), "callback_not_allowed"),
    ],
)
def test_refusals_have_the_standard_s_shape(client: httpx.Client, body: Any, code: str) -> None:
    response = evaluate(client, body)
    assert response.status_code == 400
    assert response.json()["code"] == code
    assert response.json()["title"]
    assert response.json()["message"]


@pytest.mark.parametrize(
    ("body", "told"),
    [
        ({}, "submission: The field “submission” is missing."),
        ({"submission": {"type": "SONG", "content": {}}}, "submission, type: This must be one of: "),
        ([], "The body must be a JSON object"),
    ],
)
def test_a_body_that_can_be_read_is_told_what_is_wrong_with_it(
    client: httpx.Client, body: Any, told: str
) -> None:
    """Whoever left a member out was told to send JSON."""
    assert evaluate(client, body).json()["message"].startswith(told)


def test_a_body_is_bounded(client: httpx.Client, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("service.http.uploads.SECONDS", 300.0)  # a busy machine sends slowly
    response = client.post("/evaluate", content=b"[" + b"1," * (1 << 20) + b"1]")
    assert response.status_code == 400
    assert response.json()["code"] == "body_too_large"


def test_another_version_is_not_spoken(client: httpx.Client) -> None:
    assert evaluate(client, request(), **{"X-Api-Version": "9.9"}).status_code == 406
    assert client.get("/evaluate/health", headers={"X-Api-Version": "9.9"}).status_code == 406


def test_health_says_what_is_evaluated(client: httpx.Client) -> None:
    health = client.get("/evaluate/health").json()
    assert health["status"] == "OK"
    profiles = health["capabilities"]["supportedArtefactProfiles"]
    assert {profile["type"] for profile in profiles} == {"MODEL", "OTHER"}
    assert "uk" in health["capabilities"]["supportedLanguages"]


@pytest.mark.parametrize(
    "content",
    [
        {"model": TABLE},
        {"model": json.dumps(TABLE), "notation": "json"},
        {"value": {"table": TABLE}},
    ],
)
def test_a_table_may_stand_where_the_standard_puts_a_model(client: httpx.Client, content: Any) -> None:
    assert evaluate(client, request(content)).json()[0]["awardedPoints"] > 0


def test_preferences_may_stand_beside_the_user_s_type(client: httpx.Client) -> None:
    user = {"type": "LEARNER", "detailPreference": "BRIEF", "languagePreference": "uk"}
    response = evaluate(client, request(WRONG, user=user))
    assert response.headers["content-language"] == "uk"
    assert not any("suggestedAction" in entry for entry in response.json())


def function(client: httpx.Client, body: Any, command: str | None = None) -> dict[str, Any]:
    """An answer of the older interface, which tells its errors in the body."""
    headers = {"command": command} if command else {}
    response = client.post("/evaluate/lambda-feedback", json=body, headers=headers)
    assert response.status_code == 200, response.text
    answer: dict[str, Any] = response.json()
    assert set(answer) in ({"command", "result"}, {"error"})
    return answer


def test_an_evaluation_function_judges_as_evaluate_does(client: httpx.Client) -> None:
    right = function(client, {"response": TABLE, "answer": "twolink"})
    assert right["command"] == "eval"
    assert right["result"]["is_correct"] is True
    told = {name: value for name, value in TABLE.items() if name != "rows"}
    alone = {"response": TABLE["rows"], "answer": "twolink", "params": told}
    assert function(client, alone)["result"] == right["result"]
    named = function(client, {"response": {**TABLE, "exercise": "twolink"}})
    assert named == right
    wrong = function(client, {"response": WRONG, "answer": "twolink", "params": {"language": "fr"}}, "eval")
    assert wrong["result"]["is_correct"] is False
    assert 0 < wrong["result"]["mark"] < 1
    french = evaluate(client, request(WRONG, user={"preference": {"language": "fr"}})).json()
    assert wrong["result"]["feedback"].replace("\n\n", " ") == french[0]["message"]


def test_an_evaluation_function_previews_without_judging(client: httpx.Client) -> None:
    previews = [function(client, {"response": given, "params": {"exercise": "twolink"}}, "preview")
                for given in (TABLE, WRONG)]  # fmt: skip
    assert previews[0] == previews[1]
    assert previews[0]["command"] == "preview"
    assert previews[0]["result"]["preview"]["feedback"]


def test_an_evaluation_function_checks_itself(client: httpx.Client) -> None:
    result = function(client, {}, "healthcheck")["result"]
    assert result["tests_passed"] is True
    assert [case["name"] for case in result["successes"]] == ["right_table", "wrong_table"]
    assert result["failures"] == result["errors"] == []


@pytest.mark.parametrize(
    ("body", "command", "code"),
    [
        ({"response": TABLE, "answer": "r2d2"}, "eval", "exercise_not_named"),
        ({"response": TABLE, "answer": {}}, "eval", "exercise_not_named"),
        ({"answer": "twolink"}, "eval", "function_call_invalid"),
        ({"response": TABLE, "answer": "twolink", "extra": 1}, "eval", "function_call_invalid"),
        ([], "preview", "function_call_invalid"),
        ({}, "dance", "function_command_unknown"),
    ],
)
def test_an_evaluation_function_tells_its_errors(
    client: httpx.Client, body: Any, command: str, code: str
) -> None:
    error = function(client, body, command)["error"]
    assert error["code"] == code
    assert error["message"]


def test_an_unreadable_response_is_wrong_and_says_why(client: httpx.Client) -> None:
    for given in ("nonsense", 5, {"rows": []}):
        result = function(client, {"response": given, "answer": "twolink"})["result"]
        assert result["is_correct"] is False
        assert result["feedback"]


class Receiver(http.server.BaseHTTPRequestHandler):
    received: list[tuple[dict[str, str], bytes]]
    arrived: threading.Event

    def do_POST(self) -> None:
        body = self.rfile.read(int(self.headers["Content-Length"]))
        self.received.append((dict(self.headers), body))
        self.send_response(200)
        self.end_headers()
        self.arrived.set()

    def log_message(self, *_: object) -> None:
        pass


@pytest.fixture
def receiver() -> Iterator[http.server.ThreadingHTTPServer]:
    Receiver.received, Receiver.arrived = [], threading.Event()
    server = http.server.ThreadingHTTPServer(("127.0.0.1", 0), Receiver)
    thread = threading.Thread(target=server.serve_forever, daemon=True)
    thread.start()
    yield server
    server.shutdown()
    server.server_close()


@pytest.mark.parametrize(
    ("host", "address", "allowed"),
    [
        ("lms.example", "https://LMS.example/x", True),
        ("lms.example", "http://lms.example/x", False),
        ("lms.example", "https://user@lms.example/x", False),
        ("lms.example:8443", "https://lms.example/x", False),
        ("[::1]:80", "http://[::1]:80/x", True),
        ("[2001:DB8::1]", "https://[2001:db8::1]/x", True),
    ],
)
def test_the_hosts_that_feedback_is_sent_to(host: str, address: str, allowed: bool) -> None:
    assert Callbacks((host,), lambda _body: "").allows(address) is allowed


def test_feedback_is_sent_to_an_allowed_host_and_signed(
    receiver: http.server.ThreadingHTTPServer, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("service.work.callbacks._TIMEOUT_SECONDS", 60.0)  # or it is sent again
    port = receiver.server_address[1]
    settings = Settings(callback_hosts=(f"127.0.0.1:{port}",))
    with running(settings) as url, httpx.Client(base_url=url, timeout=120) as client:
        response = evaluate(client, request(callbackUrl=f"http://127.0.0.1:{port}/feedback"))
        assert response.status_code == 202
        assert response.json()["status"] == "ACCEPTED"
        assert Receiver.arrived.wait(60)
        ((headers, body),) = Receiver.received
        assert json.loads(body)[0]["awardedPoints"] > 0
        key = OKPKey.import_key(client.get("/api/v1/receipts/keys").json()["keys"][0])
    signed = jws.deserialize_compact(headers["X-Framewise-Signature"], key, payload=body, registry=REGISTRY)
    assert signed.payload == body
