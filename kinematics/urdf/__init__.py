"""URDF: a DH table as a robot description that other programs load, and the way back.

document  XML text to links and joints; what is unsafe or malformed is refused
serial    the one serial chain of a description that is meant
reading   its joint axes, and a DH table of them
writing   a DH table to XML text
"""

from kinematics.urdf.document import MAX_CHARACTERS
from kinematics.urdf.table_reading import UrdfChain, UrdfRobot, chain_from_urdf, table_from_urdf
from kinematics.urdf.writing import (
    BASE_LINK,
    TIP_LINK,
    WrittenUrdf,
    check_joint_names,
    check_link_names,
    urdf_from_table,
)
