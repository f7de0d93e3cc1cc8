"""What is installed is whole: the wheel holds every file that the tree serves, and serves it."""

import json
import os
import subprocess
import sys
import zipfile
from pathlib import Path

import pytest

from tests.architecture.serving import fetched, serving
from tests.architecture.sources import PACKAGES, ROOT


@pytest.fixture(scope="module")
def wheel(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("wheel")
    subprocess.run(
        [sys.executable, "-m", "build", "--wheel", "--no-isolation", "--outdir", str(folder), str(ROOT)],
        check=True,
        capture_output=True,
    )
    (built,) = folder.glob("*.whl")
    return built


@pytest.fixture(scope="module")
def installed(wheel: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("installed")
    subprocess.run(
        [
            sys.executable,
            "-m",
            "pip",
            "install",
            "--quiet",
            "--no-deps",
            "--no-index",
            "--target",
            folder,
            wheel,
        ],
        check=True,
        capture_output=True,
    )
    return folder


def test_every_file_of_the_packages_is_in_the_wheel(wheel: Path) -> None:
    names = set(zipfile.ZipFile(wheel).namelist())
    wanted = {
        str(path.relative_to(ROOT))
        for package in PACKAGES
        for path in (ROOT / package).rglob("*")
        if path.is_file() and "__pycache__" not in path.parts  # where other processes write meanwhile
    }
    wanted |= {
        f"service/{path.relative_to(ROOT)}"
        for path in (ROOT / "static").rglob("*")
        if path.is_file() and path.name != ".complete"
    }
    assert not wanted - names


def test_the_wheel_holds_nothing_else(wheel: Path) -> None:
    names = zipfile.ZipFile(wheel).namelist()
    assert {name.split("/")[0] for name in names} <= {*PACKAGES, "framewise-0.1.0.dist-info"}


def test_the_wheel_serves_away_from_the_tree(installed: Path, tmp_path: Path) -> None:
    command = [sys.executable, str(installed / "bin" / "framewise"), "--port", "0"]
    environment = {"PYTHONPATH": str(installed), "PATH": os.environ["PATH"]}
    with serving(command, cwd=tmp_path, environment=environment) as address:
        assert json.loads(fetched(address, "/healthz")[1]) == {"status": "ok"}
        status, body = fetched(address, "/api/v1/openapi.json")
        assert status == 200
        for path, operations in json.loads(body)["paths"].items():
            if "get" in operations and "{" not in path and path != "/healthz":
                assert fetched(address, path)[0] == 200, path
        assert fetched(address, "/")[0] == 200
        assert fetched(address, "/static/any/vendor/katex/katex.js")[0] == 200
