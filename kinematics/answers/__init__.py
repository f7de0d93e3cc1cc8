"""Does an answer mean the same? Decisions about what students compute from a robot, in any frames.

joint_answers        joint values that reach a pose: one, all, families of them, or none
joint_rows           one row of them
joint_questions      such a pose, and all that reaches it
joint_verdicts       what is said of them
screw_answers        joint screws and a home pose
jacobian_answers     Jacobians in numbers, and the joint torques and forces for a wrench
jacobian_forms       the same as functions of the joint variables
entry_proofs         are entries the same functions
jacobian_verdicts    what is said of both
singularity_answers  conditions for singularities, as a set, and the motion that is lost
singularity_verdicts  what is said of them
singular_arms        families of singularities and points of them
lost_motions         motions that an arm has lost in a configuration
unit_multiples       is a function a product of given ones, up to what never vanishes
dynamics_answers     equations of motion
dynamics_verdicts    what is said of them
form_samples         points at which closed forms are compared
axis_pairs           how axes lie to each other, in any frames
left_open            by how much decimals may move an entry
"""
