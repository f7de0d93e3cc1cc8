"""Equations of motion as an answer: are M, C and g those of the robot, as functions?

    M(q) q̈ + C(q, q̇) q̇ + g(q) = τ

M and g are unique, so each entry is right when it is the same function. C is not: every C with C q̇ = h is
right, h being the Coriolis and centrifugal forces, so rows of C q̇ are compared. Whether Ṁ − 2C is
skew-symmetric, which distinguishes some of these C, is a question of its own: C + Cᵀ = Ṁ.

Where entries are exact this is equality of canonical forms (`kinematics.symbolic.canonical`). What is not
proved, such as numbers in the place of names, is compared at configurations that are drawn from the answer:
at the robot's values, and with other values for the names that the entry itself holds.
"""

import math
import random
from collections.abc import Mapping, Sequence
from fractions import Fraction

import numpy as np

from kinematics.answers.dynamics_verdicts import (
    DynamicsMistake,
    DynamicsQuestion,
    DynamicsVerdict,
    EquationsAnswer,
    derived,
)
from kinematics.answers.entry_proofs import proved
from kinematics.answers.left_open import EXACT, left_open
from kinematics.cells.substitution import substitute
from kinematics.dynamics import RigidBody, rate_name
from kinematics.expressions import (
    ONE,
    ZERO,
    Expression,
    Number,
    Parameter,
    add,
    multiply,
    negate,
    parameters_in,
)
from kinematics.expressions.arrays import values_at
from kinematics.expressions.values import holds_decimals
from kinematics.se3 import Floats
from kinematics.symbolic import Matrix, ProofStatus

Pair = tuple[Expression, Expression]
POINTS = 8  # Configurations at which functions are compared, for each set of values.
HALF = Number(Fraction(1, 2))
TOLERANCE = 0.005  # Of an entry that is not proved, as a share of its size: two decimals and a half.


@np.errstate(all="ignore")
def judge_dynamics(
    question: DynamicsQuestion, answer: EquationsAnswer, tolerance: float = TOLERANCE
) -> DynamicsVerdict:
    """Judge equations of motion.

    Args:
        answer: with n rows and columns; its names are those of the question and of the rates.
        tolerance: of an entry that is not proved.

    Raises:
        FormSizeError: the robot's own equations are too large to be derived.
    """
    judge = _EntryJudge(question, answer, tolerance)
    found = question.equations
    mass = velocity = gravity = skew = None
    mistakes: list[DynamicsMistake] = []
    if answer.mass is not None:
        mass = judge.mass(answer.mass)
        if not all(map(all, mass)):
            mistakes += _mistakes_of_mass(judge, question, answer.mass)
    products: list[tuple[Sequence[Expression], list[Sequence[Pair]] | None]] = []
    if answer.coriolis is not None:
        products.append((_applied(answer.coriolis), list(map(_terms, answer.coriolis))))
    if answer.velocity is not None:
        products.append((answer.velocity, None))
    for given, terms in products:
        rows = judge.vector(given, _column(found.velocity), terms)
        velocity = rows if velocity is None else tuple(map(all, zip(velocity, rows, strict=True)))
        if not all(rows):
            slips = _mistakes_of_velocity(judge, question, given)
            mistakes += [slip for slip in slips if slip not in mistakes]
    if answer.coriolis is not None:
        skew = judge.skew(answer.coriolis)
    if answer.gravity is not None:
        gravity = judge.vector(answer.gravity, _column(found.gravity))
        if not all(gravity) and judge.agrees(answer.gravity, [negate(g) for g in _column(found.gravity)]):
            mistakes.append(DynamicsMistake.GRAVITY_SIGN)
    return DynamicsVerdict(
        mass=mass, velocity=velocity, skew=skew, gravity=gravity, proof=judge.proof, mistakes=tuple(mistakes)
    )


class _EntryJudge:
    """Compares functions; remembers how surely they agreed."""

    def __init__(self, question: DynamicsQuestion, answer: EquationsAnswer, tolerance: float) -> None:
        self._question, self._tolerance, self._rounded = question, tolerance, answer.rounded
        self._random = random.Random(repr(answer))  # noqa: S311 - the same answer, the same points
        self._n = question.table.n_joints
        self.proof = ProofStatus.PROVED

    def mass(self, given: Matrix) -> tuple[tuple[bool, ...], ...]:
        ours = self._question.equations.mass
        return tuple(
            tuple(self._same(given[i][j], ours[i][j], ((ours[i][i], ours[j][j]),)) for j in range(self._n))
            for i in range(self._n)
        )

    def vector(
        self,
        given: Sequence[Expression],
        ours: Sequence[Expression],
        terms: Sequence[Sequence[Pair]] | None = None,
    ) -> tuple[bool, ...]:
        """Compare entries, each the sum of its terms, if it was not typed as it stands."""
        return tuple(
            self._same(
                one,
                other,
                [(size, size) for size in ((other,) if other != ZERO else ours)],
                None if terms is None else terms[i],
            )
            for i, (one, other) in enumerate(zip(given, ours, strict=True))
        )

    def skew(self, coriolis: Matrix) -> bool:
        """Compare C + Cᵀ with Ṁ; what is said of it is no part of the proof."""
        before = self.proof
        rate = self._question.equations.mass_rate
        sizes = [(entry, entry) for row in rate for entry in row if entry != ZERO] or [(ONE, ONE)]
        found = all(
            self._same(
                add((coriolis[i][j], coriolis[j][i])),
                rate[i][j],
                sizes,
                [(coriolis[i][j], ONE), (coriolis[j][i], ONE)],
            )
            for i in range(self._n)
            for j in range(i + 1)
        )
        self.proof = before
        return found

    def agrees(self, given: Sequence[Expression], other: Sequence[Expression]) -> bool:
        """Return whether an answer is some other one than the right one."""
        before = self.proof
        found = all(self.vector(given, other)) and any(entry != ZERO for entry in other)
        self.proof = before
        return found

    def _same(
        self, given: Expression, ours: Expression, sizes: Sequence[Pair], terms: Sequence[Pair] | None = None
    ) -> bool:
        """Compare an entry; the tolerance is a share of the largest geometric mean of two sizes.

        M_ij is at most √(M_ii M_jj), and may be far less than the larger one. Names get other values of about
        one, so that none is lost beside the others: what is small for a student is not left out. An entry
        with names is off by no more than the decimals in it leave open.

        Args:
            ours: the robot's.
            sizes: pairs whose geometric means are sizes.
            terms: what was typed and its factor, for all that the entry is the sum of; itself, if left out.
        """
        if proved(((given, ours),)) is ProofStatus.PROVED:
            return True
        terms = [(given, ONE)] if terms is None else terms
        near = self._near(given, ours, sizes, {}, terms)
        names = sorted(parameters_in(given) & self._question.values.keys())
        if near and names:
            other = {name: self._random.uniform(0.5, 2.0) for name in names}
            near = self._near(given, ours, sizes, other, terms)
        if self.proof is not ProofStatus.REFUTED:
            self.proof = ProofStatus.UNDECIDED if near else ProofStatus.REFUTED
        return near

    def _near(
        self,
        given: Expression,
        ours: Expression,
        sizes: Sequence[Pair],
        other: Mapping[str, float],
        terms: Sequence[Pair],
    ) -> bool:
        values = {**self._question.values, **other}
        points: dict[str, Floats] = {name: np.full(POINTS, value) for name, value in values.items()}
        for joint in range(1, self._n + 1):
            points[rate_name(joint)] = self._drawn()
        joints = np.array([self._drawn() for _ in range(self._n)])
        size = max(
            math.sqrt(math.prod(float(np.abs(values_at(entry, points, joints)).max()) for entry in pair))
            for pair in sizes
        )
        difference = np.abs(values_at(given, points, joints) - values_at(ours, points, joints))
        tolerance = self._tolerance if holds_decimals(given) else EXACT
        moved = [
            np.abs(values_at(factor, points, joints)) * left_open(entry, self._rounded, points, joints)
            for entry, factor in terms
        ]
        return bool((difference <= np.minimum(tolerance * size, EXACT * size + sum(moved))).all())

    def _drawn(self) -> Floats:
        return np.array([self._random.uniform(-3.0, 3.0) for _ in range(POINTS)])


def _applied(coriolis: Matrix) -> tuple[Expression, ...]:
    """C q̇."""
    return tuple(add(map(multiply, _terms(row))) for row in coriolis)


def _terms(row: Sequence[Expression]) -> list[Pair]:
    """A row of C, each entry with its rate."""
    return [(entry, Parameter(rate_name(j))) for j, entry in enumerate(row, 1)]


def _column(matrix: Matrix) -> tuple[Expression, ...]:
    return tuple(row[0] for row in matrix)


def _mistakes_of_mass(judge: _EntryJudge, question: DynamicsQuestion, given: Matrix) -> list[DynamicsMistake]:
    n = len(given)
    found = []
    pairs = [(i, j) for i in range(n) for j in range(i)]
    upper, lower = ([given[i][j] for i, j in pairs], [given[j][i] for i, j in pairs])
    if upper and not judge.agrees(upper, lower) and upper != lower:
        found.append(DynamicsMistake.ASYMMETRIC)
    points = tuple(
        RigidBody(mass=link.mass, centre=link.centre, inertia=((ZERO,) * 3,) * 3) for link in question.links
    )
    bare = derived(question.table, points, question.gravity).mass
    flat = [entry for row in given for entry in row]
    if judge.agrees(flat, [entry for row in bare for entry in row]):
        found.append(DynamicsMistake.POINT_MASSES)
    return found


def _mistakes_of_velocity(
    judge: _EntryJudge, question: DynamicsQuestion, given: Sequence[Expression]
) -> list[DynamicsMistake]:
    ours = question.equations
    n = question.table.n_joints
    rates = [Parameter(rate_name(j)) for j in range(1, n + 1)]
    right = _column(ours.velocity)
    squares = []
    for i in range(n):
        only = []
        for j in range(n):
            alone = {rate_name(k + 1): ZERO for k in range(n) if k != j}
            only.append(multiply((substitute(ours.coriolis[i][j], alone), rates[j])))
        squares.append(add(only))
    once = [
        add((multiply((HALF, row)), multiply((HALF, square))))
        for row, square in zip(right, squares, strict=True)
    ]
    tried = (
        (DynamicsMistake.VELOCITY_SIGN, [negate(row) for row in right]),
        (DynamicsMistake.COUPLING_ONCE, once),
        (DynamicsMistake.MASS_RATE, list(_applied(ours.mass_rate))),
    )
    return [mistake for mistake, other in tried if judge.agrees(given, other)][:1]
