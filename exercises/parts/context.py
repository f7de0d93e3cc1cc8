"""What the parts of one answer are judged by: the key, the student's own table, values, tolerance."""

import math
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from exercises.grading import Policy, Verdict
from exercises.instance import Instance
from exercises.parts.following import share_that_follows
from exercises.parts.joint_draws import key_numbers, key_size
from exercises.parts.protocol import Answer
from exercises.parts.report import Credit
from exercises.parts.samples import Points, Samples
from kinematics.cells import AngleUnit, LengthUnit, ParameterKind, ReadTable, parameters_in_radians
from kinematics.dh import link_transforms
from kinematics.errors import ParameterError
from kinematics.forward import ForwardKinematics, forward_kinematics
from kinematics.symbolic import ClosedForm, closed_form
from kinematics.table import Convention, JointType, NumericTable, bind

DRAWS = 3
CONFIGURATIONS = 5
"""Values of the lengths, and joint values for each, at which functions are compared: one point on no grid
tells two different closed forms apart, fifteen leave nothing to luck."""
_STEPS = tuple(math.sqrt(p) for p in (2, 3, 5, 7, 11, 13, 17, 19, 23, 29, 31, 37, 41, 43, 47, 53))


@dataclass(frozen=True, kw_only=True, eq=False)
class Context:
    """Everything that one answer is judged by."""

    instance: Instance
    answer: Answer
    verdict: Verdict | None
    _own_links: dict[tuple[Samples, Convention], Sequence[NDArray[np.float64]]] = field(
        init=False, default_factory=dict
    )
    _own_numbers: dict[tuple[float, ...], NumericTable] = field(init=False, default_factory=dict)
    _samples: dict[frozenset[str], Samples] = field(init=False, default_factory=dict)

    @property
    def reference(self) -> ReadTable:
        """The key, in the exercise's units."""
        return self.instance.exercise.reference

    @property
    def policy(self) -> Policy:
        """What a table is held to."""
        return self.instance.exercise.policy

    @property
    def own(self) -> ReadTable | None:
        """The student's own table, if one was handed in."""
        return self.answer.table

    @property
    def own_correct(self) -> bool:
        """Whether the student's own table was accepted."""
        return self.verdict is not None and self.verdict.correct

    @cached_property
    def own_share(self) -> float:
        """Which share of its points an answer earns that follows from the student's own table."""
        if self.own is None:
            return 1.0
        try:
            own = self.own_numbers(self.values(self.own_names()))
        except ParameterError:
            return 1.0
        return share_that_follows(own, self.reference_numbers)

    @property
    def own_credit(self) -> Credit:
        """What points rest on that follow from the student's own table."""
        return Credit.KEY if self.own_correct else Credit.OWN_TABLE

    @property
    def angle_unit(self) -> AngleUnit:
        """Unit of angles in the student's answer."""
        return self.answer.angle_unit

    @property
    def length_unit(self) -> LengthUnit:
        """Unit of lengths in the student's answer."""
        return self.answer.length_unit

    @cached_property
    def parameters(self) -> Mapping[str, float]:
        """Values of the robot's dimensions [the exercise's units]."""
        return self.instance.parameters

    @cached_property
    def own_form(self) -> ClosedForm:
        """The closed form of the student's own table."""
        assert self.own is not None
        return closed_form(self.own.table)

    @cached_property
    def reference_numbers(self) -> NumericTable:
        """The key with its values, lengths in the exercise's unit."""
        return key_numbers(self.instance)

    @cached_property
    def reference_values(self) -> dict[str, float]:
        """Value of every parameter of the key, lengths in the exercise's unit, angles in [rad]."""
        return parameters_in_radians(self.parameters, self._kinds, self.reference.angle_unit)

    @cached_property
    def unit_ratio(self) -> float:
        """Units of the student's answer in one unit of the exercise."""
        return float(self.reference.length_unit.metres_per_unit / self.length_unit.metres_per_unit)

    @cached_property
    def size(self) -> float:
        """Typical length of the robot, in the student's unit."""
        size = key_size(self.instance) * self.unit_ratio
        return size if size > 0 else 1.0

    @property
    def joint_types(self) -> tuple[JointType, ...]:
        """Types of the joints whose variables may stand in the answer: the student's own, else the key's."""
        return (self.own or self.reference).table.joint_types

    def values(self, names: Iterable[str] = ()) -> dict[str, float]:
        """Return the value of every parameter, in the student's length unit and in [rad].

        Other names get some value.
        """
        known = self.reference_values
        values = {
            name: value * (1.0 if self._is_angle(name) else self.unit_ratio) for name, value in known.items()
        }
        for k, name in enumerate(sorted(set(names) - set(values))):
            values[name] = self.size * (0.31 + 0.47 * _fraction(k, 97))
        return values

    def draws(self, names: Iterable[str]) -> Iterator[dict[str, float]]:
        """Yield other values of the parameters, all different from one another and far from zero."""
        ordered = sorted({*self.parameters, *names})
        for draw in range(1, DRAWS):
            yield {
                name: (1.0 if self._is_angle(name) else self.size) * (0.2 + _fraction(k, draw))
                for k, name in enumerate(ordered)
            }

    def configurations(self, joint_types: Sequence[JointType]) -> NDArray[np.float64]:
        """Return (CONFIGURATIONS, n) joint values on no grid, in [rad] and in the student's unit."""
        return np.array(
            [
                [
                    (2.0 * _fraction(k, sample + 1) - 1.0)
                    * (3.0 if type_ is JointType.REVOLUTE else self.size)
                    for k, type_ in enumerate(joint_types)
                ]
                for sample in range(CONFIGURATIONS)
            ]
        ).reshape(CONFIGURATIONS, len(joint_types))

    def own_links(
        self, samples: Samples, convention: Convention | None = None
    ) -> Sequence[NDArray[np.float64]]:
        """Return the matrices of the student's own rows at samples, (k, 4, 4) each, computed once.

        Args:
            samples: where the table holds.
            convention: that its rows are read in, if not the table's.

        Raises:
            ParameterError: an entry has no value there.
        """
        assert self.own is not None
        key = samples, convention or self.own.table.convention
        if key not in self._own_links:
            self._own_links[key] = self._links_at(*key)
        return self._own_links[key]

    def _links_at(self, samples: Samples, convention: Convention) -> Sequence[NDArray[np.float64]]:
        tables = [self.own_numbers(values) for values, _ in samples.points]
        places = {row: joint for joint, row in enumerate(tables[0].joint_rows)}
        return [
            link_transforms(
                rows, convention, [_column(joints, places.get(i)) for _, joints in samples.points]
            )
            for i, rows in enumerate(zip(*(table.rows for table in tables), strict=True))
        ]

    def own_numbers(self, values: Mapping[str, float]) -> NumericTable:
        """Return the student's own table with these values, made once.

        Raises:
            ParameterError: an entry has no value there.
        """
        assert self.own is not None
        key = tuple(values[name] for name in self.own.parameters)
        if key not in self._own_numbers:
            self._own_numbers[key] = bind(self.own.table, values)
        return self._own_numbers[key]

    def samples(self, names: frozenset[str]) -> Samples:
        """Return where functions are compared: the exercise's values with joint values, then others of both.

        The last one is the first sample with every length twice as long. Other values are left out where the
        student's own table does not hold for them.
        """
        names = names.difference(self.reference_values)  # these have values anyhow
        if names not in self._samples:
            nominal, joints = self.values(names), self.configurations(self.joint_types)
            found: list[Points] = [(nominal, joints)]
            if self.own_scales:
                slides = [type_ is JointType.PRISMATIC for type_ in self.joint_types]
                found += ((values, joints[:2]) for values in self.draws(names) if self._own_holds(values))
                found.append((self.scaled(nominal, 2.0), np.where(slides, 2.0, 1.0) * joints[:1]))
            self._samples[names] = Samples(tuple(found))
        return self._samples[names]

    def own_poses(self, values: Mapping[str, float], joints: Sequence[float]) -> ForwardKinematics:
        """Return the poses of the student's own table; lengths in the student's unit.

        Raises:
            ParameterError: an entry has no value there.
        """
        return forward_kinematics(self.own_numbers(values), joints)

    def own_names(self) -> frozenset[str]:
        """Return the parameters of the student's own table."""
        return frozenset(self.own.parameters) if self.own else frozenset()

    @cached_property
    def own_scales(self) -> bool:
        """Whether the student's own table names every length, and so holds for all values of the names."""
        if self.own is None:
            return False
        values = self.values(self.own_names())
        doubled = self.scaled(values, 2.0)
        if not (self._own_holds(values) and self._own_holds(doubled)):
            return False
        return twice_as_long(self.own_numbers(values), self.own_numbers(doubled))

    def _own_holds(self, values: Mapping[str, float]) -> bool:
        """Whether every entry of the student's own table has a value there: √(L2² − L1²) may have none."""
        try:
            self.own_numbers(values)
        except ParameterError:
            return False
        return True

    def scaled(self, values: Mapping[str, float], factor: float) -> dict[str, float]:
        """Return the values with every length multiplied."""
        return {name: value if self._is_angle(name) else value * factor for name, value in values.items()}

    def _is_angle(self, name: str) -> bool:
        return self._kinds.get(name) is ParameterKind.ANGLE

    @cached_property
    def _kinds(self) -> dict[str, ParameterKind]:
        return {**(self.own.parameters if self.own else {}), **self.reference.parameters}


def twice_as_long(once: NumericTable, twice: NumericTable) -> bool:
    """Return whether every length of a table is twice that of another."""
    return all(
        math.isclose(2.0 * a, b, rel_tol=1e-9, abs_tol=1e-12)
        for row, other in zip(once.rows, twice.rows, strict=True)
        for a, b in ((row.a, other.a), (row.d, other.d))
    )


def _column(joints: NDArray[np.float64], joint: int | None) -> NDArray[np.float64]:
    """(k,) values of one joint among (k, n); zeros for a row without a joint, whose table may have none."""
    return joints[:, joint] if joint is not None else np.zeros(len(joints))


def _fraction(k: int, n: int) -> float:
    """The n-th term of the k-th Kronecker sequence, in [0, 1)."""
    return ((n + 1) * _STEPS[k % len(_STEPS)] * (1 + k // len(_STEPS))) % 1.0
