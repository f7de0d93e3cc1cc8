"""The [policy] and the [weights] of a definition, from its file."""

from __future__ import annotations

from dataclasses import fields

from exercises.grading import BaseRule, ConventionRule, DirectionRule, Policy, Tolerance, ToolRule, ZeroRule
from exercises.grading.facts import Weights
from exercises.reading import Reader

MOST_WEIGHT = 100.0
"""A weight beyond this leaves nothing to the other facts: a slip of the pen."""


def read_policy(reader: Reader) -> Policy:
    """Return what a table is held to; faults go to the reader."""
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


def read_weights(reader: Reader) -> Weights:
    """Return what facts and slips are worth in a wrong table; faults go to the reader."""
    usual = Weights()
    given = {entry.name: reader.number(entry.name, getattr(usual, entry.name)) for entry in fields(usual)}
    for name, value in given.items():
        most = 1.0 if name == "sign" else MOST_WEIGHT  # sign is a share of the others
        if not 0.0 <= value <= most:
            reader.fault("weight_out_of_range", name, name=name, most=most)
    reader.finish()
    return Weights(**given)
