"""POST /compare-tables and POST /other-tables: tables of one robot."""

from typing import Annotated

import numpy as np
from pydantic import Field

from exercises.alternatives import other_tables
from exercises.grading import Policy, ToolRule, grade
from exercises.parts.mistakes.compare_tables import ComparisonReason, true_reasons
from kinematics.cells import Limits
from service.http.calls import CallRouter
from service.schemas.base import WHOLE, Wire
from service.schemas.exercises.verdicts import PolicyModel
from service.schemas.spoken import SpokenFeedback, spoken
from service.schemas.tables import Parameters, Table
from service.wire.kinematics.written_tables import table_in_units_of

router = CallRouter("exercises")

MOST_TABLES = 10  # As many as an author is shown of right answers that look different.


class CompareTablesRequest(Wire):
    """Two tables that may describe the same robot."""

    first: Table = Field(description="one table")
    second: Table = Field(description="the other; its units and its convention may differ")
    parameters: Parameters = Field(
        default_factory=dict, description="values of the first table's parameters, in its units"
    )


class CompareTablesAnswer(Wire):
    """Whether two tables describe the same robot, whatever frames were chosen, and why."""

    same: bool
    reasons: list[ComparisonReason] = Field(
        description="of the same robot what differs in the frames; of another one what differs in the robot"
    )
    feedback: list[SpokenFeedback] = Field(description="the explanation of the verdict")


class OtherTablesRequest(Wire):
    """A table, and what is free beside it."""

    table: Table = Field(description="a table of the robot")
    policy: PolicyModel = Field(default_factory=PolicyModel, description="what the other tables are held to")
    parameters: Parameters = Field(
        default_factory=dict, description="values of the table's parameters, in its units"
    )
    count: Annotated[int, Field(ge=1, le=MOST_TABLES), WHOLE] = Field(1, description="how many are wanted")


class ComparedTable(Wire):
    """Another table of the same robot."""

    table: Table = Field(description="it, in the units of the first")
    reasons: list[ComparisonReason] = Field(description="in what its frames differ from those of the first")


class OtherTablesAnswer(Wire):
    """Other tables of the same robot."""

    tables: list[ComparedTable] = Field(
        description="the other convention first, if it is free, then tables that differ in one choice; "
        "fewer than were asked for where the policy leaves little free"
    )


@router.judge("/compare-tables", "Do two tables describe the same robot, and why?")
def compare_tables(body: CompareTablesRequest, limits: Limits, language: str) -> CompareTablesAnswer:
    """Return whether they are one robot, whichever way frames, zeros, directions and conventions were chosen.

    Nothing is fixed but the joints: frame 0 and the last frame may lie anywhere. For the certificate and for
    policies see `/grade`.
    """
    first = body.first.read(limits, "first")
    second = body.second.read(limits, "second")
    with np.errstate(all="ignore"):
        verdict = grade(first, second, Policy(tool=ToolRule.FREE), body.parameters)
    return CompareTablesAnswer(
        same=verdict.correct,
        reasons=sorted(true_reasons(verdict)),
        feedback=spoken(verdict.feedback, language),
    )


@router.judge("/other-tables", "Other tables of the same robot")
def write_other_tables(body: OtherTablesRequest, limits: Limits) -> OtherTablesAnswer:
    """Return tables of a given one's robot that keep a policy, with what differs in their frames.

    Each was judged against the given table by the checker before it was sent.
    """
    read = body.table.read(limits, "table")
    with np.errstate(all="ignore"):
        found = other_tables(read, body.policy.policy(), body.parameters, body.count)
    return OtherTablesAnswer(
        tables=[
            ComparedTable(table=table_in_units_of(read, other.table.table), reasons=sorted(other.reasons))
            for other in found
        ]
    )
