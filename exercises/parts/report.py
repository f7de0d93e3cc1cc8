"""What is said of an answer to one part."""

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from enum import StrEnum

from exercises.definition import Part
from exercises.grading import Feedback, Finding, HelpLevel

PLACES = 6  # Decimals of points: what floating-point arithmetic leaves behind them is not shown.


class Credit(StrEnum):
    """What the points of a part rest on.

    KEY: the answer is right for the robot.
    OWN_TABLE: it is not, or may not be, but it follows from the student's own table, so that an error costs
        points once.
    NONE: neither.
    """

    KEY = "key"
    OWN_TABLE = "own_table"
    NONE = "none"


@dataclass(frozen=True, kw_only=True, slots=True)
class Fact:
    """One thing that an answer says, and what was found of it.

    Attributes:
        where: path inside the part's answer, such as ("relations", 1) or (2, 0, 3).
        finding: right, wrong, missing or hidden.
    """

    where: tuple[str | int, ...]
    finding: Finding


@dataclass(frozen=True, kw_only=True, slots=True)
class PartReport:
    """What is said of an answer to one part.

    Attributes:
        kind: which part.
        correct: the answer is right for the robot.
        score: 0 … 1, what it earns; an answer that follows from a wrong table earns its points, too.
        points: score times what the part is worth.
        max_points: what the part is worth.
        credit: what the points rest on.
        facts: the single findings, if the help level shows them.
        feedback: what to tell the student.
    """

    kind: str
    correct: bool
    score: float
    points: float
    max_points: float
    credit: Credit
    facts: tuple[Fact, ...] = ()
    feedback: tuple[Feedback, ...] = ()


def fact(right: bool, *where: str | int) -> Fact:
    """Return what was found of one thing that is right or wrong."""
    return Fact(where=where, finding=Finding.OK if right else Finding.WRONG)


def judged(
    part: Part,
    score: float,
    credit: Credit,
    *,
    correct: bool | None = None,
    facts: Iterable[Fact] = (),
    feedback: Iterable[Feedback] = (),
) -> PartReport:
    """Return the report on a part.

    Args:
        score: 0 … 1.
        credit: what the points rest on; nothing, if there are none.
        correct: right for the robot; left out: all points, if they rest on the key.
    """
    credit = credit if score else Credit.NONE
    points = float(part.points)
    return PartReport(
        kind=part.kind,
        correct=(score == 1.0 and credit is Credit.KEY) if correct is None else correct,
        score=score,
        points=round(points * score, PLACES),
        max_points=points,
        credit=credit,
        facts=tuple(facts),
        feedback=tuple(feedback),
    )


def share_earned(right: Sequence[bool], nothing: Sequence[bool]) -> float:
    """Return the share of facts that are right, less what an answer that says nothing has right.

    What that has right weighs no more than all the rest: if of nine facts eight are right for nothing, one of
    these costs an eighth.

    Args:
        right: which facts an answer has right.
        nothing: which of them an answer of zeros has right.
    """
    given = sum(nothing)
    earned = len(right) - given
    if not earned:
        return float(all(right))
    weights = [min(1.0, earned / given) if free else 1.0 for free in nothing]
    lost = sum(weight for good, weight in zip(right, weights, strict=True) if not good)
    return max(0.0, 1.0 - lost / earned)


@dataclass(frozen=True, kw_only=True, slots=True)
class Disclosure:
    """From which level of help on a feedback is told, and what is told instead below it.

    Attributes:
        level: the first level that tells it.
        instead: code of a coarser feedback with the same parameters, or None to say nothing.
    """

    level: HelpLevel
    instead: str | None = None


def told_from(level: HelpLevel, *codes: str, instead: str | None = None) -> dict[str, Disclosure]:
    """Return the disclosure of feedback that is told from one level of help on.

    Args:
        instead: code of the coarser feedback below it, if there is one.
    """
    return dict.fromkeys(codes, Disclosure(level=level, instead=instead))


def shown(report: PartReport, help_level: HelpLevel, disclosures: Mapping[str, Disclosure]) -> PartReport:
    """Return the report as a level of help shows it.

    An answer that is not right is never left without a word.

    Args:
        disclosures: by code; feedback that is not listed is always told.
    """
    told: list[Feedback] = []
    for entry in report.feedback:
        code: str | None = entry.code
        while code is not None and code in disclosures and not help_level.includes(disclosures[code].level):
            code = disclosures[code].instead
        spoken = None if code is None else replace(entry, code=code)
        if spoken is not None and spoken not in told:
            told.append(spoken)
    if not told and not report.correct:
        told.append(Feedback(code="part_wrong"))
    facts = report.facts if help_level.includes(HelpLevel.ROW) else ()
    return replace(report, facts=facts, feedback=tuple(told))
