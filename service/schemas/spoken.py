"""What is said of an answer, as a code and as a sentence."""

from collections.abc import Iterable, Mapping
from types import MappingProxyType

from pydantic import Field

from exercises.grading import Edit, Feedback
from service.messages import sentence
from service.schemas.base import Wire

NOTHING: Mapping[str, object] = MappingProxyType({})


class SpokenFeedback(Wire):
    """Something that is said of an answer."""

    code: str = Field(description="stable identifier, in snake_case")
    params: dict[str, str | int | float] = Field(description="the values in the sentence")
    message: str = Field(description="the sentence, in the caller's language")


def spoken(feedback: Iterable[Feedback], language: str) -> list[SpokenFeedback]:
    """Return feedback with its sentences."""
    return [
        SpokenFeedback(
            code=entry.code,
            params={
                name: value for name, value in _params(entry).items() if isinstance(value, str | int | float)
            },
            message=feedback_sentence(entry.code, language, values_told(entry)),
        )
        for entry in feedback
    ]


def feedback_sentence(code: str, language: str, values: Mapping[str, object] = NOTHING) -> str:
    """Return what a code of feedback says."""
    return sentence(language, f"feedback-{code}", values) or code


def option_name(code: str, language: str) -> str:
    """Return what a mistake is called where it can be chosen."""
    return sentence(language, f"option-{code}") or code


def values_told(entry: Feedback | Edit) -> Mapping[str, object]:
    """Return what a sentence may name: the parameters, the row i, and the frame i − 1 that it starts from."""
    return entry.params if entry.row is None else {"before": entry.row - 1, **_params(entry)}


def _params(entry: Feedback | Edit) -> Mapping[str, object]:
    return entry.params if entry.row is None else {"row": entry.row, **entry.params}
