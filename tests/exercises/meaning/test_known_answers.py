"""Some of the answers of `make campaign-answers`: no right one is refused, no wrong one is accepted."""

import random

import numpy as np
import pytest
import sympy

from tests.conftest import EXPLORE
from tests.exercises.meaning import moving_arms
from tests.exercises.meaning.campaign_of_answers import CAMPAIGNS, judged_answers
from tests.exercises.meaning.posed_answers import student

FEW = 120 if EXPLORE else 24


@pytest.mark.parametrize("name", CAMPAIGNS)
def test_answers_are_judged_as_they_are(name: str) -> None:
    found = judged_answers(name, 0, FEW)
    assert not found.misjudged
    assert min(found.right, found.wrong) > FEW / 8


@pytest.mark.parametrize("name", moving_arms.BOOKS)
def test_the_books_equations_of_motion_are_those_of_energies(name: str) -> None:
    rng, instance = random.Random(2), student(name, 3)
    for _ in range(2):
        n = instance.exercise.reference.table.n_joints
        joints, rates = ([rng.uniform(-1, 1) for _ in range(n)] for _ in range(2))
        values: dict[str, float] = moving_arms.values_of(instance)
        values |= {f"q{i}": q for i, q in enumerate(joints, 1)}
        values |= {f"dq{i}": rate for i, rate in enumerate(rates, 1)}
        for terms, found in zip(
            moving_arms.BOOKS[name](), moving_arms.of_energies(instance, joints, rates), strict=True
        ):
            wanted = np.array(sympy.Matrix(terms).subs(values), dtype=float)
            np.testing.assert_allclose(found, wanted.reshape(found.shape), rtol=1e-6, atol=1e-7)
