"""What the pages show is what happens; `python -m tests.architecture.test_readme --update` writes it."""

import contextlib
import io
import itertools
import json
import math
import re
import shlex
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

from tests.architecture.serving import serving
from tests.architecture.sources import ROOT

PAGES = [ROOT / "README.md", ROOT / "docs" / "api.md"]
ADDRESS = "http://127.0.0.1:8000"
BLOCK = re.compile(r"^```(\w*)\n(.*?)^```$", re.MULTILINE | re.DOTALL)


def commands(text: str) -> Iterator[tuple[str, str]]:
    """Shell commands with the output that is shown below them."""
    for language, body in BLOCK.findall(text):
        if language != "console":
            continue
        for part in re.split(r"^\$ ", body, flags=re.MULTILINE)[1:]:
            lines = part.splitlines(keepends=True)
            end = 1
            while not complete("".join(lines[:end])):
                end += 1
            yield "".join(lines[:end]).strip(), "".join(lines[end:]).strip()


def complete(command: str) -> bool:
    """Whether no quotation mark is open."""
    try:
        shlex.split(command)
    except ValueError:
        return False
    return True


def requests() -> list[Any]:
    return [
        pytest.param(command, shown, id=f"{page.name}: {command.split()[2].removeprefix(ADDRESS)} {i}")
        for page in PAGES
        for i, (command, shown) in enumerate(commands(page.read_text(encoding="utf-8")))
        if command.startswith("curl")
    ]


@pytest.fixture(scope="module")
def address() -> Iterator[str]:
    command = [sys.executable, "-m", "service", "--port", "0"]
    with serving(command, cwd=ROOT) as url:
        yield url


def executed(command: str, address: str) -> str:
    result = subprocess.run(
        ["bash", "-c", command.replace(ADDRESS, address)],
        capture_output=True,
        text=True,
        check=True,
        timeout=300,
    )
    return result.stdout.strip()


def alike(shown: Any, real: Any) -> bool:
    if isinstance(shown, float) and isinstance(real, int | float):
        return math.isclose(shown, real, rel_tol=1e-9, abs_tol=1e-12)
    if isinstance(shown, list) and isinstance(real, list):
        return len(shown) == len(real) and all(map(alike, shown, real))
    if isinstance(shown, dict) and isinstance(real, dict):
        ours, theirs = ({**found, "request_id": ""} for found in (shown, real))
        return ours.keys() == theirs.keys() and all(alike(ours[key], theirs[key]) for key in ours)
    return bool(shown == real)


def says_the_same(shown: str, real: str) -> bool:
    if shown.startswith(("{", "[")):
        return alike(json.loads(shown), json.loads(real))
    return shown == real


@pytest.mark.parametrize(("command", "shown"), requests())
def test_a_request_gets_the_answer_that_is_shown(address: str, command: str, shown: str) -> None:
    real = executed(command, address)
    assert says_the_same(shown, real), real


def test_the_make_targets_exist() -> None:
    for page in (ROOT / "README.md", ROOT / "CONTRIBUTING.md", ROOT / "docs" / "operations.md"):
        for command, _ in commands(page.read_text(encoding="utf-8")):
            if command.startswith("make"):
                target = command.split()[1]
                result = subprocess.run(
                    ["make", "-n", target], cwd=ROOT, capture_output=True, text=True, check=False
                )
                assert result.returncode == 0, command


def test_the_first_command_stands_on_the_first_screen() -> None:
    lines = (ROOT / "README.md").read_text(encoding="utf-8").splitlines()
    assert lines[0].startswith("# ")
    assert next(i for i, line in enumerate(lines, 1) if line.startswith("$ curl")) <= 15
    assert "## What it does not do" in lines


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.name)
def test_python_examples_print_what_is_shown(page: Path, address: str) -> None:
    blocks = BLOCK.findall(page.read_text(encoding="utf-8"))
    found = 0
    for (language, code), (_, output) in itertools.pairwise(blocks):
        if language == "python":
            printed = io.StringIO()
            with contextlib.redirect_stdout(printed):
                exec(compile(code.replace(ADDRESS, address), page.name, "exec"), {})
            assert printed.getvalue().strip() == output.strip()
            found += 1
    assert found


def update() -> None:
    with serving([sys.executable, "-m", "service", "--port", "0"], cwd=ROOT) as address:
        for page in PAGES:
            text = page.read_text(encoding="utf-8")
            for command, shown in commands(text):
                real = executed(command, address) if command.startswith("curl") else shown
                if not says_the_same(shown, real):
                    text = text.replace(f"{command}\n{shown}\n", f"{command}\n{real}\n")
            page.write_text(text, encoding="utf-8")


if __name__ == "__main__" and "--update" in sys.argv:
    update()
