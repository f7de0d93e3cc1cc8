"""`framewise warm`: an exam's figures, variants and closed forms, made beforehand."""

from pathlib import Path
from unittest.mock import patch

import httpx
import pytest

from courses.model import LinkSettings, Role
from courses.people.enrolment import Arrival, arrive
from courses.storage.database import open_store
from courses.teaching.link_changes import change_settings
from service.cli.commands import main
from service.course_resources import now
from service.settings import Settings
from service.wire.exercises import figure_files
from tests.courses.classroom import platform
from tests.exercises.folders import TWO_LINKS
from tests.exercises.folders import folder as exercise_folder
from tests.live_service import running

STUDENTS = 6


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.setenv("FRAMEWISE_STORAGE", "on")
    monkeypatch.setenv("FRAMEWISE_DATA_FOLDER", str(tmp_path))
    return tmp_path


def _class(folder: Path, settings: LinkSettings) -> list[str]:
    """Sessions of a class whose link has these settings."""
    store = open_store("", folder)
    tokens, link = [], 0
    for n in range(STUDENTS):
        told = {"deployment": "1", "context": "c", "resource": "r", "course_title": "Robotics 1"}
        arrival = Arrival(platform=platform(store), subject=f"s{n}", role=Role.LEARNER, **told)
        token, link = arrive(store, arrival, now())
        tokens.append(token)
    change_settings(store, link, settings, now())
    store.close()
    return tokens


@pytest.mark.parametrize(
    ("settings", "sets"),
    [
        (LinkSettings(exercise_id="twolink", variants=3, language="en"), 3),
        (LinkSettings(exercise_id="twolink", per_student=True, language="en"), STUDENTS + 1),
    ],
)
def test_a_warm_course_draws_nothing_more(
    folder: Path, settings: LinkSettings, sets: int, capsys: pytest.CaptureFixture[str]
) -> None:
    tokens = _class(folder, settings)
    assert main(["warm", "Robotics 1"]) == 0
    assert capsys.readouterr().out.startswith(
        f"twolink: {sets} sets of values tested and drawn, {sets} figures"
    )
    seeds = set()
    with (
        running(Settings(storage="on", data_folder=folder)) as origin,
        httpx.Client(base_url=f"{origin}/api/v1/", trust_env=False, timeout=120) as client,
        patch.object(figure_files, "figure_drawing", side_effect=AssertionError("drawn again")),
    ):
        for token in tokens:
            session = client.get("session", headers={"Authorization": f"Bearer {token}"}).json()
            seeds.add(session["seed"])
            own = {"seed": session["seed"], "lang": "en"}
            shown = client.get("exercises/twolink", params=own).json()
            assert client.get(shown["figure"]["file"]).status_code == 200
    if settings.variants:  # shared out by a secret: by chance none of few students has one of them
        assert seeds <= {f"variant-{number + 1}" for number in range(sets)}
    else:
        assert len(seeds) == STUDENTS


def test_variants_of_an_exercise_are_drawn_in_every_language(
    folder: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(["warm", "onelink", "--variants", "2"]) == 0
    assert (
        "2 sets of values tested and drawn, 12 figures, 3 closed forms, 0 failed" in capsys.readouterr().out
    )


def test_what_does_not_exist_is_told(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["warm", "nothing"]) == 2
    assert "[nothing_to_warm]" in capsys.readouterr().err


@pytest.mark.parametrize("what", ["Robotics 1", "shared"])
def test_a_number_of_variants_that_is_set_elsewhere_is_refused(
    what: str, folder: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    _class(folder, LinkSettings(exercise_id="twolink", per_student=True, language="en"))
    exercise_folder(folder / "own", f"{TWO_LINKS}\n[access]\nvariants = 3\n", name="shared")
    monkeypatch.setenv("FRAMEWISE_EXERCISE_FOLDERS", str(folder / "own"))
    assert main(["warm", what, "--variants", "4"]) == 2
    assert "[variants_set]" in capsys.readouterr().err
