"""What an application with storage has at its disposal: the database, the platforms' keys, their services."""

import threading
import time
from collections.abc import Callable
from contextlib import suppress
from datetime import UTC, datetime
from typing import Any, TypeAlias

from courses.attempts.stored_attempts import Typed, keep_drafts
from courses.attempts.submissions import JudgedSubmission, store_submissions
from courses.grades.outbox import OutboxState, outbox_state
from courses.links.publications import publish, published
from courses.model import Attempt, Course, CourseSession, Platform, PlatformStatus
from courses.people.platforms import StoredKey, add_key, platform_by_id, platforms, remove_keys, stored_keys
from courses.people.secrets import pseudonym
from courses.people.sessions import sessions_of
from courses.refusals import SessionError, StorageUnavailableError
from courses.storage.database import Store, open_store
from exercises.authoring.draft import draft_of_files
from exercises.definition import Exercise
from exercises.library import Library
from exercises.loader import read_exercise
from kinematics.errors import Fault
from service.lti.fetching import Fetcher, origin_of
from service.lti.launch_errors import PlatformError
from service.lti.memberships import members
from service.lti.platform_keys import PlatformKeys
from service.lti.services import Services
from service.lti.signing_keys import PUBLISHED_BEFORE, new_private_key, outdated, signing_key
from service.settings import Settings
from service.work.batcher import Batcher
from service.work.fair_queue import Proven, proven

_ORIGINS_LIVE = 30.0  # Seconds for which the origins of known platforms are not read again.
_ANSWER_LIVES = 2.0  # Seconds for which what the database answered on its own health is believed.
CACHED_EXERCISES = 512  # Published exercises in the cache, as read: some tens of megabytes.
_PAUSE_FOR_EACH, _LONGEST_PAUSE = 0.005, 0.25
"""Seconds in which judged answers are gathered for one transaction: for each answer that waits to be judged,
which takes about as long, and at the most. One alone costs five times as much as one of some dozens."""
_SESSIONS_PAUSE = 0.02
"""Seconds in which requests are gathered to ask once who is signed in, while many are under way: one alone
costs four times as much as one of some dozens."""
_DRAFTS_PAUSE = 0.1
"""Seconds in which drafts are gathered for one transaction: nobody waits for them, and each transaction keeps
those waiting who hand in."""
_MEMBERS_LIVE = 300.0  # Seconds for which a class list of the platform is not fetched again.
SESSIONS_KNOWN = 8192
"""Sessions whose people are in the cache, so that all their requests wait in a turn of their own."""
_COURSES_KNOWN = 100  # Courses whose class lists are held at a time.


_ClassList: TypeAlias = tuple[int, str]  # A platform, and the address at which it tells who is in a course.


class CourseResources:
    """The resources of courses.

    Attributes:
        fetcher: sends requests to platforms.
        platform_keys: their keys.
        services: their services.
        sign_in: finds who is signed in by a token.
        keep: stores a judged submission.
        keep_draft: stores what somebody has typed.
        key_set: the public keys as they were published last; empty before.
    """

    def __init__(
        self, settings: Settings, answers_waiting: Callable[[], int] = int, is_busy: Callable[[], bool] = bool
    ) -> None:
        """Open the database.

        Args:
            answers_waiting: how many answers wait to be judged.
            is_busy: whether so many requests are under way that a moment more is nothing.
        """
        self.store: Store = open_store(settings.database_url, settings.data_folder)
        self.store.bound_answers()
        self.fetcher = Fetcher(frozenset(settings.lti_trusted_origins))
        self.platform_keys = PlatformKeys(self.fetcher)
        self.services = Services(self.fetcher, self.signing)
        alike: dict[str, Any] = {"capacity": settings.grading_queue, "gives_up": _database_is_gone}
        self.sign_in: Batcher[str, CourseSession] = Batcher(
            lambda tokens: sessions_of(self.store, tokens, now()),
            **alike,
            pause=lambda: _SESSIONS_PAUSE if is_busy() else 0.0,
        )
        self.keep: Batcher[JudgedSubmission, Attempt] = Batcher(
            lambda submissions: store_submissions(self.store, submissions, now()),
            **alike,
            pause=lambda: min(_PAUSE_FOR_EACH * answers_waiting(), _LONGEST_PAUSE),
        )
        self.keep_draft: Batcher[Typed, None] = Batcher(
            lambda typed: keep_drafts(self.store, typed, now()), **alike, pause=lambda: _DRAFTS_PAUSE
        )
        self.key_set: dict[str, Any] = {}
        self._people: dict[str, Proven] = {}
        self._lock = threading.Lock()
        self._members: dict[_ClassList, tuple[dict[str, str | None] | None, float]] = {}
        self._asking: dict[_ClassList, threading.Lock] = {}
        self._answered = (True, float("-inf"))
        self._editions: dict[str, str] = {}
        self._published: dict[str, Exercise] = {}
        self._origins: tuple[tuple[str, ...], float] = ((), float("-inf"))

    def close(self) -> None:
        """Store what waits, and end every connection."""
        self.sign_in.close()
        self.keep.close()
        self.keep_draft.close()
        self.fetcher.close()
        self.store.close()

    async def signed_in(self, token: str) -> CourseSession:
        """Return who is signed in by a token; what follows in this request counts as theirs.

        Raises:
            SessionError: nobody is.
        """
        if not token:
            raise SessionError(Fault.at("session_expired"))
        session = await self.sign_in(token)
        who = Proven("person", session.person.id)
        if token not in self._people:
            while len(self._people) >= SESSIONS_KNOWN:
                self._people.pop(next(iter(self._people)))
            self._people[token] = who
        proven(who)
        return session

    def person(self, authorization: str) -> Proven | None:
        """Return who was signed in before by the token of an Authorization field; None where nobody is known.

        It says whose turn it is, and lets nobody in: that a session has ended meanwhile makes no difference.
        """
        return self._people.get(bearer_token(authorization))

    def outbox(self) -> OutboxState:
        """Return how the outbox of scores is.

        Raises:
            StorageUnavailableError: the database does not answer, or takes nothing.
        """
        if not self.answers():
            raise StorageUnavailableError(is_gone=True)
        return outbox_state(self.store, now())

    def answers(self) -> bool:
        """Return whether the database answers, and takes what is written; asked at most every two seconds."""
        with self._lock:
            known, until = self._answered
            if time.monotonic() < until:
                return known
        try:
            self.store.check()
            found = True
        except StorageUnavailableError:
            found = False
        with self._lock:
            self._answered = (found, time.monotonic() + _ANSWER_LIVES)
        return found

    def published(self, address: str) -> Exercise | None:
        """Return the published exercise at an address; it never changes, so it is read once."""
        if address not in self._published:
            draft = published(self.store, address)
            if draft is None:
                return None
            while len(self._published) >= CACHED_EXERCISES:
                self._published.pop(next(iter(self._published)))
            self._published[address] = read_exercise(address, draft.definition, draft.statements)
        return self._published[address]

    def edition(self, library: Library, exercise_id: str) -> str:
        """Return the address of an exercise as it is now, made from its content.

        What stands there never changes.

        Raises:
            UnknownExerciseError: there is no such exercise.
        """
        files = library.files(exercise_id)
        if files is None:
            return exercise_id  # it has been published, under this address
        if exercise_id not in self._editions:
            draft = draft_of_files(exercise_id, files)
            self._editions[exercise_id] = publish(self.store, draft, now(), most=None).address
        return self._editions[exercise_id]

    def knows_edition(self, exercise_id: str | None) -> bool:
        """Return whether the address of an exercise is known without asking the database."""
        return exercise_id is None or exercise_id in self._editions or exercise_id in self._published

    def class_members(self, course: Course) -> dict[str, str | None] | None:
        """Return names of a course's students by pseudonym, as the platform tells them; None if it does not.

        They are asked for only where the operator lets names be stored for the platform, at most every few
        minutes, and are not written down.
        """
        platform = platform_by_id(self.store, course.platform_id)
        if not platform.names_shared or not course.memberships_url:
            return None
        asked = platform.id, course.memberships_url  # SQLite gives the number of an erased course again
        with self._lock:
            asking = self._asking.setdefault(asked, threading.Lock())
        with asking:  # a platform that is slow to answer is asked once for all who look at the class
            with self._lock:
                known = self._members.get(asked)
            if known is not None and time.monotonic() < known[1]:
                return known[0]
            found = self._asked_members(platform, course.memberships_url)
            with self._lock:
                if len(self._members) >= _COURSES_KNOWN:
                    self._members.clear()
                self._members[asked] = (found, time.monotonic() + _MEMBERS_LIVE)
            return found

    def _asked_members(self, platform: Platform, address: str) -> dict[str, str | None] | None:
        try:
            listed = members(self.services, platform, address)
        except PlatformError:
            return None
        return {
            pseudonym(self.store, platform.issuer, platform.client_id, member.user): member.name
            for member in listed
            if member.is_student
        }

    def keys(self) -> list[StoredKey]:
        """Return the tool's keys; the first one is made when it is first needed."""
        found = stored_keys(self.store)
        if not found:
            add_key(self.store, _new_key(now(), at_once=True), only_if_none=True)
            found = stored_keys(self.store)
        return found

    def signing(self) -> StoredKey:
        """Return the key that signs now."""
        return signing_key(self.keys(), now())

    def rotate(self, *, at_once: bool = False) -> StoredKey:
        """Make a new key, published now and signing later; forget keys that have served their time."""
        remove_keys(self.store, outdated(self.keys(), now()))
        key = _new_key(now(), at_once=at_once)
        add_key(self.store, key)
        return key

    def frame_origins(self) -> tuple[str, ...]:
        """Return origins of active platforms: their pages may show ours in a frame."""
        with self._lock:
            found, until = self._origins
            if time.monotonic() < until:
                return found
        try:
            active = [each for each in platforms(self.store) if each.status is PlatformStatus.ACTIVE]
        except StorageUnavailableError:
            return found  # pages are served without the database
        origins = tuple(sorted({origin for platform in active for origin in _origins(platform)}))
        with self._lock:
            self._origins = (origins, time.monotonic() + _ORIGINS_LIVE)
        return origins

    def forget_origins(self) -> None:
        """Read the platforms' origins again: one of them has changed."""
        with self._lock:
            self._origins = ((), float("-inf"))


def bearer_token(authorization: str) -> str:
    """Return the token in an Authorization field; empty if there is none."""
    scheme, _, token = authorization.partition(" ")
    return token.strip() if scheme.lower() == "bearer" else ""


def now() -> datetime:
    """Return the time."""
    return datetime.now(UTC)


def _database_is_gone(error: Exception) -> bool:
    return isinstance(error, StorageUnavailableError) and error.is_gone


def _new_key(made: datetime, *, at_once: bool) -> StoredKey:
    kid, private = new_private_key()
    signs_from = made if at_once else made + PUBLISHED_BEFORE
    return StoredKey(kid=kid, private=private, created=made, signs_from=signs_from)


def _origins(platform: Platform) -> list[str]:
    found = []
    for address in (platform.issuer, platform.authorization_endpoint, *platform.origins):
        with suppress(ValueError):
            found.append(origin_of(address))
    return found
