"""Statements become HTML, and nothing but what is listed survives."""

import re

import pytest
from hypothesis import given
from hypothesis import strategies as st

from exercises.statements import first_sentence, names_in, to_html
from tests.exercises.packaged import exercise, exercise_ids


@pytest.mark.parametrize(
    ("markdown", "html"),
    [
        ("One *L1* and *RL4*.", "<p>One <var>L<sub>1</sub></var> and <var>RL<sub>4</sub></var>.</p>"),
        ("At *P*.", "<p>At <var>P</var>.</p>"),
        ("A *whole phrase*.", "<p>A <em>whole phrase</em>.</p>"),
        ("**Mind** `q1 < 2`.", "<p><strong>Mind</strong> <code>q1 &lt; 2</code>.</p>"),
        ("One\nline.\n\nAnother.", "<p>One line.</p>\n<p>Another.</p>"),
        ("- one\n- two", "<ul><li>one</li><li>two</li></ul>"),
        ("1. one\n2) two", "<ol><li>one</li><li>two</li></ol>"),
        ("## A heading", "<h3>A heading</h3>"),
        ("2 * 3 * 4", "<p>2 * 3 * 4</p>"),
        ("<script>alert(1)</script>", "<p>&lt;script&gt;alert(1)&lt;/script&gt;</p>"),
        ("[link](javascript:x)", "<p>[link](javascript:x)</p>"),
    ],
)
def test_markup(markdown: str, html: str) -> None:
    assert to_html(markdown) == html


@given(st.text(max_size=300))
def test_no_tag_of_the_source_survives(markdown: str) -> None:
    allowed = {"p", "ul", "ol", "li", "h3", "h4", "h5", "em", "strong", "code", "var", "sub"}
    html = to_html(markdown)
    assert set(re.findall(r"</?([a-zA-Z0-9]+)", html)) <= allowed
    assert not re.search(r"<[a-z0-9]+ ", html)


def test_names_are_those_of_dimensions_and_points() -> None:
    assert names_in("*L1*, **a2**, `d3`, *P*, *two words*, *RL4*") == {"L1", "P", "RL4"}


@pytest.mark.parametrize("exercise_id", exercise_ids)
def test_a_first_sentence_is_plain_and_short(exercise_id: str) -> None:
    for text in exercise(exercise_id).statements.values():
        first = first_sentence(text)
        assert 10 < len(first) < 260
        assert first[-1] in ".!?"
        assert "*" not in first
