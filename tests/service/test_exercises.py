"""Exercises over HTTP: list, statement, figure, grading."""

import json
import re
import threading
from collections.abc import Iterator
from pathlib import Path
from typing import Any, cast

import httpx
import numpy as np
import pytest

from exercises.definition import Exercise
from exercises.needs import unneeded_dimensions
from service.__main__ import main
from service.settings import Settings
from service.wire.exercises import exercise_views
from tests.examples import ANSWERS, SCARA_BY_THE_BOOK
from tests.exercises.folders import TWO_LINKS, folder
from tests.exercises.packaged import exercise, exercise_ids, table_ids
from tests.live_service import running

LANGUAGES = ("en", "es", "fr", "pt", "ro", "uk")
PUMA_BY_CRAIG = {
    "convention": "modified",
    "angle_unit": "deg",
    "rows": [
        {"alpha": 0, "a": 0, "d": 0, "theta": "q1"},
        {"alpha": -90, "a": 0, "d": 0, "theta": "q2"},
        {"alpha": 0, "a": "a2", "d": "d3", "theta": "q3"},
        {"alpha": -90, "a": "a3", "d": "d4", "theta": "q4"},
        {"alpha": 90, "a": 0, "d": 0, "theta": "q5"},
        {"alpha": -90, "a": 0, "d": 0, "theta": "q6"},
    ],
}


def grade(client: httpx.Client, exercise_id: str, body: Any, **headers: str) -> httpx.Response:
    return client.post(f"/api/v1/exercises/{exercise_id}/grade", json=body, headers=headers)


def test_others_are_served_while_it_is_found_out_which_dimensions_are_needed(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """It takes tens of milliseconds, with the first visit to an exercise: a thread does it."""
    exercise_views.free_dimensions.cache_clear()
    found: list[str] = []

    def noted(asked: Exercise) -> tuple[str, ...]:
        found.append(threading.current_thread().name)
        return unneeded_dimensions(asked)

    monkeypatch.setattr(exercise_views, "unneeded_dimensions", noted)
    asked, first = "/api/v1/exercises/scara", {"seed": "of nobody who was here before"}
    with running(Settings(storage="off")) as url:  # a service that has not seen yet how long a visit takes
        seen = [httpx.get(f"{url}{asked}", params=first, timeout=120).json()["dimensions"] for _ in range(2)]
    assert seen[0] == seen[1]
    assert len(found) == 1
    assert found[0].startswith("limited")


def test_the_list_names_every_exercise_in_every_language(client: httpx.Client) -> None:
    titles = set()
    for language in LANGUAGES:
        answer = client.get("/api/v1/exercises", params={"lang": language})
        assert answer.headers["content-language"] == language
        body = answer.json()
        assert [entry["id"] for entry in body["exercises"]] == list(exercise_ids)
        assert body["languages"] == list(LANGUAGES)
        titles.add(next(entry["title"] for entry in body["exercises"] if entry["id"] == "cloos"))
        assert all(entry["summary"].endswith((".", "?")) for entry in body["exercises"])
    assert len(titles) == 6


def test_accept_language_decides_unless_the_address_does(client: httpx.Client) -> None:
    header = {"Accept-Language": "uk;q=0.9, de"}
    assert client.get("/api/v1/exercises/dmra", headers=header).json()["language"] == "uk"
    assert client.get("/api/v1/exercises/dmra?lang=ro", headers=header).json()["language"] == "ro"
    refused = client.get("/api/v1/exercises/dmra?lang=de")
    assert (refused.status_code, refused.json()["code"], refused.json()["errors"][0]["in"]) == (
        422,
        "language_unknown",
        "query",
    )


@pytest.mark.parametrize("exercise_id", exercise_ids)
def test_an_exercise_tells_all_that_a_student_needs(client: httpx.Client, exercise_id: str) -> None:
    found = exercise(exercise_id)
    held = {part.kind for part in found.parts} & {"table", "frames", "screws"}
    for language in LANGUAGES:
        asked = {"lang": language, "seed": "4"}
        body = client.get(f"/api/v1/exercises/{exercise_id}", params=asked).json()
        assert body["language"] == language
        assert body["title"] == found.titles[language]
        assert body["statement"]["html"].startswith("<p>")
        assert set(body["parameters"]) == {parameter.name for parameter in found.parameters}
        assert [part["kind"] for part in body["parts"]] == [part.kind for part in found.parts]
        assert all(part["task"] and "{" not in part["task"] for part in body["parts"])
        free = [entry["name"] for entry in body["dimensions"] if not entry["needed"]]
        more = bool(free and exercise_id in table_ids) - (held == {"screws"})  # no convention without a table
        assert len(body["rules"]) == (5 + more if held else 0)
        assert all("{" not in rule and rule.endswith(".") for rule in body["rules"])
        assert body["points"] == 100
        assert len(body["joints"]) == len(body["figure"]["axes"]) == found.reference.table.n_joints
        assert body["figure"]["description"].count(".") > 4
        assert {entry["name"] for entry in body["figure"]["dimensions"]} == set(body["parameters"])


@pytest.mark.parametrize("exercise_id", table_ids)
def test_the_key_is_never_told(client: httpx.Client, exercise_id: str) -> None:
    body = client.get(f"/api/v1/exercises/{exercise_id}").json()
    policy = body.pop("policy")
    for part in body["parts"]:
        del part["form"], part["numbers"]  # what is given, and how many rows an answer may have
    last = len(exercise(exercise_id).reference.table.rows)
    prescribed = [i for i, rule in ((0, "base"), (last, "tool")) if policy[rule] == "frame"]
    assert [frame["number"] for frame in body["figure"].pop("frames")] == prescribed
    names = set(re.findall(r'"(\w+)":', json.dumps(body)))
    assert not names & {
        "reference",
        "table",
        "rows",
        "alpha",
        "theta",
        "base",
        "posture",
        "frames",
        "frame",
        "key",
    }
    assert all(max(axis["direction"], key=abs) > 0 for axis in body["figure"]["axes"])


def test_values_follow_the_seed(client: httpx.Client) -> None:
    def parameters(query: str) -> Any:
        return client.get(f"/api/v1/exercises/puma560{query}").json()["parameters"]

    assert parameters("") == {"a2": 0.4318, "a3": 0.0203, "d3": 0.15005, "d4": 0.4318}
    assert parameters("?seed=7") == parameters("?seed=7") != parameters("")
    assert len({json.dumps(parameters(f"?seed={seed}")) for seed in range(20)}) > 15
    too_long = client.get("/api/v1/exercises/puma560", params={"seed": "x" * 201})
    assert too_long.status_code == 422


@pytest.mark.parametrize("path", ["", "/figure.svg"])
def test_an_unknown_exercise_is_an_address_at_which_nothing_is(client: httpx.Client, path: str) -> None:
    answer = client.get(f"/api/v1/exercises/r2d2{path}")
    assert (answer.status_code, answer.json()["code"]) == (404, "exercise_unknown")
    assert grade(client, "r2d2", {}).status_code == 404
    assert grade(client, "r2d2", {"colour": 1}).status_code == 404


@pytest.mark.parametrize("exercise_id", ["puma560", "scara", "rx90"])
def test_the_figure_is_svg_in_the_readers_language(client: httpx.Client, exercise_id: str) -> None:
    for language in LANGUAGES:
        answer = client.get(f"/api/v1/exercises/{exercise_id}/figure.svg", params={"lang": language})
        assert answer.headers["content-type"] == "image/svg+xml"
        assert f'lang="{language}"' in answer.text
        assert exercise(exercise_id).titles[language] in answer.text


def test_a_figure_is_not_sent_twice(client: httpx.Client) -> None:
    first = client.get("/api/v1/exercises/uw/figure.svg")
    again = client.get("/api/v1/exercises/uw/figure.svg", headers={"If-None-Match": first.headers["etag"]})
    assert (again.status_code, again.content) == (304, b"")
    other = client.get(
        "/api/v1/exercises/uw/figure.svg?lang=fr", headers={"If-None-Match": first.headers["etag"]}
    )
    assert other.status_code == 200


def test_the_figures_style_may_be_applied(client: httpx.Client) -> None:
    """Opened by itself, the figure follows the reader's dark scheme: its policy must allow its own style."""
    policy = client.get("/api/v1/exercises/uw/figure.svg").headers["content-security-policy"]
    assert "style-src 'unsafe-inline'" in policy
    assert "default-src 'none'" in policy


def test_puma_in_craigs_form_is_right(client: httpx.Client) -> None:
    for seed in (None, "3", 17):
        body = grade(client, "puma560", {"table": PUMA_BY_CRAIG, "seed": seed}).json()
        assert (body["correct"], body["score"], body["basis"]) == (True, 1.0, "proved")
        assert body["seed"] == (None if seed is None else str(seed))
        assert body["parts"]["table"]["points"] == 35
        assert body["total"]["score"] == 0.35
        assert body["total"]["missing"] == ["schematic", "link_matrices", "transform", "pose", "workspace"]


def test_puma_in_numbers_is_right_for_its_own_seed_only(client: httpx.Client) -> None:
    values = client.get("/api/v1/exercises/puma560?seed=7").json()["parameters"]
    rows = [{name: values.get(cell, cell) for name, cell in row.items()} for row in PUMA_BY_CRAIG["rows"]]
    table = {**PUMA_BY_CRAIG, "rows": rows}
    assert grade(client, "puma560", {"table": table, "seed": "7"}).json()["correct"]
    assert not grade(client, "puma560", {"table": table}).json()["correct"]


def test_a_seed_in_the_address_is_the_students_too(client: httpx.Client) -> None:
    body = {"table": PUMA_BY_CRAIG}
    at = "/api/v1/exercises/puma560/grade?seed=7"
    assert client.post(at, json=body).json() == grade(client, "puma560", body | {"seed": "7"}).json()
    assert client.post(at, json=body | {"seed": "3"}).json()["seed"] == "3"


def test_every_part_of_the_answer_is_judged(client: httpx.Client) -> None:
    body = grade(client, "scara", ANSWERS["all parts"]).json()
    scores = {kind: part["score"] for kind, part in body["parts"].items()}
    assert scores == {"schematic": 1, "table": 1, "link_matrices": 0.75, "transform": 1, "workspace": 1}
    assert body["parts"]["link_matrices"]["facts"][3] == {"where": [3], "finding": "missing"}
    assert body["total"]["points"] == pytest.approx(15 + 35 + 11.25 + 15 + 10)
    assert body["help"] == "kind"


def test_an_accepted_answer_shows_the_key_in_the_figure(client: httpx.Client) -> None:
    right = grade(client, "scara", {"table": SCARA_BY_THE_BOOK}).json()
    assert set(right["figure"]) == {"base", "posture", "directions"}
    assert np.array(right["figure"]["base"]).shape == (4, 4)
    wrong = {
        **SCARA_BY_THE_BOOK,
        "rows": [{**SCARA_BY_THE_BOOK["rows"][0], "alpha": 90}, *SCARA_BY_THE_BOOK["rows"][1:]],
    }
    assert grade(client, "scara", {"table": wrong}).json()["figure"] is None


def test_parts_alone_are_judged_without_a_table(client: httpx.Client) -> None:
    body = grade(client, "scara", {"workspace": {"inner": 0.1, "outer": 0.9}}).json()
    assert (body["correct"], body["score"], body["basis"], body["certificate"]) == (False, 0.5, None, None)
    assert set(body["parts"]) == {"workspace"}


@pytest.mark.parametrize("language", LANGUAGES)
def test_feedback_is_spoken_in_every_language(client: httpx.Client, language: str) -> None:
    matrix = [["c1", "s1", 0, "-a2"], ["-s1", "c1", 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]
    wrong = {
        **SCARA_BY_THE_BOOK,
        "rows": [{**SCARA_BY_THE_BOOK["rows"][0], "alpha": 90}, *SCARA_BY_THE_BOOK["rows"][1:]],
    }
    answer = grade(
        client,
        "scara",
        {
            "table": wrong,
            "link_matrices": [matrix, None, None, None],
            "workspace": {"inner": 0.9, "outer": 0.9},
            "schematic": {"joints": ["revolute"], "relations": []},
        },
        **{"Accept-Language": language},
    )
    assert answer.headers["content-language"] == language
    body = answer.json()
    for entry in told(body):
        assert entry["message"] != entry["code"]
        assert "{" not in entry["message"]


def told(body: Any) -> Iterator[Any]:
    yield from body["feedback"]
    for repair in body["repairs"]:
        yield from repair["edits"]
    for part in body["parts"].values():
        yield from part["feedback"]


@pytest.mark.parametrize(
    ("body", "code", "pointer"),
    [
        ({}, "answer_empty", ""),
        ({"table": {**SCARA_BY_THE_BOOK, "rows": []}}, "table_empty", "/table/rows"),
        (
            {"table": {**SCARA_BY_THE_BOOK, "rows": [{"theta": "(q1", "d": 0, "a": 0, "alpha": 0}]}},
            "parenthesis_not_closed",
            "/table/rows/0/theta",
        ),
        ({"table": SCARA_BY_THE_BOOK, "colour": 1}, "field_unknown", "/colour"),
        ({"transform": [[1, 2, 3]]}, "list_too_short", "/transform/0"),
        (
            {"transform": [["#", 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]},
            "character_not_allowed",
            "/transform/0/0",
        ),
        ({"pose": [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]}, "pose_needs_table", "/pose"),
        (
            {"schematic": {"joints": ["revolute"], "relations": ["parallel"]}},
            "schematic_relations_count",
            "/schematic/relations",
        ),
        ({"schematic": {"joints": ["screw"], "relations": []}}, "value_not_allowed", "/schematic/joints/0"),
        ({"workspace": {"inner": "#", "outer": 1}}, "character_not_allowed", "/workspace/inner"),
        ({"table": SCARA_BY_THE_BOOK, "help": "all"}, "value_not_allowed", "/help"),
        ({"table": SCARA_BY_THE_BOOK, "seed": "x" * 201}, "seed_too_long", "/seed"),
        ({"table": SCARA_BY_THE_BOOK, "seed": 1.5}, "seed_invalid", "/seed"),
        ([], "body_not_object", ""),
    ],
)
def test_what_cannot_be_graded_costs_no_attempt(
    client: httpx.Client, body: Any, code: str, pointer: str
) -> None:
    answer = grade(client, "scara", body)
    problem = answer.json()
    assert answer.headers["content-type"] == "application/problem+json"
    assert answer.status_code == 422
    assert (problem["code"], problem["pointer"]) == (code, pointer)
    assert problem["attempt_counted"] is False
    assert problem["note"] == "This answer was not graded and costs no attempt."


@pytest.mark.parametrize("row", [True, 1.5, [1], {"row": 1}])
def test_what_is_neither_a_number_nor_text_is_told_once_and_at_its_place(
    client: httpx.Client, row: Any
) -> None:
    answer = grade(client, "rx90-find-mistake", {"find_mistake": {"row": row}})
    told = [(entry["code"], entry["pointer"], entry["params"]) for entry in answer.json()["errors"]]
    assert told == [("integer_expected", "/find_mistake/row", {"field": "row"})]


@pytest.mark.parametrize(
    ("value", "code"), [([1], "cell_not_a_value"), (True, "cell_not_a_value"), ("0,5", "decimal_comma")]
)
def test_a_cell_that_stands_alone_is_told_once_and_at_its_place(
    client: httpx.Client, value: Any, code: str
) -> None:
    orientation = {"middle": 90, "value": value, "combination": "sum"}
    answer = grade(client, "puma560-gimbal-lock", {"orientation": orientation})
    told = [(entry["code"], entry["pointer"]) for entry in answer.json()["errors"]]
    assert told == [(code, "/orientation/value")]


def test_a_body_that_is_not_json_costs_no_attempt(client: httpx.Client) -> None:
    answer = client.post(
        "/api/v1/exercises/scara/grade",
        content=b"{",
        headers={"Content-Type": "application/json", "Accept-Language": "fr"},
    )
    assert (answer.status_code, answer.json()["attempt_counted"]) == (400, False)
    assert answer.json()["note"] == "Cette réponse n’a pas été notée et ne coûte aucun essai."


def test_less_help_may_be_asked_for(client: httpx.Client) -> None:
    wrong = {
        **SCARA_BY_THE_BOOK,
        "rows": [{**SCARA_BY_THE_BOOK["rows"][0], "alpha": 90}, *SCARA_BY_THE_BOOK["rows"][1:]],
    }
    for level, repairs, rows in (("verdict", 0, False), ("row", 0, True), ("repair", 1, True)):
        body = grade(client, "scara", {"table": wrong, "help": level}).json()
        assert body["help"] == level
        assert bool(body["repairs"]) is bool(repairs)
        assert any(entry["row"] for entry in body["feedback"]) is rows


def test_exercises_of_ones_own_are_served(tmp_path: Path) -> None:
    folder(tmp_path, name="crane")
    with (
        running(Settings(exercise_folders=(tmp_path,))) as url,
        httpx.Client(base_url=url, timeout=120) as own,
    ):
        assert "crane" in {entry["id"] for entry in own.get("/api/v1/exercises").json()["exercises"]}
        assert own.get("/api/v1/exercises/crane/figure.svg").status_code == 200
        table = {
            "convention": "modified",
            "rows": [
                {"alpha": 0, "a": 0, "d": 0, "theta": "q1"},
                {"alpha": 0, "a": "L1", "d": 0, "theta": "q2"},
            ],
        }
        assert grade(own, "crane", {"table": table}).json()["correct"]


def test_a_malformed_exercise_of_ones_own_stops_the_service(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    folder(tmp_path, "version = 1")
    monkeypatch.setenv("FRAMEWISE_EXERCISE_FOLDERS", str(tmp_path))
    with pytest.raises(SystemExit, match="2"):
        main(["--port", "0"])
    assert "two/exercise.toml: title" in capsys.readouterr().err


def test_a_reader_is_told_the_language_of_a_text_by_its_name() -> None:
    class InEnglish:
        def text_language(self, language: str) -> str:
            return "en"

    note = exercise_views.language_note(cast("Exercise", InEnglish()), "fr")
    assert note is not None
    assert note.endswith("English.")


def test_the_page_of_a_text_in_another_language_says_so(tmp_path: Path) -> None:
    """It was said in the answer of the API alone, and the text was read aloud as in the page's language."""
    (folder(tmp_path, name="crane") / "statement.uk.md").unlink()
    with (
        running(Settings(exercise_folders=(tmp_path,))) as url,
        httpx.Client(base_url=url, timeout=120) as own,
    ):
        note = own.get("/api/v1/exercises/crane?lang=uk").json()["note"]
        translated, other = (own.get(f"/exercises/crane?lang={code}").text for code in ("fr", "uk"))
    assert note in other
    assert 'id="statement" class="prose" lang="en"' in other
    assert 'id="statement" class="prose" lang="fr"' in translated
    assert "Langue du texte" not in translated


def test_the_limits_by_which_a_workspace_is_judged_are_told(tmp_path: Path) -> None:
    """Students read that the joints keep to their limits, and nowhere which these are."""
    asked = """
[policy]
tool = "point"

[figure]
posture = [0, -30]
marks = ["P"]
points.P = { frame = 2 }

[[parts]]
kind = "workspace"
points = 10
point = "P"
limits = [[], [-22.5, 120]]
"""
    folder(tmp_path, TWO_LINKS.replace('[[parts]]\nkind = "table"\npoints = 10\n', asked), name="crane")
    with (
        running(Settings(exercise_folders=(tmp_path,))) as url,
        httpx.Client(base_url=url, timeout=120) as own,
    ):
        for code in ("en", "es", "fr", "pt", "ro", "uk"):
            low = "22.5" if code == "en" else "22,5"
            (part,) = own.get(f"/api/v1/exercises/crane?lang={code}").json()["parts"]
            assert f"−{low}° ≤ q2 ≤ 120°" in part["task"]
            assert "q2 = −30°" in part["task"]
            assert "q1" not in part["task"]
