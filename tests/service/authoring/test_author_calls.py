"""An exercise made over HTTP: started, tried, tested, taken along, published; what is hostile refused."""

import io
import zipfile
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import httpx
import pytest

from exercises.library import ROOT, packaged
from service.settings import Settings
from tests.conftest import EXPLORE
from tests.examples import DRAFT, DRAWING
from tests.live_service import running

PATIENCE = 120.0
CALLS = "/api/v1/author/"
REBUILT = packaged().ids if EXPLORE else packaged().ids[::4]
"""Which exercises are taken over HTTP; that each comes out as it went in is tests/exercises' business."""


@pytest.fixture(scope="module")
def client(tmp_path_factory: pytest.TempPathFactory) -> Iterator[httpx.Client]:
    folder = tmp_path_factory.mktemp("data")
    with (
        running(Settings(storage="on", data_folder=folder, symbolic_seconds=60.0)) as origin,
        httpx.Client(base_url=origin, timeout=PATIENCE) as connected,
    ):
        yield connected


def zipped(exercise_id: str) -> bytes:
    stream = io.BytesIO()
    with zipfile.ZipFile(stream, "w") as archive:
        for file in (ROOT / exercise_id).iterdir():
            archive.writestr(f"{exercise_id}/{file.name}", file.read_bytes())
    return stream.getvalue()


def taken(client: httpx.Client, archive: bytes) -> httpx.Response:
    return client.post(f"{CALLS}import", content=archive, headers={"Content-Type": "application/zip"})


@pytest.mark.parametrize("exercise_id", REBUILT)
def test_a_shipped_exercise_is_rebuilt_by_the_editors_own_calls(
    client: httpx.Client, exercise_id: str
) -> None:
    draft = taken(client, zipped(exercise_id)).json()["draft"]
    robot = draft["definition"]["robot"]
    started = client.post(f"{CALLS}start", json={"id": exercise_id, "source": {"robot": robot}})
    assert started.status_code == 200
    rebuilt = {**started.json()["draft"], **{key: draft[key] for key in ("definition", "statements")}}
    answer = client.post(f"{CALLS}folder.zip", json={"draft": rebuilt})
    assert answer.status_code == 200
    with zipfile.ZipFile(io.BytesIO(answer.content)) as archive:
        files = {name: archive.read(name) for name in archive.namelist()}
    own = {f"{exercise_id}/{file.name}": file.read_bytes() for file in (ROOT / exercise_id).iterdir()}
    assert files == own


def test_a_drawing_becomes_an_exercise_that_tests_itself(client: httpx.Client) -> None:
    started = client.post(f"{CALLS}start", json={"id": "my-arm", "source": {"axes": DRAWING}}).json()
    assert [axis["point"] for axis in started["axes"]] == [[0, 0, 0], [0, 0, 0.4], [0.5, 0, 0.4]]
    assert [row["a"] for row in started["draft"]["definition"]["reference"]["rows"]] == [0, 0, "L1"]
    for seed in ({}, {"seed": 1}):
        found = client.post(f"{CALLS}check", json={"draft": started["draft"], **seed}).json()
        assert found["failures"] == []
        assert found["passed"] > 20
        assert {line["check"] for line in found["warnings"]} == {"unneeded"}


def test_a_preview_is_what_students_see(client: httpx.Client) -> None:
    shown = client.post(f"{CALLS}preview", json={"draft": DRAFT}, headers={"Accept-Language": "ro"}).json()
    assert shown["exercise"]["title"] == "Două elemente"
    assert shown["figure"].startswith("<svg")
    assert (
        shown["statements"]["en"]
        == "<p>Two links of lengths <var>L<sub>1</sub></var> and <var>L<sub>2</sub></var>.</p>"
    )
    assert shown["policy"]["admitted"] <= shown["policy"]["choices"]
    assert str(shown["policy"]["choices"]) in shown["policy"]["message"]
    assert shown["key"]["rows"][0]["a"] == "L1"


def test_right_and_wrong_answers_are_shown_with_their_marks(client: httpx.Client) -> None:
    right = client.post(f"{CALLS}right-answers", json={"draft": DRAFT, "count": 10}).json()["answers"]
    assert len(right) == 10
    assert all(answer["correct"] and answer["points"] == 10 for answer in right)
    wrong = client.post(f"{CALLS}mistakes", json={"draft": DRAFT}).json()["answers"]
    assert len(wrong) >= 8
    assert all(answer["refused"] or answer["score"] < 1 for answer in wrong)
    assert any(edit["message"] for answer in wrong for edit in answer["repairs"])


def answer_of(**cells: Any) -> dict[str, Any]:
    rows = [
        {"theta": "q1", "d": 0, "a": "L1", "alpha": 0, **cells},
        {"theta": "q2", "d": 0, "a": "L2", "alpha": 0},
    ]
    return {"table": {"convention": "standard", "angle_unit": "deg", "rows": rows}}


def test_a_student_would_be_told_the_same(client: httpx.Client) -> None:
    words = {**DRAFT["definition"], "remarks": {"alpha_value": {"en": "These axes are parallel."}}}
    draft = {**DRAFT, "definition": words}
    right = client.post(f"{CALLS}grade", json={"draft": draft, "answer": answer_of()})
    assert right.json()["total"]["score"] == 1
    wrong = client.post(f"{CALLS}grade", json={"draft": draft, "answer": answer_of(alpha=90)}).json()
    assert wrong["total"]["score"] < 1
    assert wrong["remarks"] == ["These axes are parallel."]
    refused = client.post(f"{CALLS}grade", json={"draft": draft, "answer": answer_of(alpha="(")})
    assert refused.status_code == 422
    assert refused.json()["attempt_counted"] is False
    assert refused.json()["errors"][0]["pointer"] == "/answer/table/rows/0/alpha"
    misshapen = client.post(f"{CALLS}grade", json={"draft": draft, "answer": {**answer_of(), "seed": {}}})
    assert [error["pointer"] for error in misshapen.json()["errors"]] == ["/answer/seed"]


def test_a_published_version_never_changes(client: httpx.Client) -> None:
    first = client.post(f"{CALLS}publish", json={"draft": DRAFT}).json()
    again = client.post(f"{CALLS}publish", json={"draft": DRAFT}).json()
    assert first == again
    longer = {
        **DRAFT,
        "definition": {**DRAFT["definition"], "parameters": {"L1": {"value": 2}, "L2": {"value": 1}}},
    }
    other = client.post(f"{CALLS}publish", json={"draft": longer}).json()
    assert other["id"] != first["id"]
    values = [client.get(f"/api/v1/exercises/{found['id']}").json()["parameters"] for found in (first, other)]
    assert values == [{"L1": 0.5, "L2": 0.3}, {"L1": 2, "L2": 1}]
    graded = client.post(f"/api/v1/exercises/{first['id']}/grade", json=answer_of())
    assert graded.json()["total"]["score"] == 1
    assert client.get(f"/api/v1/exercises/{first['id']}/scorm.zip").status_code == 200
    refused = client.get(f"/api/v1/exercises/{first['id']}/scorm.zip", params={"pass": "nan"})
    assert (refused.status_code, refused.json()["code"]) == (422, "number_not_finite")
    assert client.get(f"/exercises/{first['id']}").status_code == 200
    assert first["id"] not in {entry["id"] for entry in client.get("/api/v1/exercises").json()["exercises"]}


def test_a_published_version_outlives_the_process(tmp_path: Path) -> None:
    settings = Settings(storage="on", data_folder=tmp_path, symbolic_seconds=60.0)
    with running(settings) as origin:
        draft = {"draft": DRAFT}
        address = httpx.post(f"{origin}{CALLS}publish", json=draft, timeout=PATIENCE).json()["id"]
    with running(settings) as origin:
        assert httpx.get(f"{origin}/api/v1/exercises/{address}", timeout=PATIENCE).status_code == 200
        assert httpx.get(f"{origin}/api/v1/exercises/{address}x", timeout=PATIENCE).status_code == 404


def test_without_storage_everything_works_but_publishing() -> None:
    with running(Settings(storage="off", symbolic_seconds=60.0)) as origin:
        draft = {"draft": DRAFT}
        assert httpx.post(f"{origin}{CALLS}folder.zip", json=draft, timeout=PATIENCE).status_code == 200
        refused = httpx.post(f"{origin}{CALLS}publish", json=draft, timeout=PATIENCE)
        assert (refused.status_code, refused.json()["code"]) == (404, "storage_off")


HOSTILE: dict[str, tuple[str, Any, str]] = {
    "SVG in the title": ("definition", {"title": {"en": "<svg onload=alert(1)>"}}, "text_markup"),
    "a path as id": ("id", "../../etc/cron.d/x", "exercise_id_invalid"),
    "a script in the statement": ("statements", {"en": "<script>alert(1)</script>"}, "text_markup"),
    "a language that is a path": ("statements", {"../x": "y"}, "exercise_key_unknown"),
    "a remark with markup": ("definition", {"remarks": {"a_sign": {"en": "<img src=x>"}}}, "text_markup"),
    "code as a length": (
        "definition",
        {"parameters": {"L1": {"value": "__import__('os')"}, "L2": {"value": 1}}},
        "exercise_value_type",
    ),
    "endless points": (
        "definition",
        {"figure": {"points": {f"P{i}": {"frame": 0} for i in range(400)}}},
        "draft_too_large",
    ),
    "an unknown key": ("definition", {"shell": "rm -rf /"}, "exercise_key_unknown"),
}


@pytest.mark.parametrize("name", HOSTILE)
@pytest.mark.parametrize("call", ["preview", "check", "folder.zip", "publish", "mistakes"])
def test_hostile_drafts_are_refused_in_words(client: httpx.Client, name: str, call: str) -> None:
    member, value, code = HOSTILE[name]
    draft = {**DRAFT, member: {**DRAFT[member], **value} if isinstance(value, dict) else value}
    answer = client.post(CALLS + call, json={"draft": draft})
    assert answer.status_code == 422
    assert code in {fault["code"] for fault in answer.json()["errors"]}
    assert all(fault["detail"] and fault["detail"] != fault["code"] for fault in answer.json()["errors"])
    assert all(fault["pointer"].startswith("/draft/") for fault in answer.json()["errors"])


def test_a_table_longer_than_any_arm_is_refused_at_once(client: httpx.Client) -> None:
    row = {"joint": "revolute", "theta": "q1", "d": 0, "a": 1, "alpha": 0}
    reference = {**DRAFT["definition"]["reference"], "rows": [row] * 64}
    draft = {**DRAFT, "definition": {**DRAFT["definition"], "reference": reference}}
    answer = client.post(f"{CALLS}preview", json={"draft": draft})
    assert answer.json()["code"] == "draft_too_many_rows"
    assert answer.json()["pointer"] == "/draft/definition/reference/rows"


def test_hostile_archives_are_refused_and_nothing_is_written(client: httpx.Client, tmp_path: Path) -> None:
    def archive(entries: dict[str, bytes]) -> bytes:
        stream = io.BytesIO()
        with zipfile.ZipFile(stream, "w", zipfile.ZIP_DEFLATED) as made:
            for name, content in entries.items():
                made.writestr(name, content)
        return stream.getvalue()

    outside = tmp_path / "outside.toml"
    codes = {
        archive({str(outside): b"x", "a/exercise.toml": b""}): "archive_entry",
        archive({"../../outside.toml": b"x"}): "archive_entry",
        archive({"a/exercise.toml": b"0" * 50_000_000}): "archive_file_too_large",
        archive({f"a/{i}": b"" for i in range(2000)}): "archive_too_many_files",
        archive({"readme.md": b"x"}): "archive_entry",
        archive({"a/exercise.toml": b"= 1"}): "exercise_file_not_toml",
        b"no zip": "archive_not_zip",
    }
    for data, code in codes.items():
        answer = taken(client, data)
        assert (answer.status_code, answer.json()["code"]) == (422, code)
        assert answer.json()["detail"]
    assert not outside.exists()
    hundred_thousand = taken(client, archive({f"a/{i}": b"" for i in range(100_000)}))
    assert (hundred_thousand.status_code, hundred_thousand.json()["code"]) == (413, "body_too_large")
    other = client.post(f"{CALLS}import", content=b"<x/>", headers={"Content-Type": "text/xml"})
    assert other.status_code == 415


def test_a_hostile_urdf_reads_no_file(client: httpx.Client) -> None:
    urdf = '<?xml version="1.0"?><!DOCTYPE r [<!ENTITY x SYSTEM "file:///etc/passwd">]><robot name="&x;"/>'
    answer = client.post(f"{CALLS}start", json={"id": "arm", "source": {"urdf": urdf}})
    assert answer.status_code == 422
    assert "root:" not in answer.text
