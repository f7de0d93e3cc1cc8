"""The SCM chain: rows of [X Y Z A B C], one joint variable each.

The moving frame (Sistema Coordenado Móvel) travels along the arm: each row translates it by (x, y, z) and
then turns it by A about z, B about the new y and C about the new x,

    H = Trans(x, y, z) Rot_z(A) Rot_y(B) Rot_x(C).                                  (seed 001 eq. 2.4, 2.5)

Exactly one of a joint row's six entries holds the joint variable. What follows the last joint is the Final
Transformation and, behind it, the tool.
"""

from dataclasses import dataclass
from enum import StrEnum

from kinematics.errors import Fault
from kinematics.expressions import ZERO, Expression
from kinematics.table import JointType


class Entry(StrEnum):
    """The six entries of a row: translations x, y, z and turns A, B, C about z, y, x."""

    X = "x"
    Y = "y"
    Z = "z"
    A = "a"
    B = "b"
    C = "c"

    @property
    def is_turn(self) -> bool:
        """Whether the entry is an angle."""
        return self in (Entry.A, Entry.B, Entry.C)

    @property
    def axis(self) -> int:
        """Index of the axis along or about which the entry moves: 0 x, 1 y, 2 z."""
        return {"x": 0, "y": 1, "z": 2, "a": 2, "b": 1, "c": 0}[self.value]


@dataclass(frozen=True, kw_only=True, slots=True)
class Placement:
    """A constant motion [X Y Z A B C]: lengths x, y, z, then angles a, b, c [rad]."""

    x: Expression = ZERO
    y: Expression = ZERO
    z: Expression = ZERO
    a: Expression = ZERO
    b: Expression = ZERO
    c: Expression = ZERO

    def entry(self, name: Entry) -> Expression:
        """Return the entry of that name."""
        value: Expression = getattr(self, name.value)
        return value


@dataclass(frozen=True, kw_only=True, slots=True)
class ChainRow:
    """One joint of an SCM chain.

    Attributes:
        constant: the row's constants; in the variable's entry the offset.
        variable: the entry that holds the joint variable.
        sign: +1, or -1 where the variable enters reversed.
    """

    constant: Placement
    variable: Entry
    sign: int = 1

    @property
    def joint(self) -> JointType:
        """Revolute when a turn is variable, prismatic when a translation is."""
        return JointType.REVOLUTE if self.variable.is_turn else JointType.PRISMATIC


@dataclass(frozen=True, kw_only=True, slots=True)
class ScmChain:
    """A serial arm by the SCM method.

    Attributes:
        rows: joint 1 … n.
        final: the Final Transformation, from the last joint's frame to the flange.
        tool: the tool, in the flange.
    """

    rows: tuple[ChainRow, ...]
    final: Placement = Placement()
    tool: Placement = Placement()

    @property
    def n_joints(self) -> int:
        """Number of joint variables."""
        return len(self.rows)


def verify(chain: ScmChain) -> tuple[Fault, ...]:
    """Return what keeps a chain from being an SCM chain in the strict form: the toolbox's `verifyData`.

    A prismatic row translates along one axis only and does not turn; a revolute row turns about one axis only
    and holds no offset angle. Constant turns belong to the Final Transformation.

    Returns:
        The faults, each at ("joints", i, entry); none if the chain passes.

    Source: seed 001 eq. 3.14, 3.15 and note 3.
    """
    return tuple(
        Fault.at(code, "joints", i, entry.value, joint=i + 1)
        for i, row in enumerate(chain.rows)
        for entry in Entry
        if (code := _offence(row, entry))
    )


def _offence(row: ChainRow, entry: Entry) -> str | None:
    """Code of what is wrong with a constant in an entry of a joint's row."""
    if row.constant.entry(entry) == ZERO:
        return None
    if row.joint is JointType.PRISMATIC:
        return "scm_prismatic_turns" if entry.is_turn else "scm_prismatic_second_length"
    if entry is row.variable:
        return "scm_revolute_offset"
    return "scm_revolute_second_turn" if entry.is_turn else None
