"""Limits of joints: as the definition of an exercise gives them, and as its task tells them."""

from collections.abc import Iterator, Sequence
from fractions import Fraction
from typing import TypeAlias

from exercises.definition import Exercise
from exercises.figures.points import posture_in_figure
from exercises.parts.joint_draws import told_units
from exercises.reading import Reader
from kinematics.table import JointType

JointLimits: TypeAlias = tuple[tuple[Fraction, Fraction] | None, ...]
"""Of each joint its lowest and highest value [units of the exercise]; None leaves it unlimited."""


def read_limits(reader: Reader, n: int, known: Sequence[tuple[float, float]] | None) -> JointLimits:
    """Return the limits of the joints: "catalogue", a list with one entry a joint ([] for none), or none.

    Args:
        reader: what the definition says.
        n: how many joints there are.
        known: the limits in the catalogue, if it knows them.
    """
    free: JointLimits = (None,) * n
    value = reader.values["limits"] if reader.given("limits") else [[]] * n
    if value == "catalogue":
        if known is None:
            reader.fault("exercise_limits_unknown", "limits")
            return free
        return tuple((Fraction(repr(low)), Fraction(repr(high))) for low, high in known)
    if not isinstance(value, list):
        reader.fault("exercise_value_unknown", "limits", key="limits", known="catalogue, [[-180, 180], []]")
        return free
    if len(value) != n:
        reader.fault("joints_wrong_length", "limits", expected=n, given=len(value))
        return free
    limits: list[tuple[Fraction, Fraction] | None] = []
    for i, entry in enumerate(value):
        if entry == []:
            limits.append(None)
            continue
        inner = Reader({"pair": entry}, (*reader.where, "limits", i), reader.faults)
        pair = inner.exacts("pair")
        low, high = pair if len(pair) == 2 else (Fraction(1), Fraction(0))
        if low > high:
            inner.fault("exercise_limits_reversed", joint=i + 1)
        limits.append((low, high))
    return tuple(limits)


def told_limits(limits: JointLimits, exercise: Exercise) -> tuple[str, str]:
    """Return limits as inequalities, and where their joints are in the figure, which shows their zeros."""
    ranges, drawn = [], []
    joints = zip(limits, _drawn_at(exercise), told_units(exercise), strict=True)
    for i, (limit, at, sign) in enumerate(joints, 1):
        if limit is None:
            continue
        low, high, now = (f"{float(x):g}{sign if sign == '°' else f' {sign}'}" for x in (*limit, at))
        ranges.append(f"{low} ≤ q{i} ≤ {high}")
        drawn.append(f"q{i} = {now}")
    return ", ".join(ranges), ", ".join(drawn)


def with_one_joint_reversed(limits: JointLimits, exercise: Exercise) -> Iterator[JointLimits]:
    """Yield the limits as they are for a reader who takes one joint to increase the other way.

    Its value in the figure is the same, which is told.
    """
    for i, (limit, at) in enumerate(zip(limits, _drawn_at(exercise), strict=True)):
        if limit is not None:
            low, high = limit
            now = 2 * Fraction(at)
            yield (*limits[:i], (now - high, now - low), *limits[i + 1 :])


def _drawn_at(exercise: Exercise) -> Iterator[float]:
    """The joint values at which the robot is drawn [units of the exercise]."""
    table, unit = exercise.reference.table, exercise.angle_unit
    for at, joint_type in zip(posture_in_figure(exercise.figure, table), table.joint_types, strict=True):
        yield unit.from_radians(at) if joint_type is JointType.REVOLUTE else at
