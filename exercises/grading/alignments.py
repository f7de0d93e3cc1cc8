"""How the joints of an answer may stand beside those of the key where they are not as many.

With a row goes a joint and one of the links beside it, so what is matched is links, in order, as in an edit
distance; between two of them stands a joint of the answer for one or more of the key, or the reverse.
"""

from collections.abc import Iterator, Sequence
from functools import lru_cache
from itertools import chain, combinations, islice, pairwise
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from kinematics.caching import USUAL_ROWS, cached_by_size

MOST_ALIGNMENTS = 1000  # In how many ways joints are placed beside the key's at the most.
NOT_THERE = 1 << 20  # The shift of a link that the answer lacks.


class Alignments(NamedTuple):
    """All ways in which the links of an answer may be those of the key.

    Attributes:
        shifts: (k, links) by how much further behind in the key each of its links is than in the answer.
        others: for each way the joints of the key that are of another type in the answer.
    """

    shifts: NDArray[np.intp]
    others: tuple[tuple[int, ...], ...]


@lru_cache(maxsize=256)
def alignments(ours: tuple[bool, ...], theirs: tuple[bool, ...]) -> Alignments:
    """Return the ways to match links of the key and an answer, by which of their axes are prismatic.

    The first axis stands for the base and the last for the tool; neither is a joint, and both stay there.
    """
    fewer, more = sorted((len(ours) - 1, len(theirs) - 1))
    shifts = []
    for left_out in islice(_left_out(more, more - fewer), MOST_ALIGNMENTS):
        kept = [link for link in range(more) if link not in left_out]
        if fewer == len(ours) - 1:
            shifts.append([i - link for i, link in enumerate(kept)])
        else:
            beside = {link: link - i for i, link in enumerate(kept)}
            shifts.append([beside.get(link, NOT_THERE) for link in range(more)])
    return Alignments(np.array(shifts, dtype=np.intp), tuple(_others(ours, theirs, one) for one in shifts))


@cached_by_size(lambda ours, theirs, pairs: len(ours), longest=USUAL_ROWS, most=256, few=8)
def shifts_between(
    ours: tuple[bool, ...], theirs: tuple[bool, ...], pairs: tuple[tuple[int, int], ...]
) -> NDArray[np.intp]:
    """Return the common shift of the links between pairs of axes, or that they are not there side by side.

    Args:
        ours: as for `alignments`.
        theirs: likewise.
        pairs: the numbers of the first and the last axis.

    Returns:
        (pairs, k), for each of the ways in which the links are matched.
    """
    shifts = alignments(ours, theirs).shifts
    between = [shifts[:, first:last] for first, last in pairs]
    common = [np.where((some == some[:, :1]).all(axis=1), some[:, 0], NOT_THERE) for some in between]
    return np.array(common, dtype=np.intp).reshape(len(pairs), len(shifts))


def _left_out(links: int, some: int) -> Iterator[tuple[int, ...]]:
    """Which of so many links, but for those at both ends, may be left out: side by side first."""
    together = (tuple(range(i, i + some)) for i in range(1, links - some))
    return chain(together, combinations(range(1, links - 1), some)) if some else iter(((),))


def _others(ours: Sequence[bool], theirs: Sequence[bool], shifts: Sequence[int]) -> tuple[int, ...]:
    """The first of the key's joints wherever none between two links has the type of one of the answer."""
    there = [i for i, shift in enumerate(shifts) if shift != NOT_THERE]
    return tuple(
        before + 1
        for before, behind in pairwise(there)
        if set(ours[before + 1 : behind + 1]).isdisjoint(
            theirs[before + 1 - shifts[before] : behind + 1 - shifts[behind]]
        )
    )
