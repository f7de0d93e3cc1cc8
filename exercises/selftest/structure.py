"""Whether the values that students may have leave the robot its structure: which axes meet, and how."""

from collections.abc import Iterator
from dataclasses import replace
from fractions import Fraction
from types import MappingProxyType

from exercises.definition import Exercise
from exercises.draws import Draw
from exercises.instance import Instance, generate
from exercises.parts.forward.schematic import Schematic, schematic_of
from kinematics.cells import AngleUnit, ParameterKind
from kinematics.table import bind

MOST_VALUES = 25
"""A bound of the work, for each dimension: lengths near zero and angles near right ones are tried first."""
RIGHT_ANGLE = 90  # [deg]


def structure_of(instance: Instance) -> Schematic:
    """Return the structure of the robot that a student has."""
    return schematic_of(bind(instance.exercise.reference.table, instance.values))


def values_of_other_structure(exercise: Exercise) -> Iterator[tuple[str, Fraction]]:
    """Yield the first value of each dimension that may be drawn and makes it a robot of another structure.

    The other dimensions have their usual values. Few seeds draw such a value, but a student may have it.
    """
    usual = generate(exercise)
    structure = structure_of(usual)
    for parameter in exercise.parameters:
        if parameter.draw is None:
            continue
        is_angle = exercise.reference.parameters.get(parameter.name) is ParameterKind.ANGLE
        for value in _tried(parameter.draw, turns=is_angle and exercise.angle_unit is AngleUnit.DEG):
            exact = MappingProxyType({**usual.exact, parameter.name: value})
            if structure_of(replace(usual, exact=exact)) != structure:
                yield parameter.name, value
                break


def _tried(draw: Draw, *, turns: bool) -> list[Fraction]:
    """The values of a draw that are nearest to zero or, of an angle, to a multiple of a right angle."""

    def off(value: Fraction) -> Fraction:
        return abs(value - RIGHT_ANGLE * round(value / RIGHT_ANGLE)) if turns else abs(value)

    return sorted(draw.values, key=off)[:MOST_VALUES]
