"""What an author is shown: right answers, mistakes with their marks, what a policy leaves free, own words."""

from __future__ import annotations

import pickle
from dataclasses import replace
from pathlib import Path

import pytest

from exercises.answers import RawAnswer
from exercises.authoring.admission import HABITS, policy_admission
from exercises.definition import Exercise
from exercises.drawings import values
from exercises.errors import DefinitionError
from exercises.grading import BaseRule, ConventionRule, DirectionRule, HelpLevel, Policy, ToolRule, ZeroRule
from exercises.instance import generate
from exercises.loader import load_exercise, packaged
from exercises.selftest.answers import judged_answer
from exercises.selftest.rehearsal import right_answers, usual_mistakes
from tests.exercises.folders import TWO_LINKS, folder


def exercise(exercise_id: str, **policy: object) -> Exercise:
    found = packaged().exercise(exercise_id)
    return replace(found, policy=replace(found.policy, **policy))  # type: ignore[arg-type]


@pytest.mark.parametrize("exercise_id", ["puma560", "scara", "onelink"])
def test_ten_right_answers_are_right_and_differ(exercise_id: str) -> None:
    answers = right_answers(exercise(exercise_id), 10)
    assert len({answer.table for answer in answers}) == len(answers) == 10
    assert all(answer.correct and answer.points == answer.max_points for answer in answers)
    assert pickle.loads(pickle.dumps(answers)) == answers


def test_mistakes_cost_marks_and_are_explained() -> None:
    answers = usual_mistakes(exercise("scara"))
    assert len({answer.misconception for answer in answers}) == len(answers) >= 12
    assert all(answer.refused or answer.score < 1 for answer in answers)
    assert sum(bool(answer.repairs) for answer in answers) >= len(answers) - 3
    assert pickle.loads(pickle.dumps(answers)) == answers


def test_the_author_sees_what_the_help_of_the_exercise_tells() -> None:
    found = packaged().exercise("scara")
    silent = replace(found, access=replace(found.access, ladder=(HelpLevel.ROW,)))
    assert not any(answer.repairs for answer in usual_mistakes(silent))


FREE = Policy(
    convention=ConventionRule.ANY,
    base=BaseRule.FREE,
    tool=ToolRule.FREE,
    zero=ZeroRule.FREE,
    direction=DirectionRule.FREE,
)
STRICT = {
    "convention": ConventionRule.STANDARD,
    "base": BaseRule.FRAME,
    "tool": ToolRule.FRAME,
    "zero": ZeroRule.FIGURE,
    "direction": DirectionRule.FIGURE,
}


def test_a_free_policy_admits_every_choice_and_the_strictest_the_key_alone() -> None:
    found = packaged().exercise("puma560")
    known = values(generate(found))
    free = policy_admission(replace(found, policy=FREE), known)
    assert free.admitted == free.choices == 2 ** len(HABITS)
    assert set(free.free) == set(HABITS)
    strict = policy_admission(replace(found, policy=replace(FREE, **STRICT)), known)  # type: ignore[arg-type]
    assert strict.admitted == 1
    assert set(strict.fixed) == set(HABITS)


@pytest.mark.parametrize("rule", sorted(STRICT))
@pytest.mark.parametrize("exercise_id", ["puma560", "stanford"])
def test_each_rule_takes_choices_away_and_names_what_it_fixes(exercise_id: str, rule: str) -> None:
    found = packaged().exercise(exercise_id)
    known = values(generate(found))
    held = replace(FREE, **{rule: STRICT[rule]})  # type: ignore[arg-type]
    admitted = policy_admission(replace(found, policy=held), known)
    assert 0 < admitted.admitted < admitted.choices
    assert rule in admitted.fixed


def test_the_lecturers_own_words_are_told_with_the_repair() -> None:
    plain = packaged().exercise("scara")
    mistake = next(answer for answer in usual_mistakes(plain) if answer.misconception == "joint_type")
    words = {
        "en": "A joint that slides has a variable length.",
        "ro": "O cuplă de translație are d variabil.",
    }
    own = replace(
        plain, remarks={mistake.repairs[0].code: words, "a_sign": {"en": "Which way does x point?"}}
    )
    report = judged_answer(generate(own), RawAnswer(table=mistake.table))
    assert report.remarks == (words,)
    quiet = replace(own, access=replace(own.access, ladder=(HelpLevel.KIND,)))
    assert judged_answer(generate(quiet), RawAnswer(table=mistake.table)).remarks == ()
    assert sum(answer.remarks for answer in usual_mistakes(own)) >= 1


def test_remarks_are_read_and_one_on_nothing_is_a_fault(tmp_path: Path) -> None:
    remarks = '\n[remarks]\na_sign.en = "Look again which way x points."\n'
    assert load_exercise(folder(tmp_path, TWO_LINKS + remarks)).remarks["a_sign"]["en"].startswith("Look")
    with pytest.raises(DefinitionError) as caught:
        load_exercise(folder(tmp_path, TWO_LINKS + remarks.replace("a_sign", "laziness")))
    assert caught.value.code == "misconception_unknown"
