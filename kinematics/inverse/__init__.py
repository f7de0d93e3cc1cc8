"""Inverse kinematics: from a pose to the joint variables that reach it.

results      what comes out: solutions with their true residuals, or the nearest pose
arm          a serial chain as constants and joints, for one configuration or many
residuals    how far a pose is from its target
search       damped least squares from many starts at once
closed_form  methods that yield all solutions, EAIK's among them
partition    arms taken apart into a head that places a point and a tail that turns about it
refinement   from candidates to solutions, none lost at special targets
position     three joints that bring points to their places
limits       turns of a joint into its range
distinct     which solutions are the same, and which belong to a continuum
solve        one target
batch        many targets
judging      what is asked of all their candidates, in one pass
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
