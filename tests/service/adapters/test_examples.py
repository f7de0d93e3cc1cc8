"""The examples of docs/lms/examples, each executed as its host's documented contract has it."""

import importlib.util
import json
import os
import subprocess
import sys
import types
from pathlib import Path
from typing import Any

import pytest

ROOT = Path(__file__).resolve().parent.parent.parent.parent
EXAMPLES = ROOT / "docs" / "lms" / "examples"
RIGHT = "theta,d,a,alpha\nq1,0,L1,0\nq2,0,L2,0\n"
WRONG = "theta,d,a,alpha\nq1,0,L1,90\nq2,0,L2,0\n"
ENVIRONMENT = {**os.environ, "PYTHONPATH": str(ROOT)}


@pytest.mark.parametrize(("answer", "right"), [(RIGHT, True), (WRONG, False)])
def test_gradescope(answer: str, right: bool, tmp_path: Path) -> None:
    (tmp_path / "submission").mkdir()
    (tmp_path / "submission" / "answer.csv").write_text(answer)
    command = EXAMPLES / "gradescope" / "run_autograder"
    assert os.access(command, os.X_OK)
    variables = {"AUTOGRADER_ROOT": str(tmp_path), "FRAMEWISE": f"{sys.executable} -m service"}
    subprocess.run(["bash", str(command)], env={**ENVIRONMENT, **variables}, check=True, timeout=300)
    results = json.loads((tmp_path / "results" / "results.json").read_text())
    assert (results["score"] == 10) is right


@pytest.mark.parametrize(("answer", "right"), [(RIGHT, True), (WRONG, False)])
def test_coderunner(answer: str, right: bool) -> None:
    """CodeRunner renders the template with Twig and runs what comes out; a grader prints one JSON object."""
    template = (EXAMPLES / "coderunner" / "template.py").read_text()
    program = template.replace("{{ STUDENT_ANSWER | e('py') }}", answer)
    assert "{{" not in program
    done = subprocess.run(
        [sys.executable, "-c", program],
        env=ENVIRONMENT,
        capture_output=True,
        text=True,
        check=True,
        timeout=300,
    )
    assert (json.loads(done.stdout)["fraction"] == 1) is right


def test_nbgrader() -> None:
    """The last expression of the test cell is the number of points (nbgrader's partial credit)."""
    notebook = json.loads((EXAMPLES / "nbgrader" / "two-link.ipynb").read_text())
    cells = ["".join(cell["source"]) for cell in notebook["cells"] if cell["cell_type"] == "code"]
    graded = [cell for cell in notebook["cells"] if cell["metadata"]["nbgrader"]["grade"]]
    assert [cell["metadata"]["nbgrader"]["points"] for cell in graded] == [5]
    for change, most in (("", True), ('rows[0]["alpha"] = 90', False)):
        names: dict[str, Any] = {}
        exec(cells[0] + "\n" + change, names)  # the notebook is ours
        *lines, last = [line for line in cells[1].splitlines() if line]
        exec("\n".join(lines), names)
        assert (eval(last, names) == 5) is most


def test_otter() -> None:
    """Otter imports a test file and calls its test cases with the notebook's names."""
    stub = types.ModuleType("otter.test_files")
    stub.test_case = lambda **_: lambda function: function  # type: ignore[attr-defined]
    sys.modules |= {"otter": types.ModuleType("otter"), "otter.test_files": stub}
    try:
        specification = importlib.util.spec_from_file_location("q1", EXAMPLES / "otter" / "tests" / "q1.py")
        assert specification is not None
        assert specification.loader is not None
        module = importlib.util.module_from_spec(specification)
        specification.loader.exec_module(module)
    finally:
        del sys.modules["otter"], sys.modules["otter.test_files"]
    rows = [{"theta": f"q{i}", "d": 0, "a": f"L{i}", "alpha": 0} for i in (1, 2)]
    table = {"convention": "standard", "rows": rows}
    module.test_the_table_can_be_graded(table)
    module.test_the_table_describes_the_robot(table)
    with pytest.raises(AssertionError):
        module.test_the_table_describes_the_robot({**table, "rows": [{**rows[0], "alpha": 1}, rows[1]]})
    with pytest.raises(AssertionError):
        module.test_the_table_can_be_graded({**table, "rows": []})


ELEMENT = '<pl-dh-table answers-name="table" exercise="twolink" rows="3"></pl-dh-table>'


def element() -> Any:
    path = EXAMPLES / "prairielearn" / "elements" / "pl-dh-table" / "pl-dh-table.py"
    specification = importlib.util.spec_from_file_location("pl_dh_table", path)
    assert specification is not None
    assert specification.loader is not None
    module = importlib.util.module_from_spec(specification)
    specification.loader.exec_module(module)
    return module


def question() -> dict[str, Any]:
    """What PrairieLearn hands to an element, as its documentation lists it."""
    return {
        "params": {},
        "correct_answers": {},
        "submitted_answers": {},
        "raw_submitted_answers": {},
        "format_errors": {},
        "partial_scores": {},
        "score": 0,
        "feedback": {},
        "variant_seed": 17,
        "options": {},
        "editable": True,
        "panel": "question",
    }


@pytest.mark.parametrize(("answer", "right"), [(RIGHT, True), (WRONG, False)])
def test_prairielearn_element(answer: str, right: bool) -> None:
    module, data = element(), question()
    module.prepare(ELEMENT, data)
    form = module.render(ELEMENT, data)
    header, *rows = [line.split(",") for line in answer.splitlines()]
    for i, cells in enumerate(rows):
        for column, cell in zip(header, cells, strict=True):
            assert f'name="table-{i}-{column}"' in form
            data["raw_submitted_answers"][f"table-{i}-{column}"] = cell
    module.parse(ELEMENT, data)
    assert not data["format_errors"]
    json.dumps(data)  # everything is stored as JSON
    module.grade(ELEMENT, data)
    assert (data["partial_scores"]["table"]["score"] == 1) is right
    data["panel"] = "submission"
    assert module.render(ELEMENT, data)


def test_prairielearn_counts_no_attempt_for_what_cannot_be_read() -> None:
    module, data = element(), question()
    module.prepare(ELEMENT, data)
    data["raw_submitted_answers"] = {"table-0-theta": "<script>", "table-0-a": "("}
    assert "<script>" not in module.render(ELEMENT, data)
    module.parse(ELEMENT, data)
    assert data["format_errors"]["table"]


def test_two_tables_of_a_question_are_of_two_exercises() -> None:
    """Both were graded by the exercise of the last one."""
    module, data = element(), question()
    other = ELEMENT.replace('"table"', '"other"').replace("twolink", "scara")
    for each in (ELEMENT, other):
        module.prepare(each, data)
    assert data["params"]["framewise"]["exercise"] == "twolink"
    header, *rows = [line.split(",") for line in RIGHT.splitlines()]
    for i, cells in enumerate(rows):
        for column, cell in zip(header, cells, strict=True):
            data["raw_submitted_answers"][f"table-{i}-{column}"] = cell
    module.parse(ELEMENT, data)
    module.grade(ELEMENT, data)
    assert data["partial_scores"]["table"]["score"] == 1
