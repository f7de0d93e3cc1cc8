"""Exercises by the names that teachers write."""

from __future__ import annotations

from exercises.library import Library, packaged


def exercise_named(name: str, library: Library | None = None) -> str | None:
    """Return the exercise that a file means by a robot's name: its id, whatever the case and the spaces."""
    bare = "".join(letter for letter in name.lower() if letter.isalnum())
    return next((known for known in (library or packaged()).ids if known.replace("-", "") == bare), None)
