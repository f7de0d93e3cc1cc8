"""Forward kinematics: joint values to the poses of every frame."""

from numpy.typing import ArrayLike

from kinematics.evaluation.plan import EvaluationPlan, Quantity, plan_of
from kinematics.joint_values import configurations, many_configurations, one_configuration
from kinematics.se3 import Floats, Transform
from kinematics.table import NumericTable


class ForwardKinematics:
    """Poses of a serial chain at one configuration, or at m of them (each array then has a leading axis m).

    Links and frames are computed at first use; the object is immutable.

    Attributes:
        transform: (4, 4) pose of the end frame, base and tool included.
        links: (rows, 4, 4) pose of frame i in frame i-1.
        frames: (rows, 4, 4) pose of frame i in the world (frame 0 if there is no base), the tool left out.
    """

    __slots__ = ("_frames", "_joints", "_links", "_plan", "transform")

    def __init__(self, plan: EvaluationPlan, joints: list[float] | Floats, transform: Transform) -> None:
        self.transform, self._plan, self._joints = transform, plan, joints

    def __repr__(self) -> str:
        return f"ForwardKinematics(transform={self.transform!r})"

    @property
    def links(self) -> Floats:
        """(rows, 4, 4) pose of frame i in frame i-1, or (m, rows, 4, 4)."""
        links: Floats | None = getattr(self, "_links", None)
        if links is None:
            links = self._links = self._of(Quantity.LINKS)
        return links

    @property
    def frames(self) -> Floats:
        """(rows, 4, 4) pose of frame i in the world, or (m, rows, 4, 4)."""
        frames: Floats | None = getattr(self, "_frames", None)
        if frames is None:
            frames = self._of(Quantity.FRAMES)
            if not self._plan.has_tool and frames.shape[-3]:
                # The same pose, but summed in another order: without this the last digits would differ.
                frames[..., -1, :, :] = self.transform
            self._frames = frames
        return frames

    def _of(self, quantity: Quantity) -> Floats:
        computation = self._plan.of(quantity)
        if isinstance(self._joints, list):
            return computation.once(self._joints)
        return computation.many(self._joints)


def forward_kinematics(
    table: NumericTable, joints: ArrayLike, *, base: ArrayLike | None = None, tool: ArrayLike | None = None
) -> ForwardKinematics:
    """Return the poses of every frame: T = base · A_1 ⋯ A_N · tool.

    Args:
        joints: (n,) joint variables in joint order [rad, or m for a prismatic joint], or (m, n) for a batch.
        base: (4, 4) pose of frame 0 in the world; the identity if left out.
        tool: (4, 4) pose of the tool in frame N; the identity if left out.

    Raises:
        JointValueError: not n finite values, or lengths so large that the result overflows.
        PoseError: base or tool is not a rigid transform.
        TableError: an entry of the table is NaN or infinite.

    Source: seed 000 eq. 3.3.
    """
    plan = plan_of(table, base, tool)
    values = configurations(joints, plan.n_joints)
    if isinstance(values, list):
        return ForwardKinematics(plan, values, plan.pose.once(values))
    batch = values.copy() if values is joints or values.base is not None else values
    return ForwardKinematics(plan, batch, plan.pose.many(batch))


def end_pose(
    table: NumericTable, joints: ArrayLike, *, base: ArrayLike | None = None, tool: ArrayLike | None = None
) -> Transform:
    """Return the pose of the end frame alone, (4, 4): what `forward_kinematics` calls `transform`.

    Args and raises as in `forward_kinematics`, for one configuration.
    """
    plan = plan_of(table, base, tool)
    values = configurations(joints, plan.n_joints)
    return plan.pose.once(values if isinstance(values, list) else one_configuration(values, plan.n_joints))


def end_poses(
    table: NumericTable, joints: ArrayLike, *, base: ArrayLike | None = None, tool: ArrayLike | None = None
) -> Transform:
    """Return the poses of the end frame at many configurations.

    Cosine and sine come from one tangent here (see `kinematics.angles`), so a pose may differ from that of
    `end_pose` in the last digits: by a few 1e-16 for each row, times the length of the chain.

    Args and raises as in `forward_kinematics`, for (m, n) joint variables, one configuration a row.

    Returns:
        (m, 4, 4) transforms.
    """
    plan = plan_of(table, base, tool)
    return plan.pose.many(many_configurations(joints, plan.n_joints))
