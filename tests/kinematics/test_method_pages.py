"""The examples of the methods' pages give what they say."""

from __future__ import annotations

import doctest
from pathlib import Path

import pytest

DOCS = Path(__file__).resolve().parents[2] / "docs"


@pytest.mark.parametrize(("name", "least"), [("frames", 8), ("inverse-kinematics", 8)])
def test_every_example_of_the_page(name, least):
    page = DOCS / f"{name}.md"
    text = page.read_text(encoding="utf-8").replace("```", "")
    examples = doctest.DocTestParser().get_doctest(text, {}, name, str(page), 0)
    reports = []
    result = doctest.DocTestRunner().run(examples, out=reports.append)
    assert result.attempted >= least
    assert not result.failed, "".join(reports)
