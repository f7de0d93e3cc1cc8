"""The [policy] of a definition, from its file."""

from __future__ import annotations

from exercises.grading import BaseRule, ConventionRule, DirectionRule, Policy, Tolerance, ToolRule, ZeroRule
from exercises.reading import Reader


def read_policy(reader: Reader) -> Policy:
    """What a table is held to; faults go to the reader."""
    inner = reader.table("tolerance")
    usual = Tolerance()
    tolerance = Tolerance(
        length=inner.number("length", usual.length), angle=inner.number("angle", usual.angle)
    )
    for name in ("length", "angle"):
        if not 0 < getattr(tolerance, name) <= 0.1:
            inner.fault("tolerance_out_of_range", name, name=name)
    inner.finish()
    policy = Policy(
        convention=reader.choice("convention", ConventionRule, ConventionRule.ANY),
        base=reader.choice("base", BaseRule, BaseRule.FREE),
        tool=reader.choice("tool", ToolRule, ToolRule.AXIS),
        zero=reader.choice("zero", ZeroRule, ZeroRule.FREE),
        direction=reader.choice("direction", DirectionRule, DirectionRule.FREE),
        tolerance=tolerance,
    )
    reader.finish()
    return policy
