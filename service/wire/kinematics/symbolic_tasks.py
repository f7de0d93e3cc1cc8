"""From a request for closed forms to a task for the workers; answers are kept."""

from collections.abc import Callable
from functools import partial
from typing import Protocol, TypeVar

from service.http.routing import ApiRequest, BytesResponse
from service.http.validation import Shape, validated
from service.revision import revision
from service.settings import Settings
from service.work.limiters import WorkKind
from service.work.shared_answers import SharedAnswers
from service.work.workers import Lane


class WritingTask(Protocol):
    """Something that a worker process derives and writes."""

    def is_quick(self) -> bool:
        """Return whether the answer is certain to be small."""


Task = TypeVar("Task", bound=WritingTask)


async def closed_form(
    request: ApiRequest,
    shape: type[Shape],
    task_of: Callable[[Shape, Settings], Task],
    write: Callable[[Task], bytes],
) -> BytesResponse:
    """Return the answer to a request for closed forms: as it was given before, or from a worker process.

    Raises:
        RequestError: the body is not of that shape.
        KinematicsError: what it says cannot be meant.
    """
    typed = await request.json()
    question = write.__name__.encode() + await request.body()
    known = request.resources.symbolic_answers.get(question)
    if known is not None:
        return BytesResponse(known)
    asked = validated(shape, typed)
    task = await request.in_turn(partial(task_of, asked, request.settings))
    return await answered(request, task, question, write)


async def answered(
    request: ApiRequest, task: Task, question: bytes, write: Callable[[Task], bytes]
) -> BytesResponse:
    """Return the answer to a task, from a worker process."""
    resources = request.resources
    address = form_address(resources.closed_forms, task, write)
    answer = resources.closed_forms.known(address)
    if answer is None and resources.courses is not None:
        lookup = partial(resources.closed_forms.stored, address)
        answer = await resources.limiters[WorkKind.COURSES].run(lookup)
    if answer is None:
        answer = await resources.workers.run(Lane.QUICK if task.is_quick() else Lane.SLOW, write, task)
        resources.closed_forms.keep(address, answer)
    resources.symbolic_answers.put(question, answer)
    return BytesResponse(answer)


def form_address(closed_forms: SharedAnswers, task: Task, write: Callable[[Task], bytes]) -> str:
    """Return the address of the answer to a task: the same for everybody who means the same."""
    return closed_forms.address(revision(), write.__name__, repr(task))
