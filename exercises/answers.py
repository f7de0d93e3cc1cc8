"""`parse`: what a student handed in, read or refused. What is refused is not graded and costs no attempt."""

from types import MappingProxyType
from typing import Any

from exercises.errors import AnswerError
from exercises.instance import Instance
from exercises.parts.protocol import TABLE, Answer, RawAnswer, Reading
from exercises.parts.registry import part_type
from kinematics.cells import DEFAULT, Limits
from kinematics.errors import Fault

__all__ = ["Answer", "RawAnswer", "parse"]


def parse(instance: Instance, raw: RawAnswer, limits: Limits = DEFAULT) -> Answer:
    """Read an answer.

    Raises:
        AnswerError: it cannot be graded; every fault, each with its place in the answer.
    """
    faults = _not_asked(instance, raw)
    parts: dict[str, Any] = {}
    asked = (kind for kind in raw.parts if kind == TABLE or instance.exercise.part(kind) is not None)
    for kind in sorted(asked, key=lambda kind: kind != TABLE):
        reading = Reading(instance=instance, raw=raw, table=parts.get(TABLE), limits=limits)
        parts[kind] = part_type(kind).read(raw.parts[kind], reading)
        faults += (fault.within(kind) for fault in reading.faults)
    if faults:
        raise AnswerError(faults)
    source = parts.get(TABLE) or instance.exercise.reference
    return Answer(parts=MappingProxyType(parts), angle_unit=source.angle_unit, length_unit=source.length_unit)


def _not_asked(instance: Instance, raw: RawAnswer) -> list[Fault]:
    """Return what is wrong before anything is read."""
    known = tuple(part.kind for part in instance.exercise.parts)
    if not raw.parts:
        return [Fault.at("answer_empty", known=known)]
    return [
        Fault.at("part_not_asked", kind, part=kind, known=known) for kind in raw.parts if kind not in known
    ]
