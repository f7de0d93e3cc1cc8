"""A table and all that follows from it, as a student would hand it in; and handing it in."""

from dataclasses import replace
from random import Random
from types import MappingProxyType

from exercises.answers import Answer, RawAnswer, parse
from exercises.definition import Exercise
from exercises.errors import AnswerError
from exercises.grader import Report, grade
from exercises.instance import Instance, generate
from exercises.parts.context import Context
from exercises.parts.protocol import TABLE
from exercises.parts.registry import part_type
from exercises.selftest.variants import some_lengths, variant
from kinematics.cells import RawTable, ReadTable
from kinematics.chain import chain_of_table, size_of
from kinematics.expressions import Expression, parameters_in, rational_value
from kinematics.table import JointType, bind


def answer_from(instance: Instance, read: ReadTable) -> RawAnswer:
    """Return a table with everything else that the exercise asks, as it follows from that table."""
    context = context_of(instance, read)
    return RawAnswer(
        **{part.kind: part_type(part.kind).right(part, context) for part in instance.exercise.parts}
    )


def context_of(instance: Instance, read: ReadTable) -> Context:
    """Return what answers beside a student's table are made from."""
    answer = Answer(
        parts=MappingProxyType({TABLE: read}), angle_unit=read.angle_unit, length_unit=read.length_unit
    )
    return Context(instance=instance, answer=answer, verdict=None)


def other_frames(instance: Instance, rng: Random) -> ReadTable:
    """Return the key as somebody with other frames would have written it."""
    exercise = instance.exercise
    usual = size_of(chain_of_table(bind(exercise.reference.table, instance.values))) / 4
    taken = taken_by_slides(exercise)
    lengths = tuple(
        entry
        for entry in some_lengths(exercise.reference.table, usual)
        if taken.isdisjoint(parameters_in(entry))
    )
    # A number that happens to be a dimension's value would be taken for the dimension.
    told_apart = tuple(entry for entry in lengths if not _is_value(entry, instance))
    table = variant(exercise.reference.table, exercise.policy, told_apart or lengths, rng)
    return replace(exercise.reference, table=table)


def taken_by_slides(exercise: Exercise) -> frozenset[str]:
    """Return the names of dimensions that mean the variable in a prismatic row: d3, where joint 3 slides."""
    types = exercise.reference.table.joint_types
    slides = {f"d{joint}" for joint, found in enumerate(types, 1) if found is JointType.PRISMATIC}
    return frozenset(slides & {*exercise.reference.parameters, *exercise.aliases})


def _is_value(length: Expression, instance: Instance) -> bool:
    number = rational_value(length)
    return number is not None and abs(number) in {abs(value) for value in instance.exact.values()}


def judged_answer(instance: Instance, raw: RawAnswer) -> Report:
    """Return what is said of an answer at the attempt from which on most is told."""
    return grade(instance, parse(instance, raw), attempt=len(instance.exercise.access.ladder))


def is_refused(exercise: Exercise, raw: RawTable) -> bool:
    """Return whether a table is refused as malformed."""
    try:
        parse(generate(exercise), RawAnswer(table=raw))
    except AnswerError:
        return True
    return False
