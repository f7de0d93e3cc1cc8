"""What a class will be shown is drawn before it comes, and not twice."""

from collections.abc import Iterator
from dataclasses import replace
from datetime import timedelta
from pathlib import Path
from unittest.mock import Mock

import pytest

from courses.model import LinkSettings, Role
from courses.people.enrolment import Arrival, arrive
from courses.policies import AttemptPolicy
from courses.storage.database import Store, open_store
from courses.teaching.link_changes import change_settings
from exercises.definition import Exercise
from exercises.errors import DefinitionError
from exercises.instance import generate, possible_instances
from exercises.library import packaged
from kinematics.errors import Fault
from service.course_resources import now
from service.wire.exercises import figure_files
from service.work.drawing_ahead import DrawingAhead
from service.work.shared_answers import SharedAnswers
from tests.courses.classroom import platform

OWN = LinkSettings(exercise_id="puma560", per_student=True, language="en")


def few_values(exercise: Exercise) -> Exercise:
    """The exercise with six sets of values that are drawn: two of one dimension, three of another."""
    counts = {"a2": 2, "d4": 3}

    def shortened(parameter: object) -> object:
        draw = parameter.draw  # type: ignore[attr-defined]
        count = counts.get(parameter.name)  # type: ignore[attr-defined]
        if draw is None or (count is None and parameter.name != "a3"):  # type: ignore[attr-defined]
            return replace(parameter, draw=None)  # type: ignore[type-var]
        shorter = draw if count is None else replace(draw, stop=draw.start + (count - 1) * draw.step)
        return replace(parameter, draw=shorter)  # type: ignore[type-var]

    return replace(exercise, parameters=tuple(map(shortened, exercise.parameters)))  # type: ignore[arg-type]


@pytest.fixture
def store(tmp_path: Path) -> Iterator[Store]:
    found = open_store("", tmp_path)
    yield found
    found.close()


@pytest.fixture
def drawing(monkeypatch: pytest.MonkeyPatch) -> Mock:
    """Counts what is drawn."""
    counted = Mock(wraps=figure_files.figure_drawing)
    monkeypatch.setattr(figure_files, "figure_drawing", counted)
    return counted


def linked(store: Store, settings: LinkSettings) -> None:
    """Have a link in the database."""
    told = {"deployment": "1", "context": "c", "resource": str(settings)}
    _, link = arrive(store, Arrival(platform=platform(store), subject="s", role=Role.LEARNER, **told), now())
    change_settings(store, link, settings, now())


def ahead(store: Store, figures: SharedAnswers, exercise: Exercise) -> DrawingAhead:
    library = Mock()
    library.exercise.return_value = exercise
    return DrawingAhead(store, library, figures, lambda: False)


def test_a_malformed_exercise_leaves_the_others_to_be_drawn(store: Store, drawing: Mock) -> None:
    linked(store, OWN)
    linked(store, replace(OWN, exercise_id="broken"))
    exercise = few_values(packaged().exercise("puma560"))
    thread = ahead(store, SharedAnswers("figure", store), exercise)
    library: Mock = thread._library  # type: ignore[assignment]
    library.exercise.side_effect = lambda name: exercise if name == "puma560" else _malformed()
    thread.draw_all()
    assert drawing.call_count == 6


def _malformed() -> Exercise:
    raise DefinitionError(Fault(code="definition_unreadable"))


def test_all_that_students_can_be_shown_is_drawn_once(store: Store, drawing: Mock) -> None:
    linked(store, OWN)
    exercise, figures = few_values(packaged().exercise("puma560")), SharedAnswers("figure", store)
    thread = ahead(store, figures, exercise)
    thread.draw_all()
    assert drawing.call_count == 6
    thread.draw_all()
    figures.write_down()
    another = SharedAnswers("figure", store)
    ahead(store, another, exercise).draw_all()
    for number in range(30):
        figure_files.packed_figure(another, generate(exercise, f"student {number}"), "en")
    assert drawing.call_count == 6


def test_it_goes_on_when_nobody_waits_and_begins_again_where_it_was_ended(
    store: Store, drawing: Mock
) -> None:
    linked(store, OWN)
    exercise, figures = few_values(packaged().exercise("puma560")), SharedAnswers("figure", store)
    library = Mock()
    library.exercise.return_value = exercise
    waits = iter([False, True, True])
    thread = DrawingAhead(store, library, figures, lambda: next(waits, False))
    thread.draw_all()
    assert next(waits, None) is None
    assert drawing.call_count == 6
    ended = DrawingAhead(store, library, SharedAnswers("figure", None), lambda: True)
    ended.stopping.set()
    ended.draw_all()
    assert drawing.call_count == 7


@pytest.mark.parametrize(
    "settings",
    [
        replace(OWN, per_student=False),
        replace(OWN, exercise_id=None),
        replace(OWN, policy=AttemptPolicy(closes=now() - timedelta(days=1))),
    ],
)
def test_nothing_is_drawn_for_nobody(store: Store, drawing: Mock, settings: LinkSettings) -> None:
    linked(store, settings)
    exercise = few_values(packaged().exercise("puma560"))
    ahead(store, SharedAnswers("figure", store), exercise).draw_all()
    assert not drawing.called


def test_the_values_are_those_that_can_be_drawn() -> None:
    exercise = packaged().exercise("puma560")
    found = [dict(instance.exact) for instance in possible_instances(exercise, ("a3",), 726)]
    assert len(found) == 726
    told = {tuple(sorted((name, value) for name, value in each.items() if name != "a3")) for each in found}
    assert len(told) == 726
    for seed in ("a", "b", "c"):
        own = generate(exercise, seed).exact
        assert tuple(sorted((name, value) for name, value in own.items() if name != "a3")) in told
    assert not list(possible_instances(exercise, ("a3",), 725))
