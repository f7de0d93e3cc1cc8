"""The OpenAPI document is true: every example works, every answer has the shape that it states."""

import copy
import json
from collections.abc import Iterator
from html.parser import HTMLParser
from pathlib import Path
from typing import Any

import httpx
import pytest
from jsonschema import Draft202012Validator

from service.messages import languages
from tests.document import DOCUMENT
from tests.lti.classes import eventually

OPERATIONS = {
    f"{method.upper()} {path}": (path, method, operation)
    for path, operations in DOCUMENT["paths"].items()
    for method, operation in operations.items()
}


def resolved(schema: dict[str, Any]) -> dict[str, Any]:
    return {**schema, "components": DOCUMENT["components"]}


def sent() -> Iterator[Any]:
    for name, (path, method, operation) in OPERATIONS.items():
        content = operation.get("requestBody", {}).get("content", {})
        for media_type, entry in content.items():
            for title, example in entry.get("examples", {}).items():
                yield pytest.param(path, method, media_type, example["value"], id=f"{name}: {title}")


def addressed(path: str, operation: dict[str, Any]) -> str | None:
    """The path with the examples of its parameters, if every one has an example."""
    for parameter in operation.get("parameters", []):
        if parameter["in"] != "path":
            continue
        examples = [entry["value"] for entry in parameter.get("examples", {}).values()]
        examples += parameter.get("schema", {}).get("examples", [])
        if "example" in parameter:
            examples.append(parameter["example"])
        if not examples:
            return None
        path = path.replace("{" + parameter["name"] + "}", str(examples[0]))
    return path


def check_shape(response: httpx.Response, operation: dict[str, Any]) -> None:
    assert response.status_code == 200, response.text
    media_type = response.headers["content-type"].split(";")[0]
    documented = operation["responses"]["200"]["content"]
    assert media_type in documented
    if media_type == "application/json":
        Draft202012Validator(resolved(documented[media_type]["schema"])).validate(response.json())


def test_there_are_examples() -> None:
    assert len(list(sent())) >= 5


@pytest.mark.parametrize(("path", "method", "media_type", "example"), list(sent()))
def test_every_example_works(
    client: httpx.Client, path: str, method: str, media_type: str, example: Any
) -> None:
    operation = DOCUMENT["paths"][path][method]
    Draft202012Validator(resolved(operation["requestBody"]["content"][media_type]["schema"])).validate(
        example
    )
    address = addressed(path, operation)
    assert address, "a path parameter has no example"
    response = client.request(method, address, json=example, headers={"Content-Type": media_type})
    check_shape(response, operation)


def objects(value: Any) -> Iterator[dict[str, Any]]:
    """Every object of a body."""
    if isinstance(value, dict):
        yield value
    for part in value.values() if isinstance(value, dict) else value if isinstance(value, list) else ():
        yield from objects(part)


@pytest.mark.parametrize(("path", "method", "media_type", "example"), list(sent()))
def test_no_field_that_the_document_does_not_know_is_read_over(
    client: httpx.Client, path: str, method: str, media_type: str, example: Any
) -> None:
    operation = DOCUMENT["paths"][path][method]
    allowed = Draft202012Validator(resolved(operation["requestBody"]["content"][media_type]["schema"]))
    address = addressed(path, operation)
    assert address, "a path parameter has no example"
    body = copy.deepcopy(example)
    for part in objects(body):
        part["not_a_field"] = 1
        if not allowed.is_valid(body):
            answer = client.request(method, address, json=body, headers={"Content-Type": media_type})
            assert "not_a_field" in answer.text, part
        del part["not_a_field"]


@pytest.mark.parametrize("name", [name for name in OPERATIONS if name.startswith("GET ")])
def test_everything_that_can_be_got_is_there(client: httpx.Client, name: str) -> None:
    path, _, operation = OPERATIONS[name]
    address = addressed(path, operation)
    assert address, "a path parameter has no example"

    def there() -> httpx.Response | None:
        """The answer; a worker process that an earlier test needed may still be starting."""
        answer = client.get(address)
        return None if name == "GET /readyz" and answer.status_code == 503 else answer

    check_shape(eventually(there), operation)


@pytest.mark.parametrize("name", OPERATIONS)
def test_every_call_is_described(name: str) -> None:
    path, method, operation = OPERATIONS[name]
    assert operation["summary"]
    assert len(operation["description"]) > 30
    assert operation["tags"]
    if method == "post":
        assert {"400", "413", "415", "422"} <= set(operation["responses"])
        content = operation["requestBody"]["content"]["application/json"]
        assert content.get("examples"), "a call with a body shows one"
    told = {"401", "403", "429"} & set(operation["responses"])
    assert len(told) == (3 if path.startswith("/api/") else 0)  # keys, links and limits refuse all alike
    for status, response in operation["responses"].items():
        if not status.startswith("2") and (name, status) != ("GET /readyz", "503"):  # which is an answer
            schema = response["content"]["application/problem+json"]["schema"]
            assert schema["$ref"].endswith("ProblemDocument")


def test_every_call_names_the_languages_that_it_speaks(client: httpx.Client) -> None:
    asked = {
        name: parameter["schema"]
        for name, (_, _, operation) in OPERATIONS.items()
        for parameter in operation.get("parameters", [])
        if parameter["name"] == "lang"
    }
    assert len(asked) >= 6
    assert all(schema["enum"] == list(languages()) for schema in asked.values())
    for language in (*languages(), "xx", "x" * 300):
        known = language in languages()
        for path in ("robots", "exercises"):
            answer = client.get(f"/api/v1/{path}", params={"lang": language})
            assert answer.status_code == (200 if known else 422)
            assert known or answer.json()["code"] == "language_unknown"


def test_every_field_of_a_request_is_described() -> None:
    requests = {
        name for name in DOCUMENT["components"]["schemas"] if name.endswith(("Request", "Table", "Row"))
    }
    silent = [
        f"{name}.{field}"
        for name in sorted(requests)
        for field, schema in DOCUMENT["components"]["schemas"][name].get("properties", {}).items()
        if "description" not in schema and "$ref" not in schema and "allOf" not in schema
        and not any("description" in choice or "$ref" in choice for choice in schema.get("anyOf", []))
    ]  # fmt: skip
    assert not silent


def test_the_document_is_served_with_the_address_it_was_asked_at(client: httpx.Client) -> None:
    served = client.get("/api/v1/openapi.json", headers={"X-Forwarded-Prefix": "/dh"}).json()
    assert served["servers"] == [{"url": "/dh"}]
    assert served["paths"].keys() == DOCUMENT["paths"].keys()


def test_the_document_is_sent_once_to_who_has_it(client: httpx.Client) -> None:
    """Caches were told to ask again, with nothing to ask with."""
    tag = client.get("/api/v1/openapi.json").headers["etag"]
    again = client.get("/api/v1/openapi.json", headers={"If-None-Match": tag})
    assert (again.status_code, again.content) == (304, b"")


def test_the_page_for_people_shows_every_call(client: httpx.Client) -> None:
    response = client.get("/api/v1/docs")
    assert response.headers["content-type"] == "text/html; charset=utf-8"
    assert "script-src" not in response.headers["content-security-policy"]
    assert "http" not in response.headers["content-security-policy"]
    parser = Anchors()
    parser.feed(response.text)
    assert all(operation["summary"] in parser.text for _, _, operation in OPERATIONS.values())
    assert parser.targets <= parser.names
    assert not parser.outside


class Anchors(HTMLParser):
    """Collects where a page's links lead."""

    def __init__(self) -> None:
        super().__init__()
        self.targets: set[str] = set()
        self.names: set[str] = set()
        self.outside: list[str] = []
        self.text = ""

    def handle_starttag(self, tag: str, attributes: list[tuple[str, str | None]]) -> None:
        found = dict(attributes)
        self.names.add(found.get("id") or "")
        for address in filter(None, (found.get("href"), found.get("src"))):
            if address.startswith("#"):
                self.targets.add(address[1:])
            elif "//" in address:
                self.outside.append(address)

    def handle_data(self, data: str) -> None:
        self.text += data


def test_every_reference_resolves() -> None:
    text = str(DOCUMENT)
    known = DOCUMENT["components"]["schemas"]
    references = {piece.split("'")[0] for piece in text.split("#/components/schemas/")[1:]}
    assert references <= set(known)


def named_shapes() -> dict[str, Any]:
    return DOCUMENT["components"]["schemas"]


def test_an_answer_to_a_draft_is_described_as_one_to_an_exercise() -> None:
    answer = named_shapes()["TryRequest"]["properties"]["answer"]
    assert answer["$ref"] == "#/components/schemas/ExerciseAnswer"


def test_generators_can_digest_the_document() -> None:
    """Unique titles, no null as a default, no shape named like a generator's own, short ids of operations."""
    titles = [shape["title"] for shape in named_shapes().values() if "title" in shape]
    assert len(titles) == len(set(titles))
    assert not {"Configuration"} & set(named_shapes())
    assert not [name for name in named_shapes() if "__" in name]
    assert '"default": null' not in json.dumps(DOCUMENT)
    identifiers = [operation["operationId"] for _, _, operation in OPERATIONS.values()]
    assert len(identifiers) == len(set(identifiers))
    assert all(len(identifier) <= 40 and "api_v1" not in identifier for identifier in identifiers)


def test_openapi_generator_can_digest_the_document() -> None:
    """It makes shapes of `properties` within `not`, and names the arguments of a call like its body."""
    assert not [name for name, shape in named_shapes().items() if "'properties'" in str(shape.get("not", ""))]
    assert any("not" in shape for shape in named_shapes().values())
    for _, _, operation in OPERATIONS.values():
        arguments = "".join(word.title() for word in operation["operationId"].split("_")) + "Request"
        body = operation.get("requestBody", {}).get("content", {}).get("application/json", {})
        own = body.get("schema", {}).get("$ref", "").endswith(f"/{arguments}")
        assert own or arguments not in named_shapes(), arguments


def test_every_list_of_a_request_has_a_limit() -> None:
    """Except joints: what a batch holds is a setting, and is counted before it is read."""
    unbounded: set[str] = set()
    seen: set[str] = set()

    def look(shape: dict[str, Any], where: str) -> None:
        name = str(shape.get("$ref", "")).rpartition("/")[2]
        if name and name not in seen:
            seen.add(name)
            look(named_shapes()[name], name)
        for choice in (entry for key in ("anyOf", "oneOf", "allOf") for entry in shape.get(key, ())):
            look(choice, where)
        if shape.get("type") == "array" and "maxItems" not in shape:
            unbounded.add(where)
        if isinstance(shape.get("additionalProperties"), dict) and "maxProperties" not in shape:
            unbounded.add(where)
        look(shape["items"], f"{where}[]") if isinstance(shape.get("items"), dict) else None
        for field, entry in shape.get("properties", {}).items():
            look(entry, f"{where}.{field}")

    for name, (_, _, operation) in OPERATIONS.items():
        for entry in operation.get("requestBody", {}).get("content", {}).values():
            if "/evaluate" not in name:
                look(entry.get("schema", {}), name)
    assert unbounded <= {"ForwardKinematicsRequest.joints", "NumericJacobianRequest.joints"}


def test_the_page_about_the_api_names_every_call() -> None:
    page = (Path(__file__).resolve().parents[2] / "docs" / "api.md").read_text(encoding="utf-8")
    unnamed = []
    for path in DOCUMENT["paths"]:
        name = path.removeprefix("/api/v1")
        room, _, last = name.rpartition("/")
        grouped = f"`POST {room}/…`" in page and f"`{last}`" in page
        if not (f"{name}`" in page or grouped):
            unnamed.append(name)
    assert not unnamed
