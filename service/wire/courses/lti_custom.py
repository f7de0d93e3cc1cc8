"""What a deep link carries in its custom parameters, and how a launch becomes an arrival in a course."""

import json
from collections.abc import Mapping
from typing import Any
from urllib.parse import unquote

from courses.model import Platform, Role
from courses.people.enrolment import Arrival
from exercises.errors import ExerciseError
from exercises.library import Library
from service.lti.claims import HISTORY, HISTORY_VARIABLE
from service.lti.launch import Launch

EXERCISE, SETTINGS = "exercise", "settings"
LONGEST_SETTINGS = 2000  # Characters of the settings that a link carries.
_COPIES = 20  # Links that a link was copied from, one after another, that are looked for.


def custom_of(exercise_id: str, settings: Mapping[str, Any]) -> dict[str, str]:
    """Return custom parameters of a link to an exercise: only settings that are not the usual ones."""
    told = {name: value for name, value in settings.items() if value not in (None, [], False)}
    carried = {EXERCISE: exercise_id, SETTINGS: json.dumps(told, separators=(",", ":"))}
    return {**carried, HISTORY: HISTORY_VARIABLE}


def arrival_of(launch: Launch, platform: Platform, library: Library) -> Arrival:
    """Return who arrives where, by a launch message that was believed."""
    return Arrival(
        platform=platform,
        subject=launch.subject,
        role=Role.STAFF if launch.is_staff else Role.LEARNER,
        is_test_user=launch.is_test_user,
        deployment=launch.deployment,
        context=launch.context,
        resource=launch.resource,
        name=launch.name,
        course_title=launch.context_title,
        link_title=launch.resource_title,
        exercise_id=_known(launch.custom.get(EXERCISE), library),
        settings=_settings(launch.custom.get(SETTINGS, "")),
        copied_from=_history(launch.custom.get(HISTORY, "")),
        line_item=launch.line_item,
        line_items=launch.line_items,
        memberships_url=launch.memberships_url,
        locale=launch.locale,
        return_url=launch.return_url,
    )


def _known(exercise_id: str | None, library: Library) -> str | None:
    """The exercise, if there is one of this id; else a teacher chooses again."""
    if exercise_id is None:
        return None
    try:
        return library.exercise(exercise_id).id
    except ExerciseError:
        return None


def _settings(text: str) -> Mapping[str, Any]:
    if len(text) > LONGEST_SETTINGS:
        return {}
    try:
        found = json.loads(text) if text else {}
    except (ValueError, RecursionError):
        return {}
    return found if isinstance(found, Mapping) else {}


def _history(text: str) -> tuple[str, ...]:
    """The links that a link was copied from, newest first; none where the platform does not say."""
    if text == HISTORY_VARIABLE:
        return ()
    return tuple(unquote(each) for each in text.split(",", _COPIES)[:_COPIES] if each)
