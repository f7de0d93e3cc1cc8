"""Inverse kinematics: from a pose to the joint variables that reach it.

goals          what is to be reached, and within which tolerance
results        what comes out: solutions with their true residuals, families, or the nearest pose
arm            a serial chain as constants and joints, for one configuration or many
residuals      how far a pose is from its target
closed_form    methods that yield all solutions, and which arm has which:
  wrist          three axes through one point
  wrist_blocks   the same for many targets
  wrist_scalars  the same for one target that is away from singularities
  clear_blocks   both: many targets that are away from singularities
  delicate_blocks  which of many targets need care
  wrist_tapes    what these have recorded of an arm
  parallel       three parallel axes
  general        six turning joints of any kind, as an eigenproblem
  partition      arms of few joints, or with slides before a wrist
  position       three joints that bring points to their places
  trigonometric  equations in the cosine and sine of one angle
  locked         arms with a joint to spare: one is held
search         damped least squares from many starts at once
refinement     from candidates to solutions
distinct       which solutions are the same
isolation      which solutions stand alone, in one pass
components     which solutions stand alone, and which families there are
membership     which solutions belong to a family
corrections    from beside a family back to it
families       families followed along their path
walks          ways from one solution to another
crossings      where families cross others
gaps           families in pieces
valleys        folds that a target only just reaches
lengths        how long a length may be
limits         turns of a joint into its range
ranges         families within joint limits
solver         one target, of an arm made ready
solve          an arm made ready
batch          many targets
judging        what is asked of all their candidates, in one pass
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
