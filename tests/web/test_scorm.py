"""SCORM packages in a real browser: an LMS of another origin plays them by an independent run-time."""

import http.server
import io
import json
import threading
import zipfile
from collections.abc import Iterator
from functools import partial
from pathlib import Path
from typing import Any

import httpx
import pytest
from playwright.sync_api import Browser, Page, expect

from service.settings import Settings
from tests.live_service import running
from tests.web.conftest import ROOT, UNHURRIED
from tests.web.driving import cell, fill_table
from tests.web.profiles import PATIENCE, new_context

RUNTIME = ROOT / "node_modules" / "scorm-again" / "dist"
ROWS = [
    {"joint": "revolute", "theta": "q1", "d": "0", "a": "L1", "alpha": "0"},
    {"joint": "revolute", "theta": "q2", "d": "0", "a": "L2", "alpha": "0"},
]
RIGHT = {"convention": "standard", "rows": ROWS}
WRONG = {"convention": "standard", "rows": [{**ROWS[0], "alpha": "90"}, ROWS[1]]}

LMS = """<!doctype html><meta charset="utf-8"><title>LMS</title>
<script src="{script}"></script>
<script>
  const stored = JSON.parse(localStorage.getItem("cmi") || "null");
  const api = new {constructor}({{ autocommit: false }});
  if (stored) api.loadFromJSON(stored, "");
  api.on("{commit}", () => localStorage.setItem("cmi", JSON.stringify(api.cmi)));
  api.cmi.{learner} = "student-17";
  window.{name} = api;
</script>
<iframe src="package/index.html" style="width: 100%; height: 1500px; border: 0"></iframe>
"""

VERSIONS: dict[str, dict[str, str]] = {
    "1.2": {
        "script": "scorm12.js",
        "constructor": "Scorm12API",
        "name": "API",
        "learner": "core.student_id",
        "commit": "LMSCommit",
        "status": "cmi.core.lesson_status",
        "raw": "cmi.core.score.raw",
        "get": "LMSGetValue",
    },
    "2004": {
        "script": "scorm2004.js",
        "constructor": "Scorm2004API",
        "name": "API_1484_11",
        "learner": "learner_id",
        "commit": "Commit",
        "status": "cmi.success_status",
        "raw": "cmi.score.raw",
        "get": "GetValue",
    },
}


@pytest.fixture(scope="module")
def strict() -> Iterator[str]:
    """A service with its own settings: no origin but its own may frame its other pages."""
    with running(Settings(**UNHURRIED)) as origin:
        yield origin


@pytest.fixture
def lms(strict: str, tmp_path: Path, request: pytest.FixtureRequest) -> Iterator[tuple[str, dict[str, str]]]:
    """An LMS on an origin of its own that plays the package of one exercise."""
    version: str = request.param
    names = VERSIONS[version]
    address, asked = f"{strict}/api/v1/exercises/twolink/scorm.zip", {"version": version, "lang": "en"}
    answer = httpx.get(address, params=asked, timeout=120)
    assert answer.headers["content-type"] == "application/zip"
    with zipfile.ZipFile(io.BytesIO(answer.content)) as archive:
        archive.extractall(tmp_path / "package")
    (tmp_path / names["script"]).write_bytes((RUNTIME / names["script"]).read_bytes())
    (tmp_path / "index.html").write_text(LMS.format(**names), encoding="utf-8")
    handler = partial(_Quiet, directory=str(tmp_path))
    server = http.server.ThreadingHTTPServer(("127.0.0.1", 0), handler)
    thread = threading.Thread(target=server.serve_forever, daemon=True)
    thread.start()
    yield f"http://localhost:{server.server_address[1]}", names
    server.shutdown()
    server.server_close()


class _Quiet(http.server.SimpleHTTPRequestHandler):
    def log_message(self, *_: object) -> None:
        pass


def value(page: Page, names: dict[str, str], element: str) -> Any:
    return page.evaluate(f"([name]) => window.{names['name']}.{names['get']}(name)", [element])


def exercise(page: Page) -> Any:
    frame = page.frame_locator("iframe").frame_locator("#exercise")
    frame.locator("html[data-ready=true]").wait_for(state="attached", timeout=PATIENCE)
    return frame


@pytest.mark.parametrize("lms", list(VERSIONS), indirect=True)
def test_launch_wrong_right_leave_return(browser: Browser, lms: tuple[str, dict[str, str]]) -> None:
    address, names = lms
    context = new_context(browser)
    try:
        page = context.new_page()
        page.goto(f"{address}/index.html")
        frame = exercise(page)
        fill_table(frame, WRONG)
        frame.locator("button[type=submit].primary").click()
        page.wait_for_function(
            f"([name]) => window.{names['name']}.{names['get']}(name) !== ''",
            arg=[names["raw"]],
            timeout=PATIENCE,
        )
        expected = "failed" if names["name"] == "API_1484_11" else "incomplete"
        assert value(page, names, names["status"]) == expected
        low = float(value(page, names, names["raw"]))
        fill_table(frame, RIGHT)
        frame.locator("button[type=submit].primary").click()
        page.wait_for_function(
            f"([name, low]) => Number(window.{names['name']}.{names['get']}(name)) > low",
            arg=[names["raw"], low],
            timeout=PATIENCE,
        )
        assert json.loads(value(page, names, "cmi.suspend_data"))["table"]["rows"][1]
        seeds = [f.url for f in page.frames if "seed=" in f.url]
        assert len(seeds) == 1
        assert "student-17" not in seeds[0]
        page.goto("about:blank")
        page.goto(f"{address}/index.html")
        frame = exercise(page)
        expect(cell(frame, 1, "a")).to_have_value("L2")
    finally:
        context.close()
