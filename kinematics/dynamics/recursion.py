"""Dynamics in numbers: the joint forces of a motion, M(q), C(q, q̇), g(q), and the motion under joint forces.

    τ = M(q) q̈ + C(q, q̇) q̇ + g(q)

All screws and inertias are written in the coordinates of the base, about its origin, at the configuration in
question: a twist is (v, ω), a wrench (f, n), and the inertia of a body with mass m, centre c and inertia I
about it takes V to its momentum

    G = [ m 1     −m [c]×          ]
        [ m [c]×   I − m [c]× [c]× ].

Along the chain sums take the place of recursions: V_i = Σ S_j q̇_j, and what joint i carries is the sum over
the bodies beyond it. So one configuration or a batch is a handful of array operations.

Source: J. Y. S. Luh, M. W. Walker, R. P. C. Paul (1980), the recursive Newton-Euler method; R. Featherstone,
Rigid Body Dynamics Algorithms (2008), chapters 5 and 6; S. Echeandia, P. M. Wensing, J. Comput. Nonlinear
Dyn. 16 (2021), for C made of Christoffel symbols.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import ArrayLike

from kinematics.chain import Chain, chain_of_table
from kinematics.dynamics.links import NumericBody, check_links
from kinematics.errors import DescriptionError, Fault, JointValueError
from kinematics.joint_values import configurations
from kinematics.se3 import Floats, cross_arrays
from kinematics.table import NumericTable

EARTH = (0.0, 0.0, -9.81)  # Acceleration of free fall [m/s²] where z of frame 0 points up.
SINGULAR = 1e-12
"""An eigenvalue of M, as a share of the largest, below which it has no inverse: some thousand roundings."""


class MovingRobot:
    """A robot with weights.

    Args:
        table: the DH table, lengths in [m].
        links: what moves with frame 1 … N, one for each row; of a fixed row it moves with the joint before.
        gravity: (3,) acceleration of free fall in frame 0 [m/s²].

    Raises:
        DescriptionError: not one link for each row, a negative mass, or an inertia that no body has.
    """

    def __init__(
        self, table: NumericTable, links: Sequence[NumericBody], gravity: Sequence[float] = EARTH
    ) -> None:
        expected = len(table.rows)
        if len(links) != expected:
            raise DescriptionError(Fault.at("links_count", "links", expected=expected, given=len(links)))
        check_links(links)
        self.chain: Chain = chain_of_table(table)
        self.links = tuple(links)
        self.gravity = np.array(gravity, dtype=np.float64)
        self._masses = np.array([link.mass for link in links])
        self._centres = np.array([link.centre for link in links]).reshape(-1, 3)
        self._inertias = np.array([link.inertia for link in links]).reshape(-1, 3, 3)
        moving = np.array([joints for joints, _ in self.chain.links[1:]], dtype=np.intp)
        # (n, links): which links a joint moves together with the joints before it, but none after
        self._of_joint = (moving == np.arange(1, self.n_joints + 1)[:, None]).astype(np.float64)

    @property
    def n_joints(self) -> int:
        """Number of joint variables."""
        return self.chain.n_joints

    def torque(self, joints: ArrayLike, rates: ArrayLike, accelerations: ArrayLike) -> Floats:
        """Return τ = M q̈ + C q̇ + g: inverse dynamics, (n,) or (m, n) [N m, or N of a prismatic joint].

        Args:
            joints: (n,) or (m, n) joint variables [rad, or m of a prismatic joint].
            rates: q̇, of the same shape [rad/s or m/s].
            accelerations: q̈, of the same shape [rad/s² or m/s²].

        Raises:
            JointValueError: values of another number or shape, or not finite.
        """
        q, speeds, second = self._values(joints, rates, accelerations)
        return self._forces(q, speeds, second, self.gravity)

    def velocity_torque(self, joints: ArrayLike, rates: ArrayLike) -> Floats:
        """Return h = C(q, q̇) q̇, the Coriolis and centrifugal forces, (n,) or (m, n).

        Args and raises as in `torque`.
        """
        q, speeds = self._values(joints, rates)
        return self._forces(q, speeds, np.zeros_like(q), np.zeros(3))

    def gravity_torque(self, joints: ArrayLike) -> Floats:
        """Return g(q), what holds the robot still, (n,) or (m, n).

        Args and raises as in `torque`.
        """
        (q,) = self._values(joints)
        here = _Configuration(self, q)
        A = np.zeros_like(here.screws)
        A[..., :3] -= self.gravity
        return _product(here.screws, _applied(here.composites, A))

    def mass_matrix(self, joints: ArrayLike) -> Floats:
        """Return M(q), (n, n) or (m, n, n), symmetric [kg m², kg m, kg].

        Args and raises as in `torque`.
        """
        (q,) = self._values(joints)
        here = _Configuration(self, q)
        S = here.screws
        # row i, column j ≥ i: what joint j pushes with, at joint i
        upper = np.triu(S @ np.swapaxes(_applied(here.composites, S), -1, -2))
        return np.asarray(upper + np.swapaxes(np.triu(upper, 1), -1, -2))

    def coriolis_matrix(self, joints: ArrayLike, rates: ArrayLike) -> Floats:
        """Return the C(q, q̇) that is made of Christoffel symbols, (n, n) or (m, n, n): Ṁ − 2C is skew.

        Args and raises as in `torque`.
        """
        q, speeds = self._values(joints, rates)
        here = _Configuration(self, q)
        S, G = here.screws, here.inertias
        V = np.cumsum(S * speeds[..., None], axis=-2)
        rate = _motion_cross(V, S)
        momenta = _momentum_crosses(_applied(G, V))
        crosses = _motion_crosses(V)  # of forces, V ×*, it is the adjoint with its sign changed
        B = _beyond(0.5 * (momenta - np.swapaxes(crosses, -1, -2) @ G - G @ crosses), -3)
        G = here.composites
        upper = np.triu(S @ np.swapaxes(_applied(G, rate) + _applied(B, S), -1, -2))
        columns = _applied(G, S) @ np.swapaxes(rate, -1, -2)
        columns = columns + _applied(np.swapaxes(B, -1, -2), S) @ np.swapaxes(S, -1, -2)
        return np.asarray(upper + np.tril(columns, -1))

    def accelerations(self, joints: ArrayLike, rates: ArrayLike, torque: ArrayLike) -> Floats:
        """Return q̈ = M⁻¹ (τ − C q̇ − g): forward dynamics, (n,) or (m, n).

        Args and raises as in `torque`.

        Raises:
            JointValueError: M has no inverse: joints that move nothing that weighs.
        """
        q, speeds, given = self._values(joints, rates, torque)
        M = self.mass_matrix(q)
        sizes = np.linalg.eigvalsh(M)
        if q.shape[-1] and (sizes[..., 0] <= SINGULAR * sizes[..., -1]).any():
            raise JointValueError(Fault.at("mass_matrix_singular", "links"))
        rest = given - self.torque(q, speeds, np.zeros_like(q))
        return np.asarray(np.linalg.solve(M, rest[..., None])[..., 0])

    def kinetic_energy(self, joints: ArrayLike, rates: ArrayLike) -> Floats:
        """Return ½ q̇ᵀ M q̇ [J], () or (m,).

        Args and raises as in `torque`.
        """
        q, speeds = self._values(joints, rates)
        return np.asarray(0.5 * np.einsum("...i,...ij,...j", speeds, self.mass_matrix(q), speeds))

    def potential_energy(self, joints: ArrayLike) -> Floats:
        """Return −Σ m aᵀ c [J], () or (m,), zero where the centres lie level with the base.

        Args and raises as in `torque`.
        """
        (q,) = self._values(joints)
        return np.asarray(-(_Configuration(self, q).centres @ self.gravity) @ self._masses)

    def _forces(self, q: Floats, speeds: Floats, second: Floats, gravity: Floats) -> Floats:
        here = _Configuration(self, q)
        S, G = here.screws, here.inertias
        V = np.cumsum(S * speeds[..., None], axis=-2)
        A = np.cumsum(S * second[..., None] + _motion_cross(V, S) * speeds[..., None], axis=-2)
        A[..., :3] -= gravity
        return _product(S, _beyond(_applied(G, A) + _force_cross(V, _applied(G, V))))

    def _values(self, *given: ArrayLike) -> tuple[Floats, ...]:
        values = tuple(np.array(configurations(entry, self.n_joints)) for entry in given)
        for entry in values[1:]:
            if entry.shape != values[0].shape:
                raise JointValueError(Fault.at("joints_malformed", "joints"))
        return values


@dataclass
class _Configuration:
    """A robot at some joint values: screws and inertias in the base."""

    robot: MovingRobot
    joints: Floats

    @cached_property
    def screws(self) -> Floats:
        """(…, n, 6) S_i."""
        directions, points = self.robot.chain.axes_at(self.joints)
        slides = np.array([axis.prismatic for axis in self.robot.chain.axes], dtype=bool)[:, None]
        linear = np.where(slides, directions, cross_arrays(points, directions))
        return np.concatenate((linear, np.where(slides, 0.0, directions)), axis=-1)

    @cached_property
    def frames(self) -> Floats:
        """(…, N, 4, 4) the frames of the links."""
        return self.robot.chain.frames(self.joints)[..., 1:, :, :]

    @cached_property
    def centres(self) -> Floats:
        """(…, N, 3) the centres of mass."""
        turned = (self.frames[..., :3, :3] @ self.robot._centres[:, :, None])[..., 0]
        return np.asarray(turned + self.frames[..., :3, 3])

    @cached_property
    def inertias(self) -> Floats:
        """(…, n, 6, 6) G of what moves with each joint and none after it."""
        robot, R, c = self.robot, self.frames[..., :3, :3], self.centres
        m = robot._masses[:, None, None]
        across = _crosses(c)
        G = np.zeros((*c.shape[:-1], 6, 6))
        G[..., :3, :3] = m * np.eye(3)
        G[..., :3, 3:], G[..., 3:, :3] = -m * across, m * across
        G[..., 3:, 3:] = R @ robot._inertias @ np.swapaxes(R, -1, -2) - m * (across @ across)
        return np.asarray(np.einsum("jl,...lab->...jab", robot._of_joint, G))

    @cached_property
    def composites(self) -> Floats:
        """(…, n, 6, 6) G of everything beyond each joint."""
        return _beyond(self.inertias, -3)


def _beyond(parts: Floats, axis: int = -2) -> Floats:
    """Sum what belongs to a joint and to all after it, along the axis of the joints."""
    return np.flip(np.cumsum(np.flip(parts, axis), axis=axis), axis)


def _applied(matrices: Floats, vectors: Floats) -> Floats:
    return np.asarray((matrices @ vectors[..., None])[..., 0])


def _product(screws: Floats, wrenches: Floats) -> Floats:
    return np.asarray(np.einsum("...k,...k->...", screws, wrenches)) + 0.0


def _motion_cross(a: Floats, b: Floats) -> Floats:
    """Return V × V' = (ω × v' + v × ω', ω × ω')."""
    v, w, x, y = a[..., :3], a[..., 3:], b[..., :3], b[..., 3:]
    return np.concatenate((cross_arrays(w, x) + cross_arrays(v, y), cross_arrays(w, y)), axis=-1)


def _force_cross(a: Floats, b: Floats) -> Floats:
    """Return V ×* F = (ω × f, ω × n + v × f)."""
    v, w, f, n = a[..., :3], a[..., 3:], b[..., :3], b[..., 3:]
    return np.concatenate((cross_arrays(w, f), cross_arrays(w, n) + cross_arrays(v, f)), axis=-1)


def _crosses(vectors: Floats) -> Floats:
    """Return the matrices [v]× of (…, 3) vectors, (…, 3, 3)."""
    x, y, z = vectors[..., 0], vectors[..., 1], vectors[..., 2]
    o = np.zeros_like(x)
    return np.stack((o, -z, y, z, o, -x, -y, x, o), axis=-1).reshape(*vectors.shape[:-1], 3, 3)


def _blocks(a: Floats, b: Floats, c: Floats, d: Floats) -> Floats:
    return np.concatenate((np.concatenate((a, b), axis=-1), np.concatenate((c, d), axis=-1)), axis=-2)


def _motion_crosses(V: Floats) -> Floats:
    """Return the matrices of V' ↦ V × V'."""
    v, w = _crosses(V[..., :3]), _crosses(V[..., 3:])
    return _blocks(w, v, np.zeros_like(w), w)


def _momentum_crosses(F: Floats) -> Floats:
    """Return the matrices of V ↦ V ×* F."""
    f, n = _crosses(F[..., :3]), _crosses(F[..., 3:])
    return _blocks(np.zeros_like(f), -f, -f, -n)
