"""Who may import whom, and what is imported at all."""

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


def loaded(program: str, unwanted: tuple[str, ...]) -> list[str]:
    """Which of the unwanted modules a new Python has loaded after a program."""
    asked = f"import sys\n{program}\nprint(*(name for name in {unwanted!r} if name in sys.modules))"
    result = subprocess.run(
        [sys.executable, "-c", asked], cwd=ROOT, capture_output=True, text=True, check=False
    )
    assert result.returncode == 0, result.stderr
    return result.stdout.split()


@pytest.mark.parametrize(
    "program",
    [
        "import kinematics.cells",
        "import exercises",
        "import service.__main__",
        "import service.app as service; service.create_app().openapi()",
    ],
)
def test_starting_up_loads_nothing_heavy(program: str) -> None:
    assert loaded(program, ("sympy", "matplotlib", "scipy")) == []


def test_worker_processes_load_no_web_framework() -> None:
    modules = ("inverse_forms", "dynamics", "symbolic_forms", "chain_forms", "motion_products")
    program = "".join(f"import service.wire.kinematics.{module}\n" for module in modules)
    assert loaded(program, ("starlette",)) == []
