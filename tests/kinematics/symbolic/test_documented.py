"""The examples of docs/symbolic.md run."""

import re
from pathlib import Path

PAGE = Path(__file__).resolve().parents[3] / "docs" / "symbolic.md"
EXAMPLE = re.compile(r"```python\n(.*?)```", re.DOTALL)


def test_every_example_of_the_page_runs() -> None:
    examples = EXAMPLE.findall(PAGE.read_text(encoding="utf-8"))
    assert len(examples) == 2
    for example in examples:
        exec(compile(example, str(PAGE), "exec"), {})
