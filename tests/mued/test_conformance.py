"""What every µEd 0.1.0 service owes a platform, asked over HTTP.

The document `mued-0.1.0.json` states the standard's members, types and statuses, with a request of every kind
that the standard's own document has. A service may refuse what it does not evaluate (400, 403, 501); whatever
it answers has the shape that the standard gives it.
"""

import json
from pathlib import Path
from typing import Any

import httpx
import pytest
import schemathesis
from hypothesis import HealthCheck, Phase, settings
from jsonschema import Draft202012Validator
from schemathesis.specs.openapi.checks import negative_data_rejection, positive_data_acceptance

from tests.drawn_calls import for_each_call

DOCUMENT: dict[str, Any] = json.loads((Path(__file__).parent / "mued-0.1.0.json").read_text(encoding="utf-8"))
EVALUATE = DOCUMENT["paths"]["/evaluate"]["post"]
HEALTH = DOCUMENT["paths"]["/evaluate/health"]["get"]
REQUESTS: dict[str, Any] = {
    name: example["value"]
    for name, example in EVALUATE["requestBody"]["content"]["application/json"]["examples"].items()
}
MINIMAL: dict[str, Any] = {"submission": {"type": "TEXT", "content": {"text": "x"}}}
OPTIONAL = ("task", "user", "criteria", "preSubmissionFeedback", "callbackUrl", "configuration")
REFUSALS = {400, 403, 501}


def assert_documented(operation: dict[str, Any], response: httpx.Response) -> None:
    """The status is one of the operation's, and the body has that status's shape."""
    described = operation["responses"].get(str(response.status_code))
    assert described is not None, f"{response.status_code}: {response.text[:500]}"
    media_type = response.headers["content-type"].partition(";")[0]
    assert media_type in described["content"], media_type
    schema = {**described["content"][media_type]["schema"], "components": DOCUMENT["components"]}
    Draft202012Validator(schema).validate(response.json())


def test_health_tells_what_is_evaluated(platform: httpx.Client) -> None:
    response = platform.get("/evaluate/health")
    assert response.status_code in (200, 501, 503)
    assert_documented(HEALTH, response)
    if response.status_code == 200:
        for profile in response.json()["capabilities"].get("supportedArtefactProfiles") or ():
            if schema := profile.get("contentSchema"):
                Draft202012Validator.check_schema(schema)
            if schema := profile.get("locatorSchema"):
                Draft202012Validator.check_schema(schema)


@pytest.mark.parametrize("name", list(REQUESTS))
def test_each_example_is_answered_or_refused_in_the_standard_s_shape(
    platform: httpx.Client, name: str
) -> None:
    response = platform.post("/evaluate", json=REQUESTS[name])
    assert response.status_code < 500 or response.status_code == 501
    assert_documented(EVALUATE, response)


def test_a_request_id_comes_back(platform: httpx.Client) -> None:
    for call in (
        platform.get("/evaluate/health", headers={"X-Request-Id": "trace-1"}),
        platform.post("/evaluate", json=MINIMAL, headers={"X-Request-Id": "trace-1"}),
        platform.post("/evaluate", json={}, headers={"X-Request-Id": "trace-1"}),
    ):
        assert call.headers["x-request-id"] == "trace-1"


def test_a_version_that_is_spoken_comes_back_and_another_is_refused(platform: httpx.Client) -> None:
    spoken = platform.post("/evaluate", json=MINIMAL, headers={"X-Api-Version": "0.1.0"})
    assert spoken.headers.get("x-api-version", "0.1.0") == "0.1.0"
    other = platform.post("/evaluate", json=MINIMAL, headers={"X-Api-Version": "999.0.0"})
    assert other.status_code == 406
    assert_documented(EVALUATE, other)


@pytest.mark.parametrize("name", [*OPTIONAL, "format", "taskId", "submittedAt", "version"])
def test_what_is_null_counts_as_left_out(platform: httpx.Client, name: str) -> None:
    body: dict[str, Any] = json.loads(json.dumps(MINIMAL))
    (body if name in OPTIONAL else body["submission"])[name] = None
    with_null, without = platform.post("/evaluate", json=body), platform.post("/evaluate", json=MINIMAL)
    assert with_null.status_code == without.status_code
    assert_documented(EVALUATE, with_null)


def test_members_that_nobody_knows_are_passed_over(platform: httpx.Client) -> None:
    body = {**MINIMAL, "x-unknown": {"a": [1]}, "user": {"type": "OTHER", "x-unknown": True}}
    unknown, without = platform.post("/evaluate", json=body), platform.post("/evaluate", json=MINIMAL)
    assert unknown.status_code == without.status_code


def test_ids_are_the_platform_s_and_may_be_anything(platform: httpx.Client) -> None:
    for identifier in ("", "0", "Ünïcödé 漢字", "../../etc/passwd", "x" * 500):
        body = {"submission": {**MINIMAL["submission"], "submissionId": identifier, "taskId": identifier}}
        response = platform.post("/evaluate", json=body)
        assert response.status_code < 500 or response.status_code == 501
        assert_documented(EVALUATE, response)


@pytest.mark.parametrize(
    "body",
    [
        b"",
        b"{",
        b"[]",
        b'"text"',
        b"{}",
        b'{"submission": {}}',
        b'{"submission": {"type": "TEXT"}}',
        b'{"submission": {"content": {}}}',
        b'{"submission": {"type": "SONG", "content": {}}}',
        b'{"submission": {"type": "TEXT", "content": []}}',
        b'{"submission": null}',
    ],
)
def test_what_is_no_request_is_refused(platform: httpx.Client, body: bytes) -> None:
    response = platform.post("/evaluate", content=body, headers={"Content-Type": "application/json"})
    assert response.status_code in REFUSALS
    assert_documented(EVALUATE, response)


def test_a_callback_is_accepted_with_an_id_or_refused(platform: httpx.Client) -> None:
    response = platform.post("/evaluate", json={**MINIMAL, "callbackUrl": "https://platform.example.com/x"})
    assert response.status_code in {200, 202, *REFUSALS}
    assert_documented(EVALUATE, response)


schema = schemathesis.openapi.from_dict(DOCUMENT)
schema.config.update(request_timeout=120)  # ten seconds otherwise, and machines may be busy
EXAMPLES = 60


@pytest.fixture
def called(mued_url: str, mued_headers: dict[str, str]) -> dict[str, Any]:
    return {"mued_url": mued_url, "mued_headers": mued_headers}


@for_each_call(schema, most=None)
@settings(
    max_examples=EXAMPLES,
    deadline=None,
    phases=[Phase.explicit, Phase.generate],
    suppress_health_check=list(HealthCheck),
)
def test_whatever_is_sent_the_standard_holds(
    mued_url: str, mued_headers: dict[str, str], case: schemathesis.Case
) -> None:
    """Excused: a valid request may mean nothing to a service, and unknown members are passed over."""
    case.call_and_validate(
        base_url=mued_url,
        headers=mued_headers,
        excluded_checks=[positive_data_acceptance, negative_data_rejection],
    )
