"""POST /grade on the wire."""

from __future__ import annotations

from pydantic import Field

from exercises.grading import HelpLevel
from service.schemas.base import Wire
from service.schemas.tables import Parameters, Table
from service.schemas.verdicts import Help, PolicyModel


class GradeRequest(Wire):
    """A submission to be judged by a key that the caller keeps."""

    reference: Table = Field(description="the key")
    submission: Table = Field(description="the answer; it may be in other units and in the other convention")
    policy: PolicyModel = PolicyModel()
    parameters: Parameters = Field(
        default_factory=dict,
        description="values of the key's parameters, in the key's units, so that answers may hold numbers",
    )
    help: Help = HelpLevel.REPAIR
