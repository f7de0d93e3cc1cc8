"""A key whose lengths are of one size at some draws and far apart at others."""

from pathlib import Path

import pytest

from exercises.answers import RawAnswer, parse
from exercises.grader import grade
from exercises.instance import generate
from exercises.loader import load_exercise
from exercises.selftest.rehearsal import usual_mistakes
from kinematics.cells import AngleUnit, RawRow, RawTable
from kinematics.table import Convention
from tests.exercises.folders import changed, folder

STEEP = "L1^16/L2^16"
TOOL_ON_ITS_AXIS = '\n[policy]\ntool = "axis"\n'


def test_a_length_that_vanishes_beside_another_at_some_draws_is_judged(
    tmp_path: Path, caplog: pytest.LogCaptureFixture
) -> None:
    """Axes seem to coincide at these draws, so that frame N has fewer places than at others."""
    text = changed('a = "L1"', f'a = "{STEEP}"') + TOOL_ON_ITS_AXIS
    exercise = load_exercise(folder(tmp_path, text))
    assert len(usual_mistakes(exercise)) > 5
    assert not caplog.records  # an explanation that fails is logged
    rows = (RawRow(theta="q1", d=0, a=STEEP, alpha=0), RawRow(theta="q2", d=0, a="L2", alpha=0))
    table = RawTable(convention=Convention.STANDARD, rows=rows, angle_unit=AngleUnit.DEG)
    instance = generate(exercise)
    assert grade(instance, parse(instance, RawAnswer(table=table))).correct
