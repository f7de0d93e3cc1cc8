"""POST /grade: a key that the caller keeps."""

from collections.abc import Sequence
from typing import Any

import httpx
import pytest

from tests.examples import GRADE, RX90, SCARA, SCARA_BY_THE_BOOK


def grade(client: httpx.Client, **body: Any) -> httpx.Response:
    return client.post("/api/v1/grade", json=body)


def row(table: dict[str, Any], index: int, **cells: Any) -> dict[str, Any]:
    rows = [dict(entry) for entry in table["rows"]]
    rows[index] |= cells
    return {**table, "rows": rows}


@pytest.mark.parametrize("name", GRADE)
def test_examples_are_answered(client: httpx.Client, name: str) -> None:
    assert grade(client, **GRADE[name]).status_code == 200


def test_a_right_answer_has_a_certificate(client: httpx.Client) -> None:
    body = grade(client, reference=SCARA, submission=SCARA_BY_THE_BOOK).json()
    assert (body["correct"], body["score"], body["basis"]) == (True, 1.0, "proved")
    certificate = body["certificate"]
    assert [len(certificate[name]) for name in ("joint_signs", "joint_offsets", "base", "tool")] == [
        4,
        4,
        4,
        4,
    ]
    assert certificate["residual"] < 1e-9
    assert certificate["samples"] >= 64
    assert certificate["exact"]["joint_offsets"] == ["0", "0", "0", "0"]
    assert all(
        link[fact] == "ok" for link in body["links"] for fact in ("length", "twist", "offset", "joint")
    )
    assert body["repairs"] == []


def test_the_usual_policy_leaves_the_tool_free(client: httpx.Client) -> None:
    elsewhere = row(RX90, 5, d=0.3)
    assert grade(client, reference=RX90, submission=elsewhere).json()["correct"]
    held = grade(client, reference=RX90, submission=elsewhere, policy={"tool": "point"}).json()
    assert not held["correct"]
    assert grade(client, reference=RX90, submission=elsewhere, policy={"tool": "axis"}).json()["correct"]


def test_a_wrong_answer_is_explained(client: httpx.Client) -> None:
    body = grade(client, reference=RX90, submission=row(RX90, 3, alpha=0)).json()
    assert not body["correct"]
    assert 0 < body["score"] < 1
    assert body["certificate"] is None
    assert any(link["row"] == 4 and link["twist"] == "wrong" for link in body["links"])
    assert any(
        edit["row"] == 4 and edit["cell"] == "alpha" for repair in body["repairs"] for edit in repair["edits"]
    )


def test_a_wrong_row_is_told_with_the_axes_between_which_it_is_measured(client: httpx.Client) -> None:
    body = grade(client, reference=RX90, submission=row(RX90, 3, alpha=0)).json()
    told = [entry["message"] for entry in body["feedback"]]
    assert "Row 4: the twist α, the angle from z3 to z4, is not right." in told
    mending = [edit["message"] for repair in body["repairs"] for edit in repair["edits"]]
    assert any(text.endswith("Look again at how z3 and z4 lie relative to each other.") for text in mending)


def test_help_levels(client: httpx.Client) -> None:
    def asked(level: str) -> Any:
        return grade(client, reference=RX90, submission=row(RX90, 3, alpha=0), help=level).json()

    assert asked("verdict")["repairs"] == asked("kind")["repairs"] == []
    assert all("ok" not in link.values() for link in asked("verdict")["links"])
    assert asked("repair")["repairs"]


def test_numbers_are_held_against_the_keys_values(client: httpx.Client) -> None:
    numbers = row(row(RX90, 2, a=0.45), 3, d=0.45)
    assert grade(client, reference=RX90, submission=numbers, parameters={"D3": 0.45, "RL4": 0.45}).json()[
        "correct"
    ]
    millimetres = {**row(row(RX90, 2, a=450), 3, d=450), "length_unit": "mm"}
    assert grade(client, reference=RX90, submission=millimetres, parameters={"D3": 0.45, "RL4": 0.45}).json()[
        "correct"
    ]
    assert not grade(client, reference=RX90, submission=numbers, parameters={"D3": 0.45, "RL4": 0.4}).json()[
        "correct"
    ]


@pytest.mark.parametrize(
    ("change", "code", "pointer"),
    [
        ({"reference": row(RX90, 0, theta="2q1")}, "variable_scaled", "/reference/rows/0/theta"),
        ({"submission": row(RX90, 1, alpha="90°°")}, "symbol_misplaced", "/submission/rows/1/alpha"),
        ({"submission": row(RX90, 1, alpha=None)}, "cell_not_a_value", "/submission/rows/1/alpha"),
        ({"submission": {**RX90, "rows": []}}, "table_empty", "/submission/rows"),
        ({"policy": {"tool": "tip"}}, "value_not_allowed", "/policy/tool"),
        ({"policy": {"tolerance": {"length": 5}}}, "number_too_large", "/policy/tolerance/length"),
        ({"policy": {"tolerance": {"angle": 0}}}, "number_too_small", "/policy/tolerance/angle"),
        ({"parameters": {"X": 1}}, "parameter_unused", "/parameters/X"),
        ({"help": "everything"}, "value_not_allowed", "/help"),
    ],
)
def test_what_cannot_be_graded_costs_no_attempt(
    client: httpx.Client, change: Any, code: str, pointer: str
) -> None:
    answer = grade(client, **{"reference": RX90, "submission": RX90, **change})
    problem = answer.json()
    assert answer.status_code == 422
    assert (problem["code"], problem["pointer"]) == (code, pointer)
    assert problem["attempt_counted"] is False


@pytest.mark.parametrize(
    ("tolerance", "says"),
    [
        ({"angle": 0}, "The number must be greater than 0."),
        ({"length": 5}, "The number must be at most 0.1."),
    ],
)
def test_a_bound_that_is_excluded_itself_is_told_so(
    client: httpx.Client, tolerance: dict[str, float], says: str
) -> None:
    answer = grade(client, reference=RX90, submission=RX90, policy={"tolerance": tolerance})
    assert answer.json()["detail"] == says


def test_both_tables_are_needed(client: httpx.Client) -> None:
    problem = grade(client, reference=RX90).json()
    assert (problem["code"], problem["pointer"]) == ("field_missing", "/submission")


def test_messages_follow_the_language(client: httpx.Client) -> None:
    body = {"reference": SCARA, "submission": SCARA_BY_THE_BOOK}
    english = client.post("/api/v1/grade", json=body).json()
    french = client.post("/api/v1/grade?lang=fr", json=body).json()
    assert english["feedback"][0]["code"] == french["feedback"][0]["code"]
    assert english["feedback"][0]["message"] != french["feedback"][0]["message"]


def test_grading_does_not_stall_others(client: httpx.Client, base_url: str) -> None:
    """While answers with long searches for repairs are judged, a small question is answered."""
    import threading

    wrong = row(row(RX90, 3, alpha=0), 2, a=0)

    def answered_meanwhile(lengths: Sequence[float]) -> int:
        done = threading.Event()

        def keep_busy() -> None:
            with httpx.Client(base_url=base_url, timeout=120) as other:
                for d in lengths:
                    other.post("/api/v1/grade", json={"reference": RX90, "submission": row(wrong, 5, d=d)})
            done.set()

        thread = threading.Thread(target=keep_busy)
        thread.start()
        answered = 0
        while not done.is_set() and answered < 500:
            assert client.get("/healthz").status_code == 200
            answered += 1
        thread.join()
        return answered

    tries = range(5)  # on a busy machine whoever asks may have stood still meanwhile
    assert any(answered_meanwhile([(4 * n + k) / 29 for k in range(4)]) > 3 for n in tries)
