"""Which dimensions an answer needs: those that no valid choice of frames can leave out.

A dimension is needed if the key with another value of it is a wrong answer. The height of a base whose frame
may lie anywhere is not: a student may put frame 0 wherever the height vanishes.
"""

from collections.abc import Iterator
from dataclasses import replace
from enum import StrEnum
from fractions import Fraction
from itertools import combinations, product
from typing import Any

from exercises.definition import Exercise
from exercises.grading import BaseRule, ToolRule, ZeroRule, is_accepted
from exercises.selftest.variants import key_as_asked
from kinematics.cells.substitution import with_values
from kinematics.expressions import Number, Parameter, add, multiply

OTHER = Fraction(7, 5)
"""Another value is this many times the right one: far outside of every tolerance (at most 0.1)."""

_FIXING: dict[str, tuple[StrEnum, ...]] = {
    "base": (BaseRule.ORIGIN, BaseRule.FRAME),
    "tool": (ToolRule.POINT, ToolRule.FRAME),
    "zero": (ZeroRule.FIGURE,),
}
"""What may fix a dimension, the weaker rule first."""


def unneeded_dimensions(exercise: Exercise) -> tuple[str, ...]:
    """Return the dimensions that an answer may leave out under the exercise's policy."""
    return tuple(name for name in exercise.reference.parameters if not is_needed(exercise, name))


def is_needed(exercise: Exercise, name: str) -> bool:
    """Return whether a table with another value of a dimension is a wrong answer."""
    key = key_as_asked(exercise.reference, exercise.policy)
    other = add((multiply((Number(OTHER), Parameter(name))), Number(Fraction(1, 1000))))
    table = with_values(key.table, {name: other})
    return not is_accepted(exercise.reference, replace(key, table=table), exercise.policy)


def rules_that_need(exercise: Exercise, name: str) -> tuple[str, ...]:
    """Return what of the policy would have to be otherwise for answers to need a dimension: each is enough.

    As few rules as will do, each as weak as will do, written as in a definition; none if no rule helps.
    """
    stricter = {
        key: rules[rules.index(now) + 1 :] if (now := getattr(exercise.policy, key)) in rules else rules
        for key, rules in _FIXING.items()
    }
    for count in range(1, len(stricter) + 1):
        found = []
        for keys in combinations(stricter, count):
            for rules in product(*(stricter[key] for key in keys)):
                changed: dict[str, Any] = dict(zip(keys, rules, strict=True))
                policy = replace(exercise.policy, **changed)
                if is_needed(replace(exercise, policy=policy), name):
                    found.append(", ".join(f'{key} = "{rule}"' for key, rule in changed.items()))
                    break
        if found:
            return tuple(found)
    return ()


def unmet_needs(exercise: Exercise) -> Iterator[int]:
    """Yield the places in `exercise.needs` of dimensions that the policy lets students leave out."""
    for i, name in enumerate(exercise.needs):
        if name in exercise.reference.parameters and not is_needed(exercise, name):
            yield i
