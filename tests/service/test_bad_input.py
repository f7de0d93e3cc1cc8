"""Whatever is sent, the answer is a problem document that says where and what would be right."""

import copy
import io
import json
from collections.abc import Iterator
from typing import Any

import httpx
import numpy as np
import pytest

from service.messages import languages
from service.settings import Settings
from tests.examples import PUMA_560
from tests.live_service import running

FK = "/api/v1/forward-kinematics"
JACOBIAN = "/api/v1/jacobian"
Q = [0] * 6


def table(**changes: Any) -> dict[str, Any]:
    return {**copy.deepcopy(PUMA_560), **changes}


def row(i: int, **changes: Any) -> dict[str, Any]:
    changed = copy.deepcopy(PUMA_560)
    changed["rows"][i].update(changes)
    return changed


def two(**second: Any) -> dict[str, Any]:
    first = {"alpha": 0, "a": 0, "d": 0, "theta": "q1"}
    return {"convention": "standard", "rows": [first, {"alpha": 0, "a": 0, "d": 0, "theta": 0, **second}]}


SLIDES = {
    "convention": "standard",
    "rows": [{"alpha": 0, "a": 0, "d": "q1", "theta": 0}, {"alpha": 0, "a": 0, "d": "q2", "theta": 0}],
}

CASES: dict[str, tuple[Any, int, str, str]] = {
    # joints
    "too few joints": ({"table": PUMA_560, "joints": [0] * 5}, 422, "joints_wrong_length", "/joints"),
    "no joints": ({"table": PUMA_560, "joints": []}, 422, "joints_wrong_length", "/joints"),
    "ragged batch": ({"table": PUMA_560, "joints": [Q, Q, [1]]}, 422, "joints_wrong_length", "/joints/2"),
    "text for a joint": (
        {"table": PUMA_560, "joints": [0, "1", 0, 0, 0, 0]},
        422,
        "number_expected",
        "/joints/1",
    ),
    "true for a joint": (
        {"table": PUMA_560, "joints": [True, 1, 0, 0, 0, 0]},
        422,
        "number_expected",
        "/joints/0",
    ),
    "null for a joint": (
        {"table": PUMA_560, "joints": [Q, [None] * 6]},
        422,
        "number_expected",
        "/joints/1/0",
    ),
    "a number in a batch": ({"table": PUMA_560, "joints": [Q, 3]}, 422, "list_expected", "/joints/1"),
    "joints by name": ({"table": PUMA_560, "joints": {"q1": 0}}, 422, "list_expected", "/joints"),
    "joints too deep": ({"table": PUMA_560, "joints": [[Q]]}, 422, "number_expected", "/joints/0/0"),
    "joints left out": ({"table": PUMA_560}, 422, "field_missing", "/joints"),
    "batch too large": ({"table": PUMA_560, "joints": [Q] * 200_001}, 413, "batch_too_large", "/joints"),
    # the body's shape
    "unknown key": ({"table": PUMA_560, "joints": Q, "tol": 1}, 422, "field_unknown", "/tol"),
    "unknown key in the table": (
        {"table": table(units="mm"), "joints": Q},
        422,
        "field_unknown",
        "/table/units",
    ),
    "unknown key in a row": (
        {"table": row(2, tetha=1), "joints": Q},
        422,
        "field_unknown",
        "/table/rows/2/tetha",
    ),
    "a list": ([1, 2], 422, "body_not_object", ""),
    "a text": ("table", 422, "body_not_object", ""),
    "nothing": ({}, 422, "field_missing", "/joints"),
    "no robot": ({"joints": Q}, 422, "table_or_robot", ""),
    "two robots": ({"table": PUMA_560, "robot": "puma560", "joints": Q}, 422, "table_or_robot", ""),
    "unknown robot": ({"robot": "puma561", "joints": Q}, 422, "robot_unknown", "/robot"),
    "text for a flag": (
        {"table": PUMA_560, "joints": Q, "inverse": "yes"},
        422,
        "boolean_expected",
        "/inverse",
    ),
    "unknown part": (
        {"table": PUMA_560, "joints": Q, "parts": ["pose"]},
        422,
        "value_not_allowed",
        "/parts/0",
    ),
    "no parts": ({"table": PUMA_560, "joints": Q, "parts": []}, 422, "list_too_short", "/parts"),
    # the table
    "no convention": (
        {"table": {"rows": PUMA_560["rows"]}, "joints": Q},
        422,
        "field_missing",
        "/table/convention",
    ),
    "convention": (
        {"table": table(convention="craig"), "joints": Q},
        422,
        "value_not_allowed",
        "/table/convention",
    ),
    "angle unit": (
        {"table": table(angle_unit="grad"), "joints": Q},
        422,
        "value_not_allowed",
        "/table/angle_unit",
    ),
    "joint": ({"table": row(1, joint="ball"), "joints": Q}, 422, "value_not_allowed", "/table/rows/1/joint"),
    "no rows": ({"table": table(rows=[]), "joints": []}, 422, "table_empty", "/table/rows"),
    "too many rows": (
        {"table": table(rows=[PUMA_560["rows"][5]] * 65), "joints": Q},
        422,
        "table_too_many_rows",
        "/table/rows",
    ),
    "a cell left out": (
        {"table": two() | {"rows": [{"alpha": 0, "a": 0, "d": 0}]}, "joints": Q},
        422,
        "field_missing",
        "/table/rows/0/theta",
    ),
    "true in a cell": ({"table": row(0, a=True), "joints": Q}, 422, "cell_not_a_value", "/table/rows/0/a"),
    "null in a cell": ({"table": row(0, a=None), "joints": Q}, 422, "cell_not_a_value", "/table/rows/0/a"),
    "code in a cell": (
        {"table": row(4, d="__import__('os')"), "joints": Q},
        422,
        "character_not_allowed",
        "/table/rows/4/d",
    ),
    "a tower in a cell": (
        {"table": row(4, d="9**9**9**9"), "joints": Q},
        422,
        "exponent_out_of_range",
        "/table/rows/4/d",
    ),
    "a variable in two rows": (
        {"table": two(theta="q1"), "joints": [0, 0]},
        422,
        "variable_twice",
        "/table/rows/1/theta",
    ),
    "a scaled variable": (
        {"table": two(theta="2*q2"), "joints": [0, 0]},
        422,
        "variable_scaled",
        "/table/rows/1/theta",
    ),
    "a variable in a constant cell": (
        {"table": two(a="q2"), "joints": [0, 0]},
        422,
        "variable_in_constant_cell",
        "/table/rows/1/a",
    ),
    # parameters
    "parameter missing": ({"table": two(a="L1"), "joints": [0]}, 422, "parameter_missing", "/parameters/L1"),
    "parameter unused": (
        {"table": PUMA_560, "joints": Q, "parameters": {"L1": 1}},
        422,
        "parameter_unused",
        "/parameters/L1",
    ),
    "parameter as text": (
        {"table": two(a="L1"), "joints": [0], "parameters": {"L1": "1"}},
        422,
        "number_expected",
        "/parameters/L1",
    ),
    "parameter without a result": (
        {"table": two(a="1/L1"), "joints": [0], "parameters": {"L1": 0}},
        422,
        "value_undefined",
        "/table/rows/1/a",
    ),
    "slash in a parameter's name": (
        {"table": PUMA_560, "joints": Q, "parameters": {"a/b~": 1}},
        422,
        "parameter_name_invalid",
        "/parameters/a~1b~0",
    ),
    # base and tool
    "base of 3 rows": (
        {"table": PUMA_560, "joints": Q, "base": [[1, 0, 0, 0]] * 3},
        422,
        "pose_wrong_shape",
        "/base",
    ),
    "base flat": ({"table": PUMA_560, "joints": Q, "base": [1] * 16}, 422, "pose_in_one_row", "/base"),
    "base ragged": (
        {"table": PUMA_560, "joints": Q, "base": [[1, 0, 0, 0], [0, 1]]},
        422,
        "pose_not_numbers",
        "/base",
    ),
    "tool scaled": (
        {"table": PUMA_560, "joints": Q, "tool": np.diag([2, 2, 2, 1]).tolist()},
        422,
        "pose_not_orthonormal",
        "/tool",
    ),
    "tool mirrored": (
        {"table": PUMA_560, "joints": Q, "tool": np.diag([1, 1, -1, 1]).tolist()},
        422,
        "pose_left_handed",
        "/tool",
    ),
    # results
    "overflow": ({"table": SLIDES, "joints": [1.7e308, 1.7e308]}, 422, "result_not_finite", "/joints"),
    "tool mirrored, in a batch": (
        {"table": PUMA_560, "joints": [Q] * 80, "tool": np.diag([1, 1, -1, 1]).tolist()},
        422,
        "pose_left_handed",
        "/tool",
    ),
    "overflow in a batch": (
        {"table": SLIDES, "joints": [[0, 0]] * 80 + [[1.7e308, 1.7e308]]},
        422,
        "result_not_finite",
        "/joints/80",
    ),
}


def check_problem(
    response: httpx.Response, status: int, code: str, pointer: str | None = None
) -> dict[str, Any]:
    assert response.status_code == status, response.text
    assert response.headers["content-type"] == "application/problem+json"
    problem: dict[str, Any] = response.json()
    assert problem["code"] == code, problem
    assert problem["status"] == status
    assert problem["title"] != "Problem"
    assert problem["type"].endswith(f"/problems/{code}")
    assert problem["detail"]
    assert problem["request_id"] == response.headers["x-request-id"]
    assert "Traceback" not in response.text
    assert problem["errors"][0]["code"] == code
    assert problem["errors"][0]["detail"] == problem["detail"]
    if pointer is not None:
        assert pointer in {entry["pointer"] for entry in problem["errors"]}
    return problem


@pytest.mark.parametrize("path", [FK, JACOBIAN])
@pytest.mark.parametrize("name", CASES)
def test_what_is_wrong_is_named_with_its_place(client: httpx.Client, name: str, path: str) -> None:
    body, status, code, pointer = CASES[name]
    if path == JACOBIAN and (code == "result_not_finite" or {"inverse", "parts"} & set(body)):
        pytest.skip("not of this call")
    check_problem(client.post(path, json=body), status, code, pointer)


@pytest.mark.parametrize("name", [name for name in CASES if "batch" not in name])
def test_every_sentence_exists_in_every_language(client: httpx.Client, name: str) -> None:
    """Batches are large; others say their sentences."""
    body, status, code, pointer = CASES[name]
    problems = {}
    for language in languages():
        response = client.post(FK, json=body, headers={"Accept-Language": language})
        assert response.headers["content-language"] == language
        problems[language] = check_problem(response, status, code, pointer)
    english = problems.pop("en")
    for language, problem in problems.items():
        assert problem["detail"] != english["detail"], language
        assert problem["title"] != english["title"], language
    assert client.post(FK, json=body).json()["detail"] == english["detail"]


def test_all_faults_come_at_once(client: httpx.Client) -> None:
    broken = row(1, alpha="1+", a="$", d="q7", theta="2q2")
    problem = check_problem(client.post(FK, json={"table": broken, "joints": Q}), 422, "cell_incomplete")
    assert [entry["pointer"] for entry in problem["errors"]] == [
        f"/table/rows/1/{cell}" for cell in ("alpha", "a", "d", "theta")
    ]


def test_a_long_list_of_faults_is_cut(client: httpx.Client) -> None:
    problem = client.post(FK, json={"table": PUMA_560, "joints": ["x"] * 200}).json()
    assert len(problem["errors"]) == Settings().fault_limit
    assert problem["errors_total"] == 200


RAW: dict[str, tuple[bytes, int, str, str]] = {
    "broken": (b'{"table": ', 400, "json_invalid", ""),
    "empty": (b"", 400, "body_missing", ""),
    "not UTF-8": (b'{"table": "\xff"}', 400, "json_not_utf8", ""),
    "deep": (b"[" * 200_000, 400, "json_too_deep", ""),
    "repeated key": (b'{"table": {"rows": [], "rows": []}}', 400, "json_duplicate_key", "/table/rows"),
    "NaN": (b'{"joints": [0, NaN]}', 400, "json_not_finite", "/joints/1"),
    "infinity": (b'{"table": {"rows": [{"a": -Infinity}]}}', 400, "json_not_finite", "/table/rows/0/a"),
    "a number too large": (b'{"joints": [1e999]}', 400, "json_not_finite", "/joints/0"),
    "an endless integer": (b'{"joints": [0, ' + b"9" * 5000 + b"]}", 400, "json_not_finite", "/joints/1"),
}


@pytest.mark.parametrize("path", [FK, JACOBIAN])
@pytest.mark.parametrize("name", RAW)
def test_bodies_that_are_not_strict_json(client: httpx.Client, name: str, path: str) -> None:
    body, status, code, pointer = RAW[name]
    response = client.post(path, content=body, headers={"Content-Type": "application/json"})
    check_problem(response, status, code, pointer)


@pytest.mark.parametrize(
    ("headers", "status", "code"),
    [
        ({}, 415, "media_type_unsupported"),
        ({"Content-Type": "text/plain"}, 415, "media_type_unsupported"),
        ({"Content-Type": "application/x-www-form-urlencoded"}, 415, "media_type_unsupported"),
        ({"Content-Type": "application/jsonx"}, 415, "media_type_unsupported"),
        ({"Content-Type": "application/json; charset=utf-16"}, 415, "charset_unsupported"),
        (
            {"Content-Type": "application/json", "Content-Encoding": "gzip"},
            415,
            "content_encoding_unsupported",
        ),
        ({"Content-Type": "application/json", "Accept": "text/html"}, 406, "not_acceptable"),
        ({"Content-Type": "application/json", "Accept": "application/json;q=0"}, 406, "not_acceptable"),
    ],
)
def test_forms_that_are_not_read_or_written(
    client: httpx.Client, headers: dict[str, str], status: int, code: str
) -> None:
    check_problem(client.post(FK, content=b"{}", headers=headers), status, code)


@pytest.mark.parametrize(
    "media_type", ["application/json; charset=UTF-8", "Application/JSON", "application/vnd.x+json"]
)
def test_json_by_other_names_is_read(client: httpx.Client, media_type: str) -> None:
    body = json.dumps({"table": PUMA_560, "joints": Q}).encode()
    assert client.post(FK, content=body, headers={"Content-Type": media_type}).status_code == 200


def pieces(total: int) -> Iterator[bytes]:
    for _ in range(total // 65536):
        yield b" " * 65536


def test_a_body_too_large_is_refused_with_and_without_its_length(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("service.http.uploads.SECONDS", 300.0)  # a busy machine sends slowly
    limits = Settings(body_limit=200_000, batch_body_limit=1_000_000)
    headers = {"Content-Type": "application/json"}
    with running(limits) as url, httpx.Client(base_url=url, timeout=120) as client:
        check_problem(client.post(FK, content=b" " * 1_000_001, headers=headers), 413, "body_too_large")
        check_problem(client.post(FK, content=pieces(4_000_000), headers=headers), 413, "body_too_large")
        check_problem(client.post(FK, content=b" " * 999_999, headers=headers), 400, "body_missing")
        check_problem(
            client.post("/api/v1/convert", content=b" " * 200_001, headers=headers), 413, "body_too_large"
        )


@pytest.mark.parametrize("item", [["x"], "", {"a": 1}])
def test_a_batch_of_texts_is_refused_before_it_is_read(
    client: httpx.Client, item: object, monkeypatch: pytest.MonkeyPatch
) -> None:
    """To read a million of them kept a thread, and the event loop by turns, for a quarter of a second."""
    check_problem(client.post(FK, json={"robot": "puma560", "joints": [item] * 10}), 422, "number_expected")
    with monkeypatch.context() as context:
        context.setattr("service.http.decoding.orjson.loads", None)
        answer = client.post(FK, json={"robot": "puma560", "joints": [item] * 36_000})
    check_problem(answer, 413, "json_too_many_values")


def saved(array: np.ndarray, **options: Any) -> bytes:
    stream = io.BytesIO()
    np.save(stream, array, **options)
    return stream.getvalue()


NPY: dict[str, tuple[bytes, int, str, str]] = {
    "objects": (saved(np.array([{}], dtype=object), allow_pickle=True), 400, "npy_object_refused", ""),
    "text": (saved(np.array(["1"])), 400, "npy_type_unsupported", ""),
    "complex": (saved(np.ones((2, 6), complex)), 400, "npy_type_unsupported", ""),
    "cut short": (saved(np.zeros((3, 6)))[:-1], 400, "npy_length_mismatch", ""),
    "too long": (saved(np.zeros((3, 6))) + b"\0", 400, "npy_length_mismatch", ""),
    "a lying header": (saved(np.zeros((3, 6))).replace(b"(3, 6)", b"(9, 6)"), 400, "npy_length_mismatch", ""),
    "no npy at all": (b'{"joints": []}', 400, "npy_header_invalid", ""),
    "empty": (b"", 400, "npy_header_invalid", ""),
    "wrong columns": (saved(np.zeros((3, 5))), 422, "joints_wrong_length", "/joints"),
    "three dimensions": (saved(np.zeros((3, 6, 1))), 422, "joints_wrong_dimensions", "/joints"),
    "a single number": (saved(np.array(1.0)), 422, "joints_wrong_dimensions", "/joints"),
    "NaN": (saved(np.array([[0, 0, 0, np.nan, 0, 0]])), 422, "joint_not_finite", "/joints/0/3"),
    "infinity": (saved(np.array([Q, [0, 0, np.inf, 0, 0, 0]])), 422, "joint_not_finite", "/joints/1/2"),
    "NaN far down": (saved(np.array([Q] * 80 + [[np.nan] * 6])), 422, "joint_not_finite", "/joints/80/0"),
    "too many": (saved(np.zeros((200_001, 6), "f2")), 413, "batch_too_large", "/joints"),
}  # fmt: skip


@pytest.mark.parametrize("path", [FK, JACOBIAN])
@pytest.mark.parametrize("name", NPY)
def test_arrays_that_cannot_be_meant(client: httpx.Client, name: str, path: str) -> None:
    body, status, code, pointer = NPY[name]
    response = client.post(
        path,
        content=body,
        params={"request": json.dumps({"table": PUMA_560})},
        headers={"Content-Type": "application/x-npy"},
    )
    check_problem(response, status, code, pointer)


@pytest.mark.parametrize(
    ("query", "status", "code"),
    [
        ({}, 422, "query_missing"),
        ({"robot": "puma560", "request": "{}"}, 422, "query_missing"),
        ({"request": "{"}, 400, "json_invalid"),
        ({"request": ""}, 400, "body_missing"),
        ({"request": "[]"}, 422, "body_not_object"),
        ({"request": "{}"}, 422, "table_or_robot"),
        ({"request": '{"robot": "puma560", "joints": [1]}'}, 422, "field_unknown"),
        ({"robot": "puma561"}, 422, "robot_unknown"),
    ],
)
def test_the_rest_of_an_npy_request(
    client: httpx.Client, query: dict[str, str], status: int, code: str
) -> None:
    response = client.post(
        FK, content=saved(np.zeros((2, 6))), params=query, headers={"Content-Type": "application/x-npy"}
    )
    check_problem(response, status, code)


@pytest.mark.parametrize("parts", [["links", "frames"], ["orientation"]])
def test_an_npy_file_holds_one_array(client: httpx.Client, parts: list[str]) -> None:
    body = {"robot": "puma560", "joints": Q, "parts": parts}
    response = client.post(FK, json=body, headers={"Accept": "application/x-npy"})
    check_problem(response, 422, "npy_one_part", "/parts")
