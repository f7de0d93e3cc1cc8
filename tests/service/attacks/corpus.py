"""The corpus: each attack by name, as an address and a body, at a limit and ten times beyond."""

import json
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from itertools import cycle
from typing import Any

API = "/api/v1"
JOINT = {"alpha": 0, "a": 0, "d": 0, "theta": "q1"}
MIB = 1024 * 1024


@dataclass(frozen=True)
class Attack:
    """A request that means little and asks for much."""

    name: str
    path: str
    body: bytes


def attacks() -> Iterator[Attack]:
    """The corpus."""
    known = [(f"{name} x{n}", _written(table)) for n in (256, 10_000, 100_000) for name, table in tables(n)]
    unknown = list(bodies())
    for path in CALLS:
        for name, table in known:
            two = b'{"submission": %b, "reference": %b}' % (table, table)
            yield Attack(f"{path} {name}", API + path, two if path == "/grade" else b'{"table": %b}' % table)
        yield from (Attack(f"{path} {name}", API + path, body) for name, body in unknown)
    for count in (256, 10_000, 100_000):
        for name, each in chains(count):
            chain = _written(each)
            yield Attack(f"scm {name} x{count}", f"{API}/scm/forward-kinematics", b'{"chain": %b}' % chain)
            yield Attack(
                f"convert scm {name} x{count}", f"{API}/convert", b'{"scm": %b, "to": "poe"}' % chain
            )
    for count in (1_000, 100_000, 1_000_000):
        for name, joints in batches(count):
            body = b'{"robot":"puma560","joints":%b}' % joints
            yield Attack(f"joints {name} x{count}", f"{API}/forward-kinematics", body)
            yield Attack(f"joints {name} x{count}, Jacobian", f"{API}/jacobian", body)
    for length in (1_000, MIB - 1_000):
        yield Attack(f"urdf of {length}", f"{API}/convert", _written({"urdf": "<" * length, "to": "poe"}))
        yield Attack(f"robot of {length}", f"{API}/workspace", _written({"robot": "x" * length}))
    for count in (64, 640, 6_400):
        matrices = [[["cos(q1)*sin(q2)+L1"] * 4] * 4] * count
        answer = {"table": {"convention": "standard", "rows": []}, "link_matrices": matrices}
        yield Attack(f"link matrices x{count}", f"{API}/exercises/puma560/grade", _written(answer))
    for name, text in conditions():
        asked = {"robot": "puma560", "conditions": [text]}
        yield Attack(f"conditions: {name}", f"{API}/check-singularities", _written(asked))
    for name, pose, zero in poses():
        yield Attack(f"solutions of {name}", f"{API}/inverse-kinematics", _written(pose))
        answer = {**pose, "solutions": [zero]}
        yield Attack(f"answer about {name}", f"{API}/check-inverse-kinematics", _written(answer))


CALLS = ("/understand", "/forward-kinematics", "/symbolic", "/workspace", "/grade")


def tables(count: int) -> Iterator[tuple[str, object]]:
    """Tables of so many rows, cells or terms."""
    yield "rows of nothing", {"convention": "standard", "rows": [{}] * count}
    yield "rows of null", {"convention": "standard", "rows": [None] * count}
    yield "rows of lists", {"convention": "standard", "rows": [[]] * count}
    yield "rows", {"convention": "standard", "rows": [JOINT] * count}
    yield "terms", {"convention": "standard", "rows": [JOINT | {"a": "+".join(["L1"] * count)}]}
    names = "+".join(f"L{i}" for i in range(count))
    yield "names", {"convention": "standard", "rows": [JOINT | {"a": names}]}
    yield "long name", {"convention": "standard", "rows": [JOINT | {"a": "L" * count}]}
    yield "brackets", {"convention": "standard", "rows": [JOINT | {"a": "(" * count + "1" + ")" * count}]}
    yield "fields", {"convention": "standard", "rows": [dict.fromkeys(map(str, range(count)), 0)]}
    yield "cell of lists", {"convention": "standard", "rows": [JOINT | {"a": [[]] * count}]}


def bodies() -> Iterator[tuple[str, bytes]]:
    """Bodies that are not what any call takes."""
    for count in (1_000, 100_000):
        keys = {f"k{i}": i for i in range(count)}
        yield f"unknown fields x{count}", _written(keys)
        yield f"parameters x{count}", _written({"robot": "puma560", "parameters": keys})
        yield f"objects x{count}", b"[" + b"{}," * count + b"{}]"
        yield f"deep x{count}", b"[" * count
        yield f"escapes x{count}", b'{"robot":"' + b"\\n" * count + b'"}'
        yield f"repeated key x{count}", b"{" + b'"a":1,' * count + b'"a":1}'


def chains(count: int) -> Iterator[tuple[str, object]]:
    """SCM chains of so many joints."""
    yield "joints", {"joints": [[0, 0, 1, 0, 0, "q1"]] * count}
    yield "joints of nothing", {"joints": [{}] * count}
    yield "joints of lists", {"joints": [[]] * count}
    yield "long joint", {"joints": [[0] * count]}


def conditions() -> Iterator[tuple[str, str]]:
    """Cells with conditions whose search or number grows faster than their length."""
    for count in (1_900, 20_000, 900_000):
        yield f"spaces x{count}", "q3 = k*pi" + " " * count + "x"
        yield f"equations x{count}", "q3 = " + ", ".join(["0"] * (count // 3))


def poses() -> Iterator[tuple[str, dict[str, object], list[int]]]:
    """Poses whose solutions take a second, and joint values that do not reach them."""
    near = [
        [0.2329973, -0.7868313, 0.571497, 0.146982],
        [0.9509681, 0.0614327, -0.3031265, 0.0301877],
        [0.2034008, 0.6141031, 0.7625651, 0.0007213],
        [0, 0, 0, 1],
    ]
    yield "a pose near two singularities", {"robot": "puma560", "target": near}, [0] * 6
    rows = [{"alpha": 37 * i % 180, "a": 0.1 * i, "d": 0.3, "theta": f"q{i + 1}"} for i in range(12)]
    table = {"convention": "standard", "angle_unit": "deg", "rows": rows}
    yield "twelve joints", {"table": table, "target": [1, 1, 1, 0, 0, 0]}, [0] * 12


def batches(count: int) -> Iterator[tuple[str, bytes]]:
    """Joint values that are none."""
    yield "texts", b"[" + b'"",' * count + b'""]'
    yield "objects", b"[" + b"{}," * count + b"{}]"
    yield "empty", b"[" + b"[]," * count + b"[]]"
    yield "rows of texts", b"[" + b'["x"],' * count + b'["x"]]'
    yield "one long row", b"[[" + b"0," * count + b"0]]"
    yield "one long configuration", b"[" + b"0," * count + b"0]"


FIELDS: Mapping[str, object] = {
    "objects": [{}] * 50_000,
    "rows": [[0] * 6] * 10_000,
    "matrices": [[[0, 0, 0, 1]] * 4] * 3_000,
    "tables": [{"convention": "standard", "rows": [JOINT] * 64}] * 60,
    "cells": ["cos(q1)*L1+sqrt(2)"] * 10_000,
    "numbers": [1e300] * 30_000,
    "fields": {f"k{i}": i for i in range(20_000)},
    "text": "x" * 300_000,
    "brackets": "(" * 300_000,
    "terms": "+".join(["L1"] * 100_000),
    "lists of texts": [[""] * 250] * 240,
    "lists of objects": [[{}] * 190] * 200,
    "objects of fields": [{f"k{i}": 0 for i in range(250)}] * 64,
    "large number": 10**4_000,
}
"""What may stand in a field in the place of a little."""


def in_each_field(document: Mapping[str, Any], *, every: bool) -> Iterator[Attack]:
    """Each field of each call of an OpenAPI document in turn, in an example that is otherwise right.

    Args:
        document: the OpenAPI document.
        every: with each of the values there are; else the values go round.
    """
    turns = cycle(FIELDS)
    for path, call, body in _examples(document):
        for field in _fields(document, call["schema"]):
            for name in FIELDS if every else (next(turns),):
                yield Attack(f"{path} {field}: {name}", path, _written({**body, field: FIELDS[name]}))


def _examples(document: Mapping[str, Any]) -> Iterator[tuple[str, Mapping[str, Any], dict[str, Any]]]:
    """Yield the address of each call that takes JSON, what it takes, and the first example of it."""
    for path, methods in document["paths"].items():
        content = methods.get("post", {}).get("requestBody", {}).get("content", {})
        if call := content.get("application/json"):
            example = next(iter(call.get("examples", {}).values()), {})
            yield path.replace("{exercise_id}", "puma560"), call, example.get("value", {})


def _fields(document: Mapping[str, Any], schema: Mapping[str, Any]) -> Iterator[str]:
    """Yield the names of a body's fields, those of alternatives included."""
    if "$ref" in schema:
        schema = document["components"]["schemas"][schema["$ref"].rpartition("/")[2]]
    names = dict.fromkeys(schema.get("properties", {}))
    for way in ("oneOf", "anyOf", "allOf"):
        for alternative in schema.get(way, ()):
            names |= dict.fromkeys(_fields(document, alternative))
    yield from names


def _written(body: object) -> bytes:
    return json.dumps(body).encode()
