"""Wrong tables with one mistake: is it found, and in the right row?"""

from __future__ import annotations

from random import Random

from exercises.grading import Policy, Repair, ToolRule, grade
from kinematics.equivalence.reference import prepared
from kinematics.table import NumericTable
from tests.exercises.grading.written import written
from tests.kinematics.equivalence.campaign import TABLES_PER_BLOCK, Outcome, references
from tests.kinematics.equivalence.generators import random_valid_table
from tests.kinematics.equivalence.mutations import Mutation, mutations

MISTAKES_PER_TABLE = 10
LONGEST = 4.0
ATTEMPTS = 20


def mended_tables(block: int) -> Outcome:
    """One mistake of the catalogue in a valid table: a single edit mends it, in the right row.

    An answer that is right in spite of the mistake (the sign of an α that another sign makes up for) counts
    as accepted. Failures are mistakes for which no single edit was found, or none in the right row.
    """
    rng = Random(f"mended {block}")
    known = references()
    outcome = Outcome()
    while outcome.tables < TABLES_PER_BLOCK:
        name, reference = rng.choice(known)
        key = written(reference)
        table = drawn_by_hand(reference, rng)
        if table is None:
            continue
        made = mutations(table, rng)
        for mutation in rng.sample(made, min(MISTAKES_PER_TABLE, len(made))):
            verdict = grade(key, written(mutation.table), Policy(tool=ToolRule.FREE))
            if verdict.correct:
                outcome.accepted += 1
                continue
            outcome.tables += 1
            outcome.kinds[mutation.kind] += 1
            outcome.mended += any(len(repair.edits) == 1 for repair in verdict.repairs)
            outcome.right_row += is_mended(mutation, verdict.repairs)
            if not is_mended(mutation, verdict.repairs):
                outcome.failures.append(
                    f"{name}, block {block}, {mutation.kind} in {mutation.rows}: {verdict.repairs[:2]}"
                )
    return outcome


def drawn_by_hand(reference: NumericTable, rng: Random) -> NumericTable | None:
    """A valid table as a person might draw it: no length many times the robot's size."""
    for _ in range(ATTEMPTS):
        table = random_valid_table(reference, rng, dummies=0.0, signed_rows=False, textbook_ends=True)
        longest = max(abs(length) for row in table.rows for length in (row.a, row.d))
        if longest <= LONGEST * prepared(reference).size:
            return table
    return None


def is_mended(mutation: Mutation, repairs: tuple[Repair, ...]) -> bool:
    """Whether a single edit was found, in the right row."""
    single = [repair.edits[0] for repair in repairs if len(repair.edits) == 1]
    rows = {edit.row for edit in single} | {edit.params.get("other") for edit in single}
    return bool(single) and (not mutation.rows or bool(rows & set(mutation.rows)))
