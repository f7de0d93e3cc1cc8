"""Robots with weights, and their dynamics by other means than the package's.

The oracle is Uicker's form of Lagrange's equations: with T_k the pose of link k from products of DH matrices
and J_k its pseudo-inertia, M_ij = Σ_k tr(∂T_k/∂q_i J_k ∂T_k/∂q_jᵀ). Derivatives are complex steps.
"""

from fractions import Fraction

import numpy as np
from hypothesis import strategies as st

from kinematics.dynamics import NumericBody, RigidBody, SymbolicBody
from kinematics.expressions import Expression, Number
from kinematics.table import Convention, JointType, NumericTable
from tests.kinematics.strategies import tables

STEP = 1e-30

# B. Armstrong, O. Khatib, J. Burdick (1986), as Corke's Robotics Toolbox for Python 1.5 gives them
PUMA_LINKS = (
    (0.0, (0.0, 0.0, 0.0), (0.0, 0.35, 0.0)),
    (17.4, (-0.3638, 0.006, 0.2275), (0.13, 0.524, 0.539)),
    (4.8, (-0.0203, -0.0141, 0.07), (0.066, 0.086, 0.0125)),
    (0.82, (0.0, 0.019, 0.0), (1.8e-3, 1.3e-3, 1.8e-3)),
    (0.34, (0.0, 0.0, 0.0), (3e-4, 4e-4, 3e-4)),
    (0.09, (0.0, 0.0, 0.032), (1.5e-4, 1.5e-4, 4e-5)),
)


def link(mass: float, centre: tuple[float, ...], moments: tuple[float, ...]) -> NumericBody:
    a, b, c = moments
    x, y, z = centre
    return RigidBody(mass=mass, centre=(x, y, z), inertia=((a, 0.0, 0.0), (0.0, b, 0.0), (0.0, 0.0, c)))


def puma_links() -> tuple[NumericBody, ...]:
    return tuple(link(*entry) for entry in PUMA_LINKS)


def exact(links: tuple[NumericBody, ...]) -> tuple[SymbolicBody, ...]:
    """Links in numbers as links in the decimals that they are printed as."""

    def number(value: float) -> Expression:
        return Number(Fraction(repr(value)))

    return tuple(
        RigidBody(
            mass=number(body.mass),
            centre=tuple(map(number, body.centre)),
            inertia=tuple(tuple(map(number, row)) for row in body.inertia),
        )
        for body in links
    )


@st.composite
def bodies(draw: st.DrawFn) -> NumericBody:
    """A body: heavy, light or none, with any axes of inertia."""
    mass = draw(st.sampled_from((0.0, 0.09, 1.0, 17.4)))
    centre = draw(st.tuples(*[st.floats(-0.5, 0.5)] * 3))
    half = np.array(draw(st.tuples(*[st.tuples(*[st.floats(-0.4, 0.4)] * 3)] * 3)))
    inertia = half @ half.T
    return RigidBody(mass=mass, centre=centre, inertia=tuple(tuple(map(float, row)) for row in inertia))


@st.composite
def robots(draw: st.DrawFn, max_rows: int = 6) -> tuple[NumericTable, tuple[NumericBody, ...]]:
    """A table of any kind, and a body for each row."""
    table = draw(tables(min_rows=1, max_rows=max_rows).filter(lambda table: table.n_joints > 0))
    return table, tuple(draw(bodies()) for _ in table.rows)


def link_poses(table: NumericTable, joints: np.ndarray) -> list[np.ndarray]:
    """⁰T_k of each row from the matrices of the two conventions as they are printed."""
    values = iter(joints)
    pose, found = np.eye(4), []
    for row in table.rows:
        theta, d = row.theta, row.d
        if row.joint is JointType.REVOLUTE:
            theta = theta + row.sign * next(values)
        elif row.joint is JointType.PRISMATIC:
            d = d + row.sign * next(values)
        ct, s, ca, sa = np.cos(theta), np.sin(theta), np.cos(row.alpha), np.sin(row.alpha)
        if table.convention is Convention.STANDARD:
            rows = [[ct, -s * ca, s * sa, row.a * ct], [s, ct * ca, -ct * sa, row.a * s], [0, sa, ca, d]]
        else:
            rows = [[ct, -s, 0, row.a], [s * ca, ct * ca, -sa, -d * sa], [s * sa, ct * sa, ca, d * ca]]
        pose = pose @ np.array([*rows, [0, 0, 0, 1]])
        found.append(pose)
    return found


def pseudo_inertia(body: NumericBody) -> np.ndarray:
    """J = Σ m (x, 1)(x, 1)ᵀ of a body, from its moments about the centre."""
    inertia, centre = np.array(body.inertia), np.array(body.centre)
    J = np.zeros((4, 4))
    J[:3, :3] = np.trace(inertia) / 2 * np.eye(3) - inertia + body.mass * np.outer(centre, centre)
    J[:3, 3] = J[3, :3] = body.mass * centre
    J[3, 3] = body.mass
    return J


def slopes(table: NumericTable, joints: np.ndarray) -> np.ndarray:
    """∂T_k/∂q_i, (n, N, 4, 4)."""
    steps = 1j * STEP * np.eye(len(joints))
    return np.array([np.imag(link_poses(table, joints + step)) / STEP for step in steps])


def mass_matrix(table: NumericTable, links: tuple[NumericBody, ...], joints: np.ndarray) -> np.ndarray:
    """M by Uicker's formula."""
    J = np.array([pseudo_inertia(body) for body in links])
    found = slopes(table, joints)
    return np.einsum("ikab,kbc,jkac->ij", found, J, found)


def gravity(
    table: NumericTable, links: tuple[NumericBody, ...], joints: np.ndarray, fall: np.ndarray
) -> np.ndarray:
    """The gradient of −Σ m aᵀ c."""
    moments = np.array([pseudo_inertia(body)[:, 3] for body in links])
    return -np.einsum("ikab,kb,a->i", slopes(table, joints)[:, :, :3], moments, fall)
