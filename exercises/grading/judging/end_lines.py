"""Whether the lines that a policy fixes at the ends lie where the typed digits allow.

Under the rule `axis` z_N lies on the last joint's axis or on the key's z_N, and z_0 on the first joint's axis
or on the key's z_0 (`kinematics/equivalence/policy.py`): each length and angle of one of the two must be
explained.
"""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from exercises.grading.judging.digits import not_explained
from exercises.grading.judging.typed import NOTHING_TYPED, Place
from kinematics.equivalence import BaseRule, Kind, Policy, ToolRule
from kinematics.equivalence.invariants import Invariants, invariants_of
from kinematics.equivalence.measures import Measure, Shape
from kinematics.equivalence.reference import Reference
from kinematics.table import NumericTable

_BASE_LINE = Policy(base=BaseRule.FRAME, tool=ToolRule.FREE)
_TOOL_LINE = Policy(base=BaseRule.FREE, tool=ToolRule.FRAME)


def ends_beyond_digits(
    reference: Reference, table: NumericTable, steps: Mapping[Place, float], policy: Policy, share: float
) -> tuple[Kind, ...]:
    """Return which rules `axis` an answer keeps only within the tolerance of poses, not within its digits.

    Args:
        reference: the key.
        table: the answer, as it was meant, with as many joints.
        steps: half a unit of the last place of its decimals [rad or length].
        policy: what the answer is held to.
        share: by which part of itself an angle or a length may be off.
    """
    n = table.n_joints
    found = []
    for kind, asked, line, joint, end in (
        (Kind.BASE, policy.base is BaseRule.AXIS, _BASE_LINE, 1, 0),
        (Kind.TOOL, policy.tool is ToolRule.AXIS, _TOOL_LINE, n, n + 1),
    ):
        if asked and n:
            ways = (_on_the_joint(reference, joint, end), _on_the_line(reference, line, end))
            # without steps first: most lines lie where they should, and this is what edits are asked
            if all(
                all(not_explained(way, reference, table, typed, line, share) for way in ways)
                for typed in (NOTHING_TYPED, steps)
            ):
                found.append(kind)
    return tuple(found)


def _on_the_joint(reference: Reference, joint: int, end: int) -> Invariants:
    """What vanishes where the line is the joint's axis; a prismatic joint's is only parallel."""
    between = (min(joint, end), max(joint, end))
    shapes = [Shape(Measure.ANGLE, between)]
    if not reference.chain.axes[joint - 1].prismatic:
        shapes.append(Shape(Measure.DISTANCE, (*between, joint)))
    nothing = np.zeros((len(shapes), 1))
    return Invariants(tuple(shapes), nothing, nothing)


def _on_the_line(reference: Reference, line: Policy, end: int) -> Invariants:
    """What no choice of frames changes of the key's line, but for where its origin lies along it."""
    invariants = invariants_of(reference, line)
    return invariants.some(
        [i for i, shape in enumerate(invariants.shapes) if end in shape.axes and end not in shape.runs]
    )
