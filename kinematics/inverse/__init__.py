"""Inverse kinematics: from a pose to the joint variables that reach it.

goals          what is to be reached, and within which tolerance
results        what comes out: solutions with their true residuals, families, or the nearest pose
arm            a serial chain as constants and joints, for one configuration or many
scaled_lengths  arms and answers in a unit in which a distance counts as much as an angle
lengths        how long a length may be
residuals      how far a pose is from its target
methods        closed forms, eigenproblems: all solutions of the arms that have them
newton         Newton steps to the nearest pose
search         damped least squares from many starts at once
valleys        folds that a target only just reaches
refinement     from candidates to solutions
distinct       which solutions are the same
degree         whether solutions can be all there are
self_motions   families of solutions, and solutions that stand alone
limits         turns of a joint into its range
solver         one target, of an arm made ready
telling        its solutions with their errors, or the pose that comes nearest
solve          an arm made ready
batch          many targets

Where an argument is not described it is this: `target` the (4, 4) pose that is wanted, or one for each
configuration, (m, 4, 4); `joints`, `q` and `candidates` (m, n) configurations, `x` the same in the units of
the arm (radians, and parts of its size); `tolerance` the distance [m] and the angle [rad] within which a
target is reached.
"""

from kinematics.inverse.arm import ArmReach
from kinematics.inverse.batch import InverseKinematicsBatch, solve_many
from kinematics.inverse.limits import JointLimits
from kinematics.inverse.results import IKSolution, IKStatus, InverseKinematics, NearestPose, UnreachableReason
from kinematics.inverse.solve import inverse_kinematics, solver_of
from kinematics.inverse.solver import Solver

__all__ = [
    "ArmReach",
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
