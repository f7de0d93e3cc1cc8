"""All solutions of six revolute joints without any special geometry, as an eigenproblem.

Seen from joint 3, axis 6 is a point p and a direction l, reached from either end of the chain:

    E_3 E_4 E_5 · axis 6 = E_2⁻¹ E_1⁻¹ T' · axis 6.

Of p, l, p·p, p·l, p × l and (p·p) l - 2 (p·l) p every entry is linear in the cosine and sine of every
angle: fourteen equations. The eight products of the angles on the right are eliminated linearly; what
remains are six equations in q_3, q_4, q_5, twelve with their multiples by x_4 = tan(q_4/2), in the twelve
monomials x_4^a x_5^b, a ≤ 3, b ≤ 2. Their matrix is quadratic in x_3 and singular at the solutions: a linear
eigenproblem of size 24, of which at most 16 eigenvalues are solutions. The coefficients are not derived but
interpolated: what is linear in the cosine and sine of an angle is known from its values at three angles.

Source: M. Raghavan, B. Roth, Inverse kinematics of the general 6R manipulator and related linkages, J. Mech.
Design 115 (1993) 502; D. Manocha, J. F. Canny, Efficient inverse kinematics for general 6R manipulators,
IEEE Trans. Robotics 10 (1994) 648, for the eigenproblem.
"""

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from kinematics.inverse.arm import Arm, Array
from kinematics.inverse.methods.trigonometric import rotations
from kinematics.se3 import cross_arrays, inverse_transform

NEARLY_REAL = 0.05
"""Imaginary part of an angle up to which it is tried: two solutions that meet leave the real line
together, and rounding makes a complex pair of two that are near each other."""

WELL_CONDITIONED = 1e9
"""Largest condition of the leading matrix with which an eigenproblem is worth its digits: Newton steps
take over from five."""

INDEPENDENT = 1e-9  # Singular values below this part of the largest are those of dependent equations.

TRUSTED = 1e-3
"""What a real eigenvalue's solution may be off. Where eigenvalues coincide, eigenvectors mix their
solutions and are off by more; another cut of the loop parts them."""

COINCIDENT = 1e-4  # Values of q_3 [rad] that differ by less may have mixed eigenvectors.

MIXED = 0.618  # Weight of x_5 beside x_4: solutions with one q_3 differ in the sum but for rare chance.

_SHIFTS = ((0.4, 1.1, -0.7), (2.3, -0.9, 1.9), (-1.6, 0.3, 0.8), (1.2, 2.6, -2.1))
"""Half turns of (q_3, q_4, q_5), where tangents of half angles are infinite, are put at these angles plus
π."""

_GRID = 2.0 * np.pi * np.arange(3) / 3.0
_WAVES = np.column_stack((np.ones(3), np.cos(_GRID), np.sin(_GRID)))
_TO_WAVES = np.linalg.inv(_WAVES)


@dataclass(frozen=True, eq=False)
class GeneralArm:
    """The eigenproblem of an arm.

    Attributes:
        arm: the arm; lengths are measured in its size.
    """

    arm: Arm

    @cached_property
    def _axes(self) -> tuple[Array, Array, Array]:
        z, p, end = self.arm.screws
        return z, p / self.arm.size, inverse_transform(end)

    @cached_property
    def _left(self) -> Array:
        z, p, _ = self._axes
        return _left_side(z, p)

    def candidates(self, target: Array) -> Array | None:
        """See `InverseClosedForm`.

        The joints and the target form a loop, which may be cut open before any joint: where axes meet or are
        parallel, cuts differ in whether the equations are independent.
        """
        z, p, end = self._axes
        moved = target @ end
        moved[:3, 3] /= self.arm.size
        found = _solutions(z, p, moved, self._left)
        back = inverse_transform(moved)
        for cut in range(6):
            if found is not None:
                return np.roll(found, cut, axis=1)
            z = np.vstack((z[1:], z[0] @ back[:3, :3].T))
            p = np.vstack((p[1:], p[0] @ back[:3, :3].T + back[:3, 3]))
            found = _solutions(z, p, moved, _left_side(z, p))
        return None


def general_arm_of(arm: Arm) -> GeneralArm | None:
    """Return the eigenproblem of an arm, or None if it is not one of six revolute joints."""
    return GeneralArm(arm) if arm.n_joints == 6 and bool(arm.revolute.all()) else None


def _left_side(z: Array, p: Array) -> Array:
    """(14, 3, 9): coefficients of the left side in (1, cos, sin) of q_3, and of q_4 times q_5."""
    turns = [np.array([_displacement(z[i], p[i], q) for q in _GRID]) for i in (2, 3, 4)]
    E = np.einsum("aij,bjk,ckl->abcil", *turns, optimize=True).reshape(27, 4, 4)
    values = _functions(E[:, :3, :3] @ p[5] + E[:, :3, 3] - p[2], E[:, :3, :3] @ z[5])
    waves = np.einsum("ai,bj,ck,ijkf->fabc", *[_TO_WAVES] * 3, values.reshape(3, 3, 3, 14), optimize=True)
    return np.asarray(waves.reshape(14, 3, 9))


def _right_side(z: Array, p: Array, moved: Array) -> Array:
    """(14, 9): coefficients of the right side in (1, cos, sin) of q_1 times that of q_2."""
    first, second = (np.array([_displacement(z[i], p[i], -q) for q in _GRID]) for i in (0, 1))
    back = (second[None] @ first[:, None]).reshape(9, 4, 4)
    R = moved[:3, :3]
    points = back[:, :3, :3] @ (R @ p[5] + moved[:3, 3]) + back[:, :3, 3] - p[2]
    values = _functions(points, back[:, :3, :3] @ (R @ z[5])).reshape(3, 3, 14)
    return np.asarray(np.einsum("ai,bj,ijf->fab", _TO_WAVES, _TO_WAVES, values).reshape(14, 9))


def _solutions(z: Array, p: Array, moved: Array, left: Array) -> Array | None:
    """Candidates for a chain of axes that is to move by `moved`; None where equations are dependent."""
    right = _right_side(z, p, moved)
    U, scales, Vt = np.linalg.svd(right[:, 1:])
    if scales[-1] <= INDEPENDENT * scales[0]:
        return None
    N = U[:, 8:].T
    waves = np.einsum("nf,fak->ank", N, left)
    waves[0, :, 0] -= N @ right[:, 0]
    found = _middle_turns(waves)
    if found is None:
        return None
    middle, real = found
    # q_1 and q_2 from the products that were eliminated, q_6 from the rotation that is left.
    products45 = np.einsum("mi,mj->mij", _waves(middle[:, 1]), _waves(middle[:, 2])).reshape(-1, 9)
    known = np.einsum("fak,ma,mk->mf", left, _waves(middle[:, 0]), products45, optimize=True)
    products = (known - right[:, 0]) @ ((U[:, :8] / scales) @ Vt)
    q = np.empty((len(middle), 6))
    q[:, 1] = np.arctan2(products[:, 1], products[:, 0])
    q[:, 0] = np.arctan2(products[:, 5], products[:, 2])
    q[:, 2:5] = middle
    rest = np.broadcast_to(moved[:3, :3], (len(q), 3, 3))
    for i in range(5):
        rest = rotations(z[i], -q[:, i]) @ rest
    across = np.linalg.svd(z[5][None])[2][1]
    turned = rest @ across
    q[:, 5] = np.arctan2(turned @ cross_arrays(z[5], across), turned @ across)
    return q if bool((_off(z, p, q[real], moved) <= TRUSTED).all()) else None


def _off(z: Array, p: Array, q: Array, moved: Array) -> Array:
    """(m,): largest entry by which E_1 ⋯ E_6 is off."""
    E = np.broadcast_to(np.eye(4), (len(q), 4, 4))
    for i in range(6):
        step = np.zeros((len(q), 4, 4))
        step[:, :3, :3], step[:, 3, 3] = rotations(z[i], q[:, i]), 1.0
        step[:, :3, 3] = p[i] - step[:, :3, :3] @ p[i]
        E = E @ step
    return np.asarray(np.abs(E - moved).max(axis=(1, 2)))


def _functions(p: Array, l: Array) -> Array:  # noqa: E741
    """(m, 14): p, l, p·p, p·l, p × l and (p·p) l - 2 (p·l) p."""
    pp, pl = (p * p).sum(axis=1)[:, None], (p * l).sum(axis=1)[:, None]
    return np.concatenate((p, l, pp, pl, cross_arrays(p, l), pp * l - 2.0 * pl * p), axis=1)


def _middle_turns(waves: Array) -> tuple[Array, NDArray[np.bool_]] | None:
    """Return q_3, q_4, q_5, (m, 3), at which six equations hold, and which are real, (m,).

    Of a complex pair its middle is tried, where two solutions have met, and both sides, where they may be if
    rounding has made the pair. None where the equations hold for every q_3, or no eigenproblem is well
    conditioned.
    """
    best = None
    for shift in _SHIFTS:
        A, B, C = _quadratic(waves, shift)
        condition = float(np.linalg.cond(A))
        if best is None or condition < best[0]:
            best = (condition, A, B, C, shift)
        if condition < 1e5:
            break
    assert best is not None
    condition, A, B, C, shift = best
    if not condition < WELL_CONDITIONED:
        return None
    companion = np.zeros((24, 24))
    companion[:12, 12:] = np.eye(12)
    companion[12:] = -np.linalg.solve(A, np.hstack((C, B)))
    x, vectors = np.linalg.eig(companion)
    with np.errstate(all="ignore"):
        off = np.abs(2.0 * x.imag / (1.0 + x * x))
    near = off <= NEARLY_REAL
    vectors, sides = _parted(x[near], vectors.T[near])
    tangents = np.empty((len(vectors), 3), dtype=np.complex128)
    for i, v in enumerate(vectors):
        x3 = _ratio(v[:12], v[12:])
        monomials = (v[12:] if abs(x3) > 1.0 else v[:12]).reshape(4, 3)
        tangents[i] = x3, _ratio(monomials[:-1], monomials[1:]), _ratio(monomials[:, :-1], monomials[:, 1:])
    middles = tangents.real[sides > 0.0]
    tried = np.concatenate((tangents.real + tangents.imag, middles))
    return 2.0 * np.arctan(tried) + shift, np.concatenate((sides == 0.0, np.zeros(len(middles), dtype=bool)))


def _parted(
    x: NDArray[np.complex128], vectors: NDArray[np.complex128]
) -> tuple[NDArray[np.complex128], Array]:
    """One vector for each solution, (m, 24), and the imaginary parts of their eigenvalues, (m,).

    Solutions with one q_3 have one eigenvalue, and their eigenvectors are any that span the same space. In it
    x_4 and x_5 are linear maps, which have the solutions' own vectors for eigenvectors.
    """
    angles = 2.0 * np.arctan(x.real)
    order = np.argsort(angles, kind="stable")
    starts = np.flatnonzero(np.diff(angles[order], prepend=-np.inf) > COINCIDENT)
    found: list[NDArray[np.complex128]] = []
    sides: list[float] = []
    for group in np.split(order, starts[1:]):
        values, members = x[group], vectors[group]
        if len(group) > 1:
            _, scales, basis = np.linalg.svd(np.vstack((members.real, members.imag)), full_matrices=False)
            basis = basis[: len(group)][scales[: len(group)] > INDEPENDENT * scales[0]]
            values, inner = np.linalg.eig(_maps(basis))
            members = inner.T @ basis
        found += [*members]
        sides += [float(value.imag) for value in values]
    return np.array(found, dtype=np.complex128).reshape(-1, 24), np.array(sides)


def _maps(basis: Array) -> Array:
    """(k, k): x_4 + MIXED x_5 as a map of a space of vectors, (k, 24), into itself."""
    monomials = basis.reshape(len(basis), 2, 4, 3)
    fourth = _map(monomials[:, :, :-1], monomials[:, :, 1:])
    return fourth + MIXED * _map(monomials[:, :, :, :-1], monomials[:, :, :, 1:])


def _map(lower: Array, upper: Array) -> Array:
    """(k, k): what takes monomials of k vectors to their multiples, by least squares."""
    k = len(lower)
    return np.asarray(np.linalg.lstsq(lower.reshape(k, -1).T, upper.reshape(k, -1).T, rcond=None)[0])


def _ratio(lower: NDArray[np.complex128], upper: NDArray[np.complex128]) -> complex:
    """The factor from monomials to their multiples, by least squares."""
    lower, upper = lower.ravel(), upper.ravel()
    return complex(np.vdot(lower, upper) / max(float(np.vdot(lower, lower).real), 1e-300))


def _quadratic(waves: Array, shift: tuple[float, float, float]) -> tuple[Array, Array, Array]:
    """A, B, C of the (12, 12) matrix A x_3² + B x_3 + C."""
    to_powers = [_powers(angle) for angle in shift]
    small = np.einsum("inj,ia->anj", waves, to_powers[0]).reshape(3, 6, 3, 3)
    small = np.einsum("anij,ik,jl->ankl", small, to_powers[1], to_powers[2])
    large = np.zeros((3, 12, 4, 3))
    large[:, :6, :3] = small
    large[:, 6:, 1:] = small
    C, B, A = large.reshape(3, 12, 12)
    return A, B, C


def _powers(shift: float) -> Array:
    """(1, cos q, sin q) times 1 + x² in the powers 1, x, x², where q = shift + 2 atan x."""
    c, s = np.cos(shift), np.sin(shift)
    return np.array(((1.0, 0.0, 1.0), (c, -2.0 * s, -c), (s, 2.0 * c, -s)))


def _waves(q: Array) -> Array:
    return np.stack((np.ones_like(q), np.cos(q), np.sin(q)), axis=-1)


def _displacement(z: Array, p: Array, q: float) -> Array:
    E = np.eye(4)
    E[:3, :3] = rotations(z, q)
    E[:3, 3] = p - E[:3, :3] @ p
    return E
