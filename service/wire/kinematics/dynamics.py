"""Dynamics between the wire and the domain."""

from collections.abc import Mapping
from dataclasses import dataclass, replace
from fractions import Fraction
from typing import Any

import numpy as np

from kinematics.cells import LengthUnit, ReadTable, in_length_unit, parameter_values
from kinematics.cells.substitution import substitute, with_values
from kinematics.dynamics import Derivation, MovingRobot, RigidBody, SymbolicBody, bind_links, rate_name
from kinematics.dynamics.reading import ReadBodies, read_bodies
from kinematics.errors import DescriptionError, Fault, TableError
from kinematics.expressions import Expression, Number, evaluate, parameters_in
from kinematics.inverse.lengths import check_lengths
from kinematics.printing import Format, Purpose
from kinematics.se3 import triple
from kinematics.table import JointType, bind, table_parameters
from service.http.problems import located
from service.schemas.kinematics.dynamics_request import (
    EquationPart,
    NumericDynamicsRequest,
    SymbolicDynamicsRequest,
    WeighedRobot,
)
from service.schemas.tables import units_of
from service.settings import Settings
from service.wire.fault_pointers import traced
from service.wire.json_chunks import plain_lists
from service.wire.kinematics.exact_values import exact_values
from service.wire.kinematics.joint_values import values_in_radians
from service.wire.kinematics.prepared_robots import joint_units, listed_robot
from service.wire.kinematics.symbolic_forms import FormTask

QUICK_JOINTS = 3  # Joints up to which equations of motion take some milliseconds.


@dataclass(frozen=True, kw_only=True, slots=True)
class WeighedTable:
    """A robot with weights, as read.

    Attributes:
        read: its table, in the request's units.
        metric: its table in [m].
        bodies: its links and gravity, in SI units.
        usual: the values of the parameters that it brings along, in the request's units.
    """

    read: ReadTable
    metric: ReadTable
    bodies: ReadBodies
    usual: Mapping[str, float]


@dataclass(frozen=True, kw_only=True, slots=True)
class DynamicsTask(FormTask[Format]):
    """Equations of motion to be derived and written; lengths in [m]."""

    links: tuple[SymbolicBody, ...]
    gravity: tuple[Expression, Expression, Expression]
    parts: tuple[EquationPart, ...]

    def is_quick(self) -> bool:
        """Return whether the answer is certain to be small."""
        return self.table.n_joints <= QUICK_JOINTS


def weighed(question: WeighedRobot, settings: Settings) -> WeighedTable:
    """Read the robot of a validated request and what it weighs.

    Raises:
        KinematicsError: the table or a link cannot be read, nothing moves, or nobody says what the links
            weigh.
    """
    links = None if question.links is None else [link.raw() for link in question.links]
    usual: Mapping[str, float] = {}
    if question.table is None:
        listed = listed_robot(str(question.robot))
        read, usual = listed.table, listed.parameters
        if links is None and listed.weights is not None:
            links = list(listed.weights.links)
    else:
        read = question.table.read(settings.cell_limits, "table")
    if read.table.n_joints == 0:
        raise TableError(Fault.at("dynamics_without_joints", "table", "rows"))
    if links is None:
        raise DescriptionError(Fault.at("links_missing", "links"))
    bodies = read_bodies(read, links, question.gravity, settings.cell_limits)
    return WeighedTable(read=read, metric=in_length_unit(read, LengthUnit.M), bodies=bodies, usual=usual)


def parameter_numbers(found: WeighedTable, given: Mapping[str, float]) -> dict[str, float]:
    """Return the values of all parameters in SI units, from those given in the request's.

    Raises:
        ParameterError: a value is missing, not needed or not a finite number.
    """
    read, bodies = found.read, found.bodies
    values = parameter_values(bodies.kinds, read.angle_unit, {**found.usual, **given})
    metres = float(read.length_unit.metres_per_unit)
    return {name: value * metres if name in bodies.lengths else value for name, value in values.items()}


@np.errstate(all="ignore")
def numeric_answer(question: NumericDynamicsRequest, settings: Settings) -> dict[str, Any]:
    """Return the dynamics at one configuration.

    Raises:
        KinematicsError: the robot cannot be read, a parameter or joint value does not fit, a link cannot be,
            or no acceleration follows from the torque.
    """
    found = weighed(question, settings)
    read, bodies = found.read, found.bodies
    values = parameter_numbers(found, question.parameters)
    metres = float(read.length_unit.metres_per_unit)
    with located("table"):
        table = bind(found.metric.table, values)
    with traced(question):
        check_lengths(table)
    links = bind_links(bodies.links, values)
    robot = MovingRobot(table, links, [evaluate(entry, values) for entry in bodies.gravity])
    angle = read.angle_unit.radians
    units = [
        unit * (metres if kind is JointType.PRISMATIC else 1.0)
        for unit, kind in zip(joint_units(table.joint_types, angle), table.joint_types, strict=True)
    ]
    q = values_in_radians(question.joints, units, "joints")
    answer: dict[str, Any] = {
        **units_of(read),
        "M": robot.mass_matrix(q),
        "g": robot.gravity_torque(q),
        "potential_energy": robot.potential_energy(q),
    }
    rates = [0.0] * robot.n_joints
    if question.rates is not None:
        rates = values_in_radians(question.rates, units, "rates")
        answer["C"] = robot.coriolis_matrix(q, rates)
        answer["h"] = robot.velocity_torque(q, rates)
        answer["kinetic_energy"] = robot.kinetic_energy(q, rates)
    if question.accelerations is not None:
        second = values_in_radians(question.accelerations, units, "accelerations")
        answer["torque"] = robot.torque(q, rates, second)
    _check_finite(answer)
    if question.torque is not None:
        drive = values_in_radians(question.torque, [1.0] * robot.n_joints, "torque")
        answer["accelerations"] = robot.accelerations(q, rates, drive)
        _check_finite(answer)
    return {
        name: value if isinstance(value, str) else plain_lists(np.asarray(value))
        for name, value in answer.items()
    }


def _check_finite(answer: Mapping[str, Any]) -> None:
    if not all(np.isfinite(value).all() for value in answer.values() if not isinstance(value, str)):
        raise DescriptionError(Fault.at("dynamics_not_finite", "links"))


def dynamics_task(question: SymbolicDynamicsRequest, settings: Settings) -> DynamicsTask:
    """Return what a validated request asks of the workers.

    Raises:
        KinematicsError: the robot cannot be read or does not move, a parameter does not fit it, or is named
            like a rate.
    """
    found = weighed(question, settings)
    read, bodies = found.read, found.bodies
    kinds = bodies.kinds
    rates = [rate_name(joint) for joint in range(1, read.table.n_joints + 1)]
    taken = [name for name in rates if name in kinds]
    if taken:
        raise DescriptionError(Fault.at("name_of_rate", "links", name=name) for name in taken)
    values = exact_values(replace(read, parameters=kinds), question.parameters)
    metres = Number(Fraction(read.length_unit.metres_per_unit))
    for name in values.keys() & bodies.lengths:
        value = values[name]
        assert isinstance(value, Number)
        values[name] = Number(value.value * metres.value)
    with located("table"):
        table = with_values(found.metric.table, values)
    links = tuple(_valued(link, values) for link in bodies.links)
    gravity = triple(substitute(entry, values) for entry in bodies.gravity)
    entries = [entry for link in links for _, entry in link.entries()]
    used = set(table_parameters(table)).union(*map(parameters_in, (*entries, *gravity)))
    return DynamicsTask(
        table=table,
        links=links,
        gravity=gravity,
        variables=read.joint_names,
        parts=tuple(dict.fromkeys(question.parts)),
        formats=tuple(dict.fromkeys(question.formats)),
        notation=question.notation,
        head={
            **units_of(read),
            "variables": list(read.joint_names),
            "parameters": [name for name in kinds if name in used],
            "rates": rates,
            "notation": question.notation.value,
        },
    )


def written_dynamics(task: DynamicsTask) -> bytes:
    """Return the equations of motion in the wanted formats, as JSON.

    Raises:
        FormSizeError: they are too large to be derived or written out.
    """
    found = Derivation(task.table, task.links, task.gravity)
    writing = task.writing((*task.head["parameters"], *task.head["rates"]))
    answer: dict[str, Any] = {}
    for part in task.parts:
        attribute, name, meaning = _PARTS[part]
        purpose = Purpose(name=name, meaning=meaning, result=part.value)
        answer[part.value] = writing.matrix(getattr(found, attribute), purpose)
    return writing.answer(**task.head, **answer)


_PARTS = {
    EquationPart.M: ("mass", "mass_matrix", "Mass matrix."),
    EquationPart.C: (
        "coriolis",
        "coriolis_matrix",
        "Coriolis and centrifugal matrix of Christoffel symbols.",
    ),
    EquationPart.H: ("velocity", "velocity_torque", "Coriolis and centrifugal torques."),
    EquationPart.G: ("gravity", "gravity_torque", "Torques of gravity."),
}
"""Of each part what it is in a derivation, and the name and the meaning of a function that computes it."""


def _valued(link: SymbolicBody, values: Mapping[str, Expression]) -> SymbolicBody:
    def put(entry: Expression) -> Expression:
        return substitute(entry, values)

    inertia = tuple(triple(map(put, row)) for row in link.inertia)
    return RigidBody(mass=put(link.mass), centre=triple(map(put, link.centre)), inertia=inertia)
