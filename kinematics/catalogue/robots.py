"""What the catalogue knows of a robot."""

from collections.abc import Mapping
from dataclasses import dataclass

from kinematics.cells import RawTable, ReadTable
from kinematics.dynamics.reading import RawBody
from kinematics.expressions import Expression
from kinematics.scm import RawChain, ReadChain
from kinematics.se3 import Transform


@dataclass(frozen=True, kw_only=True, slots=True)
class RobotSource:
    """Where a robot comes from.

    Attributes:
        document: title, author and year.
        place: figure, equation, table or script within it.
        figures: where the lengths come from, as printed.
    """

    document: str
    place: str
    figures: str


@dataclass(frozen=True, kw_only=True, slots=True)
class NamedConfiguration:
    """Joint values that mean something.

    Attributes:
        joints: q_1 … q_n, in the units of the robot's table.
        meaning: what the arm looks like there.
        position: origin of the end frame there, derived by hand from the figure, in the table's parameters.
    """

    joints: tuple[float, ...]
    meaning: str
    position: tuple[Expression, Expression, Expression] | None


@dataclass(frozen=True, kw_only=True, slots=True)
class ScmDescription:
    """The same robot as an SCM chain.

    Attributes:
        raw: the chain as the document prints it.
        read: the chain, its joint variables those of the table.
        parameters: for each of the chain's lengths the table's parameter that it is.
    """

    raw: RawChain
    read: ReadChain
    parameters: Mapping[str, str]


@dataclass(frozen=True, kw_only=True, slots=True)
class LinkWeights:
    """What the links of a robot weigh.

    Attributes:
        links: one for each row of the table, in [kg, the table's length unit, kg m²].
        source: where the figures come from.
    """

    links: tuple[RawBody, ...]
    source: str


@dataclass(frozen=True, kw_only=True, slots=True)
class ReferencePose:
    """A pose that was derived without the DH table.

    Attributes:
        derivation: how.
        joints: q_1 … q_n, in the units of the robot's table.
        transform: (4, 4) ⁰T_N, translation in the table's length unit.
    """

    derivation: str
    joints: tuple[float, ...]
    transform: Transform


@dataclass(frozen=True, kw_only=True, eq=False)
class Robot:
    """A robot of the catalogue.

    Attributes:
        id: name of its file, and of its exercise.
        source: where it comes from.
        raw: its DH table as written.
        table: its DH table as read.
        parameters: the value of every parameter, in the table's units.
        configurations: named joint values.
        limits: (low, high) of every joint in the table's units, or None where they aren't known.
        limits_source: where the limits come from.
        chain: the robot as an SCM chain.
        reference: a pose from a second derivation.
        weights: of its links, or None where they aren't known.
    """

    id: str
    name: str
    source: RobotSource
    raw: RawTable
    table: ReadTable
    parameters: Mapping[str, float]
    configurations: Mapping[str, NamedConfiguration]
    limits: tuple[tuple[float, float], ...] | None
    limits_source: str | None
    chain: ScmDescription | None
    reference: ReferencePose
    weights: LinkWeights | None = None

    @property
    def chain_values(self) -> dict[str, float]:
        """The value of every parameter of the SCM chain, in the table's units."""
        named = {} if self.chain is None else self.chain.parameters
        return {name: self.parameters[known] for name, known in named.items()}
