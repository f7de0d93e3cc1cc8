"""A table and all that follows from it, as a student would hand it in."""

from __future__ import annotations

from types import MappingProxyType

from exercises.answers import Answer, RawAnswer
from exercises.instance import Instance
from exercises.parts.context import Context
from exercises.parts.protocol import TABLE
from exercises.parts.registry import part_type
from kinematics.cells import ReadTable


def answer_from(instance: Instance, read: ReadTable) -> RawAnswer:
    """Return a table with everything else that the exercise asks, as it follows from that table.

    Args:
        instance: the exercise with the student's values.
        read: the table, right or wrong.
    """
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
