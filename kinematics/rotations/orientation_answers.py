"""Does an answer mean a given orientation, in whatever notation it is written?

An answer is right when the rotation that it denotes is the expected one, R(answer) = R, to within a
tolerance: a matrix entry by entry, anything else by the angle of Rᵀ R(answer). So q and −q are the same, and
so are (k, θ), (−k, −θ) and θ + 2π, and the two triples of a sequence of angles, each up to full turns. Where
every triple is asked, both are needed, and of a locked rotation the relation that describes its family.

A wrong answer is compared with what the usual slips would have made of the expected one.
"""

import math
from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace

from kinematics.poses import transform_from_axis_angle, transform_from_quaternion
from kinematics.rotations.matrices import (
    IDENTITY,
    Matrix3,
    Triple,
    angle_between,
    product,
    rotation_part,
    transposed,
)
from kinematics.rotations.orientation_verdicts import (
    RIGHT,
    Built,
    ComponentOrder,
    OrientationVerdict,
    RotationMistake,
)
from kinematics.rotations.properties import failed_properties
from kinematics.rotations.sequences import Combination, EulerSequence, GimbalFamily, Turning, euler_solutions

USUAL_TOLERANCE = 0.005
"""[rad] what three decimals of a matrix or a quaternion, and a tenth of a degree, stay within."""


def judge_matrix(
    expected: Matrix3, given: Matrix3, tolerance: float = USUAL_TOLERANCE, built: Built | None = None
) -> OrientationVerdict:
    """Judge a matrix, entry by entry.

    Args:
        given: what was answered; any finite numbers.
        tolerance: largest error of an entry.
        built: how the rotation was described, to recognise slips.
    """
    if _same(expected, given, tolerance):
        return RIGHT
    if any(_is_rounded(expected, given, decimals) for decimals in (1, 2)):
        return _wrong(RotationMistake.ROUNDED)
    failed = failed_properties(given, 3.0 * tolerance)
    if failed:
        return _wrong(*(RotationMistake(found.value) for found in failed))

    def looks_like(other: Matrix3) -> bool:
        return _same(other, given, tolerance)

    return _wrong(*_slips(expected, looks_like, built))


def _is_rounded(expected: Matrix3, given: Matrix3, decimals: int) -> bool:
    """Whether every entry is that of the rotation with so many decimals."""
    typed = all(entry == round(entry, decimals) for row in given for entry in row)
    return typed and _same(expected, given, 0.501 * 10.0**-decimals)


def judge_quaternion(
    expected: Matrix3,
    given: Sequence[float],
    order: ComponentOrder = ComponentOrder.SCALAR_FIRST,
    tolerance: float = USUAL_TOLERANCE,
    built: Built | None = None,
) -> OrientationVerdict:
    """Judge a unit quaternion; q and −q are the same rotation.

    Args:
        given: four finite numbers.
        order: where the scalar stands in them.
        tolerance: largest angle from the expected rotation [rad], and error of the length.
        built: how the rotation was described, to recognise slips.
    """
    if abs(math.hypot(*given) - 1.0) > tolerance:
        return _wrong(RotationMistake.NOT_UNIT)
    found = _of_quaternion(given, order)
    if angle_between(expected, found) <= tolerance:
        return RIGHT
    other = (
        ComponentOrder.SCALAR_LAST if order is ComponentOrder.SCALAR_FIRST else ComponentOrder.SCALAR_FIRST
    )
    if angle_between(expected, _of_quaternion(given, other)) <= tolerance:
        return _wrong(RotationMistake.COMPONENT_ORDER)
    if angle_between(product(expected, expected), found) <= tolerance:
        return _wrong(RotationMistake.HALF_ANGLE)
    return _wrong(*_slips(expected, _near(found, tolerance), built))


def judge_axis_angle(
    expected: Matrix3,
    axis: Sequence[float],
    angle: float,
    tolerance: float = USUAL_TOLERANCE,
    built: Built | None = None,
) -> OrientationVerdict:
    """Judge an axis and an angle; (k, θ), (−k, −θ) and θ + 2π are the same rotation.

    Args:
        axis: three finite numbers; any length but zero, unless the angle is a full turn.
        angle: [rad].
        tolerance: largest angle from the expected rotation [rad].
        built: how the rotation was described, to recognise slips.
    """
    if not any(axis):
        nothing = abs(math.remainder(angle, math.tau)) <= tolerance
        same = nothing and angle_between(expected, IDENTITY) <= tolerance
        return RIGHT if same else _wrong(RotationMistake.NO_AXIS)
    found = _of_axis(axis, angle)
    if angle_between(expected, found) <= tolerance:
        return RIGHT
    for turned in (_in_degrees(angle), math.radians(angle)):
        if angle_between(expected, _of_axis(axis, turned)) <= tolerance:
            return _wrong(RotationMistake.DEGREES)
    return _wrong(*_slips(expected, _near(found, tolerance), built))


def judge_triples(
    expected: Matrix3,
    sequence: EulerSequence,
    given: Sequence[Sequence[float]],
    *,
    every: bool = False,
    tolerance: float = USUAL_TOLERANCE,
) -> OrientationVerdict:
    """Judge triples of angles; each counts up to full turns.

    Args:
        given: triples (first, middle, last) [rad]; at least one.
        every: all triples are asked, not one: both, or of a locked rotation its family (`judge_family`).
        tolerance: largest angle from the expected rotation [rad].
    """
    wrong = [triple for triple in given if angle_between(expected, sequence.matrix(triple)) > tolerance]
    if wrong:
        found = _triple_slips(expected, sequence, wrong[0], tolerance)
        share = 0.0 if len(wrong) == len(given) else 0.5
        return OrientationVerdict(right=False, share=share, mistakes=tuple(found))
    if not every:
        return RIGHT
    solutions = euler_solutions(expected, sequence)
    if solutions.family is not None:
        return OrientationVerdict(right=False, share=0.5, mistakes=(RotationMistake.FAMILY_MISSING,))
    if len({_nearer(triple, solutions.triples) for triple in given}) == len(solutions.triples):
        return RIGHT
    twice = RotationMistake.SOLUTION_TWICE if len(given) > 1 else RotationMistake.SOLUTION_MISSING
    return OrientationVerdict(right=False, share=0.5, mistakes=(twice,))


def judge_family(
    expected: Matrix3, sequence: EulerSequence, given: GimbalFamily, tolerance: float = USUAL_TOLERANCE
) -> OrientationVerdict:
    """Judge the relation that describes all triples of a locked rotation.

    The sum for the difference, or the reverse, earns half: the middle angle and the value are right.
    """
    if _is_family(expected, sequence, given, tolerance):
        return RIGHT
    found = tuple(_family_slips(expected, sequence, given, tolerance))
    share = 0.5 if found == (RotationMistake.COMBINATION,) else 0.0
    return OrientationVerdict(right=False, share=share, mistakes=found)


def _is_family(expected: Matrix3, sequence: EulerSequence, given: GimbalFamily, tolerance: float) -> bool:
    """Return whether a relation holds for every triple of a rotation.

    One member more than another decides: with three members a third of a turn apart, all of which make the
    rotation, first ± last is constant on it and β is right.
    """
    firsts = (0.0, math.tau / 3, 2 * math.tau / 3)
    members = [(first, given.middle, given.last(first)) for first in firsts]
    return all(angle_between(expected, sequence.matrix(member)) <= tolerance for member in members)


def _wrong(*mistakes: RotationMistake) -> OrientationVerdict:
    return OrientationVerdict(right=False, share=0.0, mistakes=mistakes)


def _same(first: Matrix3, second: Matrix3, tolerance: float) -> bool:
    pairs = zip(first, second, strict=True)
    return all(abs(a - b) <= tolerance for row, other in pairs for a, b in zip(row, other, strict=True))


def _near(found: Matrix3, tolerance: float) -> Callable[[Matrix3], bool]:
    return lambda other: angle_between(other, found) <= tolerance


def _slips(
    expected: Matrix3, looks_like: Callable[[Matrix3], bool], built: Built | None
) -> Iterator[RotationMistake]:
    """Yield the slip that makes the answered rotation of the expected one, if there is one."""
    if looks_like(transposed(expected)):
        yield RotationMistake.TRANSPOSED
        return
    if built is None:
        return
    sequence, angles = built.sequence, built.angles
    backwards = EulerSequence(axes=sequence.axes, turning=_other(sequence.turning))
    if looks_like(backwards.matrix(angles)):
        yield RotationMistake.ORDER_REVERSED
    elif looks_like(sequence.matrix([-angle for angle in angles])):
        yield RotationMistake.HANDEDNESS
    elif looks_like(sequence.matrix([_in_degrees(angle) for angle in angles])):
        yield RotationMistake.DEGREES


def _triple_slips(
    expected: Matrix3, sequence: EulerSequence, triple: Sequence[float], tolerance: float
) -> Iterator[RotationMistake]:
    def makes(matrix: Matrix3) -> bool:
        return angle_between(expected, matrix) <= tolerance

    backwards = EulerSequence(axes=sequence.axes, turning=_other(sequence.turning))
    first, middle, last = triple
    halves = [
        (first + i * math.pi, second, last + k * math.pi)
        for i in (0, 1)
        for second in (middle, -middle, math.pi - middle, math.pi + middle)
        for k in (0, 1)
    ]
    if makes(backwards.matrix(triple)):
        yield RotationMistake.ORDER_REVERSED
    elif makes(transposed(sequence.matrix(triple))):
        yield RotationMistake.TRANSPOSED
    elif makes(sequence.matrix([-angle for angle in triple])):
        yield RotationMistake.HANDEDNESS
    elif any(makes(sequence.matrix([unit(a) for a in triple])) for unit in (_in_degrees, math.radians)):
        yield RotationMistake.DEGREES
    elif any(makes(sequence.matrix([*triple[:i], -triple[i], *triple[i + 1 :]])) for i in range(3)):
        yield RotationMistake.ANGLE_SIGN
    elif any(makes(sequence.matrix(turned)) for turned in halves):
        yield RotationMistake.QUADRANT


def _family_slips(
    expected: Matrix3, sequence: EulerSequence, given: GimbalFamily, tolerance: float
) -> Iterator[RotationMistake]:
    """Yield the slip that makes the relation of the right one, if there is one."""
    if euler_solutions(expected, sequence).family is None:
        yield RotationMistake.NOT_LOCKED
        return
    (other,) = set(Combination) - {given.combination}
    mirrored = (replace(given, middle=-given.middle), replace(given, value=-given.value))
    units = (
        replace(given, middle=unit(given.middle), value=unit(given.value))
        for unit in (_in_degrees, math.radians)
    )
    if _is_family(expected, sequence, replace(given, combination=other), tolerance):
        yield RotationMistake.COMBINATION
    elif _is_family(transposed(expected), sequence, given, tolerance):
        yield RotationMistake.TRANSPOSED
    elif _is_family(expected, sequence, replace(given, middle=-given.middle, value=-given.value), tolerance):
        yield RotationMistake.HANDEDNESS
    elif any(_is_family(expected, sequence, changed, tolerance) for changed in mirrored):
        yield RotationMistake.ANGLE_SIGN
    elif any(_is_family(expected, sequence, changed, tolerance) for changed in units):
        yield RotationMistake.DEGREES


def _in_degrees(angle: float) -> float:
    """Return an angle [rad] in degrees; one too large for that as it is."""
    turned = math.degrees(angle)
    return turned if math.isfinite(turned) else angle


def _nearer(triple: Sequence[float], solutions: Sequence[Triple]) -> int:
    """Return which solution a triple is: the one whose middle angle is nearer on the circle."""
    apart = [abs(math.remainder(triple[1] - solution[1], math.tau)) for solution in solutions]
    return apart.index(min(apart))


def _other(turning: Turning) -> Turning:
    return Turning.FIXED if turning is Turning.CURRENT else Turning.CURRENT


def _of_quaternion(given: Sequence[float], order: ComponentOrder) -> Matrix3:
    w, x, y, z = given if order is ComponentOrder.SCALAR_FIRST else (given[3], *given[:3])
    return rotation_part(transform_from_quaternion((w, x, y, z)))


def _of_axis(axis: Sequence[float], angle: float) -> Matrix3:
    return rotation_part(transform_from_axis_angle(axis, angle))
