"""Robots, what is asked of them, and what is computed.

prepared_robots, prepared_chains   a robot that can be computed with
robot_questions, joint_values, pose_matrices, exact_values   what is asked at which values
pose_answers, link_points, inverse_solutions, inverse_forms, dynamics,
motion_products, chain_forms, conversion   what is computed
answer_functions                   functions that an answer to a `check-…` call holds
symbolic_tasks, symbolic_forms     closed forms, made by worker processes
written_tables                     tables as they are sent
"""
