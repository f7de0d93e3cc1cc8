"""Other tables of the same robot, beside a right one, to compare: nothing here knows a key."""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from random import Random

from exercises.grading import ConventionRule, Policy, grade
from exercises.parts.mistakes.compare_tables import ComparisonReason, true_reasons
from exercises.selftest.variants import key_as_asked, small_changes, some_lengths
from exercises.written_table import written_table
from kinematics.cells import RawTable, ReadTable
from kinematics.table import Convention

ATTEMPTS = 8
"""How often each kind of change is tried, at a place drawn anew: a table has a few places where it fits."""


@dataclass(frozen=True, kw_only=True, slots=True)
class OtherTable:
    """Another table of the same robot."""

    table: ReadTable
    reasons: frozenset[ComparisonReason]


def other_tables(
    read: ReadTable, policy: Policy, parameters: Mapping[str, float], count: int
) -> tuple[OtherTable, ...]:
    """Return tables of the same robot that a policy accepts beside a given one.

    The other convention comes first, if it is free; then tables that differ in a single choice. Under the
    strictest policies there may be none: where every axis is skew to the next, fixed rows alone leave one.

    Args:
        read: a table, taken to be right.
        parameters: values of the table's parameters [its units].
    """
    found: dict[RawTable, OtherTable] = {}
    given = written_table(read)
    for candidate in _candidates(read, policy):
        if len(found) == count:
            break
        raw = written_table(candidate)
        if raw == given or raw in found:
            continue
        verdict = grade(read, candidate, policy, parameters)
        if verdict.correct and (reasons := true_reasons(verdict)):
            found[raw] = OtherTable(table=candidate, reasons=reasons)
    return tuple(found.values())


def _candidates(read: ReadTable, policy: Policy) -> Iterator[ReadTable]:
    if policy.convention is ConventionRule.ANY:
        standard = read.table.convention is Convention.STANDARD
        other = ConventionRule.MODIFIED if standard else ConventionRule.STANDARD
        yield key_as_asked(read, replace(policy, convention=other))
    rng = Random("other tables")  # noqa: S311 - the same for a table, for ever
    lengths = some_lengths(read.table, 1.0)
    for _ in range(ATTEMPTS):
        for table in small_changes(read.table, policy, lengths, rng):
            yield replace(read, table=table)
