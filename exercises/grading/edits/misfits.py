"""What of the key tables do not have, many at once, told from what no choice of frames changes."""

from functools import cached_property
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from exercises.grading.axis_directions import fixed_ends, fixed_signs, least_cost
from exercises.grading.edits.fitting import OFF
from exercises.grading.edits.scope import FAR, REACH_OF_A_ROW, EditScope
from exercises.grading.edits.work import Work
from kinematics.equivalence import DirectionRule


class Misfit(NamedTuple):
    """What of the key one table does not have.

    Attributes:
        failing: how many facts fail, whichever way the axes point.
        misplaced: how many others fail: signs, where the directions of the variables are fixed, and what lies
            between axes that are no neighbours, where their zeros are.
        scope: what an edit must have to do with that mends all facts that fail, or, if none does, all that
            is misplaced.
    """

    failing: int
    misplaced: int
    scope: EditScope


class Misfits:
    """What of the key tables do not have.

    Attributes:
        found: (q, k) their invariants, from which it is told.
    """

    def __init__(self, work: Work, found: NDArray[np.float64]) -> None:
        self._invariants, self._facts, self.found = work.invariants, work.n_facts, found
        self._axes = len(work.reference.chain.axes) + 2
        self._fixed = fixed_ends(self._axes, work.policy)
        self._strains = self._invariants.strains(found)
        self._failing = self._strains > 1.0
        self._counts = self._failing[: self._facts].sum(axis=0)
        if work.policy.direction is DirectionRule.FIGURE:
            self._fixed = (*self._fixed, *range(1, self._axes - 1))
            pointing = fixed_signs(self._invariants.shapes, self._fixed)
            self._failing[pointing] |= ~self._invariants.fits(found)[0][pointing]
        self._misplaced = self._failing.sum(axis=0) - self._counts

    def might_be_none(self) -> list[int]:
        """Return the numbers of those in which nothing fails, if axes are turned so that the signs agree."""
        which = np.flatnonzero((self._counts == 0) & (self._misplaced == 0))
        if which.size:
            fits = self._invariants.fits(self.found[:, which])
            if not fits[0].all():
                costs = (~fits).astype(float)
                sums = least_cost(self._invariants.shapes, self._axes, costs, self._fixed)
                which = which[sums == 0.0]
        numbers: list[int] = which.tolist()
        return numbers

    @cached_property
    def told(self) -> list[Misfit]:
        """What of the key each does not have."""
        counts, failing, facts = self._counts, self._failing, self._facts
        angular, strained = self._invariants.angular, self._strains > OFF
        angles = angular[:facts]
        kinds = (strained[:facts] & angles, strained[:facts] & ~angles, strained[facts:])
        off = zip(*(some.any(axis=0).tolist() for some in kinds), strict=True)
        if self._misplaced.any():
            failing = failing & ((counts == 0) | (self._strains > 1.0))
            failing[facts:, counts > 0] = False
        first, last = self._invariants.spans
        starts = np.where(failing, first, 0).max(axis=0, initial=0) - REACH_OF_A_ROW
        ends = np.where(failing, last, FAR).min(axis=0, initial=FAR) + REACH_OF_A_ROW
        reaches = zip(starts.tolist(), ends.tolist(), strict=True)
        of_angles: list[bool] = np.asarray((failing & angular).any(axis=0)).tolist()
        scope = map(EditScope, reaches, of_angles, off)
        misplaced: list[int] = self._misplaced.tolist()
        return list(map(Misfit, counts.tolist(), misplaced, scope))
