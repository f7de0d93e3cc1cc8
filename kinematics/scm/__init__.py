"""The SCM method (Sistema Coordenado Móvel) of seed 001: chains of [X Y Z A B C] rows.

chain              what a chain is, and what is verified of it
chain_reading      a chain as it is handed in
motion             direct kinematics and Jacobians by inspection, in numbers
symbolic_matrices  its matrices in closed form
differentiation    the Jacobian by differentiating them
products           products of any motions, in symbols
product_reading    such products as they are handed in
dh                 a chain as a modified DH table, through which every other method is open to it
unrolled           the same for any chain, motion by motion
rows               elementary motions as rows, joined to as few as possible
from_table         a DH table as a chain
sampling           random configurations
substitution       values in the place of parameters

docs/scm.md lists the toolbox's functions.
"""

from kinematics.scm.chain import ChainRow, Entry, Placement, ScmChain, verify
from kinematics.scm.chain_reading import RawChain, RawPlacement, ReadChain, read_chain
from kinematics.scm.dh import modified_dh_from_scm
from kinematics.scm.differentiation import (
    derivative,
    jacobian_by_differentiation,
    jacobian_numbers_by_differentiation,
)
from kinematics.scm.from_table import DescribedScm, scm_from_numbers, scm_from_table, with_tool
from kinematics.scm.motion import (
    ScmKinematics,
    check_values,
    forward_kinematics_scm,
    jacobian_by_inspection,
    unit_vectors,
)
from kinematics.scm.sampling import default_limits, random_configurations
from kinematics.scm.substitution import with_values
from kinematics.scm.symbolic_matrices import (
    ScmClosedForm,
    closed_form_scm,
    inverse_closed_form_scm,
    jacobian_closed_form_scm,
    link_matrix,
)
from kinematics.scm.unrolled import table_of_chain, unrolled_dh_from_scm
