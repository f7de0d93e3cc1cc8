"""Does an answer mean the same? Decisions about what students compute from a robot, in any frames.

joint_answers   joint values that reach a pose: one, all, families of them, or none
screw_answers   joint screws and a home pose
jacobian_answers  Jacobians in numbers, and the joint forces that hold a wrench
"""
