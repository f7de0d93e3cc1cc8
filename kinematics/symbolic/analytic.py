"""The analytic Jacobian in closed form: rates of three angles instead of the angular velocity.

The first angle turns about a fixed axis a of the sequence, the last about c = R e, e the last axis, for a
rotation about e leaves e where it is; the middle one about b = (a × c) / L with L = |a × c|. So

    ω = a α̇ + b β̇ + c γ̇,    β̇ = b · ω,    γ̇ = (ω - a (a · ω)) · c / L²,    α̇ = a · ω - (a · c) γ̇.

About fixed axes the first and the last change places. The other triple of the same orientation has −b for b,
and of x, y, z, three axes in their cyclic order, −b is that of the one with its middle angle within ±π/2.

Source: B. Siciliano, L. Sciavicco, L. Villani, G. Oriolo, Robotics (2009), section 3.6.
"""

from contextlib import suppress
from functools import lru_cache

from kinematics.errors import FormSizeError
from kinematics.expressions import MINUS_ONE, ONE, ZERO, Expression, Function, add, call, multiply, power
from kinematics.jacobian import JacobianFrame
from kinematics.rotations.sequences import AXES, EulerSequence, Turning
from kinematics.symbolic.canonical import same_function
from kinematics.symbolic.closed_form import Workings
from kinematics.symbolic.writing import Matrix
from kinematics.table import SymbolicTable

PRODUCTS = 2_000
"""Products of terms that are formed to find a constant; the rates of a wrist that has one need fewer."""


@lru_cache(maxsize=64)
def analytic_form(
    table: SymbolicTable, angles: EulerSequence, *, base: Matrix | None = None, tool: Matrix | None = None
) -> Matrix | None:
    """Return the Jacobian of (x, y, z) and the angles in their order, 6 × n; None if they never have rates.

    Of the two triples that make the rotation it is that of `euler_solutions`' first.

    Args:
        angles: of the tool in the world.
        base: 4×4 pose of frame 0 in the world; the identity if left out.
        tool: 4×4 pose of the tool in frame N; the identity if left out.

    Raises:
        FormSizeError: whether they do needs more products of terms than a proof may form.
    """
    workings = Workings(table, base=base, tool=tool)
    linear = workings.jacobian(JacobianFrame.BASE)
    first, last = (AXES.index(axis) for axis in (angles.axes[0], angles.axes[2]))
    if angles.turning is Turning.FIXED:
        first, last = last, first
    p, q = (first + 1) % 3, (first + 2) % 3
    before, behind = (q, p) if last == q else (p, q)
    c = [row[last] for row in workings.transform[:3]]
    squared = add((power(c[p], 2), power(c[q], 2)))
    if same_function(squared, ZERO):
        return None
    root, inverse = power(call(Function.SQRT, squared), -1), power(squared, -1)

    def rates(omega: tuple[Expression, ...]) -> tuple[Expression, Expression, Expression]:
        gamma = _product(add((_product(omega[p], c[p]), _product(omega[q], c[q]))), inverse)
        beta = add((_product(omega[behind], c[before]), _product(MINUS_ONE, omega[before], c[behind])))
        alpha = add((omega[first], _product(MINUS_ONE, gamma, c[first])))
        return _plain(alpha), _product(_plain(beta), root), _plain(gamma)

    columns = [rates(tuple(row[k] for row in linear[3:])) for k in range(table.n_joints)]
    if angles.turning is Turning.FIXED:
        columns = [(gamma, beta, alpha) for alpha, beta, gamma in columns]
    return (*linear[:3], *(tuple(column[i] for column in columns) for i in range(3)))


def _plain(entry: Expression) -> Expression:
    """Return 0, 1 or -1 where an entry is that, as it is of most wrists; else the entry."""
    for value in (ZERO, ONE, MINUS_ONE):
        with suppress(FormSizeError):
            if same_function(entry, value, limit=PRODUCTS):
                return value
    return entry


def _product(*factors: Expression) -> Expression:
    return multiply(factors)
