"""Denavit–Hartenberg kinematics: pure mathematics in radians and one unit of length.

table            what a DH table is: conventions, joint types, rows
dh               what a row means: the product of its elementary motions, written once
se3              rigid motions and 3-vectors
angles           cosines and sines, exact for multiples of 15°
chain            joint axes and a home pose: the arm in numbers, whatever described it
forward          joint values to the pose of every frame
jacobian         joint rates to the velocity of the tool
rates            rates of change, the analytic Jacobian, joint forces
ellipsoids       where the tool moves easily
poses            notations of poses; `pose_batches` for arrays of them
screws           products of exponentials
conversion       standard to modified tables and back
fixed_rows       a constant pose as rows of a table
trajectory       motions from rest to rest
tree_structures  tables that branch
joint_values     one configuration, or a batch
errors           what goes wrong, and where
caching          caches that hold many short results and few long ones
keys             keys of TOML files

The numeric core is exported here. What needs more is imported from where it lives, so that nobody pays for
what is not used: `kinematics.cells` reads tables as people write them, `kinematics.catalogue` knows robots,
`kinematics.symbolic` works in closed form, `kinematics.inverse` solves for joint values, `kinematics.frames`
assigns frames to axes, `kinematics.equivalence` decides whether two tables are the same robot,
`kinematics.answers` judges what students compute from one, `kinematics.scm` speaks the moving-frame notation
of seed 001.

Conventions (order of products, signs, units) are set out in docs/conventions.md.
"""

from kinematics.angles import cos_sin
from kinematics.conversion import Conversion, XScrew, convert, screw_transform
from kinematics.dh import link_transform
from kinematics.errors import (
    CellError,
    DescriptionError,
    Fault,
    JointValueError,
    KinematicsError,
    ParameterError,
    PoseError,
    TableError,
)
from kinematics.forward import ForwardKinematics, end_pose, end_poses, forward_kinematics
from kinematics.jacobian import Dexterity, JacobianFrame, Mobility, dexterity, jacobian
from kinematics.poses import (
    XYZABC,
    AxisAngle,
    PoseNotations,
    Quaternion,
    RollPitchYaw,
    axis_angle_from_transform,
    pose_notations,
    quaternion_from_transform,
    rpy_from_transform,
    transform_from_axis_angle,
    transform_from_quaternion,
    transform_from_rpy,
    transform_from_xyzabc,
    xyzabc_from_transform,
)
from kinematics.screws import (
    ProductOfExponentials,
    Screw,
    exponential,
    pose_of_product,
    product_of_exponentials,
    table_of_product,
)
from kinematics.se3 import Transform, check_transform, inverse_transform
from kinematics.table import (
    Convention,
    DHRow,
    DHTable,
    JointType,
    NumericRow,
    NumericTable,
    SymbolicRow,
    SymbolicTable,
    bind,
    table_parameters,
)

__all__ = [
    "XYZABC",
    "AxisAngle",
    "CellError",
    "Convention",
    "Conversion",
    "DHRow",
    "DHTable",
    "DescriptionError",
    "Dexterity",
    "Fault",
    "ForwardKinematics",
    "JacobianFrame",
    "JointType",
    "JointValueError",
    "KinematicsError",
    "Mobility",
    "NumericRow",
    "NumericTable",
    "ParameterError",
    "PoseError",
    "PoseNotations",
    "ProductOfExponentials",
    "Quaternion",
    "RollPitchYaw",
    "Screw",
    "SymbolicRow",
    "SymbolicTable",
    "TableError",
    "Transform",
    "XScrew",
    "axis_angle_from_transform",
    "bind",
    "check_transform",
    "convert",
    "cos_sin",
    "dexterity",
    "end_pose",
    "end_poses",
    "exponential",
    "forward_kinematics",
    "inverse_transform",
    "jacobian",
    "link_transform",
    "pose_notations",
    "pose_of_product",
    "product_of_exponentials",
    "quaternion_from_transform",
    "rpy_from_transform",
    "screw_transform",
    "table_of_product",
    "table_parameters",
    "transform_from_axis_angle",
    "transform_from_quaternion",
    "transform_from_rpy",
    "transform_from_xyzabc",
    "xyzabc_from_transform",
]
