"""How exactly an entry was typed, and what a rounded one stands for.

A decimal is right within half a unit of its last place. A name, a fraction, a multiple of π and a multiple of
15° are exact. A decimal that is, within its digits, a multiple of π/12 or a value of the key stands for that.
"""

import math
from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import lru_cache
from types import MappingProxyType

from kinematics.angles import TWELFTH
from kinematics.cells import AngleUnit
from kinematics.expressions import ZERO, Expression, Number, evaluate, negate, pi_fraction, pi_times
from kinematics.table import ANGLES, CELLS, DHTable, JointType, SymbolicTable

# An angle typed with fewer than two decimals [rad], or less than one [deg], stands for itself.
COARSEST_ANGLE = 0.01
COARSEST = 0.25
"""Half a unit of the last place beside the number itself: 0.2 may be 0.15, 0.1 is not 0.15 rounded."""
SAME = 1e-9
"""[rad], or a share: millions of roundings to doubles, 1e-16 each, leave no more of what is the same."""
_MOST_DECIMALS = 40  # More digits than a double can tell apart: such an entry counts as exact.

Place = tuple[int, str]
NOTHING_TYPED: Mapping[Place, float] = MappingProxyType({})


@dataclass(frozen=True, eq=False, slots=True)
class Typed:
    """A table as it was meant, and how far its entries may be from what was meant.

    Attributes:
        table: the table with rounded entries replaced by what they stand for.
        steps: half a unit of the last place of those that stand for themselves, by row and cell; exact ones
            are left out [rad or length].
        typed_steps: the same of all decimals, whatever they stand for.
    """

    table: SymbolicTable
    steps: Mapping[Place, float]
    typed_steps: Mapping[Place, float]

    @property
    def exact(self) -> bool:
        """Whether every entry is known exactly."""
        return not self.steps


def meant(
    table: SymbolicTable,
    unit: AngleUnit,
    angles: tuple[Expression, ...],
    lengths: tuple[Expression, ...] = (),
    last_places: Mapping[Place, float] = NOTHING_TYPED,
    given: Collection[Fraction] = (),
) -> Typed:
    """Return what a table was meant to say.

    Args:
        table: the table as read.
        unit: in which its angles were typed.
        angles: exact values, without names, that a rounded angle may stand for, beside multiples of π/12.
        lengths: exact values, without names, that a rounded length may stand for.
        last_places: units of the last place of decimals whose values do not show it.
        given: lengths that the exercise gives: what is one of them to its last digit is not rounded.
    """
    steps = half_steps(table, unit, last_places)
    known_angles, known_lengths = _with_signs(angles), _with_signs(lengths)
    rows = list(table.rows)
    left: dict[Place, float] = {}
    for (i, cell), step in steps.items():
        entry = getattr(rows[i], cell)
        if (
            given
            and cell not in ANGLES
            and isinstance(entry, Number)
            and entry.value
            and abs(entry.value) in given
        ):
            continue
        exact = _angle(entry, step, known_angles) if cell in ANGLES else _nearest(entry, step, known_lengths)
        if exact is None:
            left[i, cell] = step
        elif exact != entry:
            rows[i] = replace(rows[i], **{cell: exact})  # type: ignore[arg-type]
    changed = any(new is not old for new, old in zip(rows, table.rows, strict=True))
    told = DHTable(convention=table.convention, rows=tuple(rows)) if changed else table
    return Typed(told, left, steps)


def half_steps(
    table: SymbolicTable, unit: AngleUnit, last_places: Mapping[Place, float] = NOTHING_TYPED
) -> dict[Place, float]:
    """Return half a unit in the last place for every entry that is a decimal and matters.

    A zero is as exact as the most exact entry of its kind in the table; where there is none, it is exact. The
    offset of a joint's own variable is left out: no answer depends on it, unless the figure fixes it.
    """
    steps, zeros = _half_steps_by_value(table, unit)
    found = {place: min(step, 0.5 * last_places.get(place, math.inf)) for place, step in steps.items()}
    for angular in (True, False):
        finest = [step for (_, cell), step in found.items() if (cell in ANGLES) is angular]
        if finest:
            found |= {place: min(finest) for place in zeros if (place[1] in ANGLES) is angular}
    return found


@lru_cache(maxsize=32)
def _half_steps_by_value(
    table: SymbolicTable, unit: AngleUnit
) -> tuple[Mapping[Place, float], Sequence[Place]]:
    """Half a unit in the last place that the value of a decimal shows, and where zeros stand.

    Remembered, for it is asked for in every way in which an answer may be meant.
    """
    steps: dict[Place, float] = {}
    zeros: list[Place] = []
    for i, row in enumerate(table.rows):
        for cell in CELLS:
            if _is_variable(row.joint, cell):
                continue
            step = _half_step(getattr(row, cell), cell, unit)
            if step is None:
                zeros.append((i, cell))
            elif step:
                steps[i, cell] = step
    return MappingProxyType(steps), tuple(zeros)


def says_enough(step: float, entry: float, cell: str | None = None) -> bool:
    """Return whether half a unit of the last place is small beside a number; beside a zero it is not.

    An angle of more than a turn is not rounded: 45 rad, typed where degrees were meant, is no 0.79 rad.
    """
    beyond_a_turn = cell in ANGLES and abs(entry) > math.tau
    return not beyond_a_turn and step <= COARSEST * abs(entry) * (1.0 + SAME)


def meant_in_radians(angle: float) -> float:
    """Return what an angle [rad] was meant to be, if radians were typed where degrees are declared.

    Of a multiple of π/12 two decimals are enough: they were chosen before anybody looked at the unit.
    """
    typed = math.degrees(angle)
    exact = round(typed / TWELFTH) * TWELFTH
    return exact if abs(typed - exact) <= COARSEST_ANGLE / 2 else typed


def _is_variable(joint: JointType, cell: str) -> bool:
    return (joint is JointType.REVOLUTE and cell == "theta") or (joint is JointType.PRISMATIC and cell == "d")


def _half_step(entry: Expression, cell: str, unit: AngleUnit) -> float | None:
    """Half a unit of the last place; 0 for what is exact, None for a zero."""
    if entry == ZERO:
        return None
    if cell not in ANGLES:
        return _of_decimal(entry.value.denominator) if isinstance(entry, Number) else 0.0
    if unit is AngleUnit.RAD:
        return _of_decimal(entry.value.denominator) if isinstance(entry, Number) else 0.0
    turns = pi_fraction(entry)
    if turns is None or not (turns * 12) % 1:
        return 0.0
    return math.radians(_of_decimal((turns * 180).denominator))


@lru_cache(maxsize=4096)
def _of_decimal(rest: int) -> float:
    """Half a unit of the last decimal of a number with such a denominator; 0 if it is no decimal."""
    twos = (rest & -rest).bit_length() - 1
    rest >>= twos
    fives = 0
    while rest % 5 == 0:
        rest //= 5
        fives += 1
    decimals = max(twos, fives)
    return 0.5 * 10.0**-decimals if rest == 1 and decimals <= _MOST_DECIMALS else 0.0


@lru_cache(maxsize=256)
def _with_signs(values: tuple[Expression, ...]) -> list[tuple[float, Expression]]:
    """Values with either sign, as numbers and exactly."""
    signed = dict.fromkeys(entry for value in values for entry in (value, negate(value)))
    return [(evaluate(entry), entry) for entry in signed]


def _angle(entry: Expression, step: float, known: list[tuple[float, Expression]]) -> Expression | None:
    if step > COARSEST_ANGLE:
        return None
    here = evaluate(entry)
    twelfths = round(here / TWELFTH)
    if abs(here - twelfths * TWELFTH) <= step:
        return _twelfths_of_pi(twelfths)
    return _nearest(entry, step, known)


@lru_cache(maxsize=64)
def _twelfths_of_pi(number: int) -> Expression:
    return pi_times(Fraction(number, 12))


def _nearest(entry: Expression, step: float, known: list[tuple[float, Expression]]) -> Expression | None:
    if not known:
        return None
    here = evaluate(entry)
    value, exact = min(known, key=lambda one: abs(one[0] - here))
    return exact if abs(value - here) <= step * (1.0 + SAME) and says_enough(step, here) else None
