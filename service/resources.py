"""What one application has at its disposal: its settings, exercises, caches, limiters and worker processes.

Two applications in one process have each their own. Routes ask for them as a dependency:
`resources: AppResources`.
"""

from __future__ import annotations

from typing import Annotated, TypeAlias

from fastapi import Depends, Request

from exercises.loader import Library
from kinematics.errors import Fault
from service.course_resources import CourseResources
from service.http.problems import NotFoundError, RequestPart
from service.receipts.keys import receipt_keys
from service.settings import Settings
from service.wire.answer_cache import AnswerCache
from service.wire.prepared_robots import RobotCache
from service.work.callbacks import Callbacks
from service.work.limiters import limiters
from service.work.workers import Workers


class Resources:
    """The resources of one application.

    Attributes:
        settings: the operator's choices.
        exercises: the exercises that it serves.
        robots: tables that were read before.
        symbolic_answers: closed forms that were written before.
        limiters: for each kind of work in threads.
        workers: the worker processes.
        receipt_keys: the keys that sign receipts.
        callbacks: sends feedback that is asked for later.
        courses: the database and what comes with it; None where storage is switched off.
    """

    def __init__(self, settings: Settings) -> None:
        self.settings = settings
        self.exercises = Library(settings.exercise_folders)
        self.exercises.read_all()
        self.robots = RobotCache(settings)
        self.symbolic_answers = AnswerCache()
        self.limiters = limiters(settings)
        self.workers = Workers(settings)
        self.receipt_keys = receipt_keys(settings)
        self.callbacks = Callbacks(settings.callback_hosts, self.receipt_keys.sign)
        self.courses = CourseResources(settings) if settings.storage == "on" else None

    def with_courses(self) -> CourseResources:
        """Return the resources of courses.

        Raises:
            NotFoundError: storage is switched off.
        """
        if self.courses is None:
            raise NotFoundError(Fault(code="storage_off"), part=RequestPart.PATH)
        return self.courses

    def close(self) -> None:
        """End worker processes and connections."""
        self.workers.close()
        if self.courses is not None:
            self.courses.close()


def resources_of(request: Request) -> Resources:
    """Return the resources of the application that serves the request."""
    resources: Resources = request.scope["app"].state.resources
    return resources


AppResources: TypeAlias = Annotated[Resources, Depends(resources_of)]
