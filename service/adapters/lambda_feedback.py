"""Lambda Feedback's call before µEd: one address, the command in a header, carried out by the µEd adapter.

What goes wrong is told in the member `error` of a body, as that interface has it.
"""

from collections.abc import Callable, Mapping
from typing import Any

from pydantic import ValidationError

from exercises.errors import UnknownExerciseError
from exercises.library import Library
from kinematics.errors import Fault
from service.adapters import mued
from service.adapters.judging import JudgedAnswer, judge, told_fault
from service.messages import sentence
from service.schemas.exercises.evaluation import EvaluateRequest, FunctionCall

_OF_ROWS = ("convention", "angle_unit", "length_unit")
_CHECKED = "twolink"
"""The exercise by which the service checks itself: the smallest that has something to mistake."""


def answered(command: str, body: bytes, language: str, library: Library) -> dict[str, Any]:
    """Carry out a command.

    Args:
        command: eval, preview or healthcheck.
        body: the JSON body: `response` (a table, or an answer), `answer` (the exercise), `params`
            (exercise, seed, language, detail).
        language: of the feedback, where `params` names none.

    Returns:
        The body of the answer: `command` and `result`, or `error`.
    """
    if command == _HEALTH:
        return {"command": _HEALTH, "result": _health(library)}
    if command not in _COMMANDS:
        fault = Fault.at("function_command_unknown", known=(*_COMMANDS, _HEALTH))
        return _error(fault, language)
    name, carry_out = _COMMANDS[command]
    try:
        call = FunctionCall.model_validate_json(body)
    except ValidationError as error:
        places = ", ".join(".".join(map(str, fault["loc"])) or fault["msg"] for fault in error.errors()[:5])
        return _error(Fault.at("function_call_invalid", places=places), language)
    request = _request(call, check=name == _PREVIEW)
    language = mued.language_wanted(request, language)
    try:
        return {"command": name, "result": carry_out(request, language, library)}
    except mued.NotEvaluatedError as error:
        return _error(error.fault, language)
    except UnknownExerciseError as error:
        return _error(error.faults[0], language)


def _request(call: FunctionCall, *, check: bool) -> EvaluateRequest:
    """Return the same call as µEd has it."""
    exercise = call.params.get("exercise")
    if exercise is None:
        exercise = call.answer if isinstance(call.answer, str) else None
    content = _content(call)
    preference = {
        name: value for name in ("detail", "language") if isinstance(value := call.params.get(name), str)
    }
    return EvaluateRequest.model_validate(
        {
            "submission": {"type": "MODEL", "content": content},
            "task": {"metadata": {"exercise": exercise, "seed": call.params.get("seed")}},
            "user": {"preference": preference},
            "preSubmissionFeedback": {"enabled": check},
        }
    )


def _content(call: FunctionCall) -> Mapping[str, Any]:
    """Return the answer as an object: a table, or its rows alone, with what `params` say of them."""
    if isinstance(call.response, Mapping):
        return call.response
    if not isinstance(call.response, list):
        return {"value": call.response}
    told = {name: call.params[name] for name in _OF_ROWS if name in call.params}
    return {"convention": "standard", **told, "rows": call.response}


def _evaluation(request: EvaluateRequest, language: str, library: Library) -> dict[str, Any]:
    judged = mued.judged(request, language, library)
    if not isinstance(judged, JudgedAnswer):
        return {"is_correct": False, "feedback": "\n\n".join(judged.sentences(language))}
    title = sentence(language, "evaluation-right" if judged.correct else "evaluation-wrong") or ""
    return {
        "is_correct": judged.correct,
        "feedback": "\n\n".join(judged.sentences()) or title,
        "mark": judged.score,
        "codes": list(judged.codes),
    }


def _preview(request: EvaluateRequest, language: str, library: Library) -> dict[str, Any]:
    entries = mued.evaluate(request, language, library)
    return {"preview": {"feedback": "\n\n".join(entry["message"] for entry in entries)}}


def _health(library: Library) -> dict[str, Any]:
    """Judge a right and a wrong table, as a caller's would be."""
    rows = [{"theta": f"q{i}", "d": 0, "a": f"L{i}", "alpha": 0} for i in (1, 2)]
    cases = {"right_table": (rows, True), "wrong_table": ([{**rows[0], "a": 0}, rows[1]], False)}
    outcome: dict[str, list[dict[str, str]]] = {"successes": [], "failures": [], "errors": []}
    for name, (given, right) in cases.items():
        judged = judge(_CHECKED, {"table": {"convention": "standard", "rows": given}}, library=library)
        if not isinstance(judged, JudgedAnswer):
            outcome["errors"].append({"name": name})
        else:
            outcome["successes" if judged.correct is right else "failures"].append({"name": name})
    return {"tests_passed": not (outcome["failures"] or outcome["errors"]), **outcome}


def _error(fault: Fault, language: str) -> dict[str, Any]:
    return {"error": {"message": told_fault(fault, language), "code": fault.code}}


_PREVIEW, _HEALTH = "preview", "healthcheck"
_COMMANDS: Mapping[str, tuple[str, Callable[[EvaluateRequest, str, Library], dict[str, Any]]]] = {
    "eval": ("eval", _evaluation),
    "grade": ("eval", _evaluation),
    _PREVIEW: (_PREVIEW, _preview),
}
"""Commands, the name under which each is answered, and what carries it out."""
