"""When are two DH tables the same robot? The decision, with a certificate or what does not fit.

Policy and results:
  policy          what is free and what is fixed
  results         a certificate, or what does not fit
The decision (the theory stands in docs/checker.md):
  decision        the whole of it
  reference       a key, prepared once
  groups, plan    the motions that the choice of frames leaves, axis by axis
  alignment       one axis onto another by such a motion
  tools           where frame N must lie
  search          signs tried down the chain of groups
  certificates    from the motions to (σ, δ, B, E)
  refinement      Gauss–Newton on them
  verification    equation (1) at sampled configurations
  bounds, worst_case  equation (1) at all configurations
  meter           the work is counted, not timed
Proof:
  closed_forms    a certificate's entries in closed form, guessed from numbers
  proof           the certificate as an identity
What does not fit:
  diagnosis       fact by fact
  invariants, home_invariants  facts that no choice of frames changes
  measures, batches  the same of many tables at once; row_measures, where their rows show it
  cell_fitting    cells with which a table would be the robot
  rounding        what the rounding of entries can do
"""

from kinematics.equivalence.decision import decide, decide_draws, mirrored
from kinematics.equivalence.policy import (
    BaseRule,
    ConventionRule,
    DirectionRule,
    Policy,
    Tolerance,
    ToolRule,
    ZeroRule,
)
from kinematics.equivalence.proof import ExactCertificate, prove
from kinematics.equivalence.results import Certificate, Decision, Kind, Mismatch
from kinematics.equivalence.rounding import rounding_tolerance
