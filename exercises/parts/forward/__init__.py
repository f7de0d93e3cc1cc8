"""Questions of forward kinematics.

table            the DH table, judged by `exercises.grading`
schematic        the robot in words: types of joints, relations of axes
frames, figure_frames   frames on the drawing
link_matrices    ⁱ⁻¹T_i of each row
transform        ⁰T_N in symbols
pose             ⁰T_N in numbers
value            whether a matrix is the ⁰T_N of the robot
workspace, reach the radii between which a point moves
joint_limits     limits of joints, as they are defined and told
"""
