"""Products of motions: elementary ones, frames, and matrices of one's own, in symbols.

HRX … HTZ are placements with one entry, GEO(F) is a placement, GEO(A, B) a product of two; H2J differentiates
a product, and two products are compared as functions of whatever stands in them.

Source: seed 001 §2, eq. 2.1 to 2.5 (motions), 2.10 to 2.12 (products), 3.24 (H2J), table 1 (the toolbox).
"""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import TypeAlias

import numpy as np
from numpy.typing import NDArray

from kinematics.cells import DEFAULT, AngleUnit, Cell, LengthUnit, Limits, ParameterKind, canonical_name
from kinematics.cells.entries import cell_meaning
from kinematics.cells.meaning import Position
from kinematics.cells.refusals import CellRefusal
from kinematics.cells.substitution import substitute
from kinematics.cells.variables import variable_index
from kinematics.dh import MotionKind
from kinematics.errors import DescriptionError, Fault, FormSizeError, ParameterError
from kinematics.expressions import (
    ONE,
    ZERO,
    Expression,
    JointVariable,
    evaluate,
    joint_variables_in,
    negate,
    parameters_in,
)
from kinematics.jacobian import JacobianFrame
from kinematics.scm.chain import Entry, Placement
from kinematics.scm.differentiation import jacobian_by_differentiation
from kinematics.scm.rows import RIGHT_ANGLE
from kinematics.se3 import ORTHONORMAL_TOLERANCE
from kinematics.symbolic import Matrix, ProofStatus, compare
from kinematics.symbolic.motions import Motion
from kinematics.symbolic.runs import Runs
from kinematics.symbolic.shortening import shortened
from kinematics.symbolic.writing import MatrixWriter

RawMatrix: TypeAlias = Sequence[Sequence[Cell]]
RawFactor: TypeAlias = Mapping[str, Cell] | RawMatrix
Factor: TypeAlias = Placement | Matrix

LARGEST_VARIABLE = 64  # The number of the last joint variable that a product may hold.

_IDENTITY: Matrix = tuple(tuple(ONE if i == j else ZERO for j in range(4)) for i in range(4))


@dataclass(frozen=True, kw_only=True, slots=True)
class ReadProducts:
    """Products, understood.

    Attributes:
        products: factors of each, exact; angles in [rad], lengths in `length_unit`.
        angle_unit: the unit in which angle parameters are given.
        parameters: what each parameter measures.
        joints: kind of each joint variable that occurs, by its number: angle or length.
        named: the names of the joint variables, if they were given.
    """

    products: tuple[tuple[Factor, ...], ...]
    angle_unit: AngleUnit
    length_unit: LengthUnit
    parameters: Mapping[str, ParameterKind]
    joints: Mapping[int, ParameterKind]
    named: tuple[str, ...] = ()

    @property
    def n_joints(self) -> int:
        """The number of joint variables: as many as have names, or the largest number of one."""
        return len(self.named) or max(self.joints, default=0)

    @property
    def variables(self) -> tuple[str, ...]:
        """The names of the joint variables."""
        return self.named or tuple(f"q{k}" for k in range(1, self.n_joints + 1))


def read_products(
    raw: Sequence[Sequence[RawFactor]],
    angle_unit: AngleUnit = AngleUnit.RAD,
    length_unit: LengthUnit = LengthUnit.M,
    limits: Limits = DEFAULT,
    variables: Sequence[str] | None = None,
) -> ReadProducts:
    """Return the products that factors as handed in mean.

    q_i and θ_i are joint variables, and so are the names in `variables`; other names are parameters.

    Args:
        raw: for each product its factors: entries x, y, z, a, b, c by name, or a 4×4 of cells.
        angle_unit: unit of plain numbers where an angle stands.
        limits: how large a cell may be.
        variables: names of joint variables 1 … n, as in h2j(H, [a1 a2 d3]).

    Raises:
        DescriptionError: every fault, at ("products", i, k) and below it the entry, or row and column; at
            ("variables", i) what is no name or the name of two.
    """
    named, faults = _names(variables or ())
    numbers = {name: number for number, name in enumerate(named, start=1)}
    reader = _ProductReader(angle_unit, limits, numbers, faults, {}, {})
    products = tuple(
        tuple(reader.factor(factor, ("products", i, k)) for k, factor in enumerate(factors))
        for i, factors in enumerate(raw)
    )
    if reader.faults:
        raise DescriptionError(reader.faults)
    return ReadProducts(
        products=products,
        angle_unit=angle_unit,
        length_unit=length_unit,
        parameters=reader.kinds,
        joints=reader.joints,
        named=named,
    )


def _names(given: Sequence[str]) -> tuple[tuple[str, ...], list[Fault]]:
    """The canonical names of joint variables, and what is wrong with them."""
    names: list[str] = []
    faults = []
    for i, text in enumerate(given):
        name = canonical_name(text)
        if name is None or name in names:
            faults.append(Fault.at("variable_name_invalid", "variables", i, name=text, joint=i + 1))
        names.append(name or text)
    return tuple(names), faults


def product_of(factors: Sequence[Factor]) -> Matrix:
    """Return the product of motions as a 4×4 matrix: neighbours about and along one axis are added.

    Source: seed 001 eq. 2.4 for a placement, 2.10 to 2.12 for neighbours.
    """
    product: Matrix | None = None
    motions: list[Motion] = []
    for factor in (*factors, _IDENTITY):
        if isinstance(factor, Placement):
            motions += _motions(factor)
            continue
        writer = MatrixWriter(product)
        runs = Runs.of(writer.arena, motions).finished()
        writer.know(runs)
        product = writer.matrix(runs) if factor is _IDENTITY else writer.matrix(runs, writer.read(factor))
        motions = []
    return _IDENTITY if product is None else product


def compare_matrices(left: Matrix, right: Matrix) -> ProofStatus:
    """Return whether two matrices are the same function of their variables and parameters."""
    status = ProofStatus.PROVED
    for one, other in zip(left[:3], right[:3], strict=True):
        for a, b in zip(one, other, strict=True):
            try:
                found = compare(a, b)
            except (FormSizeError, ZeroDivisionError):
                found = ProofStatus.UNDECIDED
            if found is ProofStatus.REFUTED:
                return found
            status = found if found is ProofStatus.UNDECIDED else status
    return status


def jacobian_of_product(product: Matrix, n_joints: int, frame: JacobianFrame) -> Matrix:
    """Return J0 or Jn of any matrix of direct kinematics (H2J), each entry in the shortest form found.

    Raises:
        DescriptionError: a joint variable stands in a function of which no transform consists.

    Source: seed 001 eq. 3.19, 3.24.
    """
    try:
        J = jacobian_by_differentiation(product, n_joints, frame)
    except ValueError:
        raise DescriptionError(Fault.at("no_derivative", "products")) from None
    return shortened(J)


def check_rotations(factors: Sequence[Factor], product: int) -> None:
    """Make sure that velocities can be had of a product: the rotation parts of its matrices are rotations.

    Numbers are put in for the names, so that rounded entries pass as elsewhere. A part in parameters alone
    may be a rotation for values that satisfy conditions nobody has stated, and passes.

    Raises:
        DescriptionError: code `matrix_not_rotation`, at ("products", i, k).
    """
    faults = [
        Fault.at("matrix_not_rotation", "products", product, k)
        for k, factor in enumerate(factors)
        if not isinstance(factor, Placement) and not _may_rotate(factor)
    ]
    if faults:
        raise DescriptionError(faults)


def _may_rotate(matrix: Matrix) -> bool:
    part = tuple(row[:3] for row in matrix[:3])
    parameters, variables = names_left(part)
    if parameters and not variables:
        return True
    values = {name: 0.37 + 0.61 * i for i, name in enumerate(sorted(parameters))}
    joints = [0.83 + 0.47 * i for i in range(max(variables, default=0))]
    try:
        R = np.array([[float(evaluate(entry, values, joints)) for entry in row] for row in part])
    except ParameterError:
        return True
    return bool(np.abs(R @ R.T - np.eye(3)).max() <= ORTHONORMAL_TOLERANCE and np.linalg.det(R) > 0.0)


def names_left(matrix: Matrix) -> tuple[frozenset[str], frozenset[int]]:
    """Return the parameters and the numbers of the joint variables in a matrix."""
    entries = [entry for row in matrix for entry in row]
    return (
        frozenset().union(*map(parameters_in, entries)),
        frozenset().union(*map(joint_variables_in, entries)),
    )


def matrix_with_values(matrix: Matrix, values: Mapping[str, Expression]) -> Matrix:
    """Return a matrix with parameters replaced: S2D with some of the values.

    Raises:
        ZeroDivisionError: an entry now divides by zero.
    """
    return tuple(tuple(substitute(entry, values) for entry in row) for row in matrix)


def matrix_in_numbers(matrix: Matrix, joints: Sequence[float]) -> NDArray[np.float64]:
    """Return the (r, c) values of a matrix without parameters (S2D).

    Args:
        joints: q_1 … q_n [rad, or length units].

    Raises:
        ParameterError: an entry has no finite value there.
    """
    values = [[float(evaluate(entry, {}, joints)) for entry in row] for row in matrix]
    return np.array(values, dtype=np.float64) + 0.0


def _motions(placement: Placement) -> Iterator[Motion]:
    """Trans(x, y, z) Rot_z(A) Rot_y(B) Rot_x(C) as motions about and along x and z."""
    back = negate(RIGHT_ANGLE)
    yield Motion(MotionKind.SHIFT_X, placement.x)
    yield Motion(MotionKind.TURN_Z, RIGHT_ANGLE)
    yield Motion(MotionKind.SHIFT_X, placement.y)
    yield Motion(MotionKind.TURN_Z, back)
    yield Motion(MotionKind.SHIFT_Z, placement.z)
    yield Motion(MotionKind.TURN_Z, placement.a)
    if placement.b != ZERO:
        yield Motion(MotionKind.TURN_X, back)
        yield Motion(MotionKind.TURN_Z, placement.b)
        yield Motion(MotionKind.TURN_X, RIGHT_ANGLE)
    yield Motion(MotionKind.TURN_X, placement.c)


@dataclass(slots=True)
class _ProductReader:
    angle_unit: AngleUnit
    limits: Limits
    named: Mapping[str, int]
    faults: list[Fault]
    kinds: dict[str, ParameterKind]
    joints: dict[int, ParameterKind]

    def factor(self, raw: RawFactor, where: tuple[str | int, ...]) -> Factor:
        if isinstance(raw, Mapping):
            cells = {entry: raw.get(entry.value, 0) for entry in Entry}
            return Placement(
                **{
                    entry.value: self._cell(
                        cell, Position.ANGLE if entry.is_turn else Position.LENGTH, (*where, entry.value)
                    )
                    for entry, cell in cells.items()
                }
            )
        if len(raw) != 4 or any(len(row) != 4 for row in raw):
            self.faults.append(Fault.at("matrix_not_4x4", *where))
            return _IDENTITY
        rows = tuple(
            tuple(
                self._cell(cell, Position.LENGTH if k == 3 and i < 3 else Position.RATIO, (*where, i, k))
                for k, cell in enumerate(row)
            )
            for i, row in enumerate(raw)
        )
        if rows[3] != _IDENTITY[3]:
            self.faults.append(Fault.at("pose_bottom_row", *where, 3))
        return rows

    def _cell(self, cell: Cell, position: Position, where: tuple[str | int, ...]) -> Expression:
        def variable_of(name: str) -> Expression | None:
            index = self.named.get(name, variable_index(name))
            return None if index is None else JointVariable(index)

        try:
            meaning = cell_meaning(cell, position, self.angle_unit, self.limits, variable_of)
        except CellRefusal as refusal:
            self.faults.append(refusal.at(*where))
            return ZERO
        for name, kind in meaning.kinds.items():
            if self.kinds.setdefault(name, kind) is not kind:
                self.faults.append(Fault.at("scm_parameter_two_kinds", *where, name=name))
        kind = ParameterKind.LENGTH if position is Position.LENGTH else ParameterKind.ANGLE
        largest = len(self.named) or LARGEST_VARIABLE
        for index in joint_variables_in(meaning.expression):
            if not 1 <= index <= largest:
                self.faults.append(Fault.at("number_too_large", *where, limit=largest, bound="included"))
            self.joints.setdefault(index, kind)
        return meaning.expression
