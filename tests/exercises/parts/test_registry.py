"""A part type is one module: everything that asks for one goes through the registry."""

import ast
from dataclasses import replace
from fractions import Fraction
from pathlib import Path
from random import Random

import pytest

from exercises.definition import Exercise
from exercises.instance import generate
from exercises.loader import robot_facts
from exercises.parts.protocol import PartType
from exercises.parts.registry import part_types
from exercises.reading import Reader
from exercises.selftest.answers import context_of
from service.messages import sentence, template
from tests.exercises.packaged import exercise, exercise_ids

EXERCISES = Path(__file__).parents[3] / "exercises"


def asking(kind: str) -> Exercise:
    """A packaged exercise that asks for a kind; if none does, one that begins to."""
    found = next((found for found in map(exercise, exercise_ids) if found.part(kind) is not None), None)
    if found is not None:
        return found
    scara, judge = exercise("scara"), part_types()[kind]
    robot = robot_facts(scara.reference, scara.robot)
    part = judge.define(Reader(judge.start(robot), ("parts", 0), []), Fraction(10), robot)
    return replace(scara, parts=(part,))


ASKING = {kind: asking(kind) for kind in part_types()}


def test_no_other_module_names_the_kinds_one_by_one() -> None:
    kinds = set(part_types()) - {"table"}
    named = {
        str(path.relative_to(EXERCISES)): sorted(found)
        for path in EXERCISES.rglob("*.py")
        if EXERCISES / "parts" not in path.parents
        and (
            found := {
                node.value
                for node in ast.walk(ast.parse(path.read_text(encoding="utf-8")))
                if isinstance(node, ast.Constant) and isinstance(node.value, str)
            }
            & kinds
        )
    }
    assert named.pop("drawings.py", ["frames"]) == ["frames"]  # frames drawn in a figure
    assert named.keys() <= {"authoring/scaffold.py"}  # a new exercise asks for some of them


@pytest.mark.parametrize("kind", part_types())
def test_every_kind_explains_what_it_says_in_every_language(kind: str) -> None:
    found = part_types()[kind]
    assert isinstance(found, PartType)
    assert found.meaning
    part = ASKING[kind].part(kind)
    task = found.task(part, generate(ASKING[kind], "7"))
    for language in ("en", "es", "fr", "pt", "ro", "uk"):
        text = sentence(language, task.message, task.values)
        assert text
        assert "{" not in text
        for code in found.disclosures:
            assert template(language, f"feedback-{code}"), code


@pytest.mark.parametrize("kind", part_types())
def test_every_kind_makes_wrong_answers_that_it_explains(kind: str) -> None:
    found = ASKING[kind]
    instance = generate(found, "3")
    made = list(part_types()[kind].wrong(found.part(kind), context_of(instance, found.reference), Random(1)))
    assert made
    assert {code for code, _ in made} <= {
        *part_types()[kind].disclosures,
        *part_types()[kind].misconceptions,
        "pose_wrong",
    }
