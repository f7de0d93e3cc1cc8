"""Short and full notation: c23 or cos(q2 + q3).

The short notation is that of seed 001's SCZIP and of most textbooks. A sine or cosine gets a short name only
where nothing else can be meant: its angle is a sum or difference of joint variables and no parameter of the
table has the same name.
"""

from collections.abc import Collection, Sequence
from dataclasses import dataclass
from enum import StrEnum

from kinematics.expressions import MINUS_ONE, Call, Expression, Function, JointVariable, Product, terms_of

_LAST_DIGIT = 9  # Beyond it, the indices of a sum of joints (θ₁₂) need something between them.


class Notation(StrEnum):
    """How sines and cosines of joint variables are written."""

    SHORT = "short"
    FULL = "full"


@dataclass(frozen=True, slots=True)
class ShortName:
    """The short name of a sine or cosine.

    Attributes:
        letter: c or s.
        joints: the joint variables in the angle, each with its sign; the first one's is +1.
        separated: whether the numbers are kept apart, because one of them has two digits.
    """

    letter: str
    joints: tuple[tuple[int, int], ...]
    separated: bool

    @property
    def word(self) -> str:
        """The name as an identifier: c23, c1_10, and c2m3 of the angle q2 - q3."""
        return self.letter + self._joined(minus="m", between="_")

    @property
    def index(self) -> str:
        """The index as it is typeset, with U+2212 for a difference: 23, 1,10 or 2−3."""
        return self._joined(minus="−", between=",")

    @property
    def plain(self) -> str:
        """The name with its index as typed: c23, c1,10 or c2-3."""
        return self.letter + self._joined(minus="-", between=",")

    @property
    def is_sum(self) -> bool:
        """Whether no joint variable is subtracted, so that the name can stand in a line of text."""
        return all(sign > 0 for _, sign in self.joints)

    def _joined(self, *, minus: str, between: str) -> str:
        plus = between if self.separated else ""
        words = [
            (minus if sign < 0 else plus if i else "") + str(n) for i, (n, sign) in enumerate(self.joints)
        ]
        return "".join(words)


@dataclass(frozen=True, kw_only=True, slots=True)
class Names:
    """Which names sines and cosines get.

    Attributes:
        notation: short or full.
        parameters: names that the table's parameters have.
        separated: whether joint numbers are kept apart: the table has ten joints or more.
        variables: names of the joint variables, in joint order; q1, q2, … if left out.
    """

    notation: Notation = Notation.FULL
    parameters: Collection[str] = frozenset()
    separated: bool = False
    variables: Sequence[str] = ()

    def variable(self, joint: int) -> str:
        """Return the name of a joint variable."""
        return self.variables[joint - 1] if joint <= len(self.variables) else f"q{joint}"

    def short(self, node: Expression) -> ShortName | None:
        """Return the short name of a sine or cosine of joint variables; None of what is written in full."""
        if self.notation is Notation.FULL:
            return None
        name = short_name(node, separated=self.separated)
        return None if name is None or name.word in self.parameters else name


def short_name(node: Expression, *, separated: bool = False) -> ShortName | None:
    """Return the short name of a sine or cosine of a sum or difference of joint variables, if it is one."""
    if not isinstance(node, Call) or node.function not in (Function.SIN, Function.COS):
        return None
    (angle,) = node.arguments
    joints = []
    for term in terms_of(angle):
        sign = 1
        if isinstance(term, Product) and len(term.factors) == 2 and term.factors[0] == MINUS_ONE:
            sign, term = -1, term.factors[1]
        if not isinstance(term, JointVariable):
            return None
        joints.append((term.index, sign))
    if joints[0][1] < 0:
        return None
    separated = separated or any(joint > _LAST_DIGIT for joint, _ in joints)
    return ShortName(node.function.value[0], tuple(joints), separated)
