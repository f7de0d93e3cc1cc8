"""POST /understand: what the table editor shows beneath each cell."""

import math
from typing import Any

import httpx
import pytest


def row(joint: str | None = "revolute", **cells: Any) -> dict[str, Any]:
    typed = {"alpha": 0, "a": 0, "d": 0, "theta": 0, **cells}
    return {**typed, "joint": joint} if joint else typed


def understand(client: httpx.Client, *rows: dict[str, Any], **table: Any) -> dict[str, Any]:
    whole = {"convention": "modified", "angle_unit": "deg", "rows": list(rows), **table}
    answer = client.post("/api/v1/understand", json={"table": whole})
    assert answer.status_code == 200, answer.text
    return answer.json()  # type: ignore[no-any-return]


def test_every_cell_is_said_in_radians_and_with_its_variable(client: httpx.Client) -> None:
    answer = understand(
        client,
        row(alpha="-90", a="2L1", theta="θ1 + 90"),
        row("prismatic", d="L2 - d_2", theta="45°"),
        row("fixed", d="0.4318"),
    )
    assert answer["readable"] is True
    assert answer["faults"] == []
    text = [{name: r[name]["text"] for name in ("alpha", "a", "d", "theta")} for r in answer["rows"]]
    assert text == [
        {"alpha": "-pi/2", "a": "2*L1", "d": "0", "theta": "q1 + pi/2"},
        {"alpha": "0", "a": "0", "d": "-q2 + L2", "theta": "pi/4"},
        {"alpha": "0", "a": "0", "d": "0.4318", "theta": "0"},
    ]
    assert [(r["joint"], r["sign"], r["variable"]) for r in answer["rows"]] == [
        ("revolute", 1, "q1"),
        ("prismatic", -1, "q2"),
        ("fixed", 1, None),
    ]
    assert answer["rows"][0]["alpha"]["latex"] == r"-\frac{\pi}{2}"
    assert answer["rows"][0]["alpha"]["mathml"].startswith("<math")
    assert "<mfrac>" in answer["rows"][0]["alpha"]["mathml"]
    assert answer["parameters"] == [{"name": "L1", "kind": "length"}, {"name": "L2", "kind": "length"}]


def test_an_offset_under_a_stated_joint_is_shown_with_its_variable(client: httpx.Client) -> None:
    answer = understand(client, row(theta="30"), row("prismatic", d="0.2"))
    assert answer["rows"][0]["theta"]["text"] == "q1 + pi/6"
    assert answer["rows"][1]["d"]["text"] == "q2 + 0.2"


def test_cells_that_cannot_be_read_leave_the_others_their_meaning(client: httpx.Client) -> None:
    answer = understand(client, row(alpha="", a="2(L1", theta="θ1"), row(alpha="90", d="1/0", theta="q2"))
    assert answer["readable"] is False
    assert {(fault["pointer"], fault["code"]) for fault in answer["faults"]} >= {
        ("/table/rows/0/alpha", "cell_empty"),
        ("/table/rows/0/a", "parenthesis_not_closed"),
    }
    assert {fault["pointer"] for fault in answer["faults"]} == {
        "/table/rows/0/alpha",
        "/table/rows/0/a",
        "/table/rows/1/d",
    }
    first, second = answer["rows"]
    assert (first["alpha"], first["a"], second["d"]) == (None, None, None)
    assert (first["theta"]["text"], second["alpha"]["text"]) == ("q1", "pi/2")


def test_rows_that_form_no_table_are_said_to_form_none(client: httpx.Client) -> None:
    answer = understand(
        client, row(None, theta="q1"), row("fixed"), row(None, theta="q3"), row(None, theta="q3")
    )
    assert answer["readable"] is False
    assert answer["faults"]


def test_faults_are_told_in_the_callers_language(client: httpx.Client) -> None:
    table = {"convention": "standard", "rows": [row(alpha="")]}
    details = set()
    for language in ("en", "ro", "pt", "fr", "uk", "es"):
        answer = client.post(
            "/api/v1/understand", json={"table": table}, headers={"Accept-Language": language}
        )
        assert answer.headers["content-language"] == language
        details.add(answer.json()["faults"][0]["detail"])
    assert len(details) == 6


def test_what_is_no_table_is_refused(client: httpx.Client) -> None:
    for body in ({}, {"table": 1}, {"table": {"convention": "other", "rows": []}}):
        answer = client.post("/api/v1/understand", json=body)
        assert answer.status_code == 422
        assert answer.json()["errors"][0]["pointer"].startswith("/table")


def link(client: httpx.Client, table: dict[str, Any], parameters: dict[str, float]) -> list[Any]:
    body = {
        "table": table,
        "parameters": parameters,
        "joints": [0.0] * len(table["rows"]),
        "parts": ["links"],
    }
    answer = client.post("/api/v1/forward-kinematics", json=body)
    assert answer.status_code == 200, answer.text
    return answer.json()["links"]  # type: ignore[no-any-return]


def test_links_come_with_the_meaning(client: httpx.Client) -> None:
    """One call is enough to draw a table: its links are those of /forward-kinematics at zero."""
    rows = [row(alpha="-90", a="a2", theta="90 - θ1"), row("prismatic", alpha="b", d="d2 + L_1", theta="30")]
    values = {"a2": 0.4, "L1": 0.2, "b": 30.0}
    for convention in ("modified", "standard"):
        table = {"convention": convention, "angle_unit": "deg", "rows": rows}
        body = {"table": table, "parameters": {**values, "unused": 7.0}}
        answer = client.post("/api/v1/understand", json=body).json()
        found = [r["link"] for r in answer["rows"]]
        expected = link(client, table, values)
        for one, other in zip(found, expected, strict=True):
            for here, there in zip(one, other, strict=True):
                assert here == pytest.approx(there, abs=1e-15)
        assert [r["theta"]["value"] for r in answer["rows"]] == pytest.approx([math.pi / 2, math.pi / 6])
        assert [r["d"]["value"] for r in answer["rows"]] == pytest.approx([0.0, 0.2])


def test_rows_beside_a_fault_have_their_links(client: httpx.Client) -> None:
    """Half a table can be drawn: what cannot be read, or has no value, has no link."""
    table = {
        "convention": "standard",
        "angle_unit": "deg",
        "rows": [row(a="1"), row(a="("), row(a="L1"), row(d="1/x", a="2")],
    }
    answer = client.post("/api/v1/understand", json={"table": table, "parameters": {"x": 0}}).json()
    assert [r["link"] is not None for r in answer["rows"]] == [True, False, False, False]
    assert answer["rows"][2]["a"]["value"] is None
    assert answer["rows"][3]["d"]["value"] is None


def test_cells_of_matrices_are_read_in_the_variables_of_the_table(client: httpx.Client) -> None:
    matrix = [
        ["c1", "-s12", "0", "a2*c1"],
        ["", "q9", "(", "d3"],
        ["0", "0", "1", "1/2"],
        ["0", "0", "0", "1"],
    ]
    table = {"convention": "modified", "rows": [row(theta="θ1"), row(theta="θ2")]}
    answer = client.post("/api/v1/understand", json={"table": table, "matrices": [matrix]})
    assert answer.status_code == 200, answer.text
    (read,) = answer.json()["matrices"]
    assert read[0][1]["text"] == "-sin(q1 + q2)"
    assert (read[0][0]["value"], read[0][3]["value"], read[2][3]["value"]) == (1.0, None, 0.5)
    assert read[1] == [None, None, None, read[1][3]]
    assert [fault["pointer"] for fault in answer.json()["faults"]] == ["/matrices/0/1/1", "/matrices/0/1/2"]
