"""Variants: so many sets of values, shared out among all seeds."""

from collections import Counter
from dataclasses import replace
from pathlib import Path

import pytest

from exercises.access import ExerciseAccess
from exercises.errors import DefinitionError
from exercises.instance import generate, variant_of, variant_seeds
from exercises.loader import load_exercise
from tests.exercises.folders import TWO_LINKS, folder
from tests.exercises.packaged import exercise


def test_all_seeds_share_as_many_sets_of_values() -> None:
    four = replace(exercise("puma560"), access=ExerciseAccess(variants=4))
    found = Counter(repr(dict(generate(four, f"student {n}").exact)) for n in range(400))
    assert len(found) == 4
    assert min(found.values()) > 60
    assert {generate(four, f"student {n}").seed for n in range(400)} == set(variant_seeds(4))


def test_a_variant_falls_to_itself_and_no_seed_to_none() -> None:
    for seed in variant_seeds(20):
        assert variant_of("puma560", seed, 20) == seed
    assert variant_of("puma560", None, 20) is None
    assert variant_of("puma560", "ada", None) == "ada"


def test_a_definition_says_how_many(tmp_path: Path) -> None:
    def faults(line: str) -> list[str]:
        with pytest.raises(DefinitionError) as refused:
            load_exercise(folder(tmp_path, f"{TWO_LINKS}\n[access]\n{line}\n"))
        return [fault.code for fault in refused.value.faults]

    found = load_exercise(folder(tmp_path, f"{TWO_LINKS}\n[access]\nvariants = 7\n"))
    assert found.access.variants == 7
    assert faults("variants = 1001") == ["variants_too_many"]
    assert faults("variants = 0") == faults("attempts = 0")
