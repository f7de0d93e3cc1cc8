# Inverse kinematics.

error-inverse_form_unknown = No symbolic inverse kinematics is known for the way in which the axes of this arm follow one another: they have to be parallel or at right angles, with two or three joints that move in a plane and a wrist whose axes meet in one point. The numeric solution works all the same.
error-inverse_form_idle_joint = Joint { $joint } does nothing where the symbolic solution needs it: the point that it would have to move lies on its axis, or another joint moves this point in the same way, because a length between axes is 0 or two slides are parallel. The numeric solution works all the same.
error-inverse_joint_count = Inverse kinematics takes 1 to { $limit } joints; this table has { $count }.
error-limits_wrong_length = The arm has { $expected ->
    [one] one joint
   *[other] { $expected } joints
}, but { $given ->
    [one] one limit was
   *[other] { $given } limits were
} given; give one for each joint, null where there is none.
error-limits_reversed = Give the limits of joint { $joint } as its least and its greatest value, in this order.
error-limits_too_far = The limits of joint { $joint } are both more than { $limit } rad from 0. Subtract full turns from both.
error-pose_tolerance_out_of_range = The tolerance is a positive number, at most { $limit }.
error-targets_wrong_shape = Give several targets as a list of 4×4 matrices.
error-workspace_condition_unmet = No configuration within the limits was found that meets this condition.
