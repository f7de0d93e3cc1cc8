"""The parts of an exercise: each kind is one module with `PART`, found by `registry`.

protocol     what a kind is
context      what the parts of an answer are judged by: the key, the student's own table
report       what is said of one
definition_keys  what its definition may say
Of the table:
  table, schematic, frames, link_matrices, transform, pose, workspace
Of the robot:
  orientation, rotation_check, frame_chain, screws, joint_solutions (inverse kinematics), jacobians,
  jacobian_forms, singularities, equations_of_motion
Find the mistake:
  find_mistake, matrix_mistake, frame_mistake, compare_tables
What several share:
  number_cells, matrix_cells, orientation_cells, jacobian_cells, conditions, by_name   what students write
  joint_draws, drawn_orientations, given_table, figure_frames   what is drawn and shown
  comparison, value, reach, joint_feedback   how it is judged
  found_mistakes, planting, planted_matrices   planted mistakes
"""
