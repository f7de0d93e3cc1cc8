"""What a stranger does: clone into a folder with a space in its name, type the two commands, twice.

Takes as long as everything else together, so it runs only when asked for: `make test-clone`.
"""

import os
import subprocess
from pathlib import Path

import pytest

from tests.architecture.serving import fetched, reserved_port, serving
from tests.architecture.sources import ROOT

pytestmark = [
    pytest.mark.skipif("TEST_CLONE" not in os.environ, reason="slow: make test-clone"),
    pytest.mark.timeout(3600),
]


@pytest.fixture(scope="module")
def clone(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("a stranger's folder") / "frame wise"
    subprocess.run(["git", "clone", "--quiet", "--no-hardlinks", str(ROOT), str(folder)], check=True)
    return folder


def outer() -> dict[str, str]:
    """The environment without what this run brought into it."""
    own = ("TEST_", "PYTEST", "VIRTUAL_ENV", "MAKE", "MFLAGS")
    return {name: value for name, value in os.environ.items() if not name.startswith(own)}


@pytest.mark.parametrize("time", ["first", "second"])
def test_make_serve_serves(clone: Path, time: str) -> None:
    with (
        reserved_port() as port,
        serving(
            ["make", "serve", f"PORT={port}"], cwd=clone, environment=outer(), bare=True, patience=600
        ) as address,
    ):
        assert address.endswith(f":{port}")
        assert fetched(address, "/healthz")[0] == 200
        assert fetched(address, "/")[0] == 200


@pytest.mark.parametrize("time", ["first", "second"])
def test_make_test_passes(clone: Path, time: str) -> None:
    result = subprocess.run(
        ["make", "test"], cwd=clone, env=outer(), capture_output=True, text=True, check=False
    )
    assert result.returncode == 0, result.stdout[-4000:] + result.stderr[-2000:]


def test_nothing_was_left_outside_what_git_ignores(clone: Path) -> None:
    status = subprocess.run(
        ["git", "status", "--porcelain"], cwd=clone, capture_output=True, text=True, check=True
    )
    assert status.stdout == ""
