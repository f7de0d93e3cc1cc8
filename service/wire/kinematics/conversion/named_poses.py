"""Base and tool with names in them, as the answers of /convert have them where a length has no value.

They are read cell by cell. Where the request gives values they become numbers like any other pose; otherwise
they stay expressions, and one that is a motion along and about x goes back into the row that it came from.
"""

from collections.abc import Mapping, Sequence
from contextlib import suppress
from dataclasses import replace
from fractions import Fraction
from itertools import chain

import numpy as np

from kinematics.cells import Limits, ParameterKind, ReadTable, parameter_values
from kinematics.conversion import XScrew
from kinematics.errors import DescriptionError, Fault, ParameterError
from kinematics.expressions import (
    ONE,
    ZERO,
    Call,
    Expression,
    Function,
    call,
    evaluate,
    joint_variables_in,
    negate,
    parameters_in,
    pi_times,
)
from kinematics.scm.product_reading import read_products
from kinematics.se3 import Transform, check_transform
from kinematics.symbolic import Matrix
from service.http.problems import located, moved
from service.schemas.kinematics.conversion import ConvertRequest, has_names

_ROUNDING = 1e-15  # What a double leaves of the sine and cosine of a multiple of 15°.


def with_names(
    read: ReadTable, request: ConvertRequest, limits: Limits
) -> tuple[ReadTable, dict[str, Matrix]]:
    """Return a table that also has the parameters of base and tool, and those poses that hold names.

    Raises:
        DescriptionError: a cell that cannot be read, a joint variable, or a name that is both a length and an
            angle, each at its place.
        PoseError: a pose that is no rigid motion, whatever its names stand for.
    """
    poses: dict[str, Matrix] = {}
    kinds = dict(read.parameters)
    for where, pose in (("base", request.base), ("tool", request.tool)):
        if not has_names(pose):
            continue
        poses[where], found = _read(pose, read, limits, where)
        for name, kind in found.items():
            if kinds.setdefault(name, kind) is not kind:
                raise DescriptionError(Fault.at("scm_parameter_two_kinds", where, name=name))
    return (replace(read, parameters=kinds), poses) if poses else (read, poses)


def in_numbers(pose: Matrix, read: ReadTable, parameters: Mapping[str, float], where: str) -> Transform:
    """Return a pose of which every name has a value.

    Raises:
        ParameterError: the values do not fit, or an entry does not exist there.
        PoseError: no rigid motion, with these values.
    """
    return _rigid(pose, parameter_values(read.parameters, read.angle_unit, parameters), where)


def x_screw(pose: Matrix | None) -> XScrew[Expression] | None:
    """Return a pose as a motion along and about x, if it is written as one."""
    if pose is None:
        return None
    twist = _twist(pose[1][1], pose[2][1])
    if twist is None:
        return None
    found = XScrew(a=pose[0][3], alpha=twist)
    pairs = zip(chain(*pose), chain(*x_screw_entries(found)), strict=True)
    return found if all(_same(one, other) for one, other in pairs) else None


def x_screw_entries(screw: XScrew[Expression]) -> Matrix:
    """Return Trans_x(a) Rot_x(alpha), written with its parameters."""
    cosine, sine = call(Function.COS, screw.alpha), call(Function.SIN, screw.alpha)
    return (
        (ONE, ZERO, ZERO, screw.a),
        (ZERO, cosine, negate(sine), ZERO),
        (ZERO, sine, cosine, ZERO),
        (ZERO, ZERO, ZERO, ONE),
    )


def _read(
    cells: Sequence[Sequence[float | str]], read: ReadTable, limits: Limits, where: str
) -> tuple[Matrix, Mapping[str, ParameterKind]]:
    with moved(lambda fault: replace(fault, where=(where, *fault.where[3:]))):
        found = read_products([[cells]], read.angle_unit, read.length_unit, limits)
    pose = found.products[0][0]
    assert isinstance(pose, tuple)
    for i, row in enumerate(pose):
        for j, entry in enumerate(row):
            for index in joint_variables_in(entry):
                raise DescriptionError(Fault.at("scm_variable_outside_joints", where, i, j, name=f"q{index}"))
    with suppress(ParameterError):  # a root or a quotient that exists at other values than these
        _rigid(pose, {name: 0.37 + 0.61 * i for i, name in enumerate(found.parameters)}, where)
    return pose, found.parameters


def _rigid(pose: Matrix, values: Mapping[str, float], where: str) -> Transform:
    numbers = np.eye(4)
    for i, j in np.ndindex(4, 4):
        with located(where, i, j):
            numbers[i, j] = evaluate(pose[i][j], values)
    return check_transform(numbers, where=(where,))


def _twist(cosine: Expression, sine: Expression) -> Expression | None:
    """The angle of a cosine and a sine, if it is written there or a multiple of 15°."""
    if isinstance(cosine, Call) and cosine.function is Function.COS:
        return cosine.arguments[0]
    if parameters_in(cosine) or parameters_in(sine):
        return None
    for k in range(-11, 13):
        angle = pi_times(Fraction(k, 12))
        if _same(call(Function.COS, angle), cosine) and _same(call(Function.SIN, angle), sine):
            return angle
    return None


def _same(one: Expression, other: Expression) -> bool:
    if parameters_in(one) or parameters_in(other):
        return one == other
    return abs(evaluate(one) - evaluate(other)) <= _ROUNDING
