"""What a function in a programming language must know of each node."""

from __future__ import annotations

from enum import IntEnum
from fractions import Fraction
from typing import NamedTuple, TypeAlias

from kinematics.expressions import Call, Function, JointVariable, Parameter, Pi, Power, Product, Sum
from kinematics.printing.ledger import Quotient
from kinematics.printing.notation import ShortName, short_name
from kinematics.printing.writer import Writer

_HALF = Fraction(1, 2)
Head: TypeAlias = Parameter | Function | Pi | None


class Naming(IntEnum):
    """When a node is computed by itself and given a name."""

    NEVER = 0
    REPEATED = 1
    ALWAYS = 2


class Trait(NamedTuple):
    """What is known of one node.

    Attributes:
        naming: when it gets a name.
        short: its short name, if it is a sine or cosine of joint variables.
        parts: the nodes that are written within it.
        head: the parameter that it is, the function that it calls, or π.
        own: whether languages spell it in ways of their own, whatever its parts are.
        fixed: whether nothing else decides how it is spelled: no name of a step, no parameter.
    """

    naming: Naming
    short: ShortName | None
    parts: tuple[int, ...]
    head: Head
    own: bool
    fixed: bool


class Traits(Writer[Trait]):
    """Finds the traits of nodes."""

    def of(self, number: int) -> Trait:
        """The traits of a node that was entered."""
        return self._written[number]

    def _write(self, number: int) -> Trait:
        node, quotient = self.ledger.nodes[number], self.ledger.quotients[number]
        parts = self.ledger.below[number]
        naming, own = Naming.NEVER, True
        head: Head = None
        short: ShortName | None = None
        if quotient is not None:
            parts = (*quotient.typed, *(base for base, _ in quotient.below))
            # a number times a name is not worth a name of its own, and a negative power is a division
            naming = Naming.REPEATED if isinstance(node, Product) and len(parts) > 1 else Naming.NEVER
            own = _holds_whole_numbers(quotient)
            head = Function.SQRT if any(exponent == _HALF for _, exponent in quotient.below) else None
        match node:
            case Sum(terms):
                # the sum of an angle only stands under a sine or cosine, where adding again costs nothing
                moving = any(isinstance(term, JointVariable) for term in terms)
                naming, own = Naming.NEVER if moving else Naming.REPEATED, False
            case Call(function, _):
                head, short = function, short_name(node)
                circular = function in (Function.SIN, Function.COS)
                naming = Naming.ALWAYS if circular and self.ledger.moving[number] else Naming.REPEATED
            case Power(_, exponent) if exponent > 0:
                naming, head = Naming.REPEATED, Function.SQRT if exponent == _HALF else None
            case Parameter():
                head, own = node, False
            case Pi():
                head = node
        inner = [self._written[part] for part in parts]
        fixed = not isinstance(node, Parameter) and all(
            trait.fixed and trait.naming is Naming.NEVER for trait in inner
        )
        return Trait(naming, short, parts, head, own, fixed)


def _holds_whole_numbers(quotient: Quotient) -> bool:
    """Whether 2, 1/3 or a power is to be written: C calls them 2.0, 1.0/3.0 and pow."""
    weight = quotient.weight
    if weight.denominator or any(exponent != 1 for _, exponent in quotient.below):
        return True
    if weight.digits:
        return not weight.decimal
    return not quotient.typed
