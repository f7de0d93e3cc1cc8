"""Angles and orders of axes that an orientation is drawn from."""

from collections.abc import Sequence
from fractions import Fraction

from exercises.definition import Exercise
from exercises.draws import Draw, Picker
from exercises.reading import KeyShape, Reader
from kinematics.errors import PoseError
from kinematics.keys import ValueKind
from kinematics.rotations.matrices import Triple
from kinematics.rotations.sequences import EulerSequence, Turning
from kinematics.se3 import triple

SEQUENCES = ("XYZ", "XZY", "YXZ", "YZX", "ZXY", "ZYX", "XYX", "XZX", "YXY", "YZY", "ZXZ", "ZYZ")
"""Every order of three axes that describes all orientations."""


def drawn_triple(
    exercise: Exercise, picker: Picker, usual: Sequence[Fraction], ways: Sequence[Draw | None], name: str
) -> Triple:
    """Return a student's three angles [rad], drawn beside the usual ones [the exercise's unit]."""
    drawn = (
        float(picker.value(value, way, f"{name} {i}"))
        for i, (value, way) in enumerate(zip(usual, ways, strict=True), 1)
    )
    return triple(map(exercise.angle_unit.in_radians, drawn))


def read_triple(reader: Reader) -> tuple[Fraction, ...]:
    """Return the three angles of a definition; faults go to the reader."""
    reader.note("angles", KeyShape.NUMBERS, ("1", "2", "3"))
    angles = reader.exacts("angles")
    if len(angles) == 3:
        return angles
    reader.mistyped(ValueKind.NUMBERS, "angles", count=3)
    return (Fraction(0),) * 3


def read_sequence(reader: Reader, axes: str, turning: str, default: EulerSequence) -> EulerSequence:
    """Return an order of axes from two keys of a definition; faults go to the reader."""
    reader.note(axes, KeyShape.CHOICE, options=SEQUENCES)
    text = reader.text(axes, default.axes)
    way = reader.choice(turning, Turning, default.turning)
    try:
        return EulerSequence(axes=text, turning=way)
    except PoseError as error:
        reader.fault(error.code, axes, axes=text)
        return default
