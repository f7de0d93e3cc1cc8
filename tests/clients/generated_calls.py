"""Make calls with a Python client of OpenAPI Generator; arguments: package, origin and folder.

Calls come from standard input; a line of JSON tells of each its name, and what went wrong or nothing.
"""

import importlib
import inspect
import json
import sys
import types
import typing
from typing import Any


def without_null(value: Any) -> Any:
    """A value without the fields that say nothing."""
    if isinstance(value, dict):
        return {key: without_null(inner) for key, inner in value.items() if inner is not None}
    return [without_null(inner) for inner in value] if isinstance(value, list) else value


def built(shape: Any, value: Any) -> Any:
    """A value as an instance of a shape, by its constructors.

    The generator's `from_dict` cannot read a list of alternatives inside an alternative.
    """
    origin, inner = typing.get_origin(shape), typing.get_args(shape)
    if origin is typing.Annotated:
        return built(inner[0], value)
    if origin in (typing.Union, types.UnionType):
        return first(inner, value)
    if shape is type(None) and value is not None:
        raise TypeError(value)
    if origin is list:
        return [built(inner[0], entry) for entry in value]
    if inspect.isclass(shape) and hasattr(shape, "model_fields"):
        fields = shape.model_fields
        choices = [field.annotation for name, field in fields.items() if name.startswith("anyof_schema_")]
        if choices:
            return shape(first([choice for choice in choices if choice is not type(None)], value))
        names = {field.alias or name: (name, field.annotation) for name, field in fields.items()}
        return shape(**{names[key][0]: built(names[key][1], entry) for key, entry in value.items()})
    return value


def first(shapes: Any, value: Any) -> Any:
    """A value by the first shape that takes it and gives it back."""
    for shape in shapes:
        try:
            found = built(shape, value)
            if client.sanitize_for_serialization(found) == value:
                return found
        except (TypeError, ValueError, KeyError, AttributeError):
            continue
    raise ValueError(f"no shape of {shapes} takes {value}")


def made(call: dict[str, Any]) -> str:
    """Make a call; return what went wrong."""
    module = importlib.import_module(f"{package}.api.{call['tag'].replace('-', '_')}_api")
    (api,) = (
        found for name, found in vars(module).items() if name.endswith("Api") and inspect.isclass(found)
    )
    function = getattr(api(client), f"{call['operation']}_with_http_info")
    arguments = dict(call["values"])
    if call["body"] is not None:
        parameters = inspect.signature(function).parameters.values()
        (name, shape), *others = (
            (parameter.name, parameter.annotation)
            for parameter in parameters
            if not parameter.name.startswith("_")
            and parameter.name not in arguments
            and parameter.default is inspect.Parameter.empty
        )
        assert not others, others
        try:
            body = shape.from_dict(call["body"])
        except (TypeError, ValueError, AttributeError):
            body = built(shape, call["body"])
        sent = json.loads(json.dumps(client.sanitize_for_serialization(body)))
        assert without_null(sent) == without_null(call["body"]), f"sent {sent}"
        arguments[name] = body
    answer = function(**arguments)
    assert answer.status_code == 200, answer.status_code
    read = without_null(client.sanitize_for_serialization(answer.data))
    assert read == without_null(json.loads(answer.raw_data)), f"read {read}"
    return ""


if __name__ == "__main__":
    package, origin, folder = sys.argv[1:]
    sys.path.insert(0, folder)
    generated = importlib.import_module(package)
    client = generated.ApiClient(generated.Configuration(host=origin))
    for todo in json.load(sys.stdin):
        try:
            fault = made(todo)
        except Exception as error:  # whatever a client raises is what its user would see
            fault = f"{type(error).__name__}: {error}"[:600]
        print(json.dumps([todo["name"], fault]), flush=True)
