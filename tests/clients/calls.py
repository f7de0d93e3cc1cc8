"""What the clients are generated from, and what they call: every example of the OpenAPI document."""

from typing import Any, NamedTuple

from tests.document import DOCUMENT

JSON = "application/json"


class Call(NamedTuple):
    """A request that the document shows.

    Attributes:
        method: of HTTP.
        path: with its parameters in braces.
        operation: its entry in the document.
        values: values of the path's parameters.
        title: of the example; empty where there is no body.
        body: the example, or None.
    """

    method: str
    path: str
    operation: dict[str, Any]
    values: dict[str, Any]
    title: str
    body: Any


def calls() -> list[Call]:
    """Every example of every call that answers in JSON."""
    found = []
    for path, operations in DOCUMENT["paths"].items():
        for method, operation in operations.items():
            if JSON not in operation["responses"]["200"].get("content", {}):
                continue
            values = {
                parameter["name"]: _example(parameter)
                for parameter in operation.get("parameters", ())
                if parameter["in"] == "path"
            }
            examples = operation.get("requestBody", {}).get("content", {}).get(JSON, {}).get("examples", {})
            found += [
                Call(method, path, operation, values, title, example["value"])
                for title, example in examples.items()
            ] or [Call(method, path, operation, values, "", None)]
    return found


def _example(parameter: dict[str, Any]) -> Any:
    shown = [entry["value"] for entry in parameter.get("examples", {}).values()]
    shown += parameter.get("schema", {}).get("examples", [])
    return parameter.get("example", shown[0] if shown else None)
