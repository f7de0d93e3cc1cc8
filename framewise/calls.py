"""The calls of the API, each described once: what is sent, and to where. Both clients send them.

Numbers may be NumPy's: a client sends an array as the list that it is.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any, TypeAlias
from urllib.parse import quote

Json: TypeAlias = dict[str, Any]
Table: TypeAlias = Mapping[str, Any]
Matrix: TypeAlias = Sequence[Sequence[float]]
Joints: TypeAlias = Sequence[float]
Chain: TypeAlias = Mapping[str, Any] | str
"""An SCM chain, or the id of a robot of the catalogue."""


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
    joints: Joints | Sequence[Joints],
    *,
    parts: Sequence[str] | None = None,
    **options: Any,
) -> ApiCall:
    """Return poses: ⁰T_N, link transforms, frames (POST /forward-kinematics).

    Args:
        robot: a table, or the id of a robot of the catalogue.
        joints: one configuration, or a list of them [units of the table].
        parts: what to return; everything if left out.
        options: further members of the body, as the API describes them: `parameters`, `base`, `tool` ….
    """
    return _of_robot("forward-kinematics", robot, joints=joints, parts=parts, **options)


def jacobian(robot: Table | str, joints: Joints, **options: Any) -> ApiCall:
    """Return J0 and Jn, rank and manipulability (POST /jacobian)."""
    return _of_robot("jacobian", robot, joints=joints, **options)


def inverse_kinematics(robot: Table | str, target: Matrix | None = None, **options: Any) -> ApiCall:
    """Return the joint values that reach a pose, and whether those are all (POST /inverse-kinematics).

    Args:
        robot: a table, or the id of a robot of the catalogue.
        target: the pose as a 4×4 matrix; or `targets`, `position`, `quaternion`, `axis` as options.
        options: further members of the body: `limits`, `start`, `tolerance` ….
    """
    return _of_robot("inverse-kinematics", robot, target=target, **options)


def check_inverse_kinematics(robot: Table | str, target: Any, **options: Any) -> ApiCall:
    """Return whether joint values, or a claim, answer a question (POST /check-inverse-kinematics)."""
    return _of_robot("check-inverse-kinematics", robot, target=target, **options)


def symbolic(
    robot: Table | str,
    *,
    formats: Sequence[str] | None = None,
    parts: Sequence[str] | None = None,
    **options: Any,
) -> ApiCall:
    """Return closed forms in the given formats (POST /symbolic)."""
    return _of_robot("symbolic", robot, formats=formats, parts=parts, **options)


def dynamics(robot: Table | str, joints: Joints | None = None, **options: Any) -> ApiCall:
    """Return M, C, g and torques, in numbers or in closed form (POST /dynamics).

    Args:
        robot: a table, or the id of a robot of the catalogue.
        joints: the configuration; none with the option `form="symbolic"`.
        options: `links`, `gravity`, `rates`, `accelerations`, `torque`, `parameters`; `parts`, `formats`,
            `notation` of closed forms.
    """
    return _of_robot("dynamics", robot, joints=joints, **options)


def rates(robot: Table | str, joints: Joints, **options: Any) -> ApiCall:
    """Return velocities, accelerations and the forces that hold a wrench (POST /rates).

    Args:
        robot: a table, or the id of a robot of the catalogue.
        joints: the configuration.
        options: `rates`, `accelerations`, `wrench`, `parameters`, `base`, `tool`.
    """
    return _of_robot("rates", robot, joints=joints, **options)


def trajectory(robot: Table | str, start: Joints, end: Joints, **options: Any) -> ApiCall:
    """Return a motion between two configurations, with its velocities (POST /trajectory)."""
    return _of_robot("trajectory", robot, start=start, end=end, **options)


def workspace(robot: Table | str, **options: Any) -> ApiCall:
    """Return what a robot reaches (POST /workspace)."""
    return _of_robot("workspace", robot, **options)


def understand(table: Table, **options: Any) -> ApiCall:
    """Return how a table is read, cell by cell (POST /understand).

    Args:
        table: the table.
        options: `parameters`, `exercise`, `matrices`.
    """
    return post("understand", table=dict(table), **options)


def convert(to: str | Mapping[str, Any], **source: Any) -> ApiCall:
    """Return a robot in another description (POST /convert).

    Args:
        to: the description that is wanted.
        source: what is given, one of `table`, `robot`, `scm`, `poe`, `urdf`, and further members of the body.
    """
    return post("convert", to=to, **source)


def assign_frames(axes: Sequence[Mapping[str, Any]], convention: str, **options: Any) -> ApiCall:
    """Return DH frames on joint axes, with the table that follows (POST /assign-frames)."""
    return post("assign-frames", axes=list(axes), convention=convention, **options)


def check_frames(
    axes: Sequence[Mapping[str, Any]], convention: str, frames: Sequence[Mapping[str, Any]], **options: Any
) -> ApiCall:
    """Return which rules of a convention frames break (POST /check-frames)."""
    return post("check-frames", axes=list(axes), convention=convention, frames=list(frames), **options)


def rotations(orientation: Mapping[str, Any], **options: Any) -> ApiCall:
    """Return an orientation in every representation (POST /rotations)."""
    return post("rotations", orientation=dict(orientation), **options)


def check_rotation(expected: Mapping[str, Any], answer: Any, **options: Any) -> ApiCall:
    """Return whether an orientation is the expected one (POST /check-rotation)."""
    return post("check-rotation", expected=dict(expected), answer=answer, **options)


def scm_forward_kinematics(chain: Chain, **options: Any) -> ApiCall:
    """Return the transforms of an SCM chain (POST /scm/forward-kinematics)."""
    return _of_chain("forward-kinematics", chain, **options)


def scm_inverse_transform(chain: Chain, **options: Any) -> ApiCall:
    """Return the inverse of an SCM chain's transform (POST /scm/inverse-transform)."""
    return _of_chain("inverse-transform", chain, **options)


def scm_jacobian(chain: Chain, **options: Any) -> ApiCall:
    """Return the Jacobian of an SCM chain (POST /scm/jacobian)."""
    return _of_chain("jacobian", chain, **options)


def scm_inverse_kinematics(chain: Chain, target: Any, **options: Any) -> ApiCall:
    """Return the joint values with which an SCM chain reaches a pose (POST /scm/inverse-kinematics)."""
    return _of_chain("inverse-kinematics", chain, target=target, **options)


def scm_random_configuration(chain: Chain, **options: Any) -> ApiCall:
    """Return random joint values of an SCM chain within its limits (POST /scm/random-configuration)."""
    return _of_chain("random-configuration", chain, **options)


def scm_products(products: Sequence[Any], **options: Any) -> ApiCall:
    """Return products of motions of one's own (POST /scm/products)."""
    return post("scm/products", products=list(products), **options)


def robots(*, language: str | None = None) -> ApiCall:
    """Return the robots of the catalogue (GET /robots)."""
    return ApiCall(method="GET", path="robots", query={"lang": language})


def robot(robot_id: str, *, language: str | None = None) -> ApiCall:
    """Return a robot of the catalogue (GET /robots/{robot_id})."""
    return ApiCall(method="GET", path=f"robots/{step(robot_id)}", query={"lang": language})


def exercises(*, language: str | None = None) -> ApiCall:
    """Return all exercises (GET /exercises)."""
    return ApiCall(method="GET", path="exercises", query={"lang": language})


def exercise(exercise_id: str, *, seed: str | None = None, language: str | None = None) -> ApiCall:
    """Return an exercise with one student's values (GET /exercises/{exercise_id})."""
    query = {"seed": seed, "lang": language}
    return ApiCall(method="GET", path=f"exercises/{step(exercise_id)}", query=query)


def figure(exercise_id: str, *, seed: str | None = None, language: str | None = None) -> ApiCall:
    """Return an exercise's figure as SVG (GET /exercises/{exercise_id}/figure.svg)."""
    query = {"seed": seed, "lang": language}
    return ApiCall(method="GET", path=f"exercises/{step(exercise_id)}/figure.svg", query=query)


def scorm_package(
    exercise_id: str,
    *,
    version: str = "1.2",
    language: str | None = None,
    help_level: str | None = None,
    per_student: bool = False,
    passing: float | None = None,
) -> ApiCall:
    """Return an exercise as a SCORM package (GET /exercises/{exercise_id}/scorm.zip).

    Args:
        exercise_id: the exercise.
        version: "1.2" or "2004".
        language: of the page.
        help_level: less help than the exercise allows.
        per_student: whether every student gets values of their own.
        passing: share of the points from which on the LMS is told "passed".
    """
    query = {
        "version": version,
        "lang": language,
        "help": help_level,
        "per_student": "true" if per_student else None,
        "pass": None if passing is None else str(passing),
    }
    return ApiCall(method="GET", path=f"exercises/{step(exercise_id)}/scorm.zip", query=query)


def grade(reference: Table, submission: Table, **options: Any) -> ApiCall:
    """Return the verdict on a table by a key of your own (POST /grade).

    Args:
        reference: the key.
        submission: the answer.
        options: `policy`, `parameters`, `help`.
    """
    return post("grade", reference=dict(reference), submission=dict(submission), **options)


def grade_all(reference: Table, submissions: Sequence[Table], **options: Any) -> ApiCall:
    """Return the verdicts on many tables by one key, in their order (POST /grade).

    One that cannot be graded has a problem document in the place of its verdict.
    """
    return post("grade", reference=dict(reference), submissions=list(map(dict, submissions)), **options)


def grade_exercise(exercise_id: str, answer: Mapping[str, Any], *, language: str | None = None) -> ApiCall:
    """Return what is said of an answer (POST /exercises/{exercise_id}/grade).

    Args:
        exercise_id: the exercise.
        answer: `table` and further parts, `seed`, `help`.
        language: of the sentences.
    """
    path = f"exercises/{step(exercise_id)}/grade"
    return ApiCall(method="POST", path=path, body=dict(answer), query={"lang": language})


def receipt(exercise_id: str, answer: Mapping[str, Any], name: str) -> ApiCall:
    """Return the receipt of an answer (POST /exercises/{exercise_id}/receipts).

    Args:
        exercise_id: the exercise.
        answer: as for `grade_exercise`.
        name: the student's, as it is to stand there.
    """
    return post(f"exercises/{step(exercise_id)}/receipts", **{**answer, "name": name})


def verify_receipts(receipts: Sequence[str]) -> ApiCall:
    """Return what receipts say, and which of them are not ours (POST /receipts/verify)."""
    return post("receipts/verify", receipts=list(receipts))


def receipt_keys() -> ApiCall:
    """Return the public keys of receipts, a JWK Set (GET /receipts/keys)."""
    return ApiCall(method="GET", path="receipts/keys")


def problem(code: str) -> ApiCall:
    """Return what a code of a refusal means (GET /problems/{code})."""
    return ApiCall(method="GET", path=f"problems/{step(code)}")


def check_jacobian(robot: Table | str, joints: Joints, jacobian: Matrix, **options: Any) -> ApiCall:
    """Return whether a Jacobian, as numbers, is a table's (POST /check-jacobian).

    Args:
        robot: a table, or the id of a robot of the catalogue.
        joints: where it was taken [units of the table].
        jacobian: the matrix.
        options: further members of the body: `point`, `frame`, `wrench`, `forces` ….
    """
    return _of_robot("check-jacobian", robot, joints=joints, jacobian=jacobian, **options)


def check_jacobian_form(robot: Table | str, jacobian: Sequence[Sequence[Any]], **options: Any) -> ApiCall:
    """Return whether a Jacobian, as functions of the joints, is a table's (POST /check-jacobian-form)."""
    return _of_robot("check-jacobian-form", robot, jacobian=jacobian, **options)


def check_singularities(robot: Table | str, conditions: Sequence[str], **options: Any) -> ApiCall:
    """Return whether an arm is singular just where conditions hold (POST /check-singularities).

    Args:
        robot: a table, or the id of a robot of the catalogue.
        conditions: functions that vanish, or equations.
        options: further members of the body: `motion`, `joints`, `lost`, `parameters` ….
    """
    return _of_robot("check-singularities", robot, conditions=list(conditions), **options)


def check_dynamics(robot: Table | str, **options: Any) -> ApiCall:
    """Return whether M, C and g are those of a robot with weights (POST /check-dynamics).

    Args:
        robot: a table, or the id of a robot of the catalogue.
        options: the answer's `M`, `C` or `h`, and `g`; `links`, `gravity`, `parameters`, `tolerance`.
    """
    return _of_robot("check-dynamics", robot, **options)


def check_screws(robot: Table | str, screws: Sequence[Any], home: Any, **options: Any) -> ApiCall:
    """Return whether screws and a home pose describe a table's robot (POST /check-screws)."""
    return _of_robot("check-screws", robot, screws=screws, home=home, **options)


def trees(tree: Mapping[str, Any], **options: Any) -> ApiCall:
    """Return the frames, Jacobians and tables of an arm that branches (POST /trees).

    Args:
        tree: its rows, each with the row that it follows, and its ends.
        options: `parameters`, `joints`.
    """
    return post("trees", tree=dict(tree), **options)


def post(path: str, **members: Any) -> ApiCall:
    """Return the answer of any call that takes a body, by its path below /api/v1.

    Args:
        path: such as `check-inverse-kinematics`.
        members: of the body; those that are None are left out.
    """
    given = {name: value for name, value in members.items() if value is not None}
    return ApiCall(method="POST", path=path, body=given)


def get(path: str, **query: str | None) -> ApiCall:
    """Return the answer of any call that takes none, by its path below /api/v1 and its query."""
    return ApiCall(method="GET", path=path, query=query)


def step(name: str) -> str:
    """Return a name as one step of a path, whatever stands in it."""
    return quote(name, safe="")


def _of_robot(path: str, robot: Table | str, **members: Any) -> ApiCall:
    named = {"robot": robot} if isinstance(robot, str) else {"table": dict(robot)}
    return post(path, **named, **members)


def _of_chain(path: str, chain: Chain, **members: Any) -> ApiCall:
    named = {"robot": chain} if isinstance(chain, str) else {"chain": dict(chain)}
    return post(f"scm/{path}", **named, **members)
