"""From an SCM chain to a modified DH table: the toolbox's SCM2DH, exactly.

In a chain that passes `verify`, no joint turns by an offset, so at zero every frame is parallel to frame 0:
joint i's axis is a coordinate direction through a point whose coordinates are sums of the row's lengths. The
common normals are coordinate directions too, and every α and θ is a multiple of π/2, exact even when the
lengths are symbols.
"""

from dataclasses import dataclass, replace
from fractions import Fraction
from typing import TypeAlias

from kinematics.errors import DescriptionError
from kinematics.expressions import (
    ZERO,
    Expression,
    Number,
    Product,
    Sum,
    add,
    multiply,
    negate,
    number,
    pi_fraction,
    pi_times,
)
from kinematics.scm.chain import Placement, ScmChain, verify
from kinematics.scm.rows import appended, constant_row, joined, shift_rows, turn_rows
from kinematics.se3 import cross, dot, opposite, triple
from kinematics.table import Convention, DHTable, JointType, SymbolicRow, SymbolicTable

Direction: TypeAlias = tuple[int, int, int]
Point: TypeAlias = tuple[Expression, Expression, Expression]

_X: Direction = (1, 0, 0)
_Y: Direction = (0, 1, 0)
_Z: Direction = (0, 0, 1)
_ORIGIN: Point = (ZERO, ZERO, ZERO)


@dataclass(frozen=True, kw_only=True, slots=True)
class _Frame:
    """A frame parallel to the coordinate axes: origin, x and z directions."""

    origin: Point
    x: Direction
    z: Direction

    @property
    def y(self) -> Direction:
        return cross(self.z, self.x)


def modified_dh_from_scm(chain: ScmChain) -> SymbolicTable:
    """Return the modified DH table whose ⁰T_N equals the chain's, base and tool included, for every q.

    Every joint keeps its number, its sign and its zero (θ offsets are multiples of π/2). Rows that no joint
    needs (a base turned away from the first axis, two parallel axes offset in two directions, the Final
    Transformation, the tool) become fixed rows, so nothing is lost and no 4x4 remains to be carried along.

    Raises:
        DescriptionError: the chain does not pass `verify`; its faults.

    Source: seed 001 §3.1 (SCM2DH), eq. 2.14.
    """
    faults = verify(chain)
    if faults:
        raise DescriptionError(faults)
    rows: list[SymbolicRow] = []
    here = _Frame(origin=_ORIGIN, x=_X, z=_Z)
    point = _ORIGIN
    for row in chain.rows:
        if row.joint is JointType.REVOLUTE:
            point = _moved(point, row.constant)
        axis = triple(row.sign if k == row.variable.axis else 0 for k in range(3))
        there = _frame_on_axis(here, point, axis)
        *lead, link = _links(here, there)
        rows = joined(rows, lead)
        rows = appended(rows, replace(link, joint=row.joint))
        here = there
    exact = _quarter_turns(chain.final)
    x, z = (_turned(_X, exact), _turned(_Z, exact)) if exact else (_X, _Z)
    rows = joined(rows, _links(here, _Frame(origin=_moved(point, chain.final), x=x, z=z)))
    turns = [] if exact else turn_rows(chain.final)
    rows = joined(rows, [*turns, *shift_rows(chain.tool), *turn_rows(chain.tool)])
    return DHTable(convention=Convention.MODIFIED, rows=tuple(rows))


def _quarter_turns(turn: Placement) -> tuple[int, int, int] | None:
    """A, B and C in quarter turns, if all three are whole numbers of them."""
    halves = [pi_fraction(angle) for angle in (turn.a, turn.b, turn.c)]
    quarters = [2 * half for half in halves if half is not None and (2 * half).denominator == 1]
    return triple(map(int, quarters)) if len(quarters) == 3 else None


def _turned(u: Direction, quarters: tuple[int, int, int]) -> Direction:
    """Rot_z(A) Rot_y(B) Rot_x(C) u, the angles in quarter turns."""
    for axis, count in zip((_X, _Y, _Z), reversed(quarters), strict=True):
        for _ in range(count % 4):
            along = dot(u, axis)
            turned = cross(axis, u)
            u = turned[0] + along * axis[0], turned[1] + along * axis[1], turned[2] + along * axis[2]
    return u


def _frame_on_axis(here: _Frame, point: Point, z: Direction) -> _Frame:
    """A frame on the axis through `point` along `z`, its x on the common normal with the previous axis."""
    if abs(dot(here.z, z)) == 1:
        return _Frame(origin=point, x=here.x, z=z)
    x = cross(here.z, z)
    shift = add((_along(point, x), negate(_along(here.origin, x))))
    turned_back = shift == ZERO and dot(x, here.x) < 0
    return _Frame(origin=point, x=opposite(x) if turned_back or _starts_negative(shift) else x, z=z)


def _links(here: _Frame, there: _Frame) -> list[SymbolicRow]:
    """Rows whose product is the pose of `there` in `here`; all but the last may be motions along z only."""
    p = triple(add((there.origin[k], negate(here.origin[k]))) for k in range(3))
    if abs(dot(here.z, there.z)) == 1:
        return _parallel_links(here, there, p)
    normal = there.x if dot(there.x, here.z) == 0 else cross(here.z, there.z)
    return [
        constant_row(theta=_angle(here.x, normal, here.z), d=_along(p, here.z)),
        constant_row(
            a=_along(p, normal),
            alpha=_angle(here.z, there.z, normal),
            d=_along(p, there.z),
            theta=_angle(normal, there.x, there.z),
        ),
    ]


def _parallel_links(here: _Frame, there: _Frame, p: Point) -> list[SymbolicRow]:
    along_x, along_y = _along(p, here.x), _along(p, here.y)
    lead: list[SymbolicRow] = []
    normal = here.x
    length = along_x
    if along_y != ZERO:
        if along_x != ZERO:
            lead.append(constant_row(a=along_x))
        normal, length = here.y, along_y
        lead.append(constant_row(theta=pi_times(Fraction(1, 2))))
    lead = lead or [constant_row()]
    alpha = _angle(here.z, there.z, normal)
    last = constant_row(a=length, alpha=alpha, d=_along(p, there.z), theta=_angle(normal, there.x, there.z))
    return [*lead, last]


def _moved(point: Point, shift: Placement) -> Point:
    return add((point[0], shift.x)), add((point[1], shift.y)), add((point[2], shift.z))


def _along(p: Point, direction: Direction) -> Expression:
    return add(multiply((number(direction[k]), p[k])) for k in range(3))


def _angle(start: Direction, end: Direction, about: Direction) -> Expression:
    """Angle from `start` to `end` about `about`, both perpendicular to it: a multiple of π/2."""
    cosine, sine = dot(start, end), dot(cross(start, end), about)
    return pi_times(Fraction({(1, 0): 0, (0, 1): 1, (-1, 0): 2, (0, -1): -1}[(cosine, sine)], 2))


def _starts_negative(expression: Expression) -> bool:
    match expression:
        case Number(value) | Product((Number(value), *_)) | Sum((Product((Number(value), *_)), *_)):
            return value < 0
    return False
