"""Which changes of the catalogue are worth trying on a table."""

from collections.abc import Iterator

from exercises.grading.edits.changes import Change
from exercises.grading.edits.misconceptions import CATALOGUE
from exercises.grading.edits.work import Work


def changes_of(work: Work) -> Iterator[Change]:
    """Yield every wanted change of the catalogue with which a table may have the key's joints."""
    excess, only, lacking, others = work.excess, work.only, work.scope.lacking, work.other_types
    for misconception in CATALOGUE:
        if (
            (misconception.counts if excess else not others or 0 < misconception.types <= others)
            and (only is None or misconception.may_be(only))
            and lacking <= misconception.sizes
        ):
            yield from misconception.changes(work)


def changes_beforehand(work: Work) -> Iterator[Change]:
    """Yield changes of a table with other joints than the key's that leave one too many or too few.

    A change that mends the joints may come after.
    """
    if work.has_the_joints():
        return
    only = work.only
    for misconception in CATALOGUE:
        if misconception.beforehand and (only is None or misconception.may_be(only)):
            yield from (
                change
                for change in misconception.changes(work)
                if (only is None or change.slip == only)
                and work.is_a_joint_off(work.table if change.table is None else change.table)
            )
