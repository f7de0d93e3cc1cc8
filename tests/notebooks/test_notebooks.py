"""The notebooks of docs/notebooks show what they would show now."""

import importlib.util
import json
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
NOTEBOOKS = sorted((ROOT / "docs" / "notebooks").glob("*.ipynb"))
_SPEC = importlib.util.spec_from_file_location("notebooks", ROOT / "tools" / "notebooks.py")
assert _SPEC is not None
assert _SPEC.loader is not None
runner = importlib.util.module_from_spec(_SPEC)
_SPEC.loader.exec_module(runner)


def test_there_are_three() -> None:
    assert [path.stem for path in NOTEBOOKS] == ["catalogue_robot", "grading_a_class", "urdf_to_closed_form"]


@pytest.mark.parametrize("path", NOTEBOOKS, ids=lambda path: path.stem)
def test_its_outputs_are_those_of_its_cells(path: Path) -> None:
    """Run `python tools/notebooks.py docs/notebooks/*.ipynb` after a change that is meant."""
    text = path.read_text(encoding="utf-8")
    notebook = json.loads(text)
    assert notebook["nbformat"] == 4
    assert any(cell.get("outputs") for cell in notebook["cells"])
    assert runner.written(runner.executed(notebook)) == text
