"""From a validated request to the domain's objects, and from its results to what is sent.

Robots and what is asked of them:
  prepared_robots, prepared_chains   a robot that can be computed with
  robot_questions, joint_values, pose_matrices, exact_values   what is asked at which values
  fault_pointers, fault_entries      faults at their places in the request
What is computed:
  pose_answers, inverse_solutions, inverse_forms, frame_assignment, orientations, dynamics,
  motion_products, chain_forms, conversion
  symbolic_tasks, symbolic_forms     closed forms, made by worker processes
  written_tables                     tables as they are sent
Answers of students:
  verdicts, many_grades, ungraded    what is said of them, and what is refused
  checks                             the `check-…` calls
  planted_choice                     planted mistakes
Exercises and courses:
  exercise_views, figure_files       exercises and their figures
  drafts, courses                    what authors, students and lecturers are shown
How it is sent:
  answer_cache, json_chunks          kept, and written in pieces
"""
