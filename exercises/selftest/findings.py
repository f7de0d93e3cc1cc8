"""What a self-test found: counts, failures and warnings, as codes and values."""

from collections import Counter
from collections.abc import Mapping
from dataclasses import dataclass, field

from kinematics.cells import RawTable
from kinematics.errors import ParamValue


@dataclass(frozen=True, kw_only=True, slots=True)
class Failure:
    """A check that failed, or a warning to the author; the sentence is message `check-<check>`.

    Attributes:
        check: what was checked, in snake_case.
    """

    check: str
    params: Mapping[str, ParamValue] = field(default_factory=dict)


@dataclass(slots=True)
class Findings:
    """What was checked, and what failed.

    Attributes:
        passed: how many checks of each kind passed.
        warnings: what the author should know and nothing breaks on.
    """

    exercise: str
    passed: Counter[str] = field(default_factory=Counter)
    failures: list[Failure] = field(default_factory=list)
    warnings: list[Failure] = field(default_factory=list)

    def expect(self, check: str, holds: bool, **params: object) -> None:
        """Count a check, or keep what failed."""
        if holds:
            self.passed[check] += 1
        else:
            self.fail(check, **params)

    def fail(self, check: str, **params: object) -> None:
        """Keep what failed."""
        self.failures.append(Failure(check=check, params=_shown(params)))

    def warn(self, check: str, **params: object) -> None:
        """Keep a warning."""
        self.warnings.append(Failure(check=check, params=_shown(params)))


def _shown(params: Mapping[str, object]) -> dict[str, ParamValue]:
    return {
        name: as_typed(value) if isinstance(value, RawTable) else "–" if value is None else str(value)
        for name, value in params.items()
    }


def as_typed(table: RawTable) -> str:
    """Return a table in one line: its convention and (θ, d, a, α) of each row."""
    rows = " ".join(f"({row.theta}, {row.d}, {row.a}, {row.alpha})" for row in table.rows)
    return f"{table.convention.value} {table.angle_unit.value} {table.length_unit.value} {rows}"
