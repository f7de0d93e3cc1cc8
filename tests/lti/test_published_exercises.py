"""A lecturer's own exercise, from its publication to the gradebook: deep linking, launch, marks."""

from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from service.settings import Publishers, Settings
from tests.examples import DRAFT
from tests.lti.classes import TEACHER, Browser, Lms, eventually, hint

PUBLISH = "author/publish"
RIGHT = {
    "table": {
        "convention": "standard",
        "angle_unit": "deg",
        "length_unit": "m",
        "rows": [
            {"alpha": 0, "a": "L1", "d": 0, "theta": "q1"},
            {"alpha": 0, "a": "L2", "d": 0, "theta": "q2"},
        ],
    }
}


@pytest.fixture(scope="module")
def settings(address: str, lms: Lms, tmp_path_factory: pytest.TempPathFactory) -> Settings:
    folder: Path = tmp_path_factory.mktemp("data")
    return Settings(
        storage="on",
        data_folder=folder,
        database_url=address,
        lti_trusted_origins=(lms.root,),
        publishing=Publishers.STAFF,
    )


def choosing(browser: Browser) -> str:
    """The code of a platform that asks a lecturer for a link."""
    answer = browser.launch("tina", hint([TEACHER], deep=True))
    return answer.headers["location"].partition("#choice=")[2]


def draft(**more: Any) -> dict[str, Any]:
    return {"draft": {**DRAFT, **more}}


def test_a_published_draft_is_chosen_launched_and_graded(browser: Browser, lms: Lms) -> None:
    choice = choosing(browser)
    published = browser.api("POST", PUBLISH, {**draft(), "choice": choice}).json()
    asked = {"choice": choice, "exercise": published["id"], "points": 8}
    made = browser.api("POST", "deep-links", asked).json()
    assert lms.client.post(made["address"], data={"JWT": made["jwt"]}).status_code == 200
    (item,) = lms.state()["returned"][-1]["items"]
    assert item["lineItem"]["scoreMaximum"] == 8
    assert item["title"] == DRAFT["definition"]["title"]["en"]
    link = hint(resource="own", custom=item["custom"])
    browser.launch("ann", link)
    assert browser.landed.endswith(f"/exercises/{published['id']}")
    session = browser.api("GET", "session").json()
    assert (session["exercise"], session["points"]) == (published["id"], 8)
    wrong = {"table": {**RIGHT["table"], "rows": [{**row, "alpha": 90} for row in RIGHT["table"]["rows"]]}}
    before = browser.api("POST", "session/attempts", wrong).json()
    assert before["total"]["score"] < 1
    graded = browser.api("POST", "session/attempts", RIGHT).json()
    assert (graded["attempt"], graded["total"]["score"]) == (2, 1)
    assert eventually(lambda: lms.result("ann", "own") == 1.0)
    assert lms.state()["refused"] == []


def test_only_the_staff_of_a_course_publishes_where_the_operator_says_so(
    browser: Browser, another_browser: Callable[[], Browser]
) -> None:
    visitor = another_browser().api("POST", PUBLISH, draft())
    assert (visitor.status_code, visitor.json()["code"]) == (403, "publishing_closed")
    assert "staff" in visitor.json()["detail"]
    forged = another_browser().api("POST", PUBLISH, {**draft(), "choice": "a-guess"})
    assert (forged.status_code, forged.json()["code"]) == (401, "code_used")
    student = another_browser()
    student.launch("ann", hint(resource="own", custom={"exercise": "scara"}))
    refused = student.api("POST", PUBLISH, draft())
    assert (refused.status_code, refused.json()["code"]) == (403, "staff_only")
    browser.launch("tina", hint([TEACHER], resource="own"))
    assert browser.api("POST", PUBLISH, draft()).status_code == 200
    chosen = choosing(browser)
    asked = {"choice": chosen, "exercise": "scara", "points": 1}
    assert browser.api("POST", "deep-links", asked).status_code == 200
    late = another_browser().api("POST", PUBLISH, {**draft(), "choice": chosen})
    assert late.json()["code"] == "code_used"
