"""An answer whose truth is known, and how numbers are typed."""

import random
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

from exercises.answers import RawAnswer, parse
from exercises.instance import Instance
from exercises.parts.context import Context
from exercises.parts.registry import part_type
from exercises.parts.report import PartReport


@dataclass(frozen=True)
class KnownAnswer:
    """An answer, whether it is right, how it is judged, and how it is told if it is misjudged."""

    right: bool
    judge: Callable[[], bool]
    told: Callable[[], str]


def report_on(instance: Instance, kind: str, **parts: Any) -> PartReport:
    """What is said of one part, from cells as they are typed; a table beside it is not judged itself."""
    answer = parse(instance, RawAnswer(**parts))
    asked = instance.exercise.part(kind)
    assert asked is not None
    context = Context(instance=instance, answer=answer, verdict=None)
    return part_type(kind).grade(asked, answer.get(kind), context)


def known(right: bool, instance: Instance, kind: str, **parts: Any) -> KnownAnswer:
    """An answer to one part, which is right if it has full marks."""
    return KnownAnswer(
        right,
        lambda: report_on(instance, kind, **parts).score == 1.0,
        lambda: f"{instance.exercise.id} {instance.exercise.part(kind)} {instance.seed} {parts}",
    )


def typed(value: float, rng: random.Random, decimals: int = 4) -> float | str:
    """A number, rounded and written in one of the ways that students have."""
    value = round(float(value), decimals) + 0.0
    text = f"{value:.{decimals}f}"
    match rng.randrange(24):
        case 0:
            return text.replace("-", "−")
        case 1:
            return f"{2 * value:.{decimals + 1}f}/2"
        case 2:
            return f"({text})"
        case 3:
            return f"{value:.{decimals + 3}e}"
        case 4:
            return f"{value - 0.25:.{decimals}f} + 1/4"
        case 5:
            return text
    return value


def typed_rows(rows: Any, rng: random.Random, decimals: int = 4) -> list[list[float | str]]:
    """A matrix so typed."""
    return [[typed(value, rng, decimals) for value in row] for row in rows]


def typed_angle(value: float, degrees: bool, rng: random.Random) -> float | str:
    """An angle [rad] in the exercise's unit, some with full turns, or with a unit of its own."""
    value += 6.283185307179586 * rng.randint(-2, 2)
    shown = value * 57.29577951308232 if degrees else value
    if degrees and rng.random() < 0.2:
        return f"{shown:.3f}°"
    return typed(shown, rng)


def other_than(values: Sequence[float], k: int, step: float) -> list[float]:
    """The values with one of them changed."""
    return [value + step if i == k else value for i, value in enumerate(values)]
