"""From a unit of Open edX to its gradebook, against the published LTI consumer block: `make test-openedx`."""

import contextlib
import html
import json
import os
import re
import shlex
import subprocess
from collections.abc import Iterator
from pathlib import Path
from typing import Any
from urllib.parse import parse_qs

import httpx
import pytest

from courses.storage.database import open_store
from service.__main__ import main
from service.settings import Settings
from tests.live_service import running
from tests.lti.classes import eventually
from tests.lti.test_launches import RIGHT, WRONG

PYTHON = os.environ.get("OPEN_EDX_PYTHON", "")
DOCUMENT = Path(__file__).resolve().parents[2] / "docs" / "lms" / "open-edx.md"
pytestmark = pytest.mark.skipif(not PYTHON, reason="`make test-openedx` runs Open edX's block beside this")


class OpenEdx:
    """The platform, and a browser that follows its frames into the tool."""

    def __init__(self, root: str) -> None:
        self.root = root
        self.client = httpx.Client(trust_env=False, timeout=120)
        self.cookies: dict[str, str] = {}

    def add(self, name: str, **fields: Any) -> dict[str, Any]:
        told: dict[str, Any] = self.client.post(
            f"{self.root}/add", json={"name": name, "fields": fields}
        ).json()
        return told

    def state(self) -> dict[str, Any]:
        found: dict[str, Any] = self.client.get(f"{self.root}/state").json()
        return found

    def open(self, block: str, user: str, role: str, **more: str) -> httpx.Response:
        """Open a block: the platform's redirect, our login, its form, our launch."""
        asked = {"block": block, "user": user, "role": role, **more}
        started = self.client.get(f"{self.root}/opened", params=asked)
        login = self.client.get(started.headers["location"])
        for field in login.headers.get_list("set-cookie"):
            name, _, value = field.partition(";")[0].partition("=")
            self.cookies[name] = value
        form = self.client.get(login.headers["location"])
        assert form.status_code == 200, form.text
        return self.submit(form.text)

    def submit(self, page: str) -> httpx.Response:
        """Press the button of the platform's form."""
        (address,) = re.findall(r'action="([^"]+)"', page)
        fields = re.findall(r'<input name="([^"]+)" value="([^"]*)"', page)
        cookies = "; ".join(f"{name}={value}" for name, value in self.cookies.items())
        told = {name: html.unescape(value) for name, value in fields}
        return self.client.post(html.unescape(address), data=told, headers={"Cookie": cookies})


@pytest.fixture(scope="module")
def open_edx() -> Iterator[OpenEdx]:
    """The block's platform in a process of its own environment."""
    command = [PYTHON, "-m", "tests.lti.open_edx"]
    process = subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)
    assert process.stdin
    assert process.stdout
    with contextlib.closing(process.stdout):
        platform = OpenEdx(json.loads(process.stdout.readline()))
        yield platform
        platform.client.close()
        process.stdin.close()
        process.wait(timeout=60)


@pytest.fixture(scope="module")
def settings(open_edx: OpenEdx, tmp_path_factory: pytest.TempPathFactory) -> Settings:
    folder = tmp_path_factory.mktemp("data")
    return Settings(storage="on", data_folder=folder, lti_trusted_origins=(open_edx.root,))


@pytest.fixture(scope="module")
def service(settings: Settings) -> Iterator[str]:
    """Origin of the running tool."""
    open_store("", settings.data_folder).close()
    with running(settings) as origin:
        yield origin


@pytest.fixture
def block(open_edx: OpenEdx, service: str, settings: Settings, request: pytest.FixtureRequest) -> str:
    """A block, set up and registered as the page about Open edX says."""
    name = re.sub(r"\W", "_", request.node.name)
    fields = {
        "lti_version": "lti_1p3",
        "display_name": "DH table",
        "has_score": True,
        "weight": 10.0,
        "lti_1p3_launch_url": f"{service}/lti/launch",
        "lti_1p3_oidc_url": f"{service}/lti/login",
        "lti_1p3_tool_key_mode": "keyset_url",
        "lti_1p3_tool_keyset_url": f"{service}/lti/jwks",
        "lti_advantage_deep_linking_enabled": True,
        "lti_advantage_deep_linking_launch_url": f"{service}/lti/launch",
        **getattr(request, "param", {}),
    }
    shown = open_edx.add(name, **fields)
    register(open_edx, shown, settings)
    return str(shown["block"])


def register(open_edx: OpenEdx, shown: dict[str, Any], settings: Settings) -> None:
    """Execute the command of the page, with what the block shows its author."""
    (console,) = re.findall(r"```console\n\$ framewise (lti add .+?)```", DOCUMENT.read_text(), re.DOTALL)
    passport = shown["keyset_url"].rpartition("/")[2]
    command = console.replace("\\\n", " ").replace("https://courses.example.edu", open_edx.root)
    command = command.replace("CLIENT_ID", shown["client_id"]).replace("PASSPORT", passport)
    assert shown["keyset_url"] in command
    assert shown["token_url"] in command
    assert shown["oidc_callback"] in command
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("FRAMEWISE_STORAGE", "on")
        patch.setenv("FRAMEWISE_DATA_FOLDER", str(settings.data_folder))
        patch.setenv("FRAMEWISE_LTI_TRUSTED_ORIGINS", open_edx.root)
        assert main(shlex.split(command)) in (0, None)


class Session:
    """What a page of ours does after its launch."""

    def __init__(self, service: str, launched: httpx.Response) -> None:
        assert launched.status_code == 303, launched.text
        self.landed, _, fragment = launched.headers["location"].partition("#")
        self.service, self.fragment = service, parse_qs(fragment)
        self.token = ""
        if "session" in self.fragment:
            self.token = self.api("POST", "session/open", {"code": self.fragment["session"][0]}).json()[
                "token"
            ]

    def api(self, method: str, path: str, content: Any = None) -> httpx.Response:
        headers = {"Authorization": f"Bearer {self.token}"} if self.token else {}
        return httpx.request(
            method,
            f"{self.service}/api/v1/{path}",
            json=content,
            headers=headers,
            timeout=120,
            trust_env=False,
        )


def test_a_teacher_chooses_and_a_mark_arrives(open_edx: OpenEdx, service: str, block: str) -> None:
    early = open_edx.open(block, "ann", "student")
    assert (early.status_code, early.json()["code"]) == (404, "link_without_exercise")
    teacher = Session(service, open_edx.open(block, "tina", "instructor"))
    assert teacher.landed.endswith("/course")
    link = teacher.api("GET", "course").json()["link"]
    chosen = {"exercise": "puma560", "points": 10, "parts": ["table"]}
    assert teacher.api("PUT", f"course/links/{link}/settings", chosen).status_code == 200
    student = Session(service, open_edx.open(block, "ann", "student"))
    assert student.landed.endswith("/exercises/puma560")
    told = student.api("GET", "session").json()
    assert (told["role"], told["person"].get("name")) == ("learner", None)
    scores = []
    for answer in (WRONG, RIGHT):
        scores.append(student.api("POST", "session/attempts", answer).json()["total"]["score"])
        found = eventually(lambda: _published(open_edx, block, "ann", scores[-1]), timeout=120)
        assert found, open_edx.state()
        assert found["max_value"] == 10
    assert scores[0] < scores[1] == 1.0
    (kept,) = open_edx.state()["scores"]
    assert (kept["given"], kept["maximum"], kept["progress"]) == (10.0, 10.0, "FullyGraded")


@pytest.mark.parametrize("block", [{"lti_advantage_ags_mode": "programmatic"}], indirect=True)
def test_a_mark_arrives_where_tools_make_the_line_items(open_edx: OpenEdx, service: str, block: str) -> None:
    teacher = Session(service, open_edx.open(block, "tina", "instructor"))
    path = f"course/links/{teacher.api('GET', 'course').json()['link']}/settings"
    teacher.api("PUT", path, {"exercise": "puma560", "points": 5, "parts": ["table"]})
    for _ in range(2):
        student = Session(service, open_edx.open(block, "cleo", "student"))
        student.api("POST", "session/attempts", RIGHT)
    assert eventually(lambda: _published(open_edx, block, "cleo", 1.0), timeout=120), open_edx.state()


def _published(open_edx: OpenEdx, block: str, user: str, score: float) -> dict[str, Any] | None:
    """Return the mark that the gradebook of the course was told last, if it is this one."""
    marks = [
        mark for mark in open_edx.state()["published"] if (mark["block"], mark["user_id"]) == (block, user)
    ]
    return marks[-1] if marks and marks[-1]["value"] == pytest.approx(10 * score) else None


def test_a_deep_link_is_taken(open_edx: OpenEdx, service: str, block: str) -> None:
    answer = open_edx.open(block, "tina", "instructor", deep="1")
    choice = Session(service, answer).fragment["choice"][0]
    asked = {"choice": choice, "exercise": "puma560", "points": 7, "parts": ["table"]}
    made = httpx.post(f"{service}/api/v1/deep-links", json=asked, timeout=120, trust_env=False).json()
    taken = open_edx.client.post(made["address"], data={"JWT": made["jwt"]})
    assert taken.status_code == 200, taken.text
    (item,) = open_edx.state()["chosen"]
    assert item["custom"]["exercise"] == "puma560"
    student = Session(service, open_edx.open(block, "bob", "student"))
    assert student.landed.endswith("/exercises/puma560")
    assert student.api("GET", "session").json()["parts"] == ["table"]
