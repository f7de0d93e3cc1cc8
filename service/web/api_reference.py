"""The OpenAPI document as one page for people: no script, nothing from elsewhere."""

import base64
import hashlib
import json
import re
from collections.abc import Iterator, Mapping
from html import escape
from typing import Any

STYLE = """
:root { color-scheme: light dark; font: 16px/1.5 system-ui, sans-serif; }
body { max-width: 62rem; margin: 0 auto; padding: 1rem; }
h2 { margin-top: 3rem; border-top: 1px solid; padding-top: 1rem; }
code, pre { font: 0.9em/1.4 ui-monospace, monospace; }
pre { overflow-x: auto; padding: 0.75rem; border: 1px solid; border-radius: 0.3rem; }
table { border-collapse: collapse; }
th, td { text-align: left; vertical-align: top; padding: 0.2rem 1rem 0.2rem 0; }
summary { cursor: pointer; padding: 0.3rem 0; }
nav li { list-style: none; }
nav ul { padding: 0; }
"""
STYLE_HASH = base64.b64encode(hashlib.sha256(STYLE.encode()).digest()).decode()
POLICY = f"default-src 'none'; style-src 'sha256-{STYLE_HASH}'; base-uri 'none'; form-action 'none'"

_REFERENCE = "#/components/schemas/"


def reference_page(document: Mapping[str, Any]) -> str:
    """Return the page."""
    operations = [
        (method, path, operation)
        for path, methods in document["paths"].items()
        for method, operation in methods.items()
    ]
    info = document["info"]
    links = "".join(
        f'<li><a href="#{_anchor(method, path)}"><code>{method.upper()} {escape(path)}</code></a> '
        f"{escape(operation['summary'])}</li>"
        for method, path, operation in operations
    )
    sections = "".join(_section(method, path, operation) for method, path, operation in operations)
    shapes = "".join(
        _shape(name, schema) for name, schema in sorted(document["components"]["schemas"].items())
    )
    return (
        '<!doctype html>\n<html lang="en"><head><meta charset="utf-8">'
        '<meta name="viewport" content="width=device-width">'
        f"<title>{escape(info['title'])}: the API</title><style>{STYLE}</style></head><body><main>"
        f"<h1>{escape(info['title'])}: the API</h1>{_prose(info['description'])}"
        f'<p>The same for programs: <a href="openapi.json">openapi.json</a>.</p>'
        f"<nav><ul>{links}</ul></nav>{sections}<h2>Shapes</h2>{shapes}</main></body></html>\n"
    )


def _section(method: str, path: str, operation: Mapping[str, Any]) -> str:
    parts = [
        f'<section><h2 id="{_anchor(method, path)}"><code>{method.upper()} {escape(path)}</code></h2>',
        f"<p><strong>{escape(operation['summary'])}</strong></p>",
        _prose(operation.get("description", "")),
    ]
    if operation.get("parameters"):
        rows = "".join(
            _row(f"{entry['name']} ({entry['in']})", _kind(entry["schema"]), entry.get("description", ""))
            for entry in operation["parameters"]
        )
        parts.append(f"<h3>Parameters</h3><table>{rows}</table>")
    for media_type, entry in operation.get("requestBody", {}).get("content", {}).items():
        parts.append(f"<h3>Body: <code>{escape(media_type)}</code> {_kind(entry.get('schema', {}))}</h3>")
        parts.extend(_examples(entry.get("examples", {})))
    answers = "".join(
        _row(status, _answer_kind(answer), answer.get("description", ""))
        for status, answer in operation["responses"].items()
    )
    parts.append(f"<h3>Answers</h3><table>{answers}</table></section>")
    return "".join(parts)


def _examples(examples: Mapping[str, Any]) -> Iterator[str]:
    for name, example in examples.items():
        flat = re.sub(r"\n\s{3,}", " ", json.dumps(example["value"], ensure_ascii=False, indent=1))
        yield f"<details><summary>{escape(name)}</summary><pre>{escape(flat)}</pre></details>"


def _answer_kind(answer: Mapping[str, Any]) -> str:
    return ", ".join(
        f"<code>{escape(media_type)}</code> {_kind(entry.get('schema', {}))}"
        for media_type, entry in answer.get("content", {}).items()
    )


def _shape(name: str, schema: Mapping[str, Any]) -> str:
    required = set(schema.get("required", ()))
    rows = "".join(
        _row(field if field in required else f"{field} (optional)", _kind(entry), _description(entry))
        for field, entry in schema.get("properties", {}).items()
    )
    values = ", ".join(f"<code>{escape(str(value))}</code>" for value in schema.get("enum", ()))
    head = f'<h3 id="{escape(name)}">{escape(name)}</h3>{_prose(schema.get("description", ""))}'
    return f"{head}{f'<p>{values}</p>' if values else ''}<table>{rows}</table>"


def _kind(schema: Mapping[str, Any]) -> str:
    """What a value of a schema is, in a few words; named shapes as links."""
    if "$ref" in schema:
        name = str(schema["$ref"]).removeprefix(_REFERENCE)
        return f'<a href="#{escape(name)}">{escape(name)}</a>'
    for key in ("anyOf", "oneOf", "allOf"):
        if key in schema:
            return " or ".join(dict.fromkeys(_kind(choice) for choice in schema[key]))
    if "enum" in schema or "const" in schema:
        return ", ".join(f"<code>{escape(str(v))}</code>" for v in schema.get("enum", [schema.get("const")]))
    if schema.get("type") == "array":
        return f"list of ({_kind(schema.get('items', {}))})"
    return escape(str(schema.get("type", "anything")))


def _description(schema: Mapping[str, Any]) -> str:
    text = schema.get("description", "")
    default = schema.get("default")
    return f"{text}; {default!r} if left out" if default is not None else text


def _row(*cells: str) -> str:
    name, kind, description = cells
    return f'<tr><th scope="row">{escape(name)}</th><td>{kind}</td><td>{_inline(description)}</td></tr>'


def _prose(text: str) -> str:
    return "".join(f"<p>{_inline(part)}</p>" for part in text.strip().split("\n\n") if part)


def _inline(text: str) -> str:
    return re.sub(r"`([^`]+)`", r"<code>\1</code>", escape(text))


def _anchor(method: str, path: str) -> str:
    return re.sub(r"[^a-z0-9]+", "-", f"{method} {path}".lower()).strip("-")
