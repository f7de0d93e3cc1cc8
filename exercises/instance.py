"""`generate`: an exercise with one student's values.

Values follow from the exercise's id, the seed and the name of the value by a hash, so that the same seed
gives the same values in every process, on every machine and in every later version, whatever else the
definition draws.
"""

from __future__ import annotations

import hashlib
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from types import MappingProxyType
from typing import TypeVar

from exercises.definition import Exercise, PartKind, PosePart
from exercises.errors import AnswerError
from kinematics.errors import Fault

SEED_CHARACTERS = 200
Value = TypeVar("Value")


@dataclass(frozen=True, kw_only=True, eq=False)
class Instance:
    """An exercise with one student's values.

    Attributes:
        exercise: the exercise.
        seed: from what the values were drawn; None for the values that everyone sees without a seed.
        exact: value of every dimension [the exercise's unit].
        pose_joints: joint values of the numeric pose [the exercise's units]; empty if none is asked.
    """

    exercise: Exercise
    seed: str | None
    exact: Mapping[str, Fraction]
    pose_joints: tuple[Fraction, ...]

    @property
    def parameters(self) -> dict[str, float]:
        """Value of every dimension [the exercise's unit]."""
        return {name: float(value) for name, value in self.exact.items()}


def generate(exercise: Exercise, seed: str | int | None = None) -> Instance:
    """The exercise with the values of a seed.

    Args:
        exercise: the exercise.
        seed: names a student or a try: text or a whole number; 7 and "7" are the same seed. None: the usual
            values.

    Raises:
        AnswerError: the seed is longer than 200 characters.
    """
    text = None if seed is None else str(seed)
    if text is not None and len(text) > SEED_CHARACTERS:
        raise AnswerError(
            Fault(
                code="seed_too_long",
                where=("seed",),
                params={"limit": SEED_CHARACTERS},
            )
        )
    exact = {
        parameter.name: parameter.value
        if text is None or parameter.draw is None
        else pick(parameter.draw.values(), exercise.id, text, parameter.name)
        for parameter in exercise.parameters
    }
    part = exercise.part(PartKind.POSE)
    joints: tuple[Fraction, ...] = ()
    if isinstance(part, PosePart):
        joints = tuple(
            value if text is None or draw is None else pick(draw.values(), exercise.id, text, f"pose q{i}")
            for i, (value, draw) in enumerate(zip(part.joints, part.draws, strict=True), 1)
        )
    return Instance(exercise=exercise, seed=text, exact=MappingProxyType(exact), pose_joints=joints)


def pick(values: Sequence[Value], *names: str) -> Value:
    """One of the values, the same one for the same names for ever."""
    digest = hashlib.blake2b("\x1f".join(names).encode(), digest_size=16).digest()
    return values[int.from_bytes(digest, "big") % len(values)]
