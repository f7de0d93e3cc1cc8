"""Who may import whom, and what is imported at all."""

from __future__ import annotations

import os
import subprocess
import sys

import pytest

from tests.architecture.sources import ROOT


def test_the_import_contracts_hold() -> None:
    program = "from importlinter.cli import lint_imports_command as main; main()"
    result = subprocess.run(
        [sys.executable, "-c", program], cwd=ROOT, capture_output=True, text=True, check=False
    )
    assert result.returncode == 0, result.stdout + result.stderr


@pytest.mark.parametrize("module", ["kinematics.cells", "exercises", "service.app", "service.__main__"])
@pytest.mark.parametrize("unwanted", ["sympy", "matplotlib", "scipy"])
def test_starting_up_loads_nothing_heavy(module: str, unwanted: str) -> None:
    program = f"import sys, {module}; sys.exit({unwanted!r} in sys.modules)"
    result = subprocess.run(
        [sys.executable, "-c", program],
        cwd=ROOT,
        env={**os.environ, "PYTHONPATH": str(ROOT)},
        capture_output=True,
        text=True,
        check=False,
    )
    assert result.returncode == 0, f"{module} imports {unwanted}\n{result.stderr}"


def test_the_application_serves_without_sympy() -> None:
    program = "import sys, service.app as s; s.create_app().openapi(); sys.exit('sympy' in sys.modules)"
    result = subprocess.run(
        [sys.executable, "-c", program], cwd=ROOT, capture_output=True, text=True, check=False
    )
    assert result.returncode == 0, result.stderr


@pytest.mark.parametrize(
    "module", ["inverse_forms", "dynamics", "symbolic_forms", "chain_forms", "motion_products"]
)
def test_worker_processes_load_no_web_framework(module: str) -> None:
    program = f"import sys, service.wire.{module}; sys.exit('starlette' in sys.modules)"
    result = subprocess.run(
        [sys.executable, "-c", program], cwd=ROOT, capture_output=True, text=True, check=False
    )
    assert result.returncode == 0, f"{module} imports the web framework\n{result.stderr}"
