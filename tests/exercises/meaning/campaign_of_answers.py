"""The campaigns of the kinds, and what comes of one."""

from __future__ import annotations

import random
import time
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field
from statistics import median

from tests.exercises.meaning import (
    decisions,
    jacobian_numbers,
    moving_arms,
    posed_answers,
    screw_cells,
    solved_poses,
    turned_answers,
)
from tests.exercises.meaning.answers_known import KnownAnswer

CAMPAIGNS: Mapping[str, Callable[[random.Random], Iterator[KnownAnswer]]] = {
    "joint-values": solved_poses.joint_values,
    "rotations": decisions.rotations,
    "orientations": turned_answers.orientations,
    "rotation-claims": turned_answers.rotation_claims,
    "poses": posed_answers.poses,
    "frame-chains": posed_answers.frame_chains,
    "closed-forms": posed_answers.closed_forms,
    "screws": screw_cells.screws,
    "jacobians": jacobian_numbers.jacobians,
    "closed-jacobians": decisions.closed_jacobians,
    "singularities": decisions.singularities,
    "equations-of-motion": moving_arms.equations_of_motion,
    "mended-tables": decisions.mended_tables_of_students,
    "mended-figures": decisions.mended_figures,
    "mended-matrices": decisions.mended_matrices_of_students,
    "compared-tables": decisions.compared_tables,
}


@dataclass
class Tally:
    """What came of some answers: how many were right and wrong, which were misjudged, and times [ms]."""

    right: int = 0
    wrong: int = 0
    misjudged: list[str] = field(default_factory=list)
    times: dict[bool, list[float]] = field(default_factory=lambda: {True: [], False: []})

    def __iadd__(self, other: Tally) -> Tally:
        self.right += other.right
        self.wrong += other.wrong
        self.misjudged += other.misjudged
        for truth, times in other.times.items():
            self.times[truth] += times
        return self

    @property
    def told(self) -> str:
        """In a line."""
        refused = sum(entry.startswith("refused") for entry in self.misjudged)
        took = ", ".join(
            f"{'right' if truth else 'wrong'} {median(times):.2f} ms"
            for truth, times in self.times.items()
            if times
        )
        return (
            f"{self.right} right, {refused} refused; {self.wrong} wrong, "
            f"{len(self.misjudged) - refused} accepted; median processor time {took}"
        )


def judged_answers(name: str, block: int, count: int) -> Tally:
    """Judge some hundred answers of a kind; the same ones for a block."""
    rng, found = random.Random(f"{name} {block}"), Tally()
    while found.right + found.wrong < count:
        for answer in CAMPAIGNS[name](rng):
            start = time.process_time()
            try:
                said = answer.judge()
            except Exception as error:  # a crash is neither right nor wrong
                found.misjudged.append(f"crashed: {error!r} {answer.told()}")
                continue
            found.times[answer.right].append(1e3 * (time.process_time() - start))
            if answer.right:
                found.right += 1
            else:
                found.wrong += 1
            if said is not answer.right:
                found.misjudged.append(f"{'refused' if answer.right else 'accepted'}: {answer.told()}")
    return found
