"""Points at which closed forms about a robot are compared: nobody knows them before the answer is written."""

import random
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from kinematics.cells import ParameterKind
from kinematics.chain import Chain, chain_of_table, size_of
from kinematics.expressions import Expression
from kinematics.expressions.arrays import values_at
from kinematics.se3 import Floats
from kinematics.table import JointType, SymbolicTable, bind


@dataclass(frozen=True, kw_only=True, eq=False)
class ValuedRobot:
    """A robot in symbols, and in numbers.

    Attributes:
        values: of every name in it [the table's length, or rad].
    """

    table: SymbolicTable
    values: Mapping[str, float]

    @cached_property
    def chain(self) -> Chain:
        """The chain at these values."""
        return chain_of_table(bind(self.table, self.values))

    @cached_property
    def size(self) -> float:
        """Typical length of the robot."""
        return size_of(self.chain) or 1.0


POINTS = 8  # Configurations with the table's lengths, and as many with others.
DOUBLED = 1e-9
"""How nearly twice the lengths must double an entry: far above rounding, below any length left out."""


@dataclass(frozen=True, kw_only=True, eq=False)
class FormRobot(ValuedRobot):
    """The robot that closed forms are of, with values of the names in the answer, too.

    Attributes:
        lengths: the names that are lengths.
    """

    lengths: frozenset[str]


COMPONENTS = ("fx", "fy", "fz", "mx", "my", "mz")  # Of a force and a moment at the tool.


def loaded_robot(
    table: SymbolicTable, values: Mapping[str, float], kinds: Mapping[str, ParameterKind]
) -> FormRobot:
    """Return a robot with a force and a moment at its tool, whose components are names, too.

    Args:
        values: of every other name, and of those components that mean something else in the table.
        kinds: of the names; one that is not among them is a length.
    """
    lengths = {name for name in values if kinds.get(name, ParameterKind.LENGTH) is ParameterKind.LENGTH}
    loads = {name: 7.0 + 3.0 * i for i, name in enumerate(COMPONENTS)}
    moments = set(COMPONENTS[3:]) - values.keys()
    return FormRobot(table=table, values={**loads, **values}, lengths=frozenset(lengths | moments))


@dataclass(frozen=True, kw_only=True, eq=False)
class FormSamples:
    """Points where functions are compared: joints (n, k), parameters (k,) each."""

    parameters: Mapping[str, Floats]
    joints: Floats

    def of(self, entries: Iterable[Expression]) -> Floats:
        """Return the values of some entries, (entries, k)."""
        found = [values_at(entry, self.parameters, self.joints) for entry in entries]
        return np.array(found).reshape(len(found), self.joints.shape[1])

    def at(self, k: int) -> "FormSamples":
        """Return one of the points."""
        parameters = {name: values[k : k + 1] for name, values in self.parameters.items()}
        return FormSamples(parameters=parameters, joints=self.joints[:, k : k + 1])


def form_samples(robot: FormRobot, given: Sequence[Expression], ours: Sequence[Expression]) -> FormSamples:
    """Return points drawn from the answer; with other lengths only if both name every length."""
    rng = random.Random(repr(given))  # noqa: S311 - the same answer, the same points
    usual = usual_samples(robot, rng)
    if not _names_every_length(robot, usual, given, ours):
        return usual
    other = {
        name: np.array([robot.size * rng.uniform(0.2, 1.2) for _ in range(POINTS)])
        if name in robot.lengths
        else values
        for name, values in usual.parameters.items()
    }
    return FormSamples(
        parameters={name: np.concatenate([usual.parameters[name], other[name]]) for name in other},
        joints=np.hstack([usual.joints, _drawn(robot, rng)]),
    )


def usual_samples(robot: FormRobot, rng: random.Random) -> FormSamples:
    """Return points with the robot's own values."""
    values = {name: np.full(POINTS, value) for name, value in robot.values.items()}
    return FormSamples(parameters=values, joints=_drawn(robot, rng))


def _drawn(robot: FormRobot, rng: random.Random) -> Floats:
    reach = [robot.size if kind is JointType.PRISMATIC else 3.0 for kind in robot.table.joint_types]
    joints = [[rng.uniform(-most, most) for _ in range(POINTS)] for most in reach]
    return np.array(joints).reshape(len(reach), POINTS)


def _names_every_length(
    robot: FormRobot, samples: FormSamples, given: Sequence[Expression], ours: Sequence[Expression]
) -> bool:
    """Whether twice the lengths double each entry or leave it as it is, the given one just like ours."""
    slides = np.array([[kind is JointType.PRISMATIC] for kind in robot.table.joint_types])
    twice = FormSamples(
        parameters={
            name: values * (2.0 if name in robot.lengths else 1.0)
            for name, values in samples.parameters.items()
        },
        joints=samples.joints * np.where(slides, 2.0, 1.0),
    )

    def grown(entries: Sequence[Expression]) -> tuple[NDArray[np.bool_], NDArray[np.bool_]]:
        before, after = samples.of(entries), twice.of(entries)
        limit = DOUBLED * max(1.0, robot.size, float(np.nan_to_num(np.abs(before)).max(initial=0.0)))
        return (
            np.all(np.abs(after - before) <= limit, axis=1),
            np.all(np.abs(after - 2.0 * before) <= limit, axis=1),
        )

    kept, doubled = zip(grown(ours), grown(given), strict=True)
    return bool((kept[0] & kept[1] | doubled[0] & doubled[1]).all())
