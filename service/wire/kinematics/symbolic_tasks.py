"""From a request for closed forms to a task for the workers; answers are kept."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import partial
from typing import Any, Protocol, TypeVar

from kinematics.jacobian import JacobianFrame
from kinematics.rotations.sequences import EulerSequence
from service.http.routing import NPY, ApiRequest, BytesResponse
from service.http.validation import validated
from service.resources import resources_of
from service.revision import revision
from service.schemas.kinematics.symbolic_request import SymbolicJacobianRequest, WritingQuestion
from service.settings import Settings
from service.wire.kinematics.exact_values import exact_question
from service.wire.kinematics.symbolic_forms import FormPart, SymbolicTask, written_jacobians
from service.work.limiters import WorkKind
from service.work.shared_answers import SharedAnswers
from service.work.workers import Lane


def matrices_task(
    question: WritingQuestion,
    settings: Settings,
    parts: tuple[FormPart, ...],
    frames: tuple[JacobianFrame, ...] = tuple(JacobianFrame),
    angles: EulerSequence | None = None,
) -> SymbolicTask:
    """Return what a validated request for matrices asks of the workers.

    Raises:
        KinematicsError: see `exact_question`.
    """
    return SymbolicTask(parts=parts, frames=frames, angles=angles, **exact_question(question, settings))


class WritingTask(Protocol):
    """Something that a worker process derives and writes."""

    def is_quick(self) -> bool:
        """Return whether the answer is certain to be small."""


Task = TypeVar("Task", bound=WritingTask)


async def answered(
    request: ApiRequest, task: Task, question: bytes, write: Callable[[Task], bytes]
) -> BytesResponse:
    """Return the answer to a task, from a worker process."""
    resources = resources_of(request)
    address = form_address(resources.closed_forms, task, write)
    answer = resources.closed_forms.known(address)
    if answer is None and resources.courses is not None:
        lookup = partial(resources.closed_forms.stored, address)
        answer = await resources.limiters[WorkKind.COURSES].run(lookup)
    if answer is None:
        lane = Lane.QUICK if task.is_quick() else Lane.SLOW
        answer = await resources.workers.run(lane, write, task)
        resources.closed_forms.keep(address, answer)
    resources.symbolic_answers.put(question, answer)
    return BytesResponse(answer)


def form_address(closed_forms: SharedAnswers, task: Task, write: Callable[[Task], bytes]) -> str:
    """Return the address of the answer to a task: the same for everybody who means the same."""
    return closed_forms.address(revision(), write.__name__, repr(task))


async def symbolic_body(request: ApiRequest) -> Mapping[str, Any] | None:
    """Return the body of a request that says "form": "symbolic"; None of any other."""
    if request.brings_npy:
        return None
    request.expect_batch()
    body = await request.json(NPY)
    return body if isinstance(body, dict) and body.get("form") == "symbolic" else None


async def symbolic_jacobian(request: ApiRequest, body: Mapping[str, Any]) -> BytesResponse:
    """Return the answer to a request for Jacobians that says "form": "symbolic".

    Raises:
        RequestError: the request is not of that shape.
        KinematicsError: what it says cannot be meant.
    """
    question = b"jacobian" + await request.body()
    resources = resources_of(request)
    known = resources.symbolic_answers.get(question)
    if known is not None:
        return BytesResponse(known)
    wire = validated(SymbolicJacobianRequest, body)
    frames = (wire.frame,) if wire.frame else tuple(JacobianFrame)
    angles = None if wire.angles is None else wire.angles.sequence()
    make = partial(matrices_task, wire, request.settings, (FormPart.JACOBIAN,), frames, angles)
    task = await request.in_turn(make)
    return await answered(request, task, question, written_jacobians)
