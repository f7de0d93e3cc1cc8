"""The parts of an exercise, in packages: each kind is one module with `PART`, found by `registry`.

protocol     what a kind is; task, what it asks, as a page shows it
context      what the parts of an answer are judged by: the key, the student's own table
samples      points at which functions are compared
report       what is said of one; following, what it earns after a wrong table
first_values             with what its definition begins
joint_draws, given_table   joint values that are drawn, tables that are shown
forward      the table, its drawing, frames and matrices, poses and what is reached
rotations    orientations, what is a rotation, chains of frames
inverse      joint values for a pose
motion       screws, Jacobians, singularities, equations of motion
mistakes     find the mistake; two tables
cells        what students write in several of them, and how entries are compared
"""
