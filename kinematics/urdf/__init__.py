"""URDF: a DH table as a robot description that other programs load, and the way back.

document  XML text to links and joints; what is unsafe or malformed is refused
chain     the one serial chain of a description that is meant
reading   that chain to a DH table
writing   a DH table to XML text
"""

from kinematics.urdf.document import MAX_CHARACTERS
from kinematics.urdf.reading import UrdfRobot, table_from_urdf
from kinematics.urdf.writing import WrittenUrdf, urdf_from_table

__all__ = ["MAX_CHARACTERS", "UrdfRobot", "WrittenUrdf", "table_from_urdf", "urdf_from_table"]
