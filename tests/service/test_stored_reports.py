"""Reports are stored as plain data and come back as they were."""

from typing import Any

import orjson
import pytest

from exercises.grader import Report
from exercises.grading import HelpLevel
from service.wire.exercises.verdicts import encoded, report_body, restored
from tests.exercises.answering import SCARA, SCARA_TRANSFORM, edited, judged, table

WRONG = table("standard", (0, "a2", 0, "q1"), (90, "a3", 0, "q2"), (0, 0, "q3", 0), (0, 0, 0, "q4"))


def _stored(report: Report) -> Any:
    return orjson.loads(encoded(report))


@pytest.mark.parametrize("given", [SCARA, WRONG, None])
@pytest.mark.parametrize("level", list(HelpLevel))
def test_a_report_comes_back_from_json_and_is_shown_again(given: object, level: HelpLevel) -> None:
    wrong = edited(SCARA_TRANSFORM, 0, 0, "c1")
    report = judged("scara", seed="7", help_level=level, table=given, transform=wrong)
    again = restored(_stored(report))
    assert again == report
    for language in ("en", "uk"):
        assert encoded(report_body(again, language)) == encoded(report_body(report, language))


def test_what_another_version_stored_is_still_read() -> None:
    report = judged("scara", table=SCARA)
    data = _stored(report)
    data["colour"] = "red"
    del data["parts"][0]["facts"]
    assert restored(data).parts[0].facts == ()


@pytest.mark.parametrize("data", [{}, {"correct": "yes"}, [], None, "x"])
def test_what_is_no_report_is_refused(data: object) -> None:
    with pytest.raises(ValueError, match="Report"):
        restored(data)
