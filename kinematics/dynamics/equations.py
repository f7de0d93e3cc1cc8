"""The equations of motion in closed form: M(q) q̈ + C(q, q̇) q̇ + g(q) = τ.

M comes from the composite rigid bodies; C is made of Christoffel symbols, so that Ṁ − 2C is skew-symmetric,

    C_ij = Σ_k c_ijk q̇_k,    c_ijk = ½ (∂M_ij/∂q_k + ∂M_ik/∂q_j − ∂M_jk/∂q_i),

and g is the gradient of the potential energy U = −aᵀ Σ m c, a the acceleration of free fall.

Source: B. Siciliano, L. Sciavicco, L. Villani, G. Oriolo, Robotics (2009), eq. 7.32, 7.45 and 7.38.
"""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from itertools import combinations_with_replacement

from kinematics.dynamics.composite import composite_of
from kinematics.dynamics.fourier import FourierSeries, SeriesTable, combined
from kinematics.dynamics.links import SymbolicBody
from kinematics.expressions import Expression, Parameter, parameters_in
from kinematics.symbolic.canonical import LIMIT
from kinematics.symbolic.elements import ZERO_FORM
from kinematics.symbolic.form_reader import FormReader
from kinematics.symbolic.ring import Ring
from kinematics.symbolic.terms import Nested
from kinematics.symbolic.writing import Matrix
from kinematics.table import CELLS, SymbolicTable

_HALF = Fraction(1, 2)


def rate_name(joint: int) -> str:
    """Return the name in closed forms of the rate q̇_i: dq1 and so on."""
    return f"dq{joint}"


def reading_order(
    table: SymbolicTable, links: Sequence[SymbolicBody], gravity: Sequence[Expression]
) -> tuple[str, ...]:
    """Return the parameters as terms are written with them: masses, lengths, inertias, gravity.

    Rates come last.
    """
    cells = [link.mass for link in links]
    cells += [getattr(row, cell) for row in table.rows for cell in CELLS]
    cells += [entry for link in links for _, entry in link.entries()]
    names: dict[str, None] = {}
    for cell in (*cells, *gravity):
        names.update(dict.fromkeys(sorted(parameters_in(cell))))
    return tuple(names)


@dataclass(frozen=True, kw_only=True, slots=True)
class EquationsOfMotion:
    """M, C, C q̇ and g in closed form, in [kg, m, s, rad].

    Attributes:
        mass: n×n, M(q).
        coriolis: n×n, C(q, q̇), with the joint rates as parameters `rate_name(i)`.
        velocity: n×1, C(q, q̇) q̇.
        gravity: n×1, g(q).
    """

    mass: Matrix
    coriolis: Matrix
    velocity: Matrix
    gravity: Matrix


class Derivation:
    """What all the equations of one robot are derived from; each is formed when it is asked for.

    Attributes:
        names: the parameters in the order in which terms are written with them.

    Args:
        table: the DH table, lengths in [m].
        links: what moves with frame 1 … N, one for each row.
        gravity: a, the acceleration of free fall in frame 0 [m/s²].
        limit: products of terms that may be formed.

    Raises:
        FormSizeError: the expansion needs more products of terms than `limit`.
    """

    def __init__(
        self,
        table: SymbolicTable,
        links: Sequence[SymbolicBody],
        gravity: Sequence[Expression],
        *,
        limit: int = LIMIT,
    ) -> None:
        reader = FormReader(Ring(limit=limit), arcs_taken_apart=False)
        found = composite_of(reader, table, links)
        ring = reader.ring
        potential = ZERO_FORM
        masses = {pair: found.expanded(form) for pair, form in found.masses.items()}
        for entry, moment in zip(gravity, found.moment, strict=True):
            potential = ring.add(potential, ring.multiply(reader.form(entry), found.expanded(moment)), -1)
        self._joints = range(1, table.n_joints + 1)
        forms = [*masses.values(), potential]
        self.names = reading_order(table, links, gravity)
        self._table = SeriesTable(ring, forms, table.n_joints, self.names)
        self._arena = self._table.arena
        *series, self._potential = self._table.series
        self._masses = dict(zip(masses, series, strict=True))

    @cached_property
    def mass(self) -> Matrix:
        """M(q)."""
        written = {pair: self._arena.expression(self._table.nested(m)) for pair, m in self._masses.items()}
        return tuple(tuple(written[min(i, j), max(i, j)] for j in self._joints) for i in self._joints)

    @cached_property
    def gravity(self) -> Matrix:
        """g(q)."""
        gradient = [self._table.derivative(self._potential, joint) for joint in self._joints]
        return tuple((self._arena.expression(self._table.nested(part)),) for part in gradient)

    @cached_property
    def coriolis(self) -> Matrix:
        """C(q, q̇) from the Christoffel symbols."""
        return tuple(
            tuple(
                self._sum((self._rates[k], self._christoffel[i, min(j, k), max(j, k)]) for k in self._joints)
                for j in self._joints
            )
            for i in self._joints
        )

    @cached_property
    def velocity(self) -> Matrix:
        """C(q, q̇) q̇: centrifugal terms q̇_j² and Coriolis terms 2 q̇_j q̇_k."""
        products = {
            (j, k): self._table.total([(self._rates[j], self._rates[k])] * (1 if j == k else 2))
            for j, k in combinations_with_replacement(self._joints, 2)
        }
        return tuple(
            (self._sum((pair, self._christoffel[i, j, k]) for (j, k), pair in products.items()),)
            for i in self._joints
        )

    @cached_property
    def _christoffel(self) -> dict[tuple[int, int, int], Nested]:
        """c_ijk by (i, j, k) with j ≤ k; c_ikj is the same.

        M_ik does not depend on q_j for j ≤ i, k: there c_ijk = −c_kji.
        """
        table, joints = self._table, self._joints
        derivatives = {(*pair, k): table.derivative(m, k) for pair, m in self._masses.items() for k in joints}

        def derivative(i: int, j: int, k: int) -> FourierSeries:
            return derivatives[min(i, j), max(i, j), k]

        found: dict[tuple[int, int, int], Nested] = {}
        for i in joints:
            for j, k in combinations_with_replacement(joints, 2):
                if k < i:
                    found[i, j, k] = self._arena.negative(found[k, j, i])
                else:
                    parts = (1, derivative(i, j, k)), (1, derivative(i, k, j)), (-1, derivative(j, k, i))
                    found[i, j, k] = table.nested(combined(parts), _HALF)
        return found

    @cached_property
    def _rates(self) -> dict[int, Nested]:
        return {joint: self._arena.read(Parameter(rate_name(joint))) for joint in self._joints}

    def _sum(self, parts: Iterable[tuple[Nested, Nested]]) -> Expression:
        return self._arena.expression(self._table.total(parts))

    @cached_property
    def mass_rate(self) -> Matrix:
        """Ṁ = Σ_k ∂M/∂q_k q̇_k."""
        table = self._table
        written = {
            pair: self._sum((self._rates[k], table.nested(table.derivative(m, k))) for k in self._joints)
            for pair, m in self._masses.items()
        }
        return tuple(tuple(written[min(i, j), max(i, j)] for j in self._joints) for i in self._joints)

    def equations(self) -> EquationsOfMotion:
        """Return all of them."""
        return EquationsOfMotion(
            mass=self.mass, gravity=self.gravity, coriolis=self.coriolis, velocity=self.velocity
        )
