"""Edits that are seen to make a table right, or to leave it wrong: no certificate is searched for.

An arm of revolute joints is determined by the angles and the distances of neighbouring axes and the offsets
between their common normals: axis by axis, each follows from the one before but for a turn about that one,
which is the zero of a variable. Where all of them are the key's, with their signs, but for the errors of the
arithmetic, equation (1) of docs/checker.md holds. Fixed points and lines at the ends count as further axes.
"""

from collections.abc import Sequence
from itertools import pairwise
from math import sin

import numpy as np

from exercises.grading.axis_directions import least_cost
from exercises.grading.edits.changes import Change
from exercises.grading.edits.work import Work
from kinematics.caching import USUAL_ROWS, cached_by_size
from kinematics.equivalence import BaseRule, DirectionRule, Kind, Policy, ToolRule, ZeroRule
from kinematics.equivalence.decision import EXACT, convention_fits
from kinematics.equivalence.invariants import STEEPEST, Invariants, invariants_of
from kinematics.equivalence.meter import per_batch
from kinematics.equivalence.reference import Reference
from kinematics.equivalence.row_measures import EXACTLY, measured_of_tables
from kinematics.se3 import Floats, cross, norm
from kinematics.table import Convention, NumericTable

SHARE = 1.0 / 8.0
"""A share of what `EXACT` allows, by the square of the number of joints: angles add up from joint to joint,
and so do the displacements at their levers."""


def surely_right(work: Work, edits: Sequence[tuple[Sequence[Change], Floats | None]]) -> list[bool]:
    """Return of edits, one after the other, whether they are seen to make a table right at every draw.

    False says nothing.

    Args:
        work: the table.
        edits: sequences of them, each with the invariants (q,) of the table that it leads to at its draw;
            None where they are not those that the policy asks for.
    """
    draws, policy = work.draws_at_hand, work.policy
    known = _determining(tuple(work.references[draw] for draw in draws), policy)
    sure = [False] * len(edits)
    if known is None:
        return sure
    each = [
        (number, work.made_alike(changes, draws))
        for number, (changes, found) in enumerate(edits)
        if found is not None
    ]
    made = [
        (number, tables)
        for number, tables in each
        if tables and work.has_the_joints(tables[0]) and _keeps_rules(tables[0], policy)
    ]
    if not made:
        return sure
    found = np.array([edits[number][1] for number, _ in made]).T
    others = [tables[k] for k in range(1, len(draws)) for _, tables in made]
    if others:
        work.meter.charge(per_batch(len(others), len(others[0].rows), len(known.shapes)))
        variations = [(k, ()) for k in range(len(others))]
        found = np.hstack((found, measured_of_tables(known.shapes, others, variations, policy)))
    values, slacks = (one.repeat(len(made), axis=1) for one in (known.values, known.slacks))
    fits = Invariants(known.shapes, values, slacks).fits(found)
    right = fits[0].all(axis=0)
    if not right.all():
        axes = len(work.reference.chain.axes) + 2
        right = least_cost(known.shapes, axes, (~fits).astype(float)) == 0.0
    at_all = right.reshape(len(draws), len(made)).all(axis=0).tolist()
    for (number, _), is_right in zip(made, at_all, strict=True):
        sure[number] = is_right
    return sure


def rows_of_missed_ends(work: Work) -> list[frozenset[int]]:
    """Return for each rule `axis` that a table is seen not to keep the rows from the joint at that end on."""
    joints = work.table.joint_rows
    if not joints or _keeps_rules(work.table, work.policy):
        return []
    missed, first, last = work.ends_beside_joints(), joints[0], joints[-1]
    rows = {Kind.BASE: range(first + 1), Kind.TOOL: range(last, len(work.table.rows))}
    return [frozenset(rows[kind]) for kind in missed]


def surely_misses(ends: Sequence[frozenset[int]], change: Change) -> bool:
    """Return whether an edit leaves a rule broken that a table does not keep.

    Args:
        ends: the rows in which each such rule is broken.
        change: the edit.
    """
    changed = {row for row, *_ in change.cells}
    return change.table is None and any(map(changed.isdisjoint, ends))


@cached_by_size(lambda keys, policy: len(keys[0].table.rows), longest=USUAL_ROWS, most=256, few=32)
def _determining(keys: tuple[Reference, ...], policy: Policy) -> Invariants | None:
    """What determines a key at each draw, (q, draws), as far as a policy asks.

    None where that is not known to be all.
    """
    free = policy.zero is ZeroRule.FREE and policy.direction is DirectionRule.FREE
    if not free or policy.base is BaseRule.FRAME or policy.tool is ToolRule.FRAME:
        return None
    if min(policy.tolerance.length, policy.tolerance.angle) < EXACT.length or not all(map(_is_clear, keys)):
        return None
    found = [invariants_of(key, policy) for key in keys]
    if any(one.shapes != found[0].shapes for one in found):
        return None
    certain = SHARE * EXACT.length / len(keys[0].chain.axes) ** 2
    slacks = [np.where(found[0].angular, certain, certain * key.size) for key in keys]
    return Invariants(found[0].shapes, np.hstack([one.values for one in found]), np.hstack(slacks))


def _is_clear(key: Reference) -> bool:
    """Whether all joints of a key turn, about axes of which neighbours are parallel or clearly not.

    Beside flatter axes no offset is measured.
    """
    axes = key.chain.axes
    sines = (norm(cross(one.direction, other.direction)) for one, other in pairwise(axes))
    turning = bool(axes) and not any(axis.prismatic for axis in axes)
    return turning and all(sine <= EXACTLY or sine >= STEEPEST for sine in sines)


def _keeps_rules(table: NumericTable, policy: Policy) -> bool:
    """Whether a table is seen to be in a convention that a policy allows, with the lines it fixes on axes."""
    rows, joints = table.rows, table.joint_rows
    behind = table.convention is Convention.STANDARD
    before = rows[: joints[0] + (not behind)] if policy.base is BaseRule.AXIS else ()
    after = rows[joints[-1] + (not behind) :] if policy.tool is ToolRule.AXIS else ()
    return convention_fits(table.convention, policy.convention) and not any(
        row.a or abs(sin(row.alpha)) > EXACTLY for row in (*before, *after)
    )
