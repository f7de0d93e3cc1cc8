"""POST /grade on the wire."""

from __future__ import annotations

from types import GenericAlias
from typing import Any

from pydantic import Field, RootModel, create_model

from exercises.grading import HelpLevel
from service.schemas.base import ProblemDocument, Wire
from service.schemas.exercises.verdicts import Help, PolicyModel, VerdictModel
from service.schemas.tables import Parameters, Table

MOST_SUBMISSIONS = 1000
"""Submissions in one request: a course's."""


class KeyQuestion(Wire):
    """A key that the caller keeps, and how it is applied."""

    reference: Table = Field(description="the key")
    policy: PolicyModel = PolicyModel()
    parameters: Parameters = Field(
        default_factory=dict,
        description="values of the key's parameters, in the key's units, so that answers may hold numbers",
    )
    help: Help = HelpLevel.REPAIR


class GradeOneRequest(KeyQuestion):
    """A submission to be judged by a key that the caller keeps."""

    submission: Table = Field(description="the answer; it may be in other units and in the other convention")


class GradeManyRequest(KeyQuestion):
    """Many submissions to be judged by one key."""

    submissions: list[dict[str, Any]] = Field(
        min_length=1,
        max_length=MOST_SUBMISSIONS,
        description="tables; one that cannot be graded has a problem document in the place of its verdict",
    )


class GradeBody(RootModel[GradeOneRequest | GradeManyRequest]):
    """One submission or many, by one key."""


_EITHER: Any = VerdictModel | ProblemDocument
_VERDICTS: dict[str, Any] = {"verdicts": (GenericAlias(list, (_EITHER,)), ...)}
ManyVerdicts = create_model(
    "ManyVerdicts", __base__=Wire, __doc__="Verdicts in the order of the submissions.", **_VERDICTS
)
