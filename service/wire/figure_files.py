"""Figures as files under addresses made from what they show.

Two students with the same values, in whatever process, have the same address; another value, another language
or another version of exercise or program has another one. What an address shows therefore never changes.
"""

from __future__ import annotations

import gzip
import hashlib
from functools import lru_cache
from urllib.parse import urlencode

from exercises.definition import Exercise
from exercises.drawings import figure_svg
from exercises.instance import Instance
from service.messages import sentence
from service.revision import revision
from service.wire.exercise_views import figure_description
from service.work.shared_answers import SharedAnswers

KEPT = 256
"""Exercises, each in a language, whose digest is kept."""


def figure_address(figures: SharedAnswers, instance: Instance, language: str) -> str:
    """Return the address of a figure: a digest of all that it follows from."""
    return figures.address(_drawn_alike(instance.exercise, language), repr(dict(instance.exact)))


@lru_cache(maxsize=KEPT)
def _drawn_alike(exercise: Exercise, language: str) -> bytes:
    """A digest of what all figures of an exercise follow from, whatever a student's values are."""
    policy = exercise.policy
    told = (
        revision(),
        language,
        exercise.title(language),
        repr(exercise.figure),
        repr(exercise.reference),
        repr((policy.direction, policy.zero, exercise.length_unit, exercise.angle_unit)),
    )
    return hashlib.sha256("\n".join(told).encode()).digest()


def figure_path(figures: SharedAnswers, instance: Instance, language: str, asked: str | None = None) -> str:
    """Return the path of a figure below the API's root, by which any process can draw it.

    Args:
        figures: the figures of the application.
        instance: the exercise with the student's values.
        language: of title and description.
        asked: the query that the page carries, if not language and seed alone.
    """
    address = figure_address(figures, instance, language)
    seed = {} if instance.seed is None else {"seed": instance.seed}
    query = asked if asked is not None else urlencode({"lang": language, **seed})
    return f"exercises/{instance.exercise.id}/figures/{address}.svg?{query}"


def packed_figure(figures: SharedAnswers, instance: Instance, language: str) -> bytes:
    """Return a figure, gzipped: as some process has drawn it, else drawn now."""
    address = figure_address(figures, instance, language)
    found = figures.known(address) or figures.stored(address)
    if found is None:
        found = gzip.compress(figure_file(instance, language), 6, mtime=0)
        figures.keep(address, found)
    return found


def figure_file(instance: Instance, language: str) -> bytes:
    """Draw the figure as an SVG file."""
    title = sentence(language, "figure-title", {"title": instance.exercise.title(language)}) or ""
    description = figure_description(instance, language)
    note = sentence(language, "figure-note") or ""
    return figure_svg(instance, title=title, description=description, language=language, note=note).encode()
