"""A long lane shortens explanations, and changes nothing else."""

from dataclasses import replace
from pathlib import Path

import httpx
import pytest

from courses.model import Attempt, LinkSettings, Role
from courses.people.enrolment import Arrival, arrive
from courses.storage.database import open_store
from courses.storage.records import finding
from exercises.library import packaged
from kinematics.cells import DEFAULT
from service.course_resources import now
from service.resources import Resources
from service.schemas.exercises.exercises import ExerciseAnswer
from service.settings import Settings
from service.work.session_grading import Grader
from tests.courses.classroom import platform
from tests.live_service import running
from tests.web.driving import PUMA, wrong

RIGHT = {**PUMA, "angle_unit": "deg"}
WRONG = wrong(RIGHT, 3, a="a2")


WAITING = "service.work.fair_queue.FairQueue.waiting"
PATH = "/api/v1/exercises/puma560/grade"


def test_a_wrong_answer_has_the_same_score_and_is_told_its_rows(
    client: httpx.Client, monkeypatch: pytest.MonkeyPatch
) -> None:
    asked, right = {"table": WRONG, "help": "repair"}, {"table": RIGHT}
    full, accepted = (client.post(PATH, json=body).json() for body in (asked, right))
    monkeypatch.setattr(WAITING, 65)
    short = client.post(PATH, json=asked).json()
    assert (full["help"], short["help"]) == ("repair", "row")
    assert full["repairs"]
    assert (short["repairs"], short["departure"]) == ([], None)
    for name in ("correct", "score", "total", "basis", "version"):
        assert short[name] == full[name]
    under_load = client.post(PATH, json=right).json()
    assert under_load["score"] == 1.0
    assert under_load["certificate"] == accepted["certificate"]


def test_what_a_student_hands_in_is_explained_but_for_a_picture_that_comes_when_it_is_opened_again(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """All was found and stored, and yet the student was told the rows alone; the picture never came."""
    store = open_store("", tmp_path)
    told = {"deployment": "1", "context": "c", "resource": "r", "exercise_id": "puma560"}
    token, _ = arrive(store, Arrival(platform=platform(store), subject="s", role=Role.LEARNER, **told), now())
    signed_in = {"Authorization": f"Bearer {token}"}
    with (
        running(Settings(storage="on", data_folder=tmp_path)) as origin,
        httpx.Client(base_url=f"{origin}/api/v1/", headers=signed_in, timeout=120, trust_env=False) as client,
    ):
        usual = client.post("session/attempts", json={"table": WRONG}).json()
        monkeypatch.setattr(WAITING, 65)
        hurried = client.post("session/attempts", json={"table": WRONG}).json()
        monkeypatch.undo()
        first, second = (client.get(f"session/attempts/{n}").json()["report"] for n in (1, 2))
    assert (usual.pop("attempt"), hurried.pop("attempt")) == (1, 2)
    assert usual["repairs"]
    assert (usual["help"], hurried["help"]) == ("repair", "repair")
    assert hurried.pop("departure_later")
    assert hurried["departure"] is None
    assert {**hurried, "departure": usual["departure"]} == usual
    assert second == first
    assert second["departure"] == usual["departure"] is not None
    with store.reading() as connection:
        kinds = [(row.attempt_id, row.kind) for row in connection.execute(finding.select())]
    store.close()
    assert kinds.count((1, "repair")) == kinds.count((2, "repair")) > 0


@pytest.mark.parametrize(
    ("settings", "table"),
    [({}, RIGHT), ({"help": "row"}, WRONG), ({"help": "kind"}, WRONG)],
    ids=["right", "rows", "kinds"],
)
def test_no_picture_comes_that_the_link_withholds(settings: dict[str, str], table: dict[str, object]) -> None:
    asked = LinkSettings(exercise_id="puma560", **settings)  # type: ignore[arg-type]
    grader = Grader(library=packaged(), limits=DEFAULT, is_crowded=lambda: True)
    judged = grader.judge(asked, None, ExerciseAnswer.model_validate({"table": table}), 1)
    attempt = Attempt(
        link_id=1,
        person_id=1,
        key="k",
        at=now(),
        exercise_id="puma560",
        version=judged.version,
        seed=None,
        language="en",
        answer={"table": table},
        report=judged.report,
        score=judged.score,
        correct=judged.correct,
    )
    assert judged.report["departure"] is None
    again = grader.with_departure(attempt, asked)
    assert (again.report["departure"] is not None) == (settings == {"help": "kind"})
    assert grader.with_departure(replace(attempt, version="another"), asked).report["departure"] is None


def test_it_depends_on_how_many_wait(monkeypatch: pytest.MonkeyPatch) -> None:
    resources = Resources(Settings(storage="off", explained_queue=3))
    try:
        for waiting, told in ((3, None), (4, "row")):
            monkeypatch.setattr(WAITING, waiting)
            assert resources.help_now(None) == told
    finally:
        resources.close()
