"""What docs/lms and docs/courses.md tell an operator to type is typed here, in their order."""

import re
import shlex
import zipfile
from pathlib import Path

import httpx
import pytest

from courses.people.platforms import deployments_of, platforms
from courses.storage.database import open_store
from service.__main__ import main
from service.settings import Settings
from tests.courses.classroom import joined
from tests.live_service import running
from tests.service.adapters.test_table_files import GOOD, spreadsheet

DOCS = Path(__file__).resolve().parents[2] / "docs"
PAGES = [*sorted((DOCS / "lms").glob("*.md")), DOCS / "courses.md"]
COMMAND = re.compile(r"^\$ (framewise (?:.*\\\n)*.*)$|`(framewise [a-z][^`]*)`", re.MULTILINE)
NAMES = {
    "CLIENT_ID": "client-7",
    "DEPLOYMENT_ID": "1",
    "PASSPORT": "passport-1",
    "NUMBER": "1",
    "ISSUER": "https://lms.example.edu",
    "ID": "1",
    "KID": "none",
}
ADDRESS = "https://lms.example.edu/address"


def commands(page: Path) -> list[str]:
    """The commands of a page, in consoles and in sentences, with names in the place of placeholders."""
    found = []
    for match in COMMAND.finditer(page.read_text(encoding="utf-8")):
        text = (match[1] or match[2]).replace("\\\n", " ").partition("#")[0]
        for name, value in NAMES.items():
            text = re.sub(rf"\b{name}\b", value, text)
        found.append(text.replace(" …", f" {ADDRESS}").strip())
    return found


def is_whole(command: str) -> bool:
    """Whether it can be typed as it stands; a sentence also names commands without their arguments."""
    return "|" not in command and len(shlex.split(command)) > 2 and command != "framewise lti add"


@pytest.fixture
def installation(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """An operator's folder, with what a class handed in."""
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("FRAMEWISE_STORAGE", "on")
    monkeypatch.setenv("FRAMEWISE_DATA_FOLDER", str(tmp_path / "data"))
    with zipfile.ZipFile("hand-ins.zip", "w") as archive:
        archive.writestr("ann.csv", GOOD)
    (tmp_path / "class.xlsx").write_bytes(
        spreadsheet({"twolink": [["theta", "d", "a", "alpha"], ["q1", 0, "L1", 0], ["q2", 0, "L2", 0]]})
    )
    (tmp_path / "FOLDER").mkdir()
    open_store("", tmp_path / "data").close()
    return tmp_path


def test_each_page_has_commands() -> None:
    found = {page.name: commands(page) for page in PAGES}
    assert {name for name, each in found.items() if any(map(is_whole, each))} >= {
        "moodle.md",
        "canvas.md",
        "open-edx.md",
        "others.md",
        "courses.md",
        "without-an-administrator.md",
    }


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.stem)
def test_what_a_page_says_can_be_typed(
    page: Path, installation: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    typed = sorted(filter(is_whole, commands(page)), key=lambda command: "lti add " not in command)
    if any("activate" in command for command in typed) and "lti add " not in typed[0]:
        typed.insert(0, _registration())
    for command in typed:
        if command.startswith("framewise restore"):
            with pytest.MonkeyPatch.context() as patch:
                patch.setenv("FRAMEWISE_DATA_FOLDER", str(installation / "other"))
                main(shlex.split(command)[1:])
            continue
        if command.startswith("framewise courses erase"):
            store = open_store("", installation / "data")
            joined(store)
            store.close()
        main(shlex.split(command)[1:])
    told = capsys.readouterr().out
    if any("lti invite" in command for command in typed):
        assert "https://framewise.example.edu/lti/register/" in told
    if any("lti add " in command for command in typed):
        store = open_store("", installation / "data")
        known = {each.client_id: each for each in platforms(store)}
        assert deployments_of(store, known["client-7"].id)
        store.close()


def _registration() -> str:
    addresses = ("authorization-endpoint", "token-endpoint", "jwks-uri")
    named = " ".join(f"--{name} {ADDRESS}" for name in addresses)
    return f"framewise lti add https://lms.example.edu client-7 --deployment 1 {named}"


def test_the_addresses_that_are_copied_into_a_platform_are_there(tmp_path: Path) -> None:
    text = "".join(page.read_text(encoding="utf-8") for page in PAGES)
    paths = set(re.findall(r"https://framewise\.example\.edu(/[a-z/-]+)", text)) | {"/lti/connect"}
    assert paths >= {"/lti/login", "/lti/launch", "/lti/jwks", "/lti/configuration"}
    with running(Settings(storage="on", data_folder=tmp_path / "data")) as origin:
        for path in paths:
            answer = httpx.get(origin + path, timeout=120, trust_env=False)
            assert answer.status_code != 404, path
        logo = httpx.get(f"{origin}/lti/configuration", timeout=120, trust_env=False).json()["logo_uri"]
        assert httpx.get(logo, timeout=120, trust_env=False).headers["content-type"] == "image/svg+xml"
