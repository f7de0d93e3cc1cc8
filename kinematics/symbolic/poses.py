"""Rigid motions with entries in the ring."""

from collections.abc import Sequence
from dataclasses import dataclass

from kinematics.dh import MotionKind
from kinematics.expressions import Expression
from kinematics.symbolic.elements import ONE_FORM, ZERO_FORM, Form
from kinematics.symbolic.form_reader import FormReader
from kinematics.symbolic.motions import Motion
from kinematics.symbolic.surds import tidy

_SHORT = 4  # Terms up to which an entry is left as it is: so few cannot hide much that cancels.
_IDENTITY = tuple(tuple(ONE_FORM if i == j else ZERO_FORM for j in range(4)) for i in range(3))


def read_matrix(reader: FormReader, matrix: Sequence[Sequence[Expression]] | None) -> list[list[Form]]:
    """Return the upper three rows of a 4×4 matrix as forms; those of the identity if there is none."""
    if matrix is None:
        return [list(row) for row in _IDENTITY]
    return [[reader.form(entry) for entry in row] for row in matrix[:3]]


@dataclass(slots=True)
class ExactPose:
    """A pose X that follows a chain: its upper three rows, the last being 0 0 0 1."""

    reader: FormReader
    m: list[list[Form]]

    def then(self, motion: Motion) -> None:
        """Replace X by X · motion."""
        ring = self.reader.ring
        if motion.kind in (MotionKind.SHIFT_X, MotionKind.SHIFT_Z):
            amount = self.reader.form(motion.amount)
            for row in self.m:
                along = row[0 if motion.kind is MotionKind.SHIFT_X else 2]
                row[3] = ring.add(row[3], ring.multiply(amount, along))
            return
        i, j = (0, 1) if motion.kind is MotionKind.TURN_Z else (1, 2)
        circle = self.reader.cosine_and_sine(motion.amount)
        for row in self.m:
            row[i], row[j] = self._mixed(circle, row[i], row[j])

    def undo(self, motion: Motion) -> None:
        """Replace X by motion^(-1) · X."""
        ring = self.reader.ring
        if motion.kind in (MotionKind.SHIFT_X, MotionKind.SHIFT_Z):
            row = self.m[0 if motion.kind is MotionKind.SHIFT_X else 2]
            row[3] = ring.add(row[3], self.reader.form(motion.amount), -1)
            return
        i, j = (0, 1) if motion.kind is MotionKind.TURN_Z else (1, 2)
        circle = self.reader.cosine_and_sine(motion.amount)
        upper, lower = self.m[i], self.m[j]
        for k in range(4):
            upper[k], lower[k] = self._mixed(circle, upper[k], lower[k])

    def tidy(self) -> None:
        """Write the longer entries in their normal form, lest what cancels pile up."""
        ring = self.reader.ring
        for row in self.m:
            row[:] = [tidy(ring, entry) if len(entry.coefficients) > _SHORT else entry for entry in row]

    def carries(self, kind: MotionKind, sign: int) -> bool:
        """Return whether X takes the joint's axis, or its direction if it slides, onto sign · z."""
        m, ring = self.m, self.reader.ring
        vanishing = [m[0][2], m[1][2]]
        if kind is MotionKind.TURN_Z:
            vanishing += [m[2][0], m[2][1], m[0][3], m[1][3]]
            vanishing += [ring.add(m[0][0], m[1][1], -sign), ring.add(m[0][1], m[1][0], sign)]
        else:
            vanishing.append(ring.add(m[2][2], ring.rational(sign), -1))
        return all(map(self.reader.vanishes, vanishing))

    def multiply(self, right: list[list[Form]]) -> None:
        """Replace X by X · right."""
        ring = self.reader.ring
        for row in self.m:
            product = []
            for j in range(4):
                entry = row[3] if j == 3 else ZERO_FORM
                for k in range(3):
                    entry = ring.add(entry, ring.multiply(row[k], right[k][j]))
                product.append(entry)
            row[:] = product

    def ends_with(self, tool: list[list[Form]]) -> bool:
        """Return whether X · tool is the identity."""
        ring = self.reader.ring
        self.multiply(tool)
        differences = (
            ring.add(entry, _IDENTITY[i][j], -1)
            for i, row in enumerate(self.m)
            for j, entry in enumerate(row)
        )
        return all(map(self.reader.vanishes, differences))

    def _mixed(self, circle: tuple[Form, Form], u: Form, v: Form) -> tuple[Form, Form]:
        ring, (c, s) = self.reader.ring, circle
        return (
            ring.add(ring.multiply(c, u), ring.multiply(s, v)),
            ring.add(ring.multiply(c, v), ring.multiply(s, u), -1),
        )
