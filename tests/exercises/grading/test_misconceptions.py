"""The catalogue of misconceptions, and the repairs found with it."""

import re
from pathlib import Path

import pytest

from exercises.grading.edits import table_edits
from exercises.grading.edits.misconceptions import CATALOGUE, HINTS, repair_codes
from tests.exercises.grading.campaign import mended_tables
from tests.kinematics.equivalence.campaign import Outcome

LOCALES = Path(__file__).parents[3] / "service" / "locales"
GRADING = Path(__file__).parents[3] / "exercises" / "grading"
LANGUAGES = ("en", "ro", "pt", "fr", "uk", "es")


def test_every_misconception_has_a_code() -> None:
    assert len({entry.code for entry in CATALOGUE}) == len(CATALOGUE)
    assert all(re.fullmatch(r"[a-z_]+", entry.code) for entry in CATALOGUE)


def test_what_is_found_in_one_cell_is_told_of_this_cell() -> None:
    """A wrong offset may be a missing or misnamed one, or one in another unit; it is no wrong length."""
    alone = [entry for entry in CATALOGUE if len(entry.cells) == 1]
    assert {"alpha", "a", "d"} <= {entry.cells[0] for entry in alone}
    for entry in alone:
        own = f"{entry.cells[0]}_"
        others = {"alpha_", "a_", "d_", "variable_"} - {own}
        assert not any(code.startswith(tuple(others)) for code in entry.codes)


def test_what_concerns_the_whole_table_has_a_hint() -> None:
    """It has no row whose facts could be told instead."""
    throughout = [entry for entry in CATALOGUE if entry.changes.__module__ == table_edits.__name__]
    assert throughout
    assert {code for entry in throughout for code in entry.codes} <= HINTS.keys()


@pytest.mark.parametrize("language", LANGUAGES)
def test_every_code_has_its_message(language: str) -> None:
    text = (LOCALES / language / "feedback.ftl").read_text(encoding="utf-8")
    known = set(re.findall(r"^([a-z]+-[a-z0-9_]+) =", text, re.M))
    sources = "".join(path.read_text(encoding="utf-8") for path in GRADING.glob("*.py"))
    told = set(re.findall(r'Feedback\(code="([a-z_]+)"', sources))
    told |= set(re.findall(r'"([a-z_]+_(?:wrong|throughout|missed|needed|order))"', sources))
    told |= set(HINTS.values())
    told |= {f"base_{rule}_missed" for rule in ("axis", "origin", "frame")}
    told |= {f"tool_{rule}_missed" for rule in ("point", "axis", "frame")}
    missing = {f"feedback-{code}" for code in told} | {f"repair-{code}" for code in repair_codes()}
    assert missing - known == set()
    assert "error-tables_without_value" in known


@pytest.mark.parametrize("language", LANGUAGES)
def test_every_mistake_has_a_name(language: str) -> None:
    """Lecturers read names: in the numbers of a class, and of answers that are rehearsed."""
    text = (LOCALES / language / "kinds.ftl").read_text(encoding="utf-8")
    known = set(re.findall(r"^option-([a-z0-9_]+) =", text, re.M))
    assert repair_codes() | {entry.code for entry in CATALOGUE} <= known


def test_single_mistakes_are_mended() -> None:
    """At least 99 % of them, each in the right row; `make campaign` runs more."""
    total = Outcome()
    for block in range(2):
        total += mended_tables(block)
    assert total.tables >= 200
    assert len(total.kinds) > 18
    assert len(total.failures) <= 0.01 * total.tables, total.failures
