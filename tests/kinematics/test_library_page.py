"""The examples of docs/library.md give what they say."""

import doctest
from pathlib import Path

PAGE = Path(__file__).resolve().parents[2] / "docs" / "library.md"


def test_every_example_of_the_page():
    text = PAGE.read_text(encoding="utf-8").replace("```", "")
    examples = doctest.DocTestParser().get_doctest(text, {}, "library", str(PAGE), 0)
    reports = []
    result = doctest.DocTestRunner().run(examples, out=reports.append)
    assert result.attempted > 20
    assert not result.failed, "".join(reports)
