"""Students' values follow from the seed, for ever."""

from fractions import Fraction
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from exercises.draws import Draw, Picker, pick
from exercises.errors import AnswerError
from exercises.instance import generate
from exercises.loader import load_exercise
from exercises.parts.forward.pose import PosePart
from tests.exercises.folders import changed, folder
from tests.exercises.packaged import exercise, exercise_ids


def test_without_a_seed_everyone_has_the_usual_values() -> None:
    instance = generate(exercise("puma560"))
    assert instance.parameters == {"a2": 0.4318, "a3": 0.0203, "d3": 0.15005, "d4": 0.4318}
    assert instance.seed is None


def test_values_of_a_seed_never_change() -> None:
    """These very values stand in students' books: a change here breaks running courses."""
    instance = generate(exercise("puma560"), "7")
    assert {name: str(value) for name, value in instance.exact.items()} == {
        "a2": "21/50",
        "a3": "1/40",
        "d3": "13/100",
        "d4": "39/100",
    }
    assert [int(value) for value in instance.drawn["pose"]] == [105, 45, 120, -75, 60, 90]


def test_text_and_number_are_the_same_seed() -> None:
    assert generate(exercise("rx90"), 7).exact == generate(exercise("rx90"), "7").exact


@given(seed=st.text(max_size=200), exercise_id=st.sampled_from(exercise_ids))
def test_drawn_values_are_among_those_that_may_be_drawn(seed: str, exercise_id: str) -> None:
    found = exercise(exercise_id)
    instance = generate(found, seed)
    for parameter in found.parameters:
        assert parameter.draw is not None
        assert instance.exact[parameter.name] in parameter.draw.values
    for part in found.parts:
        if isinstance(part, PosePart):
            for value, draw in zip(instance.drawn["pose"], part.joints.ways, strict=True):
                assert draw is not None
                assert value in draw.values


@pytest.mark.parametrize("exercise_id", exercise_ids)
def test_dimensions_with_different_names_are_drawn_different_sizes(exercise_id: str) -> None:
    found = exercise(exercise_id)
    for seed in range(100):
        sizes = [abs(value) for value in generate(found, seed).exact.values()]
        assert len(set(sizes)) == len(sizes), (seed, sizes)


def test_a_draw_without_another_choice_repeats_a_size() -> None:
    picker, only = (
        Picker(exercise_id="x", seed="1"),
        Draw(start=Fraction(1), stop=Fraction(1), step=Fraction(1)),
    )
    assert picker.value(Fraction(2), only, "L2", without={Fraction(1)}) == 1


def test_seeds_differ_from_one_another() -> None:
    found = exercise("puma560")
    assert len({tuple(generate(found, seed).exact.values()) for seed in range(200)}) > 150


def test_draws_are_even() -> None:
    counts = [0] * 10
    for seed in range(5000):
        counts[pick(range(10), "even", str(seed))] += 1
    assert min(counts) > 400
    assert max(counts) < 600


def test_a_draw_lists_its_values() -> None:
    draw = Draw(start=Fraction(1, 10), stop=Fraction(1, 2), step=Fraction(1, 10), without=(Fraction(3, 10),))
    assert [str(value) for value in draw.values] == ["1/10", "1/5", "2/5", "1/2"]


def test_a_seed_is_bounded() -> None:
    with pytest.raises(AnswerError) as refused:
        generate(exercise("rx90"), "x" * 201)
    assert refused.value.code == "seed_too_long"


def test_sizes_that_pass_for_each_other_in_numbers_are_drawn_apart(tmp_path: Path) -> None:
    text = changed("from = 0.4, to = 0.6, step = 0.1", "from = 0.297, to = 0.304, step = 0.001")
    found = load_exercise(folder(tmp_path, text))
    drawn = {generate(found, seed).exact["L1"] for seed in range(200)}
    assert drawn == {Fraction(304, 1000)}
