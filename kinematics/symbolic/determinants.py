"""Where a Jacobian loses rank: its determinant, or minors, and their irreducible factors.

The rank of the whole Jacobian depends neither on the axes nor on the point whose velocity it gives, so it is
formed in the frame that leaves fewest terms: near the wrist of an arm that has one. Rows that vanish for
all q
(motions that the arm never makes) are left out. With t_i = tan(q_i/2) the determinant becomes a polynomial
over ℚ, which SymPy factors; cos(q_i/2) is a factor besides where it vanishes at q_i = π.

Source: D. E. Whitney (1969) for the columns; K. Weierstraß for the substitution.
"""

from collections.abc import Sequence
from enum import StrEnum
from functools import lru_cache
from itertools import combinations
from math import comb
from typing import Any

from kinematics.dh import MotionKind
from kinematics.errors import Fault, FormSizeError
from kinematics.expressions import (
    Expression,
    Function,
    JointVariable,
    call,
    joint_variables_in,
    multiply,
    negate,
    number,
    power,
)
from kinematics.symbolic.canonical import Canonical, canonical_of
from kinematics.symbolic.elements import ONE_FORM, ZERO_FORM, Form
from kinematics.symbolic.form_reader import FormReader
from kinematics.symbolic.interchange import from_sympy, to_sympy
from kinematics.symbolic.motions import Motion, motions_of
from kinematics.symbolic.poses import ExactPose, read_matrix
from kinematics.symbolic.ring import Ring
from kinematics.table import JointType, SymbolicTable

PRODUCTS = 100_000
"""Products of terms for one Jacobian and its minors; arms with a wrist need a tenth of them."""
MINORS = 1_000  # Minors of one size that are looked through; an arm of seven joints has seven of the largest.
FACTORABLE = 400
"""Terms of a minor that are factored: a general arm of six joints has thousands, which take minutes."""

Columns = list[list[Form]]


class MotionRows(StrEnum):
    """Which rows of the Jacobian count.

    TWIST: all six. TRANSLATION: those of the end's velocity, of an arm that only positions its tip.
    """

    TWIST = "twist"
    TRANSLATION = "translation"


@lru_cache(maxsize=64)
def minor_factors(table: SymbolicTable, rows: MotionRows) -> tuple[tuple[Expression, ...], bool]:
    """Return the irreducible factors of a minor that does not vanish, and whether it is the only one.

    Where it is, the arm is singular just where one of the factors vanishes; where it is not, wherever it is
    singular one of them vanishes, but not the other way round.

    Returns:
        The factors in sines and cosines of half angles, those without joint variables left out.

    Raises:
        FormSizeError: the minors need more products of terms than are formed.
    """
    minor, only = largest_minor(table, rows)
    expression = minor.expression()
    if len(minor.terms) > FACTORABLE:
        return (expression,), only
    return tuple(_factors(expression, table)), only


@lru_cache(maxsize=64)
def largest_minor(table: SymbolicTable, rows: MotionRows) -> tuple[Canonical, bool]:
    """Return the first of the largest minors that do not vanish, and whether there is but one of its size.

    Raises:
        FormSizeError: as of `minor_factors`.
    """
    found = None
    motions = [motion for row in motions_of(table) for motion in row]
    before_joints = [i for i, motion in enumerate(motions) if motion.joint]
    for cut in before_joints if rows is MotionRows.TWIST else (0,):
        reader = FormReader(Ring(limit=PRODUCTS))
        columns = _columns(reader, motions, cut, rows)
        size = sum(len(form.coefficients) for column in columns for form in column)
        if found is None or size < found[0]:
            found = size, reader, columns
    if found is None:
        return Canonical(frozenset(), True), True
    _, reader, columns = found
    kept = [
        r for r in range(len(columns[0])) if any(not reader.ring.is_zero(column[r]) for column in columns)
    ]
    for rank in range(min(len(kept), len(columns)), 0, -1):
        if comb(len(columns), rank) * comb(len(kept), rank) > MINORS:
            raise FormSizeError(Fault.at("form_too_large", limit=MINORS))
        minors = [
            ([columns[c] for c in of], chosen)
            for of in combinations(range(len(columns)), rank)
            for chosen in combinations(kept, rank)
        ]
        for part, chosen in minors:
            value = _determinant(reader.ring, [[column[r] for r in chosen] for column in part])
            if not reader.ring.is_zero(value):
                return canonical_of(reader, value), len(minors) == 1
    return Canonical(frozenset(), True), True


def _columns(reader: FormReader, motions: Sequence[Motion], cut: int, rows: MotionRows) -> Columns:
    """Return the joints' twists in the frame between two motions, in the order of the joints."""
    ring, found = reader.ring, dict[int, tuple[Motion, list[Form], list[Form]]]()

    def seen(pose: ExactPose) -> tuple[list[Form], list[Form]]:
        return [row[2] for row in pose.m], [row[3] for row in pose.m]

    ahead = ExactPose(reader, read_matrix(reader, None))
    for motion in motions[cut:]:
        if motion.joint:
            found[motion.joint] = (motion, *seen(ahead))
        ahead.then(_moved(motion, inverse=False))
        ahead.tidy()
    behind = ExactPose(reader, read_matrix(reader, None))
    for motion in reversed(motions[:cut]):
        behind.then(_moved(motion, inverse=True))
        behind.tidy()
        if motion.joint:
            found[motion.joint] = (motion, *seen(behind))
    point = [ZERO_FORM] * 3 if rows is MotionRows.TWIST else [row[3] for row in ahead.m]
    columns = []
    for joint in sorted(found):
        motion, z, p = found[joint]
        slides = motion.kind is MotionKind.SHIFT_Z
        arm = [ring.add(a, b, -1) for a, b in zip(point, p, strict=True)]
        column = z if slides else _cross(ring, z, arm)
        if rows is MotionRows.TWIST:
            column = [*column, *([ZERO_FORM] * 3 if slides else z)]
        columns.append(column)
    return columns


def _moved(motion: Motion, *, inverse: bool) -> Motion:
    """Return a motion with its joint variable for an amount, or the inverse of that."""
    amount = motion.amount
    if motion.joint:
        amount = multiply((number(motion.sign), JointVariable(motion.joint)))
    return Motion(motion.kind, negate(amount) if inverse else amount)


def _cross(ring: Ring, a: list[Form], b: list[Form]) -> list[Form]:
    return [
        ring.add(
            ring.multiply(a[(i + 1) % 3], b[(i + 2) % 3]), ring.multiply(a[(i + 2) % 3], b[(i + 1) % 3]), -1
        )
        for i in range(3)
    ]


def _determinant(ring: Ring, columns: Columns) -> Form:
    """Return a determinant, developed column by column: partial[rows] is that of the columns so far."""
    partial: dict[int, Form] = {0: ONE_FORM}
    for column in columns:
        following: dict[int, Form] = {}
        for rows, value in partial.items():
            for r, entry in enumerate(column):
                if not rows >> r & 1 and entry.coefficients:
                    sign = -1 if (rows >> (r + 1)).bit_count() % 2 else 1
                    before = following.get(rows | 1 << r, ZERO_FORM)
                    following[rows | 1 << r] = ring.add(before, ring.multiply(value, entry), sign)
        partial = following
    return partial.get((1 << len(columns)) - 1, ZERO_FORM)


def _factors(minor: Expression, table: SymbolicTable) -> list[Expression]:
    import sympy as sp

    turning = [i for i, kind in enumerate(table.joint_types, 1) if kind is JointType.REVOLUTE]
    q = {i: sp.Symbol(f"q{i}") for i in turning}
    t = {i: sp.Symbol(f"_t{i}") for i in turning}
    values: dict[Any, Any] = {}
    for i in turning:
        values[sp.sin(q[i])] = 2 * t[i] / (1 + t[i] ** 2)
        values[sp.cos(q[i])] = (1 - t[i] ** 2) / (1 + t[i] ** 2)
    expanded = sp.expand_trig(to_sympy(minor))
    found: list[Expression] = []
    behind = ((i, expanded.subs({sp.sin(q[i]): 0, sp.cos(q[i]): -1})) for i in turning)
    found += [_half_cosine(i) for i, rest in behind if sp.expand(sp.expand_trig(rest)) == 0]
    _, factors = sp.factor_list(sp.numer(sp.together(expanded.subs(values))))
    for factor, _ in factors:
        back = factor
        for i in turning:
            sine, cosine = sp.sin(q[i] / 2), sp.cos(q[i] / 2)
            degree = sp.degree(factor, t[i]) if factor.has(t[i]) else 0
            back = sp.expand(back.subs(t[i], sine / cosine) * cosine**degree)
        expression = from_sympy(back)
        if joint_variables_in(expression):
            found.append(expression)
    return found


def _half_cosine(joint: int) -> Expression:
    return call(Function.COS, multiply((power(number(2), -1), JointVariable(joint))))
