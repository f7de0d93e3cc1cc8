"""The calls of the API, each described once: what is sent, and to where. Both clients send them."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any, TypeAlias

Json: TypeAlias = dict[str, Any]
Table: TypeAlias = Mapping[str, Any]
Matrix: TypeAlias = Sequence[Sequence[float]]


@dataclass(frozen=True, kw_only=True, slots=True)
class ApiCall:
    """One request.

    Attributes:
        method: GET or POST.
        path: path below /api/v1.
        body: JSON body, None for none.
        query: query parameters; those that are None are left out.
    """

    method: str
    path: str
    body: Json | None = None
    query: Mapping[str, str | None] = field(default_factory=dict)


def forward_kinematics(
    robot: Table | str,
    joints: Sequence[float] | Sequence[Sequence[float]],
    *,
    parameters: Mapping[str, float] | None = None,
    parts: Sequence[str] | None = None,
) -> ApiCall:
    """Return poses: ⁰T_N, link transforms, frames (POST /forward-kinematics).

    Args:
        robot: a table, or the id of a robot of the catalogue.
        joints: one configuration, or a list of them [units of the table].
        parameters: values of the table's names.
        parts: what to return; everything if left out.
    """
    return _of_robot("forward-kinematics", robot, joints=joints, parameters=parameters, parts=parts)


def jacobian(
    robot: Table | str, joints: Sequence[float], *, parameters: Mapping[str, float] | None = None
) -> ApiCall:
    """Return J0 and Jn, rank and manipulability (POST /jacobian)."""
    return _of_robot("jacobian", robot, joints=joints, parameters=parameters)


def inverse_kinematics(
    robot: Table | str, target: Matrix, *, parameters: Mapping[str, float] | None = None
) -> ApiCall:
    """Return the joint values that reach a pose, and whether those are all (POST /inverse-kinematics)."""
    return _of_robot("inverse-kinematics", robot, target=target, parameters=parameters)


def symbolic(
    robot: Table | str,
    *,
    formats: Sequence[str] | None = None,
    parts: Sequence[str] | None = None,
    parameters: Mapping[str, float] | None = None,
) -> ApiCall:
    """Return closed forms in the given formats (POST /symbolic)."""
    return _of_robot("symbolic", robot, formats=formats, parts=parts, parameters=parameters)


def robots() -> ApiCall:
    """Return the robots of the catalogue (GET /robots)."""
    return ApiCall(method="GET", path="robots")


def exercises(*, language: str | None = None) -> ApiCall:
    """Return all exercises (GET /exercises)."""
    return ApiCall(method="GET", path="exercises", query={"lang": language})


def exercise(exercise_id: str, *, seed: str | None = None, language: str | None = None) -> ApiCall:
    """Return an exercise with one student's values (GET /exercises/{id})."""
    return ApiCall(method="GET", path=f"exercises/{exercise_id}", query={"seed": seed, "lang": language})


def grade(
    reference: Table,
    submission: Table,
    *,
    policy: Mapping[str, Any] | None = None,
    parameters: Mapping[str, float] | None = None,
    help_level: str | None = None,
) -> ApiCall:
    """Return the verdict on a table by a key of your own (POST /grade)."""
    body = {"reference": dict(reference), "submission": dict(submission)}
    return ApiCall(
        method="POST", path="grade", body=body | _given(policy=policy, parameters=parameters, help=help_level)
    )


def grade_exercise(exercise_id: str, answer: Mapping[str, Any], *, language: str | None = None) -> ApiCall:
    """Return what is said of an answer (POST /exercises/{id}/grade).

    Args:
        exercise_id: the exercise.
        answer: `table` and further parts, `seed`, `help`.
        language: of the sentences.
    """
    path = f"exercises/{exercise_id}/grade"
    return ApiCall(method="POST", path=path, body=dict(answer), query={"lang": language})


def grade_all(
    reference: Table,
    submissions: Sequence[Table],
    *,
    policy: Mapping[str, Any] | None = None,
    parameters: Mapping[str, float] | None = None,
    help_level: str | None = None,
) -> ApiCall:
    """Return the verdicts on many tables by one key, in their order (POST /grade).

    One that cannot be graded has a problem document in the place of its verdict.
    """
    body = {"reference": dict(reference), "submissions": [dict(table) for table in submissions]}
    return ApiCall(
        method="POST", path="grade", body=body | _given(policy=policy, parameters=parameters, help=help_level)
    )


def verify_receipts(receipts: Sequence[str]) -> ApiCall:
    """Return what receipts say, and which of them are not ours (POST /receipts/verify)."""
    return ApiCall(method="POST", path="receipts/verify", body={"receipts": list(receipts)})


def _of_robot(path: str, robot: Table | str, **members: Any) -> ApiCall:
    named = {"robot": robot} if isinstance(robot, str) else {"table": dict(robot)}
    return ApiCall(method="POST", path=path, body={**named, **_given(**members)})


def _given(**members: Any) -> Json:
    return {name: value for name, value in members.items() if value is not None}
