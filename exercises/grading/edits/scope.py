"""What an edit must have to do with, so that it may mend all that is wrong: no other needs to be tried."""

from collections.abc import Callable, Collection
from typing import NamedTuple, TypeAlias

from exercises.grading.judging.typed import Place

REACH_OF_A_ROW = 1
"""Two rows exchanged, the widest of the edits in a row, change the links before, between and after them."""
FAR = 10**6  # Behind the last axis of any chain.
EVERYWHERE = (0, FAR)

Off: TypeAlias = tuple[bool, bool, bool]
"""Whether angles are off, and lengths, that no choice of frames changes; and others, joints being zero."""
ANYTHING: Off = (True, True, True)
LeftWrong: TypeAlias = Callable[[Collection[Place], Callable[[int, str], float]], bool]


def _nothing_is_known(_: Collection[Place], __: Callable[[int, str], float]) -> bool:
    return False


class EditScope(NamedTuple):
    """What is known of the edits that may mend a table; at first nothing.

    Attributes:
        reach: what an edit has to do with, to mend all that is wrong: joints from … to, counted from 1; where
            there is one too many or too few, the places of it.
        angular: an angle is wrong that no choice of frames changes: lengths alone do not mend it.
        off: what is off, if only by what need not be mended: other values of cells are found from that.
        lacking: columns in which an entry has a size that an edit must change, to mend all that is wrong.
        is_left_wrong: whether an edit is seen not to mend all, by the places that it changes and what each
            becomes.
    """

    reach: tuple[int, int] = EVERYWHERE
    angular: bool = False
    off: Off = ANYTHING
    lacking: frozenset[str] = frozenset()
    is_left_wrong: LeftWrong = _nothing_is_known

    @property
    def meet(self) -> bool:
        """Whether all that is wrong meets at one place of the chain, so that one edit might mend it."""
        start, end = self.reach
        return start - end <= -REACH_OF_A_ROW

    def is_place(self, joint: int) -> bool:
        """Return whether the joint that is missing may have this place, counted from 1."""
        start, end = self.reach
        return start <= joint <= end


ANY_EDIT = EditScope()
