"""Whether solutions can be all there are: as many have a positive Jacobian determinant as a negative one.

Six turning joints map a torus to the rigid motions, and not onto them: what is far away is out of reach. So
the degree of the map is 0. It is the sum, over all solutions for one target, of the sign of the determinant,
or of the local degree where the Jacobian has lost rank: at most 1 where it has lost one, and 2^(k-1) where it
has lost k and the k equations that are left are quadratic. Where a solution is missing the sum is not 0.

Source: J. W. Milnor, Topology from the differentiable viewpoint (1965) §5, the degree; D. Eisenbud,
H. I. Levine, An algebraic formula for the degree of a C^∞ map germ, Annals of Math. 106 (1977) 19, the bound.
"""

import math

import numpy as np

from kinematics.inverse.arm import Arm, ArmReach, Array
from kinematics.inverse.self_motions.isolation import MERGING


def signs_cancel(arm: Arm, jacobians: Array, tolerance: float) -> bool:
    """Return whether isolated solutions for a target can be all of them, as far as the degree tells.

    Of those beside a fold, which the tolerance may have joined to others, the sign does not count. Of arms of
    other joints the degree tells nothing.

    Args:
        arm: the arm.
        jacobians: (m, 6, n) at its solutions, each once, whatever the limits of its joints.
        tolerance: [m] and [rad].
    """
    if arm.n_joints != 6 or not arm.revolute.all() or arm.reach is not ArmReach.POSE or arm.redundancy:
        return True
    signs = np.sign(np.linalg.det(jacobians))
    if not signs.sum():
        return True
    lost = (np.linalg.svd(jacobians, compute_uv=False) <= MERGING * math.sqrt(tolerance)).sum(axis=1)
    most = np.exp2(lost[lost > 0] - 1.0).sum()
    return bool(abs(signs[lost == 0].sum()) <= most)
