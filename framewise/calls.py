"""The calls of the API, each described once: what is sent, and to where. Both clients send them.

Numbers may be NumPy's: a client sends an array as the list that it is.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any, Generic, TypeAlias, TypeVar
from urllib.parse import quote

Answer = TypeVar("Answer", covariant=True)
Content = TypeVar("Content", covariant=True)
Answers = TypeVar("Answers", covariant=True)

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


class Sender(ABC, Generic[Answer, Content, Answers]):
    """What sends a call, now or later, and how calls are told it."""

    @abstractmethod
    def send(self, call: ApiCall, /) -> Answer:
        """Send a call and return its JSON.

        Raises:
            ProblemError: the service refuses.
            httpx.HTTPError: the service cannot be reached.
        """

    @abstractmethod
    def fetch(self, call: ApiCall, /) -> Content:
        """Send a call and return what comes, such as a picture or a package; raises as `send` does."""

    @abstractmethod
    def stream(self, call: ApiCall, /) -> Answers:
        """Send a call and yield its answers as they come, line by line; raises as `send` does."""

    def post(self, path: str, **members: Any) -> Answer:
        """Return the answer of any call that takes a body, by its path below /api/v1.

        Args:
            path: such as `check-inverse-kinematics`.
            members: of the body; those that are None are left out.
        """
        return self.send(posted(path, **members))

    def get(self, path: str, **query: str | None) -> Answer:
        """Return the answer of any call that takes none, by its path below /api/v1 and its query."""
        return self.send(ApiCall(method="GET", path=path, query=query))

    def _of_robot(self, path: str, robot: Table | str, **members: Any) -> Answer:
        named = {"robot": robot} if isinstance(robot, str) else {"table": dict(robot)}
        return self.post(path, **named, **members)

    def _of_chain(self, path: str, chain: Chain, **members: Any) -> Answer:
        named = {"robot": chain} if isinstance(chain, str) else {"chain": dict(chain)}
        return self.post(f"scm/{path}", **named, **members)


def posted(path: str, **members: Any) -> ApiCall:
    """Return a call with a body; members that are None are left out."""
    given = {name: value for name, value in members.items() if value is not None}
    return ApiCall(method="POST", path=path, body=given)


def step(name: str) -> str:
    """Return a name as one step of a path, whatever stands in it."""
    return quote(name, safe="")


class KinematicsCalls(Sender[Answer, Content, Answers]):
    """Calls about robots and exercises that are there."""

    def forward_kinematics(
        self,
        robot: Table | str,
        joints: Joints | Sequence[Joints],
        *,
        parts: Sequence[str] | None = None,
        **options: Any,
    ) -> Answer:
        """Return poses: ⁰T_N, link transforms, frames (POST /forward-kinematics).

        Args:
            robot: a table, or the id of a robot of the catalogue.
            joints: one configuration, or a list of them [units of the table].
            parts: what to return; everything if left out.
            options: further members of the body, as the API describes them: `parameters`, `base`, `tool` ….
        """
        return self._of_robot("forward-kinematics", robot, joints=joints, parts=parts, **options)

    def jacobian(self, robot: Table | str, joints: Joints, **options: Any) -> Answer:
        """Return J0 and Jn, rank and manipulability (POST /jacobian)."""
        return self._of_robot("jacobian", robot, joints=joints, **options)

    def inverse_kinematics(self, robot: Table | str, target: Matrix | None = None, **options: Any) -> Answer:
        """Return the joint values that reach a pose, and whether those are all (POST /inverse-kinematics).

        Args:
            robot: a table, or the id of a robot of the catalogue.
            target: the pose as a 4×4 matrix; or `targets`, `position`, `quaternion`, `axis` as options.
            options: further members of the body: `limits`, `start`, `tolerance` ….
        """
        return self._of_robot("inverse-kinematics", robot, target=target, **options)

    def check_inverse_kinematics(self, robot: Table | str, target: Any, **options: Any) -> Answer:
        """Return whether joint values, or a claim, answer a question (POST /check-inverse-kinematics)."""
        return self._of_robot("check-inverse-kinematics", robot, target=target, **options)

    def symbolic(
        self,
        robot: Table | str,
        *,
        formats: Sequence[str] | None = None,
        parts: Sequence[str] | None = None,
        **options: Any,
    ) -> Answer:
        """Return closed forms in the given formats (POST /symbolic)."""
        return self._of_robot("symbolic", robot, formats=formats, parts=parts, **options)

    def dynamics(self, robot: Table | str, joints: Joints | None = None, **options: Any) -> Answer:
        """Return M, C, g and torques, in numbers or in closed form (POST /dynamics).

        Args:
            robot: a table, or the id of a robot of the catalogue.
            joints: the configuration; none with the option `form="symbolic"`.
            options: `links`, `gravity`, `rates`, `accelerations`, `torque`, `parameters`; `parts`, `formats`,
                `notation` of closed forms.
        """
        return self._of_robot("dynamics", robot, joints=joints, **options)

    def rates(self, robot: Table | str, joints: Joints, **options: Any) -> Answer:
        """Return velocities, accelerations and the forces that hold a wrench (POST /rates).

        Args:
            robot: a table, or the id of a robot of the catalogue.
            joints: the configuration.
            options: `rates`, `accelerations`, `wrench`, `parameters`, `base`, `tool`.
        """
        return self._of_robot("rates", robot, joints=joints, **options)

    def trajectory(self, robot: Table | str, start: Joints, end: Joints, **options: Any) -> Answer:
        """Return a motion between two configurations, with its velocities (POST /trajectory)."""
        return self._of_robot("trajectory", robot, start=start, end=end, **options)

    def workspace(self, robot: Table | str, **options: Any) -> Answer:
        """Return what a robot reaches (POST /workspace)."""
        return self._of_robot("workspace", robot, **options)

    def understand(self, table: Table, **options: Any) -> Answer:
        """Return how a table is read, cell by cell (POST /understand).

        Args:
            table: the table.
            options: `parameters`, `exercise`, `matrices`.
        """
        return self.post("understand", table=dict(table), **options)

    def convert(self, to: str | Mapping[str, Any], **source: Any) -> Answer:
        """Return a robot in another description (POST /convert).

        Args:
            to: the description that is wanted.
            source: what is given, one of `table`, `robot`, `scm`, `poe`, `urdf`, and further members
                of the body.
        """
        return self.post("convert", to=to, **source)

    def assign_frames(self, axes: Sequence[Mapping[str, Any]], convention: str, **options: Any) -> Answer:
        """Return DH frames on joint axes, with the table that follows (POST /assign-frames)."""
        return self.post("assign-frames", axes=list(axes), convention=convention, **options)

    def check_frames(
        self,
        axes: Sequence[Mapping[str, Any]],
        convention: str,
        frames: Sequence[Mapping[str, Any]],
        **options: Any,
    ) -> Answer:
        """Return which rules of a convention frames break (POST /check-frames)."""
        return self.post(
            "check-frames", axes=list(axes), convention=convention, frames=list(frames), **options
        )

    def rotations(self, orientation: Mapping[str, Any], **options: Any) -> Answer:
        """Return an orientation in every representation (POST /rotations)."""
        return self.post("rotations", orientation=dict(orientation), **options)

    def check_rotation(self, expected: Mapping[str, Any], answer: Any, **options: Any) -> Answer:
        """Return whether an orientation is the expected one (POST /check-rotation)."""
        return self.post("check-rotation", expected=dict(expected), answer=answer, **options)

    def scm_forward_kinematics(self, chain: Chain, **options: Any) -> Answer:
        """Return the transforms of an SCM chain (POST /scm/forward-kinematics)."""
        return self._of_chain("forward-kinematics", chain, **options)

    def scm_inverse_transform(self, chain: Chain, **options: Any) -> Answer:
        """Return the inverse of an SCM chain's transform (POST /scm/inverse-transform)."""
        return self._of_chain("inverse-transform", chain, **options)

    def scm_jacobian(self, chain: Chain, **options: Any) -> Answer:
        """Return the Jacobian of an SCM chain (POST /scm/jacobian)."""
        return self._of_chain("jacobian", chain, **options)

    def scm_inverse_kinematics(self, chain: Chain, target: Any, **options: Any) -> Answer:
        """Return the joint values with which an SCM chain reaches a pose (POST /scm/inverse-kinematics)."""
        return self._of_chain("inverse-kinematics", chain, target=target, **options)

    def scm_random_configuration(self, chain: Chain, **options: Any) -> Answer:
        """Return random joint values of an SCM chain within its limits (POST /scm/random-configuration)."""
        return self._of_chain("random-configuration", chain, **options)

    def scm_products(self, products: Sequence[Any], **options: Any) -> Answer:
        """Return products of motions of one's own (POST /scm/products)."""
        return self.post("scm/products", products=list(products), **options)

    def robots(self, *, language: str | None = None) -> Answer:
        """Return the robots of the catalogue (GET /robots)."""
        return self.get("robots", lang=language)

    def robot(self, robot_id: str, *, language: str | None = None) -> Answer:
        """Return a robot of the catalogue (GET /robots/{robot_id})."""
        return self.get(f"robots/{step(robot_id)}", lang=language)

    def exercises(self, *, language: str | None = None) -> Answer:
        """Return all exercises (GET /exercises)."""
        return self.get("exercises", lang=language)

    def exercise(self, exercise_id: str, *, seed: str | None = None, language: str | None = None) -> Answer:
        """Return an exercise with one student's values (GET /exercises/{exercise_id})."""
        return self.get(f"exercises/{step(exercise_id)}", seed=seed, lang=language)

    def figure(self, exercise_id: str, *, seed: str | None = None, language: str | None = None) -> Content:
        """Return an exercise's figure as SVG (GET /exercises/{exercise_id}/figure.svg)."""
        query = {"seed": seed, "lang": language}
        return self.fetch(
            ApiCall(method="GET", path=f"exercises/{step(exercise_id)}/figure.svg", query=query)
        )

    def scorm_package(
        self,
        exercise_id: str,
        *,
        version: str = "1.2",
        language: str | None = None,
        help_level: str | None = None,
        per_student: bool = False,
        passing: float | None = None,
    ) -> Content:
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
        return self.fetch(ApiCall(method="GET", path=f"exercises/{step(exercise_id)}/scorm.zip", query=query))

    def grade(self, reference: Table, submission: Table, **options: Any) -> Answer:
        """Return the verdict on a table by a key of your own (POST /grade).

        Args:
            reference: the key.
            submission: the answer.
            options: `policy`, `parameters`, `help`.
        """
        return self.post("grade", reference=dict(reference), submission=dict(submission), **options)

    def grade_all(self, reference: Table, submissions: Sequence[Table], **options: Any) -> Answer:
        """Return the verdicts on many tables by one key, in their order (POST /grade).

        One that cannot be graded has a problem document in the place of its verdict.
        """
        return self.post(
            "grade", reference=dict(reference), submissions=list(map(dict, submissions)), **options
        )

    def grade_each(self, reference: Table, submissions: Sequence[Table], **options: Any) -> Answers:
        """Yield what `grade_all` returns, verdict by verdict (POST /grade)."""
        submitted = list(map(dict, submissions))
        return self.stream(posted("grade", reference=dict(reference), submissions=submitted, **options))

    def grade_exercise(
        self, exercise_id: str, answer: Mapping[str, Any], *, language: str | None = None
    ) -> Answer:
        """Return what is said of an answer (POST /exercises/{exercise_id}/grade).

        Args:
            exercise_id: the exercise.
            answer: `table` and further parts, `seed`, `help`.
            language: of the sentences.
        """
        path = f"exercises/{step(exercise_id)}/grade"
        return self.send(ApiCall(method="POST", path=path, body=dict(answer), query={"lang": language}))

    def receipt(self, exercise_id: str, answer: Mapping[str, Any], name: str) -> Answer:
        """Return the receipt of an answer (POST /exercises/{exercise_id}/receipts).

        Args:
            exercise_id: the exercise.
            answer: as for `grade_exercise`.
            name: the student's, as it is to stand there.
        """
        return self.post(f"exercises/{step(exercise_id)}/receipts", **{**answer, "name": name})

    def verify_receipts(self, receipts: Sequence[str]) -> Answer:
        """Return what receipts say, and which of them are not ours (POST /receipts/verify)."""
        return self.post("receipts/verify", receipts=list(receipts))

    def receipt_keys(self) -> Answer:
        """Return the public keys of receipts, a JWK Set (GET /receipts/keys)."""
        return self.get("receipts/keys")

    def problem(self, code: str) -> Answer:
        """Return what a code of a refusal means (GET /problems/{code})."""
        return self.get(f"problems/{step(code)}")

    def check_jacobian(self, robot: Table | str, joints: Joints, jacobian: Matrix, **options: Any) -> Answer:
        """Return whether a Jacobian, as numbers, is a table's (POST /check-jacobian).

        Args:
            robot: a table, or the id of a robot of the catalogue.
            joints: where it was taken [units of the table].
            jacobian: the matrix.
            options: further members of the body: `point`, `frame`, `wrench`, `forces` ….
        """
        return self._of_robot("check-jacobian", robot, joints=joints, jacobian=jacobian, **options)

    def check_jacobian_form(
        self, robot: Table | str, jacobian: Sequence[Sequence[Any]], **options: Any
    ) -> Answer:
        """Return whether a Jacobian, as functions of the joints, is a table's (POST /check-jacobian-form)."""
        return self._of_robot("check-jacobian-form", robot, jacobian=jacobian, **options)

    def check_singularities(self, robot: Table | str, conditions: Sequence[str], **options: Any) -> Answer:
        """Return whether an arm is singular just where conditions hold (POST /check-singularities).

        Args:
            robot: a table, or the id of a robot of the catalogue.
            conditions: functions that vanish, or equations.
            options: further members of the body: `motion`, `joints`, `lost`, `parameters` ….
        """
        return self._of_robot("check-singularities", robot, conditions=list(conditions), **options)

    def check_dynamics(self, robot: Table | str, **options: Any) -> Answer:
        """Return whether M, C and g are those of a robot with weights (POST /check-dynamics).

        Args:
            robot: a table, or the id of a robot of the catalogue.
            options: the answer's `M`, `C` or `h`, and `g`; `links`, `gravity`, `parameters`, `tolerance`.
        """
        return self._of_robot("check-dynamics", robot, **options)

    def check_screws(self, robot: Table | str, screws: Sequence[Any], home: Any, **options: Any) -> Answer:
        """Return whether screws and a home pose describe a table's robot (POST /check-screws)."""
        return self._of_robot("check-screws", robot, screws=screws, home=home, **options)

    def trees(self, tree: Mapping[str, Any], **options: Any) -> Answer:
        """Return the frames, Jacobians and tables of an arm that branches (POST /trees).

        Args:
            tree: its rows, each with the row that it follows, and its ends.
            options: `parameters`, `joints`.
        """
        return self.post("trees", tree=dict(tree), **options)
