"""What to say of a wrong answer: what is wrong, and what the help level lets through."""

from collections.abc import Iterable, Iterator, Sequence

from exercises.grading.edits.accused import Accused
from exercises.grading.edits.changes import Change, Extent
from exercises.grading.edits.misconceptions import HINTS
from exercises.grading.edits.repaired import Repaired
from exercises.grading.edits.throughout import ROUNDED
from exercises.grading.judging.judgement import lacks_precision
from exercises.grading.verdict import Edit, Feedback, Finding, HelpLevel, LinkFinding, ParamValue, Repair
from kinematics.equivalence import Decision, Kind, Mismatch, Policy
from kinematics.table import VARIABLE_CELLS, JointType, NumericTable

FACTS = ("length", "twist", "offset", "joint")

_FACT_OF_KIND = {
    Kind.LENGTH: "length",
    Kind.TWIST: "twist",
    Kind.OFFSET: "offset",
    Kind.JOINT_TYPE: "joint",
}
MISSING_ROWS = frozenset({"row_missing", "fixed_row_missing"})
_SIGNS = {"alpha_sign": "α", "a_sign": "a", "d_sign": "d"}
_CODE_OF_FACT = {
    "length": "length_wrong",
    "twist": "twist_wrong",
    "offset": "offset_wrong",
    "angle": "angle_wrong",
    "joint": "joint_type_wrong",
}


def wrong_facts(decision: Decision, told: Accused, table: NumericTable) -> frozenset[tuple[int, str]]:
    """Return the wrong facts as (row counted from 0, fact): of the likeliest repair, else of the diagnosis.

    Where other cells would mend the table as well, nobody can say which one is wrong, and all of them count.
    """
    if told.changes:
        return frozenset(fact for change in told.changes for fact in _facts_of(change, table))
    return frozenset(
        (m.row, _FACT_OF_KIND[m.kind])
        for m in decision.mismatches
        if m.row is not None and m.kind in _FACT_OF_KIND
    )


_FACT_OF_CELL = {"a": "length", "alpha": "twist", "joint": "joint"}


def _facts_of(change: Change, table: NumericTable) -> frozenset[tuple[int, str]]:
    """The facts that an edit concerns; zero and direction of a variable belong to the joint.

    Of a fixed row both d and θ may be wrong; of any other one of them is the variable.
    """
    if _is_of_variable(change, table):
        return frozenset((row, "joint") for row, _ in change.places)
    fixed = {row for row, given in enumerate(table.rows) if given.joint is JointType.FIXED}
    return frozenset(
        (row, "angle" if cell == "theta" and row in fixed else _FACT_OF_CELL.get(cell, "offset"))
        for row, cell in change.places
    )


def _is_of_variable(change: Change, table: NumericTable) -> bool:
    """Whether an edit concerns the cell in which a joint variable stands, and that alone."""
    return change.extent is Extent.CELL and all(
        row < len(table.rows) and cell == VARIABLE_CELLS.get(table.rows[row].joint)
        for row, cell in change.places
    )


def link_findings(
    table: NumericTable,
    wrong: frozenset[tuple[int, str]],
    decision: Decision,
    told: Accused,
    level: HelpLevel,
) -> tuple[LinkFinding, ...]:
    """Return what is right and wrong row by row, as far as the help level tells."""
    if not level.includes(HelpLevel.ROW):
        return ()
    missing = {change.places[0][0] for change in told.changes if change.code in MISSING_ROWS}
    judged = (
        bool(told.changes)
        or decision.same_robot
        or all(m.kind is not Kind.JOINT_COUNT for m in decision.mismatches)
    )
    found = []
    for row in range(len(table.rows)):
        off = set() if row in missing else {fact for at, fact in wrong if at == row}
        if "angle" in off:
            off.add("offset")
        facts = {fact: Finding.WRONG if fact in off else Finding.OK for fact in FACTS}
        if not judged:
            facts = dict.fromkeys(FACTS, Finding.UNKNOWN)
        if level is HelpLevel.ROW and Finding.WRONG in facts.values():
            facts = dict.fromkeys(FACTS, Finding.HIDDEN)
        found.append(LinkFinding(row=row + 1, **facts))
    found += [LinkFinding(row=row + 1, **dict.fromkeys(FACTS, Finding.MISSING)) for row in sorted(missing)]
    return tuple(found)


def all_right(table: NumericTable) -> tuple[LinkFinding, ...]:
    """Return the findings of a right answer."""
    return tuple(
        LinkFinding(row=row + 1, **dict.fromkeys(FACTS, Finding.OK)) for row in range(len(table.rows))
    )


def feedback_of(
    decision: Decision,
    told: Accused,
    wrong: frozenset[tuple[int, str]],
    key: NumericTable,
    table: NumericTable,
    policy: Policy,
    level: HelpLevel,
) -> tuple[Feedback, ...]:
    """Return what to tell of a wrong answer, as far as the help level goes."""
    imprecise = not told.changes and lacks_precision(decision)
    found = [Feedback(code=_headline(decision, imprecise, level))]
    found += _about_the_whole(decision, key, table, policy, level)
    if imprecise and level.includes(HelpLevel.ROW):
        found.append(Feedback(code="entries_imprecise"))
    if level.includes(HelpLevel.ROW):
        found += _in_place(wrong, told, table, level)
    return tuple(found)


def _headline(decision: Decision, imprecise: bool, level: HelpLevel) -> str:
    """The code of the first sentence: of too few digits nobody can say that they mean another robot."""
    if not decision.same_robot:
        return "not_accepted" if imprecise else "not_equivalent"
    return "right_robot" if level.includes(HelpLevel.ROW) else "not_accepted"


def _in_place(
    wrong: frozenset[tuple[int, str]], told: Accused, table: NumericTable, level: HelpLevel
) -> Iterator[Feedback]:
    """Where something is wrong, and from `kind` on what: by the likeliest repair, else by the diagnosis."""
    if not told.changes:
        yield from _facts(wrong, table, level)
        return
    sure = [entry for change in told.sure for entry in _of(change, table, level)]
    if len(told.alike) > 1 and level.includes(HelpLevel.KIND) and all(c.code in _SIGNS for c in told.alike):
        choice = list(_signs(told.alike))
    else:
        choice = _each_once([entry for change in told.alike for entry in _of(change, table, level)])
    if len(told.alike) > 1 and len(choice) > 1:
        yield from _each_once(sure)
        yield Feedback(code="one_of_these")
        yield from choice
    else:
        yield from _each_once([*sure, *choice])


def _each_once(told: Sequence[Feedback]) -> list[Feedback]:
    """What is told, row by row, and nothing twice."""
    each = {(entry.code, entry.row, entry.params.get("other")): entry for entry in told}
    return sorted(each.values(), key=lambda entry: entry.row or 0)


def _of(change: Change, table: NumericTable, level: HelpLevel) -> Iterator[Feedback]:
    """What is told of one edit."""
    edit = change.edit
    if edit.row is not None and edit.code in HINTS:
        yield Feedback(code=HINTS[edit.code], row=edit.row, params=edit.params)
    elif edit.row is not None and _is_of_variable(change, table) and level.includes(HelpLevel.KIND):
        what = "direction" if edit.code == "variable_sign" else "zero"
        yield Feedback(code=f"variable_{what}_wrong", row=edit.row, params={"row": edit.row})
    elif edit.row is not None:
        # a row that the edit before has added is told as missing, and what is to stand in it is not wrong
        given = frozenset(fact for fact in _facts_of(change, table) if fact[0] < len(table.rows))
        yield from _facts(given, table, level)
    else:
        yield from told_throughout(change, level)


def told_throughout(change: Change, level: HelpLevel) -> Iterator[Feedback]:
    """Return what is told of something that is wrong in the whole table, where no repairs are told."""
    if change.code == ROUNDED and level.includes(HelpLevel.ROW):
        yield Feedback(code="lengths_rounded")
    elif level.includes(HelpLevel.ROW):
        kind = level.includes(HelpLevel.KIND)
        yield Feedback(code=HINTS[change.code] if kind else "whole_table")


def _signs(changes: Sequence[Change]) -> Iterator[Feedback]:
    """Row by row, the cells of which one has the wrong sign."""
    for row in sorted({change.edit.row or 0 for change in changes}):
        wrong = {change.code for change in changes if change.edit.row == row}
        cells = ", ".join(cell for code, cell in _SIGNS.items() if code in wrong)
        yield Feedback(code="sign_wrong", row=row, params={"row": row, "cells": cells})


def _facts(wrong: frozenset[tuple[int, str]], table: NumericTable, level: HelpLevel) -> Iterator[Feedback]:
    if not level.includes(HelpLevel.KIND):
        for row in sorted({row for row, _ in wrong}):
            yield Feedback(code="row_wrong", row=row + 1, params={"row": row + 1})
        return
    for row, fact in sorted(wrong):
        if fact == "offset" and table.rows[row].joint is JointType.PRISMATIC:
            fact = "angle"
        yield Feedback(code=_CODE_OF_FACT[fact], row=row + 1, params={"row": row + 1})


def _about_the_whole(
    decision: Decision, key: NumericTable, table: NumericTable, policy: Policy, level: HelpLevel
) -> Iterable[Feedback]:
    """What concerns no single row."""
    for mismatch in decision.mismatches:
        if mismatch.kind is Kind.CONVENTION:
            params: dict[str, ParamValue] = {
                "asked": policy.convention.value,
                "given": table.convention.value,
            }
            yield Feedback(code="convention_not_asked", params=params)
        elif mismatch.kind is Kind.JOINT_COUNT and level.includes(HelpLevel.ROW):
            counts: dict[str, ParamValue] = {"given": table.n_joints, "asked": key.n_joints}
            yield Feedback(code="joint_count_wrong", params=counts)
        elif mismatch.kind is Kind.HANDEDNESS and level.includes(HelpLevel.KIND):
            yield Feedback(code="mirrored")
        elif level.includes(HelpLevel.ROW) and (rule := _rule(mismatch, policy)):
            yield Feedback(code=rule)


def _rule(mismatch: Mismatch, policy: Policy) -> str | None:
    """The code of a broken rule of the policy."""
    is_rule = mismatch.kind in (Kind.BASE, Kind.TOOL, Kind.ZERO, Kind.DIRECTION)
    return rule_broken(mismatch.kind.value, policy) if is_rule else None


def rule_broken(rule: str, policy: Policy) -> str:
    """Return the code of what is told where base, tool, zero or direction is not as the policy wants it."""
    return f"{rule}_{getattr(policy, rule).value}_missed" if rule in ("base", "tool") else f"{rule}_missed"


def told_repairs(repairs: Sequence[Repaired], level: HelpLevel) -> tuple[Repair, ...]:
    """Return the repairs, if the help level goes so far."""
    if not level.includes(HelpLevel.REPAIR):
        return ()
    return tuple(Repair(edits=_edits(repaired)) for repaired in repairs)


def _edits(repaired: Repaired) -> tuple[Edit, ...]:
    return tuple(change.edit for change in repaired.changes)
