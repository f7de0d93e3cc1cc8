"""From a link in a course to a mark in its gradebook, against a platform in its own process."""

from __future__ import annotations

import json

import pytest

from tests.lti.classes import Browser, Lms, eventually, hint
from tests.web.driving import PUMA

CUSTOM = {"exercise": "puma560", "settings": json.dumps({"points": 10, "attempts": 3, "parts": ["table"]})}
RIGHT = {"table": {"convention": "modified", "angle_unit": "deg", "length_unit": "m", "rows": PUMA["rows"]}}


def test_a_mark_arrives_in_the_gradebook(browser: Browser, lms: Lms) -> None:
    answer = browser.launch("ann", hint(custom=CUSTOM, resource="mark"))
    assert answer.status_code == 303
    assert browser.landed.endswith("/exercises/puma560")
    session = browser.api("GET", "session").json()
    assert (session["exercise"], session["points"], session["attempts_allowed"]) == ("puma560", 10, 3)
    graded = browser.api("POST", "session/attempts", RIGHT, **{"Idempotency-Key": "one"}).json()
    assert (graded["attempt"], graded["correct"]) == (1, True)
    assert eventually(lambda: lms.result("ann", "mark")) == pytest.approx(graded["total"]["score"])
    assert lms.state()["refused"] == []
