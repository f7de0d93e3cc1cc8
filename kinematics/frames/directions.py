"""Which way the x axes point.

Along a common normal, x points from one axis to the next. Where axes intersect, x may point either way; where
they coincide, anywhere across. The choice is the one that leaves fewest joint angles θ different from zero;
between equals the one with positive twists, from the base on.

Makers often let x point back along a normal, and write a negative length, where that spares an offset of a
joint; and some books say which of the two cross products x is. Both can be asked for.
"""

from collections.abc import Sequence
from enum import StrEnum

from kinematics.frames.axes import AxisLine
from kinematics.frames.normals import EXACT_ANGLE, CommonNormal, Relation
from kinematics.se3 import Vector, cross, dot, norm, perpendicular, scale

_HALF_TURN = 1e-3
"""An x within this of pointing back [rad] counts as turned by a half turn: above rounding, below a choice."""
_NEGATIVE_TWIST = 1e-6  # A twist below −1e-6 rad is negative; nearer to zero its sign is rounding.


_NEGATIVE_LENGTH = 1e-5  # What a negative length costs beside an angle: it is taken only where it spares one.


class LengthSigns(StrEnum):
    """Which signs lengths may have.

    POSITIVE: x points from one axis to the next. SIGNED: it may point back where that spares an offset of a
    joint; the length is then negative, as makers write it (a_2 = -0.425 m of a UR5).
    """

    POSITIVE = "positive"
    SIGNED = "signed"


class CrossProduct(StrEnum):
    """Where x points if two axes z and z' intersect, z' being the next one.

    FEWEST: where fewest joint angles are left. FORWARD: along z × z'. BACKWARD: along z' × z.

    Source: seed 002, rules for X_i (forward); seed 004 §2.3, case 1 (backward).
    """

    FEWEST = "fewest"
    FORWARD = "forward"
    BACKWARD = "backward"


def choose_directions(
    lines: Sequence[AxisLine],
    normals: Sequence[CommonNormal],
    *,
    start: Vector | None,
    end: Vector | None,
    lengths: LengthSigns = LengthSigns.POSITIVE,
    intersecting: CrossProduct = CrossProduct.FEWEST,
) -> list[Vector]:
    """Return directions x of the N+1 normals: at the given or chosen frame 0, between the axes, at frame N.

    Args:
        start: x of a given frame 0; left out, θ_1 is made zero.
        end: x of a given frame N; left out, θ_N is made zero.
        lengths: whether x may point back along a normal.
        intersecting: where x points across two intersecting axes.

    Source: seed 000 §3.2.1 and §3.2.2; seed 002 steps 4, 6 and 7.
    """
    options = [_options(normal, lengths, intersecting) for normal in normals]
    options = [() if start is None else (start,), *options, () if end is None else (end,)]
    signed = [False, *(normal.relation is not Relation.INTERSECTING for normal in normals), False]
    chosen: list[Vector | None] = list(_cheapest(options, signed))
    return _inherit(chosen, lines)


def _options(normal: CommonNormal, lengths: LengthSigns, intersecting: CrossProduct) -> tuple[Vector, ...]:
    if normal.direction is None:
        return ()
    ways = (normal.direction, scale(normal.direction, -1.0))
    if normal.relation is not Relation.INTERSECTING:
        return ways if lengths is LengthSigns.SIGNED else ways[:1]
    chosen = {CrossProduct.FORWARD: ways[:1], CrossProduct.BACKWARD: ways[1:]}
    return chosen.get(intersecting, ways)


def _cheapest(options: Sequence[tuple[Vector, ...]], signed: Sequence[bool]) -> list[Vector | None]:
    """One of the options at each place, the sum of the costs between neighbours least (Viterbi).

    Args:
        options: at each place; the second one is dearer by a trifle.
        signed: whether it is the sign of a length there, not of a twist.
    """
    costs: list[float] = [0.0]
    back: list[list[int]] = []
    places = [i for i, choices in enumerate(options) if choices]
    for at, i in enumerate(places):
        choices = options[i]
        second = _NEGATIVE_LENGTH if signed[i] else _NEGATIVE_TWIST
        if at == 0:
            costs = [second * j for j in range(len(choices))]
            back.append([0] * len(choices))
            continue
        previous = options[places[at - 1]]
        totals: list[float] = []
        sources: list[int] = []
        for j, x in enumerate(choices):
            through = [costs[m] + _angle_cost(previous[m], x) for m in range(len(previous))]
            best = min(range(len(through)), key=through.__getitem__)
            totals.append(through[best] + second * j)
            sources.append(best)
        costs = totals
        back.append(sources)
    chosen: list[Vector | None] = [None] * len(options)
    j = min(range(len(costs)), key=costs.__getitem__)
    for at in range(len(places) - 1, -1, -1):
        chosen[places[at]] = options[places[at]][j]
        j = back[at][j]
    return chosen


def _angle_cost(u: Vector, v: Vector) -> float:
    if norm(cross(u, v)) > EXACT_ANGLE:
        return 1.0
    return 0.0 if dot(u, v) > 0 else 1.0 + _HALF_TURN


def _inherit(chosen: list[Vector | None], lines: Sequence[AxisLine]) -> list[Vector]:
    known = next((x for x in chosen if x is not None), None)
    current = perpendicular(lines[0].direction) if known is None else known
    directions = []
    for x in chosen:
        current = current if x is None else x
        directions.append(current)
    return directions
