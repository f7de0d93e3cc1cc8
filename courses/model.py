"""Records of a course: who, what is asked of them, what they handed in, and what goes to the gradebook."""

from collections.abc import Mapping
from dataclasses import dataclass, field
from datetime import datetime
from enum import StrEnum
from typing import Any

from courses.policies import Allowance, AttemptOutcome, AttemptPolicy, Counted


class Role(StrEnum):
    """What somebody may do in a course."""

    LEARNER = "learner"
    STAFF = "staff"


class PlatformStatus(StrEnum):
    """Whether launches of a platform are taken."""

    PENDING = "pending"
    ACTIVE = "active"
    DISABLED = "disabled"


@dataclass(frozen=True, kw_only=True, slots=True)
class Platform:
    """A learning management system that this service is registered with.

    Attributes:
        issuer: its identifier, exactly as it signs.
        client_id: what it calls this service.
        token_audience: audience of token requests, where it is not the token endpoint.
        origins: further origins that show its pages, such as vanity domains.
        names_shared: the operator lets names be asked for.
    """

    id: int = 0
    issuer: str
    client_id: str
    name: str = ""
    authorization_endpoint: str
    token_endpoint: str
    token_audience: str | None = None
    jwks_uri: str
    origins: tuple[str, ...] = ()
    names_shared: bool = False
    status: PlatformStatus = PlatformStatus.PENDING

    @property
    def called(self) -> tuple[str, str]:
        """The addresses at which the service calls it; browsers go to the others."""
        return self.token_endpoint, self.jwks_uri


@dataclass(frozen=True, kw_only=True, slots=True)
class Registration:
    """A one-time invitation to register a platform; only a hash of its secret is stored."""

    id: int
    note: str
    created: datetime
    expires: datetime
    used_at: datetime | None


@dataclass(frozen=True, kw_only=True, slots=True)
class Person:
    """Somebody in a course.

    Attributes:
        key: pseudonym: a keyed hash of platform and subject. All that exports, logs and pages show.
        subject: what the platform calls them; needed to send their scores, and shown nowhere.
        name: only where the platform shares it and the lecturer asked for it.
    """

    id: int
    platform_id: int
    key: str
    subject: str | None
    name: str | None


@dataclass(frozen=True, kw_only=True, slots=True)
class Course:
    """A course of a platform."""

    id: int
    platform_id: int
    title: str
    memberships_url: str | None


@dataclass(frozen=True, kw_only=True, slots=True)
class LinkSettings:
    """What a link asks, and how.

    Attributes:
        exercise_id: None until a teacher has chosen one.
        parts: kinds of the parts that are asked; empty for all of the exercise's.
        help: most help that is given; None for what the exercise allows.
        points: what a full score is worth in the gradebook.
        per_student: every student has values of their own.
        variants: so many sets of values are shared out among the students instead; None: by `per_student`.
        language: the page's language; None for the student's.
    """

    exercise_id: str | None = None
    parts: tuple[str, ...] = ()
    help: str | None = None
    points: float = 1.0
    per_student: bool = False
    variants: int | None = None
    language: str | None = None
    policy: AttemptPolicy = field(default_factory=AttemptPolicy)


@dataclass(frozen=True, kw_only=True, slots=True)
class Link:
    """A place in a course that opens an exercise."""

    id: int
    course_id: int
    resource: str
    title: str
    settings: LinkSettings
    line_item: str | None
    line_items: str | None
    released_at: datetime | None


@dataclass(frozen=True, kw_only=True, slots=True)
class Attempt:
    """A submission that was judged; never changed after it was stored.

    Attributes:
        number: 1, 2, … of this student and link.
        key: idempotency key; a submission that is sent again with it is the same attempt.
        answer: what was typed, as it arrived.
        form: what the page can put back into its form; None where no page was used.
        report: what was found, by stable codes and without sentences.
        shown: how much the student was shown when it was handed in.
    """

    id: int = 0
    link_id: int
    person_id: int
    number: int = 0
    key: str
    at: datetime
    exercise_id: str
    version: str
    seed: str | None
    language: str
    answer: Mapping[str, Any]
    form: Mapping[str, Any] | None = None
    report: Mapping[str, Any]
    score: float
    correct: bool
    shown: str = "all"

    @property
    def outcome(self) -> AttemptOutcome:
        """What policies need to know of it."""
        return AttemptOutcome(number=self.number, at=self.at, score=self.score)


@dataclass(frozen=True, kw_only=True, slots=True)
class Draft:
    """What somebody has typed and not yet handed in."""

    state: Mapping[str, Any]
    at: datetime


@dataclass(frozen=True, kw_only=True, slots=True)
class ListedAttempt:
    """An attempt as a list tells of it: without its answer and what was found."""

    number: int
    version: str
    at: datetime
    score: float
    correct: bool


@dataclass(frozen=True, kw_only=True, slots=True)
class StudentStanding:
    """How far a student is with a link.

    Attributes:
        latest: the latest attempts, oldest first.
        grade: the attempt that makes the grade; None if none does.
        draft: what was typed and not handed in.
    """

    latest: tuple[ListedAttempt, ...] = ()
    grade: Counted | None = None
    draft: Draft | None = None


@dataclass(frozen=True, kw_only=True, slots=True)
class ScoreToSend:
    """A score that is leased to one sender.

    Attributes:
        revision: raised with every change of the score; what was sent is the revision that was leased.
        timestamp: whole seconds, later than that of every message sent before for this line item and user.
        lease: names the sender; only its holder may report on it.
    """

    link_id: int
    person_id: int
    platform_id: int
    subject: str
    line_item: str | None
    line_items: str | None
    resource: str
    title: str
    score: float
    points: float
    revision: int
    tries: int
    timestamp: datetime
    submitted_at: datetime | None
    lease: str


@dataclass(frozen=True, kw_only=True, slots=True)
class CourseSession:
    """Who is signed in by a token, and for what.

    Attributes:
        made: how many attempts they have made.
        has_draft: they have typed something that was kept.
        longest: longest extra time of any student of the link, in seconds.
    """

    id: int
    role: Role
    person: Person
    course: Course
    link: Link
    allowance: Allowance
    made: int
    has_draft: bool
    longest: float
    locale: str | None
    return_url: str | None
    expires: datetime
