"""A Python client, made by openapi-python-client from the document as it is served, makes every call."""

import importlib
import inspect
import json
import os
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path
from types import ModuleType
from typing import Any

import pytest

from tests.clients.calls import Call, calls
from tests.document import DOCUMENT

pytest.importorskip("openapi_python_client") if not os.environ.get("CI") else None

NAME = "framewise_client"
OTHER_THAN_JSON = (
    *("application/x-npy", "application/zip", "application/pdf"),
    *("image/svg+xml", "text/plain", "text/html"),
)
"""What the generator leaves out, and says so: bodies and answers that are not JSON."""

LISTS_OF_EITHER = ("scm_forward_kinematics",)
"""Answers with a list of matrices or a list of written ones: they are read, but the generator's `to_dict`
takes every list for one of shapes."""


ROWS_IN_ANSWERS = ("plant_mistake", "other_tables", "author_right_answers", "author_mistakes")
"""Answers with rows as they were typed, whose `d` the generator cannot read: these calls are only sent."""


@pytest.fixture(scope="module")
def generated(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The folder of the generated package, which can be imported."""
    folder = tmp_path_factory.mktemp("client")
    document = folder / "openapi.json"
    document.write_text(json.dumps(DOCUMENT))
    settings = folder / "settings.yaml"
    settings.write_text("post_hooks: []\n")
    command = ["generate", "--path", document, "--output-path", folder / NAME, "--meta", "none"]
    made = subprocess.run(
        [sys.executable, "-m", "openapi_python_client", *map(str, command), "--config", str(settings)],
        capture_output=True,
        text=True,
        timeout=300,
        check=False,
    )
    assert made.returncode == 0, made.stdout + made.stderr
    warnings = (made.stdout + made.stderr).split("WARNING")[1:]
    assert [warning for warning in warnings if not any(kind in warning for kind in OTHER_THAN_JSON)] == []
    sys.path.insert(0, str(folder))
    return folder


@pytest.fixture(scope="module")
def connected(generated: Path, base_url: str) -> Iterator[Any]:
    """The generated package's own client."""
    package = importlib.import_module(NAME)
    with package.Client(base_url=base_url, timeout=120) as client:
        yield client


def function_of(operation: dict[str, Any]) -> ModuleType:
    tag = operation["tags"][0]
    return importlib.import_module(f"{NAME}.api.{tag}.{operation['operationId']}")


@pytest.mark.parametrize("call", calls(), ids=lambda call: f"{call.method} {call.path}: {call.title}")
def test_every_call_is_generated_and_made(generated: Path, connected: Any, call: Call) -> None:
    function = function_of(call.operation).sync_detailed
    arguments: dict[str, Any] = dict(call.values)
    if call.body is not None:
        types = importlib.import_module(f"{NAME}.models")
        annotation = (
            inspect.signature(function, eval_str=True, locals=vars(types)).parameters["body"].annotation
        )
        arguments["body"] = read(annotation, call.body)
    if call.operation["operationId"] in ROWS_IN_ANSWERS:
        sent = function_of(call.operation)._get_kwargs(**arguments)
        assert connected.get_httpx_client().request(**sent).status_code == 200
        return
    answer = function(client=connected, **arguments)
    assert answer.status_code == 200, answer.content
    assert answer.parsed is not None
    assert not type(answer.parsed).__name__.startswith("Problem")
    if call.operation["operationId"] in LISTS_OF_EITHER:
        return
    told = answer.parsed
    told = [one.to_dict() for one in told] if isinstance(told, list) else told.to_dict()
    assert told == json.loads(answer.content)


class Plain:
    """A body as it is.

    The generator's own `from_dict` cannot read a field `d` that others follow: its variable has that name.
    Rows of requests are made by their constructors, or sent so.
    """

    def __init__(self, body: Any) -> None:
        self.body = body

    def to_dict(self) -> Any:
        return self.body


def read(annotation: Any, body: Any) -> Any:
    """The body as one of the shapes that it may have, by the first that takes it and gives it back."""
    if '"d": ' in json.dumps(body):
        return Plain(body)
    for shape in getattr(annotation, "__args__", (annotation,)):
        try:
            found = shape.from_dict(body)
        except (TypeError, ValueError, KeyError, AttributeError):
            continue
        if body.items() <= found.to_dict().items():
            return found
    raise AssertionError(f"{annotation} takes no {body}")
