"""What a deep link carries in its custom parameters, and how a launch becomes an arrival in a course."""

from __future__ import annotations

import json
from collections.abc import Mapping
from typing import Any

from courses.enrolment import Arrival
from courses.model import Platform, Role
from exercises.errors import ExerciseError
from exercises.library import Library
from service.lti.launch import Launch

EXERCISE, SETTINGS = "exercise", "settings"
LONGEST_SETTINGS = 2000
"""Characters of the settings that a link carries."""


def custom_of(exercise_id: str, settings: Mapping[str, Any]) -> dict[str, str]:
    """Return custom parameters of a link to an exercise: only settings that are not the usual ones."""
    told = {name: value for name, value in settings.items() if value not in (None, [], False)}
    return {EXERCISE: exercise_id, SETTINGS: json.dumps(told, separators=(",", ":"))}


def arrival_of(launch: Launch, platform: Platform, library: Library) -> Arrival:
    """Return who arrives where, by a launch message that was believed."""
    return Arrival(
        platform=platform,
        subject=launch.subject,
        role=Role.STAFF if launch.is_staff else Role.LEARNER,
        deployment=launch.deployment,
        context=launch.context,
        resource=launch.resource,
        name=launch.name,
        course_title=launch.context_title,
        link_title=launch.resource_title,
        exercise_id=_known(launch.custom.get(EXERCISE), library),
        settings=_settings(launch.custom.get(SETTINGS, "")),
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
