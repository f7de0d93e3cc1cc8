"""Whether an answer is the key's own table, in whichever convention, or a length is one of its."""

import math
from typing import NamedTuple

from exercises.grading.judging.digits import PER_CENT
from kinematics.table import Convention, JointType, NumericTable


class _Link(NamedTuple):
    """A row of a modified table, but for θ, and for d where that is a variable."""

    joint: JointType
    alpha: float
    a: float
    d: float

    def either_way(self) -> "_Link":
        """Return it as it is however the axes of the frames point."""
        return _Link(self.joint, abs(math.remainder(self.alpha, math.pi)), abs(self.a), abs(self.d))

    def is_nearly(self, other: "_Link") -> bool:
        """Return whether it is another to within a per cent."""
        return (
            self.joint is other.joint
            and abs(math.remainder(self.alpha - other.alpha, math.tau)) <= PER_CENT
            and abs(self.a - other.a) <= PER_CENT * abs(other.a)
            and abs(self.d - other.d) <= PER_CENT * abs(other.d)
        )


def _links(table: NumericTable) -> list[_Link]:
    """A table in the modified convention; rows that move along and about x alone join the next one.

    Of a standard row the motion along x stands behind that along z, so it is the next link's.
    """
    links: list[_Link] = []
    behind = table.convention is Convention.STANDARD
    alpha = a = 0.0
    for row in table.rows:
        if not behind:
            alpha, a = alpha + row.alpha, a + row.a
        if row.joint is not JointType.FIXED or row.d or abs(math.sin(row.theta)) > PER_CENT:
            d = 0.0 if row.joint is JointType.PRISMATIC else row.d
            links.append(_Link(row.joint, alpha, a, d))
            alpha = a = 0.0
        if behind:
            alpha, a = alpha + row.alpha, a + row.a
    return [*links, _Link(JointType.FIXED, alpha, a, 0.0)]


def is_length_of(key: NumericTable, value: float, share: float = PER_CENT) -> bool:
    """Return whether a length, with either sign, stands in the key, to within a share of itself."""
    return any(
        abs(abs(value) - abs(length)) <= share * abs(length)
        for row in key.rows
        for length in (row.a, row.d)
        if length
    )


def is_own_table(table: NumericTable, key: NumericTable, *, either_way: bool = False) -> bool:
    """Return whether a table is the key, in either convention, but for the zeros of the variables.

    Args:
        table: the table.
        key: the key; what stands in front of its first axis and behind its last where it is written in the
            other convention is not compared.
        either_way: the axes may point either way.
    """
    mine, its = _links(table), _links(key)
    if table.convention is not key.convention:
        mine[-1] = its[-1]
        mine[0] = mine[0]._replace(alpha=its[0].alpha, a=its[0].a)
    if either_way:
        mine, its = [link.either_way() for link in mine], [link.either_way() for link in its]
    return len(mine) == len(its) and all(map(_Link.is_nearly, mine, its))
