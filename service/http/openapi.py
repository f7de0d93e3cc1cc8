"""The OpenAPI document: what FastAPI derives, with the bodies of direct routes and the problem responses."""

import json
import re
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from fastapi import FastAPI
from fastapi.openapi.utils import get_openapi
from pydantic import BaseModel
from pydantic.json_schema import models_json_schema

from service.http.metering import REFUSED, is_api
from service.http.problem_documents import PROBLEM_JSON
from service.http.routing import API_PREFIX, JSON
from service.schemas.base import ProblemDocument

_EXAMPLES = Path(__file__).parent.parent / "examples"
_REFERENCE = "#/components/schemas/{model}"
_DECLARED: dict[str, type[BaseModel]] = {}

DESCRIPTIONS: dict[int, str] = {
    400: "The body cannot be read: it is missing, broken, or not what its media type says.",
    401: "The service asks for a key, and the request brings none that is valid.",
    403: "The key, or the link that the caller came by, does not allow this call.",
    404: "There is nothing at this address.",
    405: "This address does not support the method.",
    406: "No representation of the answer is acceptable to the caller.",
    413: "The body, or what it asks for, exceeds a limit.",
    415: "The media type of the body is not one that this call reads.",
    422: "The body is well formed, and what it says cannot be done: each fault with its place.",
    429: "The caller has asked for more than its share; try again after the time in Retry-After.",
    503: "The service is busy; try again after the time in Retry-After.",
}


def request_body(model: type[BaseModel], **other: Mapping[str, Any]) -> dict[str, Any]:
    """Return what OpenAPI says of a direct route's body: `openapi_extra` of the route.

    Args:
        model: the JSON body's shape.
        other: further media types, by the name of their subtype with an underscore for each hyphen.
    """
    _DECLARED[model.__name__] = model
    content: dict[str, Any] = {JSON: {"schema": {"$ref": _REFERENCE.format(model=model.__name__)}}}
    content |= {f"application/{name.replace('_', '-')}": dict(entry) for name, entry in other.items()}
    return {"requestBody": {"required": True, "content": content}}


NPY_QUERY: dict[str, Any] = {
    "parameters": [
        {
            "name": "request",
            "in": "query",
            "required": False,
            "description": "with an npy body: the rest of the request, without the joints, as JSON",
            "schema": {"type": "string"},
        },
        {
            "name": "robot",
            "in": "query",
            "required": False,
            "description": "with an npy body, instead of `request`: the id of a robot of the catalogue",
            "schema": {"type": "string"},
        },
    ]
}
"""Query parameters of a call that takes joint values as npy."""


def problems(*statuses: int) -> dict[int | str, dict[str, Any]]:
    """Return what OpenAPI says of a route's refusals, `responses` of the route.

    Those that every call with a body or with parameters can make are added to all of them.
    """
    return {
        status: {
            "description": DESCRIPTIONS[status],
            "content": {PROBLEM_JSON: {"schema": {"$ref": _REFERENCE.format(model="ProblemDocument")}}},
        }
        for status in statuses
    }


def document(app: FastAPI, tags: Sequence[Mapping[str, Any]]) -> dict[str, Any]:
    """Return the OpenAPI document of the application."""
    schema = get_openapi(
        title=app.title,
        version=app.version,
        summary=app.summary,
        description=app.description,
        license_info=app.license_info,
        routes=app.routes,
        tags=[dict(tag) for tag in tags],
    )
    components = schema.setdefault("components", {}).setdefault("schemas", {})
    _, declared = models_json_schema(
        [(model, "validation") for model in _DECLARED.values()] + [(ProblemDocument, "serialization")],
        ref_template=_REFERENCE,
    )
    for name, definition in declared.get("$defs", {}).items():
        components.setdefault(name, definition)
    for unused in ("HTTPValidationError", "ValidationError"):
        components.pop(unused, None)
    examples = examples_by_call()
    for path, operations in schema["paths"].items():
        for method, operation in operations.items():
            if "requestBody" in operation:
                shown = examples[path.removeprefix(API_PREFIX)]
                operation["requestBody"]["content"][JSON]["examples"] = {
                    name: {"summary": name, "value": body} for name, body in shown.items()
                }
            operation["operationId"] = _identifier(path, method, len(operations))
            _refuse_alike(operation, REFUSED if is_api(path) else ())
            _put_in_order(operation)
    _tell_defaults(schema)
    _put_d_last(components)
    order = [tag["name"] for tag in tags]
    schema["paths"] = dict(sorted(schema["paths"].items(), key=lambda item: _rank(item[1], order)))
    return schema


def examples_by_call() -> dict[str, dict[str, Any]]:
    """Return the bodies that the document shows, by a call's address and their names; a test sends each.

    In the files of `service/examples`, {"$ref": name} stands for what is shared by several of them.
    """
    shared, calls = (json.loads((_EXAMPLES / name).read_bytes()) for name in ("shared.json", "calls.json"))

    def whole(value: Any) -> Any:
        if isinstance(value, list):
            return [whole(entry) for entry in value]
        if not isinstance(value, dict):
            return value
        return shared[value["$ref"]] if "$ref" in value else {name: whole(value[name]) for name in value}

    found: dict[str, dict[str, Any]] = whole(calls)
    return found


def _identifier(path: str, method: str, methods: int) -> str:
    """Name an operation by its path: a function of a generated client is called so."""
    words = re.findall(r"[a-z0-9]+", path.removeprefix(API_PREFIX))
    if methods > 1 or path.endswith("}"):
        words.insert(0, method)
    return "_".join(words)


def _tell_defaults(schema: Any) -> None:
    """Tell defaults in words: generators for TypeScript take fields that have one for required ones."""
    if isinstance(schema, dict):
        for shape in (schema.get("properties") or {}).values():
            default = shape.pop("default", None) if isinstance(shape, dict) else None
            if default in (None, {}, []) or "left out" in shape.get("description", ""):
                continue
            told = f"{json.dumps(default, ensure_ascii=False)} if left out"
            shape["description"] = "; ".join(filter(None, (shape.get("description"), told)))
        for entry in schema.values():
            _tell_defaults(entry)
    elif isinstance(schema, list):
        for entry in schema:
            _tell_defaults(entry)


def _put_d_last(components: dict[str, Any]) -> None:
    """List the property `d` of DH rows last: what a Python generator writes has a variable of that name."""
    for shape in components.values():
        properties = shape.get("properties", {})
        if "d" in properties:
            properties["d"] = properties.pop("d")


def _put_in_order(operation: dict[str, Any]) -> None:
    operation["responses"] = dict(sorted(operation["responses"].items()))
    succeeded = operation["responses"].get("200", {})
    if succeeded.get("description") == "Successful Response":
        succeeded["description"] = "The answer."


def _rank(path: Mapping[str, Any], order: Sequence[str]) -> int:
    """Where a path stands: by the tag of its first operation; unknown tags last."""
    tag = next(iter(path.values()))["tags"][0]
    return order.index(tag) if tag in order else len(order)


def _refuse_alike(operation: dict[str, Any], statuses: tuple[int, ...]) -> None:
    """Document the refusals that every call of its kind can make, besides some statuses."""
    responses = operation["responses"]
    if "requestBody" in operation:
        statuses += (400, 413, 415, 422)
    elif operation.get("parameters"):
        statuses += (422,)
    for status, entry in problems(*statuses).items():
        if "application/json" in responses.get(str(status), {}).get("content", {"application/json": {}}):
            responses[str(status)] = entry
