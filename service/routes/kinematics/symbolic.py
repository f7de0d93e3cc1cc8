"""POST /symbolic: every matrix of a table as a lecturer writes it, and as functions."""

from fastapi import Response
from pydantic import Field

from service.http.openapi import problems, request_body
from service.http.routing import JSON, ONE_ROBOT, ApiRequest, DirectRoute, api_router
from service.schemas.base import LONGEST_LIST, OneOf
from service.schemas.kinematics.written_matrices import (
    WritingAnswer,
    WritingQuestion,
    WrittenJacobians,
    WrittenMatrix,
)
from service.settings import Settings
from service.wire.kinematics.exact_values import exact_question
from service.wire.kinematics.symbolic_forms import FormPart, SymbolicTask, written_answer
from service.wire.kinematics.symbolic_tasks import closed_form

router = api_router("kinematics", route_class=DirectRoute)

STANDARD_PARTS = (FormPart.LINKS, FormPart.FRAMES, FormPart.TRANSFORM)


class SymbolicRequest(WritingQuestion):
    """A robot whose closed form is wanted."""

    parts: list[OneOf[FormPart]] | None = Field(
        None,
        max_length=LONGEST_LIST,
        min_length=1,
        description="what is wanted; links, frames and transform if left out",
    )
    inverse: bool = Field(False, description="whether the inverse of the transform is wanted as well")
    jacobian: bool = Field(False, description="whether the Jacobians J0 and Jn are wanted as well")

    def wanted(self) -> tuple[FormPart, ...]:
        """Return what is wanted, in the order of the enumeration."""
        chosen = set(self.parts if self.parts is not None else STANDARD_PARTS)
        chosen |= {FormPart.INVERSE} if self.inverse else set()
        chosen |= {FormPart.JACOBIAN} if self.jacobian else set()
        return tuple(part for part in FormPart if part in chosen)


class SymbolicAnswer(WritingAnswer):
    """Closed forms, nested from the last joint to the first, angles of parallel joints added."""

    operations: int | None = Field(None, description="operations in the transform, counted as written")
    links: list[WrittenMatrix] | None = Field(
        None, description="for each row the pose of frame i in frame i-1"
    )
    frames: list[WrittenMatrix] | None = Field(
        None, description="for each row the pose of frame i in the world, base included"
    )
    transform: WrittenMatrix | None = Field(None, description="⁰T_N, base and tool included")
    inverse: WrittenMatrix | None = Field(None, description="the inverse of the transform")
    jacobian: WrittenJacobians | None = None


@router.post(
    "/symbolic",
    summary="Link, frame and end transforms in closed form",
    response_model=SymbolicAnswer,
    response_model_exclude_none=True,
    responses=problems(406, 503),
    openapi_extra=request_body(SymbolicRequest),
)
async def symbolic(request: ApiRequest) -> Response:
    """Return ⁰T_N, all link transforms and frames in closed form; on request the inverse and Jacobians.

    Entries are nested from the last joint to the first, angles of parallel joints are added (c23), and
    multiples of π/12 are exact. Parameters without a value stay symbols. Matrices are in LaTeX, MathML,
    infix text, expression trees, a SymPy script, or as functions in ten programming languages, whose
    arguments are the joint variables and then the parameters. Angles are radians in all of them. What takes
    too long, or more memory than it may, is refused.
    """
    request.accepts(JSON)
    request.json_limits = ONE_ROBOT
    return await closed_form(request, SymbolicRequest, symbolic_task, written_answer)


def symbolic_task(question: SymbolicRequest, settings: Settings) -> SymbolicTask:
    """Return what a request asks of the workers.

    Raises:
        KinematicsError: see `exact_question`.
    """
    return SymbolicTask(parts=question.wanted(), **exact_question(question, settings))
