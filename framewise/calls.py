"""The calls about robots, each described once: what is sent, and to where. Both clients send them.

Numbers may be NumPy's: a client sends an array as the list that it is.
"""

from collections.abc import Mapping, Sequence
from typing import Any, TypeAlias

from framewise.sender import Answer, Answers, Chain, Content, Sender, Table, step

Matrix: TypeAlias = Sequence[Sequence[float]]
Joints: TypeAlias = Sequence[float]


class KinematicsCalls(Sender[Answer, Content, Answers]):
    """Calls about robots."""

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
        """Return velocities, accelerations, and torques and forces for a wrench (POST /rates).

        Args:
            robot: a table, or the id of a robot of the catalogue.
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

    def rotations(self, orientation: Mapping[str, Any], **options: Any) -> Answer:
        """Return an orientation in every representation (POST /rotations)."""
        return self.post("rotations", orientation=dict(orientation), **options)

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

    def problem(self, code: str) -> Answer:
        """Return what a code of a refusal means (GET /problems/{code})."""
        return self.get(f"problems/{step(code)}")

    def trees(self, tree: Mapping[str, Any], **options: Any) -> Answer:
        """Return the frames, Jacobians and tables of an arm that branches (POST /trees).

        Args:
            tree: its rows, each with the row that it follows, and its ends.
            options: `parameters`, `joints`.
        """
        return self.post("trees", tree=dict(tree), **options)
