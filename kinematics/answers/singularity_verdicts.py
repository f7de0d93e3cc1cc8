"""What is said of conditions for singularities: of each, of each family, and of all as a set."""

from dataclasses import dataclass
from enum import StrEnum

from kinematics.symbolic import ProofStatus


class ConditionStatus(StrEnum):
    """What is said of a condition.

    SINGULAR: wherever it holds, the arm is singular. INVENTED: it holds in a configuration that is not
    singular.
    EVERYWHERE: it holds for all q. NOWHERE: it never holds, and says nothing.
    """

    SINGULAR = "singular"
    INVENTED = "invented"
    EVERYWHERE = "everywhere"
    NOWHERE = "nowhere"


@dataclass(frozen=True, kw_only=True, eq=False)
class JudgedCondition:
    """A condition and what is said of it.

    Attributes:
        status: of it.
        example: of an invented one (n,) a configuration where it holds and the arm is not singular.
        is_close: wherever an invented one with decimals holds, the arm is almost singular.
    """

    status: ConditionStatus
    example: tuple[float, ...] | None = None
    is_close: bool = False


@dataclass(frozen=True, kw_only=True, eq=False)
class JudgedFamily:
    """A family of singularities and whether the conditions cover it.

    Attributes:
        found: a share: 1 if they hold everywhere in it.
        example: (n,) a configuration of it, where none of the conditions holds if some are missing.
    """

    found: float
    example: tuple[float, ...] | None


@dataclass(frozen=True, kw_only=True, eq=False)
class SingularityVerdict:
    """What is said of the conditions.

    Attributes:
        conditions: of each.
        families: of each family of the arm.
        proof: PROVED: the sets are the same by exact identities; UNDECIDED: compared at samples; REFUTED:
            they are not the same.
    """

    conditions: tuple[JudgedCondition, ...]
    families: tuple[JudgedFamily, ...]
    proof: ProofStatus

    @property
    def right(self) -> bool:
        """The conditions hold just where the arm is singular."""
        honest = (ConditionStatus.SINGULAR, ConditionStatus.NOWHERE)
        return all(entry.found == 1.0 for entry in self.families) and all(
            entry.status in honest for entry in self.conditions
        )

    @property
    def share(self) -> float:
        """Share of what was found, less that of what was invented."""
        if not self.families:
            return float(self.right)
        found = sum(entry.found for entry in self.families) / len(self.families)
        wrong = sum(
            entry.status in (ConditionStatus.INVENTED, ConditionStatus.EVERYWHERE)
            for entry in self.conditions
        )
        return max(0.0, found - wrong / len(self.families))
