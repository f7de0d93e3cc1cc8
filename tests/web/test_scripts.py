"""The form's pure parts, tested under Node."""

from __future__ import annotations

import os
import shutil
import subprocess

import pytest

from tests.web.conftest import ROOT


def test_pure_modules_under_node() -> None:
    node = shutil.which("node")
    if node is None:
        if os.environ.get("CI"):
            pytest.fail("Node is not installed")
        pytest.skip("Node is not installed")
    tests = sorted(str(path) for path in (ROOT / "tests" / "web" / "js").glob("*.test.mjs"))
    assert len(tests) >= 4
    done = subprocess.run([node, "--test", *tests], cwd=ROOT, capture_output=True, text=True, timeout=120)
    assert done.returncode == 0, done.stdout + done.stderr
