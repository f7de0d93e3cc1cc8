# Inverse kinematics.

error-inverse_form_unknown = The axes of this arm do not follow one another in a way whose inverse kinematics is known in symbols: they have to be at right angles or parallel, with a planar pair or triple of joints and a wrist through one point. In numbers it is solved all the same.
error-inverse_joint_count = Inverse kinematics takes 1 to { $limit } joints; this table has { $count }.
error-limits_wrong_length = The arm has { $expected } joints, but { $given } limits were given; give one for each, null where there is none.
error-limits_reversed = The limits of joint { $joint } are its least and its greatest value, in this order.
error-limits_too_far = The limits of joint { $joint } are both more than { $limit } rad from 0. Take full turns off both.
error-pose_tolerance_out_of_range = The tolerance is a positive number up to { $limit }.
error-targets_wrong_shape = Many targets are a list of 4×4 matrices.
error-workspace_condition_unmet = No configuration within the limits was found that meets this condition.
