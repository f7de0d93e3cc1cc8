"""Links that move as one, and the forces they ask for, carried down a chain with entries in the ring.

Walking from the tip to the base, everything beyond a joint is one rigid body: a mass m, a first moment
h = Σ m c and a moment of inertia J about the origin. A joint about or along z pushes it with the force and
the moment

    revolute   f = ẑ × h,  n = J ẑ            prismatic   f = m ẑ,  n = h × ẑ

for each unit of its acceleration; and M_ij is what of that arrives at joint i. Each elementary motion of the
table turns or shifts all of it. Turning about z multiplies

    h_x + i h_y  by e^{iφ},    J_xz + i J_yz  by e^{iφ},    (J_xx − J_yy)/2 + i J_xy  by e^{2iφ},

so a turn about a joint adds to exponents and multiplies nothing out.

Source: M. W. Walker, D. E. Orin, J. Dyn. Sys. Meas. Control 104 (1982), the composite rigid body method;
R. Featherstone, Rigid Body Dynamics Algorithms (2008), section 6.2.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from itertools import chain, combinations_with_replacement
from typing import TypeAlias

from kinematics.dh import MotionKind
from kinematics.dynamics.links import SymbolicBody
from kinematics.expressions import JointVariable, multiply, number
from kinematics.symbolic.elements import ZERO_FORM, Form, RingSymbol
from kinematics.symbolic.form_reader import FormReader
from kinematics.symbolic.motions import Motion, motions_of
from kinematics.table import SymbolicTable

Triple: TypeAlias = list[Form]
Inertia: TypeAlias = list[list[Form]]

HALF = Fraction(1, 2)
_WEIGHT = RingSymbol("power", "weight")
_OF_A_LINK = 10  # A mass, three first moments and six moments of inertia.
_TURNS = {MotionKind.TURN_Z: 2, MotionKind.SHIFT_Z: 2, MotionKind.TURN_X: 0, MotionKind.SHIFT_X: 0}
"""Which coordinate a motion turns about, or shifts along."""


@dataclass(slots=True)
class JointWrench:
    """The wrench on everything beyond a joint under unit acceleration of that joint.

    The moment n is about the origin.
    """

    force: Triple
    moment: Triple


class Composite:
    """Everything beyond a place in the chain.

    Attributes:
        mass: m.
        moment: h, the first moment about the origin.
        inertia: J, about the origin.
        wrenches: those of the joints passed, by number.
        masses: M_ij of the joints passed, by (i, j) with i ≤ j.

    Everything is linear in the mass, the first moments and the moments of inertia of each link. While they
    are carried they stand as powers of one symbol, as many as there are of them; `expanded` puts them back.
    """

    def __init__(self, reader: FormReader, n_links: int) -> None:
        self._reader = reader
        self._weights: list[Form] = []
        # the largest exponent first: it says how much room the others have
        reader.ring.symbol(_WEIGHT, Fraction(_OF_A_LINK * n_links))
        self.mass: Form = ZERO_FORM
        self.moment: Triple = [ZERO_FORM] * 3
        self.inertia: Inertia = [[ZERO_FORM] * 3 for _ in range(3)]
        self.wrenches: dict[int, JointWrench] = {}
        self.masses: dict[tuple[int, int], Form] = {}

    def add(self, link: SymbolicBody) -> None:
        """Fasten a link whose frame is here."""
        ring, form = self._reader.ring, self._reader.form
        mass = form(link.mass)
        centre = [form(entry) for entry in link.centre]
        weighted = [ring.multiply(mass, entry) for entry in centre]
        self.mass = ring.add(self.mass, self._weight(mass))
        self.moment = [ring.add(a, self._weight(b)) for a, b in zip(self.moment, weighted, strict=True)]
        square = ZERO_FORM
        for a, b in zip(weighted, centre, strict=True):
            square = ring.add(square, ring.multiply(a, b))
        for i, j in combinations_with_replacement(range(3), 2):
            entry = ring.add(form(link.inertia[i][j]), ring.multiply(weighted[i], centre[j]), -1)
            entry = self._weight(ring.add(entry, square) if i == j else entry)
            self.inertia[i][j] = self.inertia[j][i] = ring.add(self.inertia[i][j], entry)

    def pass_joint(self, motion: Motion) -> None:
        """Take joint i's row of M, and its wrench; the axis is z here."""
        ring, joint, turns = self._reader.ring, motion.joint, motion.kind is MotionKind.TURN_Z
        (hx, hy, _), zero = self.moment, ZERO_FORM
        if turns:
            wrench = JointWrench([ring.scale(hy, -1), hx, zero], [row[2] for row in self.inertia])
        else:
            wrench = JointWrench([zero, zero, self.mass], [hy, ring.scale(hx, -1), zero])
        if motion.sign < 0:
            wrench = JointWrench(
                [ring.scale(entry, -1) for entry in wrench.force],
                [ring.scale(entry, -1) for entry in wrench.moment],
            )
        self.wrenches[joint] = wrench
        for other, known in self.wrenches.items():
            arrives = known.moment[2] if turns else known.force[2]
            self.masses[joint, other] = arrives if motion.sign > 0 else ring.scale(arrives, -1)

    def pass_motion(self, motion: Motion) -> None:
        """Write everything in the frame before an elementary motion."""
        by, circle = self.read(motion)
        axis = _TURNS[motion.kind]
        if circle is None:
            self._shift(axis, by)
        else:
            self._turn(axis, circle)

    def read(self, motion: Motion) -> tuple[Form, tuple[Form, Form] | None]:
        """Return how far an elementary motion goes and, where it turns, e^(iφ) and e^(-iφ)."""
        amount = (
            multiply((number(motion.sign), JointVariable(motion.joint))) if motion.joint else motion.amount
        )
        slides = motion.kind in (MotionKind.SHIFT_X, MotionKind.SHIFT_Z)
        return self._reader.form(amount), None if slides else self._reader.exponentials(amount)

    def _turn(self, axis: int, circle: tuple[Form, Form]) -> None:
        ring = self._reader.ring
        double = ring.multiply(circle[0], circle[0]), ring.multiply(circle[1], circle[1])
        i, j = (axis + 1) % 3, (axis + 2) % 3
        vectors = [self.moment]
        for wrench in self.wrenches.values():
            vectors += (wrench.force, wrench.moment)
        for vector in vectors:
            vector[i], vector[j] = ring.turned(circle, vector[i], vector[j])
        inertia = self.inertia
        mean = ring.scale(ring.add(inertia[i][i], inertia[j][j]), HALF)
        half = ring.scale(ring.add(inertia[i][i], inertia[j][j], -1), HALF)
        half, across = ring.turned(double, half, inertia[i][j])
        inertia[i][i], inertia[j][j] = ring.add(mean, half), ring.add(mean, half, -1)
        inertia[i][j] = inertia[j][i] = across
        beside = ring.turned(circle, inertia[i][axis], inertia[j][axis])
        inertia[i][axis], inertia[j][axis] = inertia[axis][i], inertia[axis][j] = beside

    def _shift(self, axis: int, by: Form) -> None:
        if not by.coefficients:
            return
        ring, i, j = self._reader.ring, (axis + 1) % 3, (axis + 2) % 3
        inertia, moment = self.inertia, self.moment
        more = ring.add(ring.scale(moment[axis], 2), ring.multiply(self.mass, by))
        along = ring.multiply(by, more)
        for k in (i, j):
            inertia[k][k] = ring.add(inertia[k][k], along)
            beside = ring.add(inertia[k][axis], ring.multiply(by, moment[k]), -1)
            inertia[k][axis] = inertia[axis][k] = beside
        moment[axis] = ring.add(moment[axis], ring.multiply(self.mass, by))
        for wrench in self.wrenches.values():
            force, couple = wrench.force, wrench.moment
            couple[i] = ring.add(couple[i], ring.multiply(by, force[j]), -1)
            couple[j] = ring.add(couple[j], ring.multiply(by, force[i]))

    def expanded(self, form: Form) -> Form:
        """Return a form in which masses and moments are what they are in the links."""
        return self._reader.ring.replaced(form, _WEIGHT, self._weights)

    def _weight(self, form: Form) -> Form:
        """What stands for a mass or a moment of a link; numbers stand for themselves."""
        ring = self._reader.ring
        if ring.is_constant(form):
            return form
        self._weights.append(form)
        return ring.symbol(_WEIGHT, Fraction(len(self._weights)))


def composite_of(reader: FormReader, table: SymbolicTable, links: Sequence[SymbolicBody]) -> Composite:
    """Walk a chain from the tip to the base."""
    motions = motions_of(table)
    found = Composite(reader, len(links))
    # what stands in every product is read first: keys of what is read early are short
    for motion in chain.from_iterable(motions):
        found.read(motion)
    for row, link in zip(reversed(motions), reversed(links), strict=True):
        found.add(link)
        for motion in reversed(row):
            if motion.joint:
                found.pass_joint(motion)
            found.pass_motion(motion)
    return found
