"""Inverse kinematics: from a pose to the joint variables that reach it.

results      what comes out: solutions with their true residuals, or the nearest pose
arm          a serial chain as constants and joints, for one configuration or many
residuals    how far a pose is from its target
search       damped least squares from many starts at once
closed_form  all solutions of arms that can be taken apart: turning joints by EAIK
sliding      the same for arms with sliding joints
position     three joints that bring a point to its place
limits       turns of a joint into its range
distinct     which solutions are the same, and which belong to a continuum
solve        one target
batch        many targets
"""

from kinematics.inverse.batch import InverseKinematicsBatch, solve_many
from kinematics.inverse.limits import JointLimits
from kinematics.inverse.results import IKSolution, IKStatus, InverseKinematics, NearestPose, UnreachableReason
from kinematics.inverse.solve import Solver, inverse_kinematics, solver_of

__all__ = [
    "IKSolution",
    "IKStatus",
    "InverseKinematics",
    "InverseKinematicsBatch",
    "JointLimits",
    "NearestPose",
    "Solver",
    "UnreachableReason",
    "inverse_kinematics",
    "solve_many",
    "solver_of",
]
