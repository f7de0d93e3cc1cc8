"""The workspace: how near, how far and in which box the joints bring the end frame's origin.

objectives  what is to be maximised: a distance, its negative, a coordinate
coordinate_ascent  the maximum of an objective: joint by joint in closed form, then Newton's steps
conditions  the greatest value of an objective in a plane, or with the tool held as it is
spans       the ranges of the joints
reach       radii, box and points of a robot
"""

from kinematics.workspace.reach import Radii, Radius, Workspace, check_reach, workspace
from kinematics.workspace.spans import joint_spans
