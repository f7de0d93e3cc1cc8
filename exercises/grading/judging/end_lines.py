"""Whether the lines that a policy fixes at the ends lie where the typed digits allow.

Under the rule `axis` z_N lies on the last joint's axis or on the key's z_N, and z_0 on the first joint's axis
or on the key's z_0 (`kinematics/equivalence/policy.py`): each length and angle of one of the two must be
explained.
"""

from collections.abc import Collection, Iterator, Mapping
from dataclasses import replace

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
    return tuple(
        kind
        for kind, line, joint, end in _asked(policy, table.n_joints)
        if _is_beyond(
            (_on_the_joint(reference, joint, end), _on_the_line(reference, line, end)),
            *(reference, table, steps, line, share),
        )
    )


def ends_beside_joints(
    reference: Reference, table: NumericTable, steps: Mapping[Place, float], policy: Policy, share: float
) -> tuple[Kind, ...]:
    """Return which rules `axis` an answer with another robot does not keep, whatever is wrong in it.

    What is seen is at which angle and distance the line lies from its joint: no mistake among the other
    joints changes that.

    Args as in `ends_beyond_digits`.
    """
    found = []
    for kind, line, joint, end in _asked(policy, table.n_joints):
        known = _on_the_line(reference, line, end)
        beside = known.some([i for i, shape in enumerate(known.shapes) if {*shape.axes} == {joint, end}])
        ways = (_on_the_joint(reference, joint, end), beside)
        if _is_beyond(ways, reference, table, steps, line, share):
            found.append(kind)
    return tuple(found)


def _asked(policy: Policy, n_joints: int) -> Iterator[tuple[Kind, Policy, int, int]]:
    """Yield for each rule `axis` its kind, a policy that fixes the line, its joint and its end."""
    if n_joints and policy.base is BaseRule.AXIS:
        yield Kind.BASE, _BASE_LINE, 1, 0
    if n_joints and policy.tool is ToolRule.AXIS:
        yield Kind.TOOL, _TOOL_LINE, n_joints, n_joints + 1


def _is_beyond(
    ways: Collection[Invariants],
    reference: Reference,
    table: NumericTable,
    steps: Mapping[Place, float],
    line: Policy,
    share: float,
) -> bool:
    """Whether an answer has a line in none of some ways, within its digits."""
    # without steps first: most lines lie where they should, and this is what edits are asked
    return all(
        all(not_explained(way, reference, table, typed, line, share) for way in ways)
        for typed in (NOTHING_TYPED, steps)
    )


def lines_at_ends(policy: Policy, missed: Collection[Kind]) -> Policy:
    """Return a policy that fixes the key's lines at the ends where an answer keeps no rule `axis`.

    Args:
        policy: what the answer is held to.
        missed: the rules that it doesn't keep.
    """
    base = BaseRule.FRAME if Kind.BASE in missed else policy.base
    return replace(policy, base=base, tool=ToolRule.FRAME if Kind.TOOL in missed else policy.tool)


def is_off_its_joint(reference: Reference, kind: Kind) -> bool:
    """Return whether the key's line at an end lies elsewhere than on the axis of the joint there.

    Args:
        reference: the key.
        kind: BASE or TOOL.
    """
    n = len(reference.chain.axes)
    line, joint, end = (_BASE_LINE, 1, 0) if kind is Kind.BASE else (_TOOL_LINE, n, n + 1)
    way = _on_the_joint(reference, joint, end)
    return not_explained(way, reference, reference.table, NOTHING_TYPED, line, 0.0) is not None


def end_invariants(known: Invariants, n_joints: int, missed: Collection[Kind]) -> Invariants:
    """Return those of a key's invariants, its frames being fixed, that say where its lines at the ends lie.

    Args:
        known: all of them.
        n_joints: how many joints the key has.
        missed: at which ends: BASE, TOOL.
    """
    ends = [end for kind, end in ((Kind.BASE, 0), (Kind.TOOL, n_joints + 1)) if kind in missed]
    return known.some([i for end in ends for i in _of_the_line(known, end)])


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
    return invariants.some(_of_the_line(invariants, end))


def _of_the_line(invariants: Invariants, end: int) -> list[int]:
    return [i for i, shape in enumerate(invariants.shapes) if end in shape.axes and end not in shape.runs]
