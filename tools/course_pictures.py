"""The pictures of docs/lms, from live pages of a small course: what lecturers and students see of Framewise.

python -m tools.course_pictures          writes docs/images/course-*.png
"""

import json
import tempfile
from datetime import timedelta
from pathlib import Path
from typing import Any
from urllib.request import Request, urlopen

from playwright.sync_api import Browser, Page

from courses.model import Platform, PlatformStatus, Role
from courses.people.enrolment import Arrival, arrive
from courses.people.platforms import add_platform
from courses.people.secrets import issue_code
from courses.storage.database import Store, open_store
from service.course_resources import now
from tools.picture import IMAGES, TABLE
from tools.web import chromium, service

SETTINGS = {"points": 10, "attempts": 5, "parts": ["table"]}
MISTAKES: tuple[dict[int, dict[str, str]], ...] = (
    {},
    {1: {"alpha": "90"}},
    {2: {"a": "a3"}},
    {3: {"alpha": "0"}, 4: {"alpha": "0"}},
)
STUDENTS = 9
SIZE = {"width": 1100, "height": 900}


class LittleCourse:
    """A course with a teacher and some students, on a running service."""

    def __init__(self, store: Store, origin: str) -> None:
        self.store, self.origin = store, origin
        root = "https://lms.example.edu"
        self.platform = add_platform(
            store,
            Platform(
                issuer=root,
                client_id="framewise",
                authorization_endpoint=f"{root}/auth",
                token_endpoint=f"{root}/token",
                jwks_uri=f"{root}/jwks",
                status=PlatformStatus.ACTIVE,
            ),
            ("1",),
            now(),
        )

    def token(self, subject: str, role: Role) -> str:
        """Sign somebody in."""
        told = Arrival(
            platform=self.platform,
            subject=subject,
            role=role,
            deployment="1",
            context="robotics",
            course_title="Robotics 1",
            resource="week-3",
            link_title="Week 3: a table for the PUMA 560",
            exercise_id="puma560",
            settings=SETTINGS,
        )
        return arrive(self.store, told, now())[0]

    def address(self, path: str, token: str) -> str:
        """Return where a launch lands."""
        code = issue_code(self.store, "session", {"token": token}, now(), timedelta(minutes=5))
        return f"{self.origin}/{path}#session={code}"

    def call(self, method: str, path: str, token: str, body: Any) -> None:
        """Send what a page sends."""
        headers = {"Authorization": f"Bearer {token}", "Content-Type": "application/json"}
        data = json.dumps(body).encode()
        address = f"{self.origin}/api/v1/{path}"
        urlopen(Request(address, data, headers, method=method), timeout=120).close()  # noqa: S310  our own

    def fill(self) -> None:
        """Let students hand in, some of them wrong at first."""
        self.token("late", Role.LEARNER)
        for number in range(STUDENTS):
            token = self.token(f"student-{number}", Role.LEARNER)
            for attempt in range(number % 4, -1 if number % 3 else 0, -1):
                wrong = MISTAKES[attempt]
                rows = [{**row, **wrong.get(i, {})} for i, row in enumerate(TABLE["rows"])]
                self.call("POST", "session/attempts", token, {"table": {**TABLE, "rows": rows}})


def main() -> None:
    """Write the pictures."""
    with tempfile.TemporaryDirectory() as name:
        folder = {"FRAMEWISE_STORAGE": "on", "FRAMEWISE_DATA_FOLDER": name}
        with service(**folder) as origin, chromium() as browser:
            store = open_store("", Path(name))
            course = LittleCourse(store, origin)
            course.fill()
            teacher, student = course.token("tina", Role.STAFF), course.token("student-1", Role.LEARNER)
            taken(browser, f"{origin}/lti/connect?lang=en", "course-connect.png")
            taken(browser, f"{origin}/lti/choose?lang=en#choice=none", "course-choose.png")
            taken(browser, course.address("course?lang=en", teacher), "course-class.png", whole=True)
            taken(browser, course.address("exercises/puma560?lang=en", student), "course-student.png")
            store.close()


def taken(browser: Browser, address: str, name: str, *, whole: bool = False) -> None:
    """Take a picture of a page, down to the end of its numbers if it is wanted whole."""
    page: Page = browser.new_page(viewport=SIZE, color_scheme="light", reduced_motion="reduce")
    page.goto(address)
    page.locator("html[data-ready=true]").wait_for(state="attached")
    if whole:
        page.locator("#link .bars svg").first.wait_for()
        page.set_viewport_size({**SIZE, "height": 1900})
    page.wait_for_timeout(1500)
    page.screenshot(path=IMAGES / name)
    page.close()


if __name__ == "__main__":
    main()
