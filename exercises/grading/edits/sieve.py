"""Facts that stand in the entries of a table: what an edit leaves wrong is seen there, without measuring.

Where one row leads from a joint to the next, its α is the angle between the two axes and its `a` their
distance; the offset along a run of parallel axes is the sum of their d, each counted as its axis points. So
an edit after which such an entry is not the key's does not make the table right, whatever else it does. Where
fixed rows or prismatic joints stand between, or axes are parallel only nearly, nothing is said.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Collection, Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import lru_cache
from typing import NamedTuple, TypeAlias

from exercises.grading.edits.changes import Change
from exercises.grading.edits.scope import EditScope
from exercises.grading.edits.work import Work
from exercises.grading.judging.typed import SAME, Place
from kinematics.caching import USUAL_ROWS, cached_by_size
from kinematics.equivalence.invariants import Invariants
from kinematics.equivalence.measures import PLAIN_OFFSET, Measure, Shape
from kinematics.table import Convention, JointType, NumericRow, NumericTable

CLEARLY = 1.01  # A share of the slack: what is off by hardly more than it is left to be measured.


Bounds: TypeAlias = Sequence[tuple[float, float]]
"""Of every fact its size in the key, and how far it may be off."""


@dataclass(frozen=True, eq=False, slots=True)
class LegibleFact:
    """A fact that stands in entries.

    Attributes:
        number: which of the facts.
        column: α for an angle, `a` for a distance, d for an offset.
        rows: the rows in which it stands, counted from 0; of an offset those of the joints of the run.
        links: the rows whose α are zero or π, or else the fact is not seen in the entries.
        places: the cells on which it depends.
    """

    number: int
    column: str
    rows: tuple[int, ...]
    links: tuple[int, ...]
    places: frozenset[Place]

    def is_wrong(self, bounds: Bounds, rows: Sequence[NumericRow], changed: Mapping[Place, float]) -> bool:
        """Return whether it is seen not to be the key's, in rows of which some cells are changed."""
        first, column = self.rows[0], self.column
        target, slack = bounds[self.number]
        value: float = changed.get((first, column), getattr(rows[first], column))
        if column == "alpha":
            twist = abs(math.remainder(value, math.tau))
            return abs(min(twist, math.pi - twist) - target) > slack
        if not self.links:
            return abs(abs(value) - target) > slack
        twists = [changed.get((row, "alpha"), rows[row].alpha) for row in self.links]
        if any(abs(math.sin(twist)) > SAME for twist in twists):
            return False
        way = 1.0
        for row, twist in zip(self.rows[1:], twists, strict=False):
            way = math.copysign(1.0, way * math.cos(twist))
            value += way * changed.get((row, column), getattr(rows[row], column))
        return abs(abs(value) - target) > slack


class LegibleFacts(NamedTuple):
    """The facts that stand in the entries of tables with the same rows.

    Attributes:
        facts: all of them.
        at: the facts by the cells on which they depend.
        bounds: what they are held to.
    """

    facts: Sequence[LegibleFact]
    at: Mapping[Place, Sequence[LegibleFact]]
    bounds: Bounds

    def wrong(self, rows: Sequence[NumericRow]) -> list[LegibleFact]:
        """Return the facts that are seen not to be the key's."""
        return [fact for fact in self.facts if fact.is_wrong(self.bounds, rows, {})]

    def _is_right_angle(self, place: Place) -> bool:
        """Whether the key's angle, where it stands at such a place, is one."""
        return any(
            fact.column == "alpha" and abs(math.sin(2.0 * self.bounds[fact.number][0])) <= SAME
            for fact in self.at.get(place, ())
        )

    def leave_wrong(
        self, change: Change, rows: Sequence[NumericRow], before: Iterable[LegibleFact], most: int
    ) -> bool:
        """Return whether a change leaves too many facts wrong, but for those of cells yet to be solved for.

        But if none may be wrong, α has to be right where the key's is a right angle: each of these is tried.

        Args:
            change: the change.
            rows: the rows that it is made in.
            before: the facts that are wrong in these without it; asked for once where no cell is changed.
            most: how many may be.
        """
        changed = {(row, cell): value for row, cell, value in change.cells}
        free = {(change.row or 0, cell) for cell in change.unsolved}
        if free and not most:
            free = {place for place in free if place[1] != "alpha" or not self._is_right_angle(place)}
        for fact in before:
            is_wrong = fact.places.isdisjoint(changed) or fact.is_wrong(self.bounds, rows, changed)
            if is_wrong and free.isdisjoint(fact.places):
                most -= 1
                if most < 0:
                    return True
        touched = {fact for place in changed for fact in self.at.get(place, ())}
        for fact in touched.difference(before):
            if fact.is_wrong(self.bounds, rows, changed) and free.isdisjoint(fact.places):
                most -= 1
                if most < 0:
                    return True
        return False


class Sieve:
    """Holds back the edits of a table after which too many entries are seen not to be the key's.

    Attributes:
        wrong: the facts that are seen to be wrong in the table itself; none if its joints are not the key's.
    """

    def __init__(self, work: Work, most: int = 0) -> None:
        """Prepare it.

        Args:
            work: the table.
            most: how many facts an edit may leave wrong.
        """
        self._work, self._rows, self._most = work, work.table.rows, most
        self._known = work.invariants, work.n_facts
        self._wrong_in: dict[int, tuple[Sequence[LegibleFact], NumericTable]] = {}
        self.wrong: Sequence[LegibleFact] = ()
        if work.has_the_joints():
            self._entries = self._of(work.table)
            self.wrong = self._entries.wrong(self._rows)

    def _of(self, table: NumericTable) -> LegibleFacts:
        joints = tuple(row.joint for row in table.rows)
        return legible_facts(*self._known, table.convention, joints)

    def holds_back(self, change: Change) -> bool:
        """Return whether too much is seen to be wrong after a change that leads to the key's joints."""
        table = change.table
        if table is None:
            return self._entries.leave_wrong(change, self._rows, self.wrong, self._most)
        facts, rows = self._of(table), table.rows
        if not change.cells:  # seldom is all of it asked for
            wrong = (fact for fact in facts.facts if fact.is_wrong(facts.bounds, rows, {}))
            return facts.leave_wrong(change, rows, wrong, self._most)
        if id(table) not in self._wrong_in:  # the same with another row put in, of which each α is tried
            self._wrong_in[id(table)] = facts.wrong(rows), table
        return facts.leave_wrong(change, rows, self._wrong_in[id(table)][0], self._most)

    def _leaves_wrong(self, places: Collection[Place], becomes: Callable[[int, str], float]) -> bool:
        """Whether the first of what is wrong is left so; see `EditScope`."""
        fact = self.wrong[0]
        changed = {place: becomes(*place) for place in fact.places if place in places}
        return not changed or fact.is_wrong(self._entries.bounds, self._rows, changed)

    def concerned(self) -> Work:
        """Return the table, narrowed to what an edit must concern if it is to mend anything."""
        if len(self.wrong) <= self._most:
            return self._work
        start = min(self._work.joints_up_to[fact.rows[0]] for fact in self.wrong)
        end = max(self._work.joints_up_to[fact.rows[-1]] for fact in self.wrong)
        return self._work.within((start, end))

    def narrowed(self) -> Work:
        """Return the table, narrowed to what an edit must concern to mend all that is seen to be wrong."""
        if not self.wrong:
            return self._work
        start, end = self._work.scope.reach
        for fact in self.wrong:
            start = max(start, self._work.joints_up_to[fact.rows[0]])
            end = min(end, self._work.joints_up_to[fact.rows[-1]])
        lacking = frozenset(fact.column for fact in self.wrong if len(fact.rows) == 1)
        angular = self._work.scope.angular or "alpha" in lacking
        known = EditScope((start, end), angular, self._work.scope.off, lacking, self._leaves_wrong)
        return replace(self._work, scope=known)


@cached_by_size(
    lambda invariants, n_facts, convention, joints: len(joints), longest=USUAL_ROWS, most=256, few=32
)
def legible_facts(
    invariants: Invariants, n_facts: int, convention: Convention, joints: tuple[JointType, ...]
) -> LegibleFacts:
    """Return what is seen in the entries of a table with the key's joints.

    Args:
        invariants: the key's, with the slack that an answer has.
        n_facts: how many of them are facts, whatever the policy says of the zeros.
        convention: the table's.
        joints: the types of joints, row by row.
    """
    return LegibleFacts(*_seen(invariants.shapes[:n_facts], convention, joints), _bounds(invariants))


@lru_cache(maxsize=8)
def _bounds(invariants: Invariants) -> Bounds:
    sizes, slacks = invariants.own_sizes[:, 0].tolist(), (CLEARLY * invariants.slacks)[:, 0].tolist()
    return list(zip(sizes, slacks, strict=True))


@cached_by_size(lambda shapes, convention, joints: len(joints), longest=USUAL_ROWS, most=1024, few=32)
def _seen(
    shapes: tuple[Shape, ...], convention: Convention, joints: tuple[JointType, ...]
) -> tuple[Sequence[LegibleFact], Mapping[Place, Sequence[LegibleFact]]]:
    """The facts, and by cells; the same for all students of an exercise, whatever their values."""
    rows = [row for row, joint in enumerate(joints) if joint is not JointType.FIXED]
    standard = convention is Convention.STANDARD

    def link(i: int, j: int) -> int | None:
        """Return the one row that leads from joint i to joint j, both counted from 1."""
        if i < 1 or j != i + 1 or j > len(rows) or rows[j - 1] != rows[i - 1] + 1:
            return None
        return rows[i - 1] if standard else rows[j - 1]

    found: list[LegibleFact] = []
    at: dict[Place, list[LegibleFact]] = {}

    def keep(number: int, column: str, rows: tuple[int, ...], links: tuple[int, ...] = ()) -> None:
        places = frozenset({(row, column) for row in rows} | {(row, "alpha") for row in links})
        found.append(LegibleFact(number, column, rows, links, places))
        for place in places:
            at.setdefault(place, []).append(found[-1])

    for number, (measure, axes) in enumerate(shapes):
        if measure is Measure.OFFSET and len(axes) == PLAIN_OFFSET:
            before, first, last, after = axes
            links = [link(k, k + 1) for k in range(first, last)]
            inside = tuple(row for row in links if row is not None)
            if len(inside) == len(links) and None not in (link(before, first), link(last, after)):
                keep(number, "d", tuple(rows[first - 1 : last]), inside)
        elif measure in (Measure.ANGLE, Measure.DISTANCE) and (row := link(*axes[:2])) is not None:
            if measure is Measure.ANGLE:
                keep(number, "alpha", (row,))
            elif len(axes) == 3 or set(axes[2:]) == set(axes[:2]):
                keep(number, "a", (row,), (row,) if len(axes) == 3 else ())
    return found, at
