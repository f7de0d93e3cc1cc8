"""A platform in its own process, a service, and browsers that launch from one into the other."""

from __future__ import annotations

import base64
import contextlib
import json
import subprocess
import sys
import time
from collections.abc import Callable, Iterator
from typing import Any
from urllib.parse import parse_qs

import httpx

from courses.model import Platform, PlatformStatus
from courses.people.platforms import add_platform
from courses.storage.database import Store
from service.course_resources import now
from tests.lti.platform_process import CLIENT, DEPLOYMENT

LEARNER = "http://purl.imsglobal.org/vocab/lis/v2/membership#Learner"
TEACHER = "http://purl.imsglobal.org/vocab/lis/v2/membership#Instructor"
TEST_USER = "http://purl.imsglobal.org/vocab/lti/system/person#TestUser"
ADMINISTRATOR = "http://purl.imsglobal.org/vocab/lis/v2/institution/person#Administrator"
PLATFORM_SECONDS = 50.0
"""How long a platform may take to answer on a busy machine: less than a score is leased for."""
PATIENT_SERVICE = (
    "-c",
    "from courses.storage import engines; engines.CONNECT_SECONDS = 120; "
    f"from service.lti import fetching; fetching.TIMEOUT = fetching.WHOLE_ANSWER = {PLATFORM_SECONDS}; "
    "from service.__main__ import main; main()",
)
"""A service of one process that gives the platform, and the database, this time."""


@contextlib.contextmanager
def lms_process() -> Iterator[Lms]:
    """A platform; ends with the block."""
    command = [sys.executable, "-W", "ignore", "-m", "tests.lti.platform_process"]
    process = subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)
    assert process.stdout
    assert process.stdin
    lms = Lms(process.stdout.readline().strip())
    try:
        yield lms
    finally:
        lms.client.close()
        process.stdin.close()
        process.wait(timeout=60)
        process.stdout.close()


class Lms:
    """The platform, as tests see it."""

    def __init__(self, root: str) -> None:
        self.root = root
        self.elsewhere = root.replace("127.0.0.1", "localhost")
        """The same pages on another site than the service's."""
        self.client = httpx.Client(trust_env=False, timeout=120)

    def control(self, **told: Any) -> None:
        self.client.post(f"{self.root}/control", json=told)

    def state(self) -> dict[str, Any]:
        found: dict[str, Any] = self.client.get(f"{self.root}/state").json()
        return found

    def result(self, user: str, resource: str = "link-1") -> float | None:
        for entry in self.state()["results"]:
            if (entry["user"], entry["resource"]) == (user, resource):
                return entry["given"] / entry["maximum"]
        return None

    def register(self, store: Store) -> Platform:
        """Write the platform down by hand, as the command does."""
        asked = Platform(
            issuer=self.root,
            client_id=CLIENT,
            authorization_endpoint=f"{self.root}/auth",
            token_endpoint=f"{self.root}/token",
            jwks_uri=f"{self.root}/jwks",
            origins=(self.elsewhere,),
            status=PlatformStatus.ACTIVE,
        )
        return add_platform(store, asked, (DEPLOYMENT,), now())


def hint(roles: list[str] | None = None, **more: Any) -> str:
    """What a link of the platform means."""
    told = {"roles": roles or [LEARNER], "resource": "link-1", "context": "course-1", **more}
    return base64.urlsafe_b64encode(json.dumps(told).encode()).decode()


class Browser:
    """Follows a launch by hand; Secure cookies work on loopback, as in browsers."""

    def __init__(self, lms: Lms, service: str) -> None:
        self.lms, self.service = lms, service
        self.client = httpx.Client(trust_env=False, follow_redirects=False, timeout=120)
        self.cookies: dict[str, str] = {}
        self.token = ""
        self.landed = ""

    def login(self, user: str = "student", link: str | None = None, **more: str) -> httpx.Response:
        """From the click to the tool's answer to the login."""
        started = self.client.get(
            f"{self.lms.root}/start", params={"user": user, "hint": link or hint(), **more}
        )
        return self._checked(self.client.get(started.headers["location"]))

    def authorized(self, login: httpx.Response) -> dict[str, str]:
        """The form that the platform posts."""
        made = self.client.get(login.headers["location"])
        assert made.status_code == 200, made.text
        return {name: made.json()[name] for name in ("id_token", "state")}

    def post(self, form: dict[str, str], **headers: str) -> httpx.Response:
        """Post a launch message with this browser's cookies."""
        cookies = "; ".join(f"{name}={value}" for name, value in self.cookies.items())
        return self.client.post(
            f"{self.service}/lti/launch", data=form, headers={"Cookie": cookies, **headers}
        )

    def launch(self, user: str = "student", link: str | None = None) -> httpx.Response:
        """A whole launch, to the redirect with the code."""
        answer = self.post(self.authorized(self.login(user, link)))
        if answer.status_code == 303:
            self.landed, _, fragment = answer.headers["location"].partition("#")
            code = parse_qs(fragment)
            if "session" in code:
                opened = self.api("POST", "session/open", {"code": code["session"][0]})
                self.token = opened.json()["token"]
        return answer

    def api(self, method: str, path: str, content: Any = None, **headers: str) -> httpx.Response:
        sent = {**({"Authorization": f"Bearer {self.token}"} if self.token else {}), **headers}
        return (
            self.client.request(method, f"{self.service}/api/v1/{path}", json=content, headers=sent)
            if content is not None
            else self.client.request(method, f"{self.service}/api/v1/{path}", headers=sent)
        )

    def _checked(self, response: httpx.Response) -> httpx.Response:
        for field in response.headers.get_list("set-cookie"):
            name, _, value = field.partition(";")[0].partition("=")
            self.cookies[name] = value
        return response


def eventually(check: Callable[[], Any], timeout: float = 120.0) -> Any:
    """What a check finds, once it finds something true."""
    deadline = time.monotonic() + timeout
    while time.monotonic() < deadline:
        if found := check():
            return found
        time.sleep(0.05)
    return check()
