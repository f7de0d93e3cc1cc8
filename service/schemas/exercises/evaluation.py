"""µEd 0.1.0 on the wire: what a platform sends to have an answer evaluated, and the feedback it gets.

Platforms leave out what they do not use and add what we do not know: unlike our own calls, nothing but the
submission's type and content is needed, and unknown members are passed over.
"""

from enum import StrEnum
from typing import Any, Literal

from pydantic import BaseModel, ConfigDict, Field
from pydantic.alias_generators import to_camel


class _Lenient(BaseModel):
    model_config = ConfigDict(extra="ignore", frozen=True, populate_by_name=True, alias_generator=to_camel)


class SubmissionType(StrEnum):
    """Kinds of artefacts."""

    TEXT = "TEXT"
    CODE = "CODE"
    MODEL = "MODEL"
    MATH = "MATH"
    OTHER = "OTHER"


class Submission(_Lenient):
    """What a learner hands in."""

    type: SubmissionType
    content: dict[str, Any] = Field(
        description="a DH table (`convention`, `rows`) or an answer with the parts of an exercise"
    )
    format: str | None = Field(None, description="dh_table, or exercise_answer")
    submission_id: str | None = None
    task_id: str | None = None


class EvaluationTask(_Lenient):
    """What the learner was asked."""

    task_id: str | None = Field(None, description="id of an exercise of this service")
    metadata: dict[str, Any] | None = Field(None, description="`exercise` and `seed`")


class Preference(_Lenient):
    """How a learner wants feedback."""

    detail: str | None = Field(None, description="BRIEF, MEDIUM or DETAILED")
    language: str | None = Field(None, description="language tag of the feedback")


class Learner(_Lenient):
    """Whom the feedback is for; nothing of it is kept."""

    preference: Preference | None = None
    detail_preference: str | None = Field(None, description="preference.detail")
    language_preference: str | None = Field(None, description="preference.language")

    @property
    def detail(self) -> str | None:
        """How much the learner wants to be told, wherever the platform says so."""
        return (self.preference.detail if self.preference else None) or self.detail_preference

    @property
    def language(self) -> str | None:
        """The learner's language, wherever the platform says so."""
        return (self.preference.language if self.preference else None) or self.language_preference


class Enabled(_Lenient):
    """A switch."""

    enabled: bool = False


class EvaluateRequest(_Lenient):
    """The body of POST /evaluate."""

    submission: Submission
    task: EvaluationTask | None = None
    user: Learner | None = None
    pre_submission_feedback: Enabled | None = None
    callback_url: str | None = Field(None, max_length=2000)
    configuration: dict[str, Any] | None = None


class FunctionCall(BaseModel):
    """A call of Lambda Feedback's older interface: nothing else may stand in it."""

    model_config = ConfigDict(extra="forbid", frozen=True)

    response: Any
    answer: Any = None
    params: dict[str, Any] = Field(default_factory=dict)


class FeedbackTarget(_Lenient):
    """The place that feedback speaks of."""

    artefact_type: SubmissionType
    format: str
    locator: dict[str, Any]


class EvaluationFeedback(_Lenient):
    """One thing to tell the learner."""

    feedback_id: str
    title: str
    message: str
    suggested_action: str | None = None
    awarded_points: float | None = None
    target: FeedbackTarget | None = None


class EvaluationAccepted(_Lenient):
    """The feedback is going to be sent to the callback."""

    status: Literal["ACCEPTED"]
    request_id: str


class EvaluationError(_Lenient):
    """Why nothing was evaluated."""

    title: str
    message: str
    code: str
    trace: str | None = None
    details: dict[str, Any] | None = None


class ArtefactProfile(_Lenient):
    """What can be evaluated."""

    type: SubmissionType
    supported_formats: list[str]
    content_schema: dict[str, Any]
    locator_schema: dict[str, Any]


class Capabilities(_Lenient):
    """What this service does of µEd."""

    supports_evaluate: bool
    supports_pre_submission_feedback: bool
    supports_formative_feedback: bool
    supports_summative_feedback: bool
    supports_data_policy: str
    supported_artefact_profiles: list[ArtefactProfile]
    supported_languages: list[str]
    supported_versions: list[str]


class EvaluationHealth(_Lenient):
    """The state of the evaluation service."""

    status: Literal["OK", "DEGRADED", "UNAVAILABLE"]
    version: str
    message: str | None = None
    requirements: dict[str, Any]
    capabilities: Capabilities
