"""Solutions in symbols: equations one after another, with their branch signs and conditions."""

from collections.abc import Iterable
from dataclasses import dataclass, replace
from enum import StrEnum
from itertools import chain, count

from kinematics.expressions import Expression, JointVariable, Number, Parameter, add, negate
from kinematics.inverse_forms.formulas import square
from kinematics.inverse_forms.signed_axes import SignedJoint

ROTATION_NAMES = tuple(tuple(f"r{i}{j}" for j in (1, 2, 3)) for i in (1, 2, 3))
POSITION_NAMES = ("p_x", "p_y", "p_z")


class ConditionKind(StrEnum):
    """What a condition says.

    REACHABLE: the value is 0 or more, or the branch does not exist. DETERMINED: the value is not 0, or the
    joint may be chosen: a singularity. FULFILLED: the value is 0, or no configuration reaches the target.
    """

    REACHABLE = "reachable"
    DETERMINED = "determined"
    FULFILLED = "fulfilled"


class InverseReach(StrEnum):
    """What of the target the equations use: its pose, or its position alone."""

    POSE = "pose"
    POSITION = "position"


@dataclass(frozen=True, kw_only=True, slots=True)
class InverseCondition:
    """A condition on a value."""

    kind: ConditionKind
    value: Expression


class InverseQuantity(StrEnum):
    """What an intermediate is.

    TARGET: an entry of the target, seen from frame 0. WRIST_POINT: place of the point that the joints at the
    hand cannot move. TURNED_POINT: that point across the first axis, before this turns. RADIUS: its way from
    the first axis in the plane that turns with this. PLANE_POINT: where joints that move in a plane have to
    bring it, from the first axis among them. PLANE_TURN: the sum of the angles of parallel joints.
    COEFFICIENT: A, B of A cos θ + B sin θ = K. CIRCULAR: K, a sine or cosine or the sum of both. ARM_POINT:
    the point as the first of two joints at θ = 0 would place it, or how far out an elbow brings it.
    HAND_AXIS: the last axis, seen from before the first of three turns.
    """

    TARGET = "target"
    WRIST_POINT = "wrist_point"
    TURNED_POINT = "turned_point"
    RADIUS = "radius"
    PLANE_POINT = "plane_point"
    PLANE_TURN = "plane_turn"
    COEFFICIENT = "coefficient"
    CIRCULAR = "circular"
    ARM_POINT = "arm_point"
    HAND_AXIS = "hand_axis"


@dataclass(frozen=True, kw_only=True, slots=True)
class SingularCase:
    """What holds in place of some equations where an angle is not determined.

    Attributes:
        free: numbers of joints, one of which may be chosen; the equations are for the first.
        conditions: what is 0 in this case, and on which branches the case is.
        joint: number of the joint that is at a singular value, or 0 if the target alone decides.
        at: this value.
        combination: the sum or difference of joint variables that is determined; None if none is.
        value: what it is.
        steps: equations that replace those of the same names. That of the free joint is left out.
    """

    free: tuple[int, ...]
    conditions: tuple[InverseCondition, ...]
    joint: int = 0
    at: Expression | None = None
    combination: Expression | None = None
    value: Expression | None = None
    steps: "tuple[InverseStep, ...]" = ()

    @property
    def values(self) -> tuple[Expression, ...]:
        """All expressions of the case."""
        own = (value for value in (self.at, self.combination, self.value) if value is not None)
        return (*own, *(one.value for one in self.conditions), *(step.value for step in self.steps))


@dataclass(frozen=True, kw_only=True, slots=True)
class InverseStep:
    """One equation.

    Attributes:
        name: what it defines; of a joint variable nothing.
        joint: number of the joint whose variable it defines, 0 of an intermediate.
        value: in the entries of the target, the lengths, branch signs, and what was defined before.
        branch: the sign that it introduces, or nothing.
        conditions: what has to hold.
        quantity: what the intermediate is.
        meaning: what it is in the joint variables, if they say so in few words: a sum of angles, a cosine.
        singular: the cases in which the condition `determined` does not hold.
    """

    name: str
    joint: int = 0
    value: Expression
    branch: str = ""
    conditions: tuple[InverseCondition, ...] = ()
    quantity: InverseQuantity | None = None
    meaning: Expression | None = None
    singular: tuple[SingularCase, ...] = ()


@dataclass(frozen=True, kw_only=True, slots=True)
class InverseForm:
    """Inverse kinematics of an arm in closed form.

    Attributes:
        steps: in the order in which they can be computed.
        branches: names of the signs, each +1 or -1 freely: 2 to the power of their number solutions.
        reach: what of the target is used.
        rotation: 3×3 names of the target's rotation.
        position: names of its position.
        conditions: what the target has to fulfil, if the arm has fewer joints than a pose has freedoms.
    """

    steps: tuple[InverseStep, ...]
    branches: tuple[str, ...]
    reach: InverseReach
    rotation: tuple[tuple[str, ...], ...]
    position: tuple[str, ...]
    conditions: tuple[InverseCondition, ...] = ()

    @property
    def zeros(self) -> tuple[Expression, ...]:
        """The values that are 0 on a branch that reaches the target, of all equations."""
        every = chain(*(step.conditions for step in self.steps), self.conditions)
        return tuple(one.value for one in every if one.kind is ConditionKind.FULFILLED)

    @property
    def singular_cases(self) -> tuple[SingularCase, ...]:
        """The singular cases of all equations, in their order."""
        return tuple(chain.from_iterable(step.singular for step in self.steps))

    @property
    def case_values(self) -> tuple[Expression, ...]:
        """What stands in the equations and conditions of all singular cases."""
        return tuple(chain.from_iterable(case.values for case in self.singular_cases))


class InverseDerivation:
    """Writes down equations, each name once.

    Attributes:
        steps: what has been written.
        branches: the signs introduced.
        idle: number of a joint that does nothing where it is needed, so that there is no form; 0 if none.
    """

    def __init__(self, taken: Iterable[str]) -> None:
        self.idle = 0
        self.steps: list[InverseStep] = []
        self.branches: list[str] = []
        self._taken = set(taken)

    def fresh(self, name: str) -> str:
        """Return the name, or one like it that nothing else has."""
        fresh = next(
            each for each in chain((name,), (f"{name}{k}" for k in count(2))) if each not in self._taken
        )
        self._taken.add(fresh)
        return fresh

    def let(
        self,
        name: str,
        value: Expression,
        quantity: InverseQuantity,
        *conditions: InverseCondition,
        branch: Expression | None = None,
        meaning: Expression | None = None,
    ) -> Expression:
        """Return a name for a value; a value that is a number or a name already is left alone."""
        if not conditions and isinstance(value, Number | Parameter):
            return value
        name = self.fresh(name)
        self.steps.append(
            InverseStep(
                name=name,
                value=value,
                branch=_name_of(branch),
                conditions=conditions,
                quantity=quantity,
                meaning=meaning,
            )
        )
        return Parameter(name)

    def sign(self) -> Expression:
        """Return a new branch sign."""
        self.branches.append(self.fresh(f"sigma{len(self.branches) + 1}"))
        return Parameter(self.branches[-1])

    def joint(
        self,
        joint: SignedJoint,
        value: Expression,
        *conditions: InverseCondition,
        branch: Expression | None = None,
        sense: int = 1,
    ) -> Expression:
        """Write down q = sense·value - offset; returned is θ, or the way of a slide."""
        value = add((value if sense > 0 else negate(value), negate(joint.offset)))
        self.steps.append(
            InverseStep(
                name=f"q{joint.number}",
                joint=joint.number,
                value=value,
                branch=_name_of(branch),
                conditions=conditions,
            )
        )
        return joint.angle if joint.turns else JointVariable(joint.number)

    def idles(self, joint: SignedJoint) -> bool:
        """Note that a joint does nothing where it is needed; return that there is no form."""
        self.idle = joint.number
        return False

    def singular(self, *cases: SingularCase) -> None:
        """Add the cases in which the last equation does not determine its angle."""
        self.steps[-1] = replace(self.steps[-1], singular=cases)

    def free(self, joint: SignedJoint, *values: Expression) -> None:
        """Add to the equation of a joint that it may be chosen where some values are 0."""
        self.singular(SingularCase(free=(joint.number,), conditions=tuple(map(fulfilled, values))))


def _name_of(sign: Expression | None) -> str:
    return sign.name if isinstance(sign, Parameter) else ""


def reachable(value: Expression) -> InverseCondition:
    """Return the condition that a value is 0 or more."""
    return InverseCondition(kind=ConditionKind.REACHABLE, value=value)


def fulfilled(value: Expression) -> InverseCondition:
    """Return the condition that a value is 0."""
    return InverseCondition(kind=ConditionKind.FULFILLED, value=value)


def determined(*values: Expression) -> InverseCondition:
    """Return the condition that values are not all 0."""
    (first, *more) = values
    value = add(square(each) for each in values) if more else first
    return InverseCondition(kind=ConditionKind.DETERMINED, value=value)
