"""The pose whose joint values are asked, and what there is to find."""

from dataclasses import dataclass
from fractions import Fraction
from functools import lru_cache

import numpy as np

from exercises.definition import Part
from exercises.instance import Instance
from exercises.parts.joint_draws import JointDraws, PoseCase, in_radians, key_numbers
from kinematics.answers.joint_questions import JointQuestion, joint_question
from kinematics.forward import forward_kinematics
from kinematics.inverse import ArmReach, solver_of
from kinematics.se3 import Transform
from kinematics.table import JointType

OUT = 3.0
"""How many times as far away a pose is put that cannot be reached: no arm of the catalogue folds so much."""
QUESTIONS = 256  # Poses whose solutions are in the cache: students hand in again.


@dataclass(frozen=True, kw_only=True, slots=True)
class InverseKinematicsPart(Part):
    """A pose whose joint values are asked.

    Attributes:
        joints: those of the pose.
        cases: what the pose may be; drawn.
        every: all solutions are asked, not one.
        reach: what of the last frame has to reach the pose.
        tolerance: of positions as a share of the robot's size, and of angles [rad].
    """

    joints: JointDraws
    cases: tuple[PoseCase, ...]
    every: bool
    reach: ArmReach
    tolerance: float


@dataclass(frozen=True, kw_only=True, slots=True)
class DrawnPose:
    """What is drawn for one student: the joint values, and what becomes of their pose."""

    joints: tuple[Fraction, ...]
    case: PoseCase


def target_of(part: InverseKinematicsPart, instance: Instance) -> Transform:
    """Return the student's pose in the key's frames; lengths in the exercise's unit."""
    drawn: DrawnPose = instance.drawn[part.kind]
    joints = in_radians(instance.exercise, drawn.joints)
    pose = forward_kinematics(key_numbers(instance), joints).transform.copy()
    if drawn.case is PoseCase.OUT_OF_REACH:
        numbers = key_numbers(instance)
        far = sum(abs(row.a) + abs(row.d) for row in numbers.rows) + sum(
            abs(value)
            for value, kind in zip(joints, instance.exercise.reference.table.joint_types, strict=True)
            if kind is JointType.PRISMATIC
        )
        length = float(np.linalg.norm(pose[:3, 3]))
        direction = pose[:3, 3] / length if length > 1e-6 * far else np.array([1.0, 0.0, 0.0])
        pose[:3, 3] = OUT * far * direction
    return pose


@lru_cache(maxsize=QUESTIONS)
def question_of(part: InverseKinematicsPart, instance: Instance) -> JointQuestion:
    """Return the question, with all that a student may find."""
    solver, target = solver_of(key_numbers(instance), reach=part.reach), target_of(part, instance)
    return joint_question(solver, target, every=part.every, tolerance=part.tolerance, reach=part.reach)
