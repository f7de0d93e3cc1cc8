"""A wrong answer under repair: the table on which edits are tried, and what they are tried against."""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property
from itertools import accumulate

import numpy as np

from exercises.grading.axis_directions import fixed_ends
from exercises.grading.edits.changes import ROW_CELLS, Change, TableSlip
from exercises.grading.edits.other_draws import alike_at
from exercises.grading.edits.scope import ANY_EDIT, EditScope
from exercises.grading.facts import Facts
from exercises.grading.judging.comparison import Comparison
from exercises.grading.judging.end_lines import (
    ends_beside_joints,
    ends_beyond_digits,
    is_off_its_joint,
    lines_at_ends,
)
from exercises.grading.judging.judgement import share_of
from exercises.grading.judging.typed import NOTHING_TYPED, Place
from kinematics.cells import ReadTable
from kinematics.chain import Chain, chain_of_table
from kinematics.equivalence import BaseRule, Kind, Policy, ToolRule, ZeroRule
from kinematics.equivalence.decision import convention_fits, is_certified
from kinematics.equivalence.invariants import Invariants, axes_of, invariants_of
from kinematics.equivalence.meter import PER_ROW, Meter
from kinematics.equivalence.reference import Reference
from kinematics.equivalence.search import Effort
from kinematics.table import JointType, NumericRow, NumericTable

WORK_OF_ONE_EDIT = 30_000
"""What deciding whether one edit mends the table may cost: no single one uses up the search."""
EXCHANGED = 2  # Joints of another type where rows of joints of both types were exchanged.


@dataclass(frozen=True, kw_only=True, eq=False)
class Work:
    """The table that edits are tried on.

    Attributes:
        key: the key as read.
        answer: the answer as read.
        comparison: both with numbers.
        policy: what the answer is held to.
        references: the key at each draw, prepared; at the answer's size, if it has none.
        tightened: what no choice of frames changes, at a draw, as nearly as the answer must have it.
        meter: counts what trying edits costs.
        table: the answer at one draw, as it was meant, perhaps with an edit made already.
        draw: that draw.
        fits: for cells, other values that make an invariant fit which does not.
        scope: what an edit has to do with, to mend all that is wrong.
        only: the one slip that is to be undone; any, if none is named.
        kept: places that an edit made before has changed, which another one leaves alone.
        lines: at which ends the key's line is looked for, where the rule `axis` would take the joint's, too.
    """

    key: ReadTable
    answer: ReadTable
    comparison: Comparison
    policy: Policy
    references: tuple[Reference, ...]
    tightened: Callable[[int, frozenset[Kind]], Invariants]
    meter: Meter
    table: NumericTable
    draw: int = 0
    fits: Mapping[Place, list[float]] = field(default_factory=dict)
    scope: EditScope = ANY_EDIT
    only: TableSlip | None = None
    kept: frozenset[Place] = frozenset()
    lines: frozenset[Kind] = frozenset()

    @property
    def reference(self) -> Reference:
        """The key at the draw."""
        return self.references[self.draw]

    @cached_property
    def invariants(self) -> Invariants:
        """What no choice of frames changes, at the draw, as nearly as the answer must have it.

        The facts come first; behind them comes what lies between axes that are no neighbours, where the
        policy fixes the zeros of the variables, and where the key's lines at the ends lie, where these are
        looked for.
        """
        return self.tightened(self.draw, self.lines)

    @cached_property
    def chain(self) -> Chain:
        """The chain of the table."""
        return chain_of_table(self.table)

    @property
    def fixing(self) -> Policy:
        """What is fixed at the ends as the invariants are measured."""
        return lines_at_ends(self.policy, self.lines) if self.lines else self.policy

    def for_lines(self, *, to_the_letter: bool = False) -> "Work | None":
        """Return the table as one in which the key's lines at the ends are looked for.

        None where it keeps the rule `axis` at both ends, or no key's line is meant but the joint's axis.

        Args:
            to_the_letter: a line is off even where the typed digits would explain it, or where it is off only
                because of the zeros that the policy fixes.
        """
        base, tool = self.policy.base is BaseRule.AXIS, self.policy.tool is ToolRule.AXIS
        if not (base or tool) or self.lines or not self.has_the_joints():
            return None
        asked = ((Kind.BASE, base), (Kind.TOOL, tool))
        elsewhere = {kind for kind, is_asked in asked if is_asked and is_off_its_joint(self.reference, kind)}
        if not elsewhere:
            return None
        steps = NOTHING_TYPED if to_the_letter else self._typed_in(self.table)
        missed = elsewhere.intersection(self._ends_off(self.reference, self.table, steps))
        if to_the_letter and self.policy.zero is ZeroRule.FIGURE:
            missed = elsewhere  # a slider beside it takes the line along
        return replace(self, lines=frozenset(missed)) if missed else None

    @cached_property
    def n_facts(self) -> int:
        """How many of the invariants are facts."""
        return len(invariants_of(self.reference, self.policy).shapes)

    @property
    def facts(self) -> Invariants:
        """The facts among the invariants, wherever the variables are zero."""
        known = self.invariants
        return known if self.n_facts == len(known.shapes) else known.some(range(self.n_facts))

    @cached_property
    def excess(self) -> int:
        """How many joints the table has more than the key."""
        return self.table.n_joints - self.reference.table.n_joints

    def is_near(self, first: int, last: int | None = None, *, moves: bool = False) -> bool:
        """Return whether an edit in a row, or in rows from … to, may mend all that is wrong.

        An edit changes how the axes before it lie to those after it; what it leaves alone, it cannot mend.

        Args:
            first: the row, or the first of them, counted from 0.
            last: the last of them.
            moves: whether a joint goes elsewhere, so that what is before and behind the rows changes too.
        """
        start, end = self.scope.reach
        counts = self.joints_up_to
        return start <= counts[first if last is None else last] + moves and counts[first] - moves <= end

    @cached_property
    def joints_up_to(self) -> list[int]:
        """For every row the number of joints up to it."""
        return list(accumulate(row.joint is not JointType.FIXED for row in self.table.rows))

    @cached_property
    def rows(self) -> tuple[tuple[int, NumericRow], ...]:
        """The rows in which an edit may mend all that is wrong, and their numbers, from 0."""
        wanted = None if self.only is None else self.only.row
        return tuple(
            (i, row)
            for i, row in enumerate(self.table.rows)
            if (wanted is None or i == wanted) and self.is_near(i)
        )

    @property
    def rows_of_lengths(self) -> tuple[tuple[int, NumericRow], ...]:
        """The rows in which another length may mend all that is wrong."""
        return () if self.scope.angular else self.rows

    def has_the_joints(self, table: NumericTable | None = None) -> bool:
        """Return whether the table, or another, has the key's types of joints in order."""
        return (table or self.table).joint_types == self.reference.table.joint_types

    @property
    def other_types(self) -> int:
        """How many joints are of another type than the key's in the same place."""
        types = zip(self.table.joint_types, self.reference.table.joint_types, strict=False)
        return sum(ours is not wanted for ours, wanted in types)

    @cached_property
    def has_wrong_types_alone(self) -> bool:
        """Whether two joints are of another type, and the facts are right if they are read as the key's."""
        return not self.excess and self.other_types == EXCHANGED and self.wrong_facts == 0.0

    @cached_property
    def wrong_facts(self) -> float:
        """How many facts are wrong, joints of another type read as the key's."""
        key = axes_of(self.reference.chain, self.policy)
        worth, fixed = np.ones(self.n_facts), fixed_ends(len(key), self.policy)
        facts = Facts(key, self.facts, fixed, worth, sign=1.0)
        return facts.wrong(axes_of(self.chain, self.policy))

    def is_a_joint_off(self, table: NumericTable) -> bool:
        """Return whether one joint of a table is missing, superfluous or of another type, and no more."""
        ours, wanted = table.joint_types, self.reference.table.joint_types
        shorter, longer = sorted((ours, wanted), key=len)
        if len(longer) == len(shorter):
            return sum(one is not other for one, other in zip(ours, wanted, strict=True)) == 1
        return len(longer) == len(shorter) + 1 and any(
            (*longer[:k], *longer[k + 1 :]) == shorter for k in range(len(longer))
        )

    def at(self, draw: int) -> "Work":
        """Return the answer at another draw."""
        table = self.comparison.meant[draw]
        return replace(self, draw=draw, table=table, fits={}, only=None, scope=ANY_EDIT)

    def within(self, reach: tuple[int, int]) -> "Work":
        """Return the table as one that edits mend which have to do with joints from … to."""
        return replace(self, scope=self.scope._replace(reach=reach))

    def edited(self, change: Change, scope: EditScope, kept: frozenset[Place]) -> "Work":
        """Return the table with an edit made, and what another has to do with then."""
        return replace(self, table=change.of(self.table), fits={}, kept=kept, scope=scope)

    def leaves(self, columns: Sequence[str], *, prismatic: bool = True) -> bool:
        """Whether an edit of columns, perhaps but for prismatic joints, leaves earlier edits alone."""
        rows = self.table.rows
        return not any(
            cell in columns and i < len(rows) and (prismatic or rows[i].joint is not JointType.PRISMATIC)
            for i, cell in self.kept
        )

    @cached_property
    def kept_rows(self) -> frozenset[int]:
        """The rows that cannot change places with others, as an edit made before has changed them."""
        return frozenset(row for row, cell in self.kept if cell in ROW_CELLS)

    def accepts(self, change: Change, effort: Effort) -> bool:
        """Return whether an edit makes the table right, at this draw."""
        return self._are_right((self.reference,), (change.of(self.table),), effort)

    @property
    def draws_at_hand(self) -> range:
        """The draws at which edits of the table are known to be the same: all, or where it is another one."""
        return range(len(self.references)) if not self.draw else range(self.draw, self.draw + 1)

    def made_alike(self, changes: Sequence[Change], draws: range) -> list[NumericTable] | None:
        """Return what the same edits, one after the other, lead to at some draws.

        None where it is not seen what they are at another draw.
        """
        here = list(accumulate(changes, lambda table, change: change.of(table), initial=self.table))
        tables = []
        for draw in draws:
            if draw == self.draw:
                tables.append(here[-1])
                continue
            table, keys = self.comparison.meant[draw], (self.reference.table, self.references[draw].table)
            for change, mine in zip(changes, here, strict=False):
                alike = alike_at(change, (mine, table), keys)
                if alike is None:
                    return None
                table = alike.of(table)
            tables.append(table)
        return tables

    def accepts_alike(self, changes: Sequence[Change], effort: Effort, draws: range) -> bool:
        """Whether the same edits, one after the other, make the table right at some draws.

        False says nothing where it is not seen what they are at another draw.
        """
        tables = self.made_alike(changes, draws)
        return tables is not None and self._are_right([self.references[k] for k in draws], tables, effort)

    def _are_right(
        self, references: Sequence[Reference], tables: Sequence[NumericTable], effort: Effort
    ) -> bool:
        if not tables or not convention_fits(tables[0].convention, self.policy.convention):
            return not tables
        self.meter.charge(PER_ROW * len(tables) * len(tables[0].rows))
        chains = [chain_of_table(table) for table in tables]
        with self.meter.at_most(WORK_OF_ONE_EDIT):
            found = is_certified(references, chains, self.policy, effort, self.meter)
            return found and not any(map(self._has_an_end_off, references, tables))
        return False

    def _has_an_end_off(self, reference: Reference, table: NumericTable) -> bool:
        steps = self._typed_in(table)
        return not self.comparison.exact and bool(self._ends_off(reference, table, steps))

    def _typed_in(self, table: NumericTable) -> Mapping[Place, float]:
        typed_so = len(table.rows) == len(self.comparison.meant_table.rows)
        return self.comparison.steps if typed_so else NOTHING_TYPED

    def ends_beside_joints(self) -> tuple[Kind, ...]:
        """Return which rules `axis` the table does not keep, whatever else is wrong with its robot."""
        if self.table.n_joints != self.reference.table.n_joints:
            return ()
        share = share_of(self.comparison)
        return ends_beside_joints(self.reference, self.table, self._typed_in(self.table), self.policy, share)

    def _ends_off(
        self, reference: Reference, table: NumericTable, steps: Mapping[Place, float]
    ) -> tuple[Kind, ...]:
        return ends_beyond_digits(reference, table, steps, self.policy, share_of(self.comparison))
