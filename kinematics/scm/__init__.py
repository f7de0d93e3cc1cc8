"""The SCM method (Sistema Coordenado Móvel) of seed 001: chains of [X Y Z A B C] rows.

`reading` takes a chain as handed in, `chain` says what one is and verifies it, `motion` moves it in numbers
and `dh` turns it into a modified DH table, through which every other method of this package is open to it.
"""

from kinematics.scm.chain import ChainRow, Entry, Placement, ScmChain, verify
from kinematics.scm.dh import modified_dh_from_scm
from kinematics.scm.motion import (
    ScmKinematics,
    forward_kinematics_scm,
    jacobian_base_by_inspection,
    jacobian_end_by_inspection,
)
from kinematics.scm.reading import RawChain, RawPlacement, ReadChain, read_chain

__all__ = [
    "ChainRow",
    "Entry",
    "Placement",
    "RawChain",
    "RawPlacement",
    "ReadChain",
    "ScmChain",
    "ScmKinematics",
    "forward_kinematics_scm",
    "jacobian_base_by_inspection",
    "jacobian_end_by_inspection",
    "modified_dh_from_scm",
    "read_chain",
    "verify",
]
