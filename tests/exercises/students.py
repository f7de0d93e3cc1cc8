"""Simulated students, from the catalogue of misconceptions: what they hand in, what they do with a hint.

A student derived a right table in frames of their own, and made some mistakes of the catalogue in it. Told
where to look, they look there, then one row to either side (what a row says of two frames may show in the
next one), and derive afresh what they find; told of the whole table, they think again about what concerns the
whole. Who finds nothing is lost: they ask for the next rung, and on the last one they give up.

    python -m tests.exercises.students       every exercise that asks for a table
"""

import argparse
import re
import sys
from collections import Counter
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, field, replace
from itertools import chain, pairwise
from random import Random

from exercises.answers import RawAnswer, parse
from exercises.errors import AnswerError
from exercises.grader import Report, grade
from exercises.grading import Finding, HelpLevel
from exercises.grading.edits.misconceptions import CATALOGUE
from exercises.instance import Instance, generate
from exercises.selftest.answers import other_frames
from exercises.selftest.mistakes import MISTAKES
from exercises.written_table import written_table
from kinematics.cells import RawTable, ReadTable
from kinematics.table import CELLS
from service.messages import sentence
from tests.exercises.packaged import exercise, table_ids

LADDER = (HelpLevel.ROW, HelpLevel.KIND, HelpLevel.REPAIR)
MOST_ATTEMPTS = 12
CODES = [code for code in MISTAKES if code != "parameter_misnamed"]
COUNTS = tuple(entry.code for entry in CATALOGUE if entry.counts)
NAME = re.compile(r"[A-Za-zα-ω]+\d*|\d+(?:\.\d+)?")


@dataclass(frozen=True)
class Slip:
    """A mistake that a student made, and where."""

    code: str
    way: int


@dataclass
class Walk:
    """How a student went from their first answer to the last one."""

    slips: tuple[Slip, ...]
    scores: list[float] = field(default_factory=list)
    hints: list[tuple[Report, RawTable]] = field(default_factory=list)
    lost: int = 0
    beside: int = 0
    correct: bool = False


def table_with(truth: ReadTable, slips: Sequence[Slip]) -> ReadTable | None:
    """The student's table: the mistakes made in it one after another."""
    table = truth
    for slip in slips:
        ways = list(MISTAKES[slip.code](table))
        if not ways:
            return None
        table = ways[slip.way % len(ways)]
    return table


def touched(truth: ReadTable, slips: Sequence[Slip], k: int) -> tuple[int, ...] | None:
    """The rows in which a student finds their own mistake; None: it concerns the whole table."""
    before, after = table_with(truth, slips[:k]), table_with(truth, slips[: k + 1])
    assert before is not None
    assert after is not None
    rows, others = before.table.rows, after.table.rows
    if before.table.convention is not after.table.convention or before.angle_unit is not after.angle_unit:
        return None
    if len(rows) != len(others):
        first = next(
            (i for i, pair in enumerate(zip(rows, others, strict=False)) if pair[0] != pair[1]), None
        )
        return (min(len(rows), len(others)) if first is None else first,)
    changed = tuple(i for i, pair in enumerate(zip(rows, others, strict=True)) if pair[0] != pair[1])
    return changed if len(changed) <= 2 else None


def told_places(report: Report) -> tuple[list[int], bool]:
    """The rows that a report names, and whether it speaks of the table as a whole."""
    verdict = report.verdict
    assert verdict is not None
    edits = [edit for repair in verdict.repairs for edit in repair.edits]
    rows = [edit.row - 1 for edit in edits if edit.row is not None]
    rows += [
        link.row - 1
        for link in verdict.links
        if {Finding.WRONG, Finding.MISSING, Finding.HIDDEN}
        & {link.length, link.twist, link.offset, link.joint}
    ]
    rows += [entry.row - 1 for entry in verdict.feedback if entry.row is not None]
    uncertain = any(link.joint is Finding.UNKNOWN for link in verdict.links)
    whole = any(edit.row is None for edit in edits) or (uncertain and not edits)
    return list(dict.fromkeys(rows)), whole or not rows or len(rows) > 2


def walk(instance: Instance, truth: ReadTable, slips: tuple[Slip, ...]) -> Walk | None:
    """What becomes of a student; None if the answer they begin with is refused, or right all the same."""
    found = Walk(slips=slips)
    left = list(slips)
    rung = 1
    for _ in range(MOST_ATTEMPTS):
        table = table_with(truth, left)
        if table is None:
            return None
        raw = written_table(table)
        try:
            report = grade(instance, parse(instance, RawAnswer(table=raw)), attempt=rung)
        except AnswerError:
            return None
        assert report.verdict is not None
        if report.verdict.correct and not found.scores:
            return None
        found.scores.append(report.verdict.score)
        if report.verdict.correct:
            found.correct = True
            return found
        found.hints.append((report, raw))
        mended = _found_again(truth, left, report, 0)
        if mended is None:
            mended = _found_again(truth, left, report, 1)
            found.beside += mended is not None
        if mended is None:
            found.lost += 1
            if rung >= len(LADDER):
                return found
        else:
            del left[mended]
        rung = min(rung + 1, len(LADDER))
    return found


def _found_again(truth: ReadTable, slips: Sequence[Slip], report: Report, reach: int) -> int | None:
    """The slip that a student finds at the places that were told, or so many rows beside them."""
    rows, whole = told_places(report)
    near = {row + step for row in rows for step in range(-reach, reach + 1)}
    for k in range(len(slips)):
        places = touched(truth, slips, k)
        if (whole if places is None else bool(near & set(places))) or (whole and not rows):
            return k
    return None


def students(name: str, pairs: int, seed: int = 0) -> Iterator[tuple[Instance, ReadTable, tuple[Slip, ...]]]:
    """Every misconception by itself, and some of them two by two."""
    rng = Random(f"{name} {seed}")
    singles = [(code,) for code in CODES]
    yield from _who_made(name, (*singles, *(tuple(rng.sample(CODES, 2)) for _ in range(pairs))), rng)


def miscounted(name: str, seed: int = 0) -> Iterator[tuple[Instance, ReadTable, tuple[Slip, ...]]]:
    """Every misconception that changes how many joints there are, together with every other one."""
    pairs = [(count, other) for count in COUNTS for other in CODES if other not in COUNTS]
    return _who_made(name, pairs, Random(f"{name} miscounted {seed}"))


def _who_made(
    name: str, slips_made: Iterable[tuple[str, ...]], rng: Random
) -> Iterator[tuple[Instance, ReadTable, tuple[Slip, ...]]]:
    asked = exercise(name)
    held = replace(asked, access=replace(asked.access, ladder=LADDER))
    instance = generate(held)
    for chosen in slips_made:
        truth = other_frames(instance, rng)
        slips = tuple(Slip(code, rng.randrange(8)) for code in chosen)
        if table_with(truth, slips) is not None:
            yield instance, truth, slips


def revealed(found: Walk, truth: ReadTable, language: str = "en") -> list[str]:
    """Names and numbers of a right cell that some hint told though the student's table had them nowhere."""
    right = written_table(truth)
    leaks = []
    for report, raw in found.hints:
        own = set(NAME.findall(" ".join(str(getattr(row, cell)) for row in raw.rows for cell in CELLS)))
        counts = {str(k) for k in range(len(raw.rows) + 3)}
        new = set(NAME.findall(" ".join(str(getattr(row, c)) for row in right.rows for c in CELLS)))
        secret = {name for name in new - own - counts if not re.fullmatch(r"q\d+", name)}
        for text in sentences(report, language):
            leaks += [f"{name}: {text}" for name in secret & set(NAME.findall(text))]
    return leaks


def sentences(report: Report, language: str) -> list[str]:
    """Everything that a report says of a table."""
    verdict = report.verdict
    assert verdict is not None
    told = [(f"feedback-{entry.code}", entry.row, entry.params) for entry in verdict.feedback]
    told += [
        (f"repair-{edit.code}", edit.row, edit.params) for repair in verdict.repairs for edit in repair.edits
    ]
    return [
        sentence(language, name, params if row is None else {"before": row - 1, "row": row, **params})
        or f"[{name}]"
        for name, row, params in told
    ]


def score_of(instance: Instance, table: ReadTable) -> float | None:
    """What a table earns; None if it is refused."""
    try:
        verdict = grade(instance, parse(instance, RawAnswer(table=written_table(table)))).verdict
    except AnswerError:
        return None
    assert verdict is not None
    return verdict.score


def falling(name: str, count: int, seed: int = 0) -> Iterator[tuple[tuple[Slip, ...], list[float]]]:
    """Marks of students who have one fact more of the key wrong than the one before.

    In frames of one's own two slips may undo each other; in the key every fact stands in one cell.
    """
    instance = generate(exercise(name))
    rng = Random(f"{name} falling {seed}")
    facts = ("alpha_value", "a_value", "d_value", "joint_type", "theta_value")
    for _ in range(count):
        truth = instance.exercise.reference
        rows = list(range(len(truth.table.rows)))
        rng.shuffle(rows)
        slips: list[Slip] = []
        scores = [1.0]
        tables = [truth]
        for row in rows:
            code = rng.choice(facts)
            ways = list(MISTAKES[code](tables[-1]))
            at = [k for k, way in enumerate(ways) if way.table.rows[row] != tables[-1].table.rows[row]]
            if not at:
                continue
            score = score_of(instance, ways[at[0]])
            if score is None or (score == 1.0 and not slips):
                continue  # it is refused, or a cell that is free in this robot
            slips.append(Slip(code, at[0]))
            tables.append(ways[at[0]])
            scores.append(score)
        yield tuple(slips), scores


def main() -> None:
    """Say how students fare in every exercise."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--pairs", type=int, default=20)
    parser.add_argument("--only", nargs="*", default=table_ids)
    options = parser.parse_args()
    total: Counter[str] = Counter()
    for name in options.only:
        count: Counter[str] = Counter()
        for instance, truth, slips in chain(students(name, options.pairs), miscounted(name)):
            found = walk(instance, truth, slips)
            if found is None:
                continue
            count.update(
                students=1,
                reached=found.correct,
                lost=found.lost,
                beside=found.beside,
                attempts=len(found.scores),
            )
            leaks = revealed(found, truth)
            count["revealed"] += len(leaks)
            if leaks or not found.correct:
                sys.stdout.write(f"  {name} {slips} {found.scores} {leaks}\n")
        chains = list(falling(name, options.pairs))
        rises = [(s, m) for s, m in chains if any(b > a for a, b in pairwise(m))]
        count.update(chains=len(chains), rises=len(rises))
        for slips, scores in rises:
            sys.stdout.write(f"  {name} {slips} {scores}\n")
        sys.stdout.write(f"{name}: {dict(count)}\n")
        sys.stdout.flush()
        total += count
    sys.stdout.write(f"all: {dict(total)}\n")


if __name__ == "__main__":
    main()
