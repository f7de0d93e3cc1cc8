"""What one application has at its disposal: its settings, exercises, caches, limiters and worker processes.

Two applications in one process have each their own. Routes ask for them as a dependency:
`resources: AppResources`.
"""

from typing import Annotated, TypeAlias

from fastapi import Depends, Request

from exercises.access import lowest
from exercises.grading import HelpLevel
from exercises.library import Library
from kinematics.errors import Fault
from service.course_resources import CourseResources
from service.http.problems import NotFoundError, RequestPart
from service.http.uploads import UploadBudget
from service.metrics import Metrics, Occupancy
from service.receipts.keys import receipt_keys
from service.settings import Settings
from service.web.assets import Assets, static_root
from service.wire.answer_cache import AnswerCache
from service.wire.kinematics.prepared_robots import RobotCache
from service.work.callbacks import Callbacks
from service.work.fair_queue import FairQueue
from service.work.limiters import Limiter, WorkKind, limiters
from service.work.shared_answers import SharedAnswers
from service.work.workers import Workers

UPLOADS = 4  # So many bodies of the largest size may be in memory at a time.
TURNS = 4  # Requests that go on between two looks of the event loop at its connections, if they are quick.
MANY_ANSWERS = 8  # When more answers wait to be judged, those that were judged share their transactions.
MANY_REQUESTS = 64  # When more requests are under way, those who are signed in are looked up together.


class Resources:
    """The resources of one application.

    Attributes:
        exercises: the exercises that it serves.
        robots: tables that were read before.
        symbolic_answers: closed forms by the text of their question.
        closed_forms: the same by what was meant, shared with other processes.
        figures: figures that were drawn before, shared with other processes.
        limiters: for each kind of work in threads.
        turns: of requests in the event loop.
        receipt_keys: the keys that sign receipts.
        callbacks: sends feedback that is asked for later.
        courses: the database and what comes with it; None where storage is switched off.
        uploads: the bytes of large bodies that are being received.
        assets: the files that pages are made of.
        metrics: what the operator watches.
        under_way: how many requests are being answered, or wait for it.
    """

    def __init__(self, settings: Settings) -> None:
        self.settings = settings
        self.turns = FairQueue(slots=TURNS, capacity=settings.grading_queue, timeout=settings.queue_seconds)
        self.limiters = limiters(settings, self.turns)
        self.under_way = 0
        self.courses = (
            CourseResources(settings, self._waiting_answers, lambda: self.under_way > MANY_REQUESTS)
            if settings.storage == "on"
            else None
        )
        shelf = self.courses.published if self.courses is not None else None
        self.exercises = Library(settings.exercise_folders, shelf)
        self.exercises.read_own()
        self.robots = RobotCache(settings)
        self.symbolic_answers = AnswerCache()
        store = self.courses.store if self.courses is not None else None
        self.closed_forms = SharedAnswers("closed-form", store)
        self.figures = SharedAnswers("figure", store)
        self.workers = Workers(settings)
        self.receipt_keys = receipt_keys(settings)
        self.callbacks = Callbacks(settings.callback_hosts, self.receipt_keys.sign)
        self.uploads = UploadBudget(UPLOADS * settings.batch_body_limit)
        self.assets = Assets(settings.static_directory or static_root())
        self.metrics = Metrics(self._occupancy, self.courses.outbox if self.courses else None)

    def with_courses(self) -> CourseResources:
        """Return the resources of courses.

        Raises:
            NotFoundError: storage is switched off.
        """
        if self.courses is None:
            raise NotFoundError(Fault.at("storage_off"), part=RequestPart.PATH)
        return self.courses

    def _waiting_answers(self) -> int:
        """How many answers wait to be judged, where that are so many that a moment more is nothing."""
        waiting = self.grading.queue.waiting
        return waiting if waiting > MANY_ANSWERS else 0

    def _occupancy(self) -> Occupancy:
        """What runs and waits: in threads by the kind of work, in processes by their lane."""
        queues = {kind.value: limiter.queue for kind, limiter in self.limiters.items()}
        queues["turns"] = self.turns
        queues |= {f"processes-{name.value}": lane.queue for name, lane in self.workers.lanes.items()}
        return {name: (queue.running, queue.waiting) for name, queue in queues.items()}

    def is_busy(self) -> bool:
        """Return whether anything is done in threads, or a request has its turn in the event loop."""
        queues = (self.turns, *(limiter.queue for limiter in self.limiters.values()))
        return any(queue.running for queue in queues)

    def is_crowded(self) -> bool:
        """Return whether so many answers wait to be judged that less is told of a wrong one."""
        return self.grading.queue.waiting > self.settings.explained_queue

    def help_now(self, asked: HelpLevel | None) -> HelpLevel | None:
        """Return how much a wrong answer may be told now; its score is the same however long the lane is."""
        if not self.is_crowded():
            return asked
        return HelpLevel.ROW if asked is None else lowest((asked, HelpLevel.ROW))

    def close(self) -> None:
        """End worker processes and connections."""
        self.workers.close()
        if self.courses is not None:
            self.courses.close()

    @property
    def reading(self) -> Limiter:
        """What lets large bodies be read in a thread, one at a time."""
        return self.limiters[WorkKind.READING]

    @property
    def grading(self) -> Limiter:
        """What lets so many answers be judged at a time."""
        return self.limiters[WorkKind.GRADING]


def resources_of(request: Request) -> Resources:
    """Return the resources of the application that serves the request."""
    resources: Resources = request.scope["app"].state.resources
    return resources


AppResources: TypeAlias = Annotated[Resources, Depends(resources_of)]
