"""What an author is shown: right answers, mistakes with their marks, what a policy leaves free, own words."""

import pickle
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

import pytest

from exercises.answers import RawAnswer
from exercises.authoring.admission import CHOICES, policy_admission
from exercises.definition import Exercise
from exercises.errors import DefinitionError
from exercises.grading import BaseRule, ConventionRule, DirectionRule, HelpLevel, Policy, ToolRule, ZeroRule
from exercises.instance import generate
from exercises.library import packaged
from exercises.loader import load_exercise
from exercises.needs import unneeded_dimensions
from exercises.selftest.answers import judged_answer
from exercises.selftest.checks import check_values
from exercises.selftest.rehearsal import right_answers, usual_mistakes
from kinematics.table import Convention
from tests.conftest import EXPLORE
from tests.exercises.folders import TWO_LINKS, folder
from tests.exercises.packaged import table_ids


def exercise(exercise_id: str, **policy: object) -> Exercise:
    found = packaged().exercise(exercise_id)
    return replace(found, policy=replace(found.policy, **policy))  # type: ignore[arg-type]


HELD = table_ids if EXPLORE else table_ids[::5]
UNJUDGED = {"parameter_misnamed"}
"""A name that the exercise does not know is refused, and costs no attempt."""


def held_to_the_other() -> Iterator[tuple[str, ConventionRule]]:
    """Exercises with a table, held to the convention in which their keys are not written; one as it is."""
    for name in HELD:
        key = packaged().exercise(name).reference.table.convention
        yield name, ConventionRule("standard" if key is Convention.MODIFIED else "modified")
    yield "scara", ConventionRule.ANY


@pytest.mark.parametrize(("exercise_id", "convention"), tuple(held_to_the_other()))
def test_an_author_sees_right_and_wrong_answers_in_the_convention_that_is_asked_for(
    exercise_id: str, convention: ConventionRule
) -> None:
    held = exercise(exercise_id, convention=convention)
    answers = right_answers(held, 10)
    assert len({answer.table for answer in answers}) == len(answers) == 10
    assert all(answer.correct and answer.points == answer.max_points for answer in answers)
    wrong = usual_mistakes(held)
    assert len({answer.misconception for answer in wrong}) == len(wrong) >= 9
    assert {answer.misconception for answer in wrong if answer.refused} <= UNJUDGED
    assert not any(answer.correct for answer in wrong)
    assert all(answer.refused or (answer.score < 1 and answer.points < answer.max_points) for answer in wrong)
    explained = [bool(answer.repairs) for answer in wrong if not answer.refused]
    assert sum(explained) >= len(explained) - 3
    if convention is not ConventionRule.ANY:
        asked = {convention.value}
        assert {answer.table.convention.value for answer in answers} == asked
        others = [answer for answer in wrong if answer.misconception != "convention"]
        assert {answer.table.convention.value for answer in others} == asked
    assert pickle.loads(pickle.dumps((answers, wrong))) == (answers, wrong)


@pytest.mark.parametrize("convention", [ConventionRule.STANDARD, ConventionRule.MODIFIED])
def test_what_is_needed_does_not_hang_on_the_convention_that_is_asked_for(convention: ConventionRule) -> None:
    for name in ("scara", "onelink", "kr125"):
        assert unneeded_dimensions(exercise(name, convention=convention)) == unneeded_dimensions(
            exercise(name, convention=ConventionRule.ANY)
        )


@pytest.mark.parametrize("convention", list(ConventionRule))
def test_the_self_test_passes_in_either_convention(convention: ConventionRule) -> None:
    for name in ("scara", "stanford"):
        assert not check_values((None,), exercise(name, convention=convention), 3).failures


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
    known = generate(found).values
    free = policy_admission(replace(found, policy=FREE), known)
    assert free.admitted == free.choices == 2 ** len(CHOICES)
    assert set(free.free) == set(CHOICES)
    strict = policy_admission(replace(found, policy=replace(FREE, **STRICT)), known)  # type: ignore[arg-type]
    assert strict.admitted == 1
    assert set(strict.fixed) == set(CHOICES)


@pytest.mark.parametrize("rule", sorted(STRICT))
@pytest.mark.parametrize("exercise_id", ["puma560", "stanford"])
def test_each_rule_takes_choices_away_and_names_what_it_fixes(exercise_id: str, rule: str) -> None:
    found = packaged().exercise(exercise_id)
    known = generate(found).values
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
