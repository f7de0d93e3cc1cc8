# Frame assignment: its rules and refusals.

rule-z_not_along_axis = z must lie along axis { $axis }, because joint { $axis } turns about this z or slides along it.
rule-origin_not_on_axis = The origin must stand on axis { $axis }, because z of this frame lies along it.
rule-origin_not_on_common_normal = The origin must stand where the common normal of axes { $first } and { $second } meets the axis of this frame, because a is measured along that normal.
rule-origin_not_at_intersection = Axes { $first } and { $second } intersect: the origin belongs at their point of intersection, because a is zero there.
rule-x_not_across_z = x must be at right angles to z, because the axes of a frame are at right angles.
rule-x_not_along_common_normal = x must lie along the common normal of axes { $first } and { $second }, because a is measured along x, and it is the shortest distance between the axes.
rule-x_not_across_both_axes = x must be at right angles to both axes { $first } and { $second }, because α turns one into the other about x.
rule-first_x_misses_axis = x of the first frame must cross axis { $axis } at right angles, because its row has only a and α, along and about x, to get there.
rule-last_x_misses_axis = x of the last frame must cross axis { $axis } at right angles, because its row has only a and α, along and about x, to get from there.
rule-z_reversed = z points against the positive direction of joint axis { $axis }. That is allowed; the joint variable then enters with a minus sign.
rule-x_reversed = x points from axis { $second } to axis { $first }. That is allowed; the link length then becomes negative.
rule-offset_could_vanish = With another origin on this axis, d{ $joint } would be zero.
rule-angle_could_vanish = With another direction of x, θ{ $joint } would be zero.
rule-first_not_simplest = Frame 0 could be placed so that more parameters vanish.
rule-last_not_simplest = The last frame could be placed so that more parameters vanish.

error-axes_wrong_number = A chain has 1 to { $limit } axes; this one has { $count }.
error-axis_joint_unknown = The joint of an axis is revolute or prismatic.
error-gripper_jaws_along_approach = The jaws slide across the approach direction, not along it.
error-vector_malformed = Give three finite numbers x, y, z, none larger than { $limit }.
error-direction_zero = A direction needs a length: 0, 0, 0 points nowhere.
error-frames_too_many = A chain of { $count ->
    [one] one joint
   *[other] { $count } joints
} has the frames 0 to { $count }.
error-frame_y_not_z_cross_x = y follows from z and x. Leave it out, or give z × x beside both of them.
error-parallel_tolerance_out_of_range = The tolerance for parallel axes lies between { $least } and { $greatest } rad.
error-near_parallel = Axes { $previous } and { $joint } are within { $angle } rad of parallel and were treated as parallel. This may rotate the last frame by up to twice that angle and displace it by up to { $displacement }.
error-near_parallel_dummy_row = Axes { $previous } and { $joint } are within { $angle } rad of parallel; a fixed row between them keeps the table exact.
error-base_not_frame_zero_standard = Frame 0 of a standard table has z along axis 1 and its origin on it; the given frame does not, so it is reached only through the base transform.
error-base_not_frame_zero_modified = Frame 0 of a modified table has an x axis that crosses axis 1 at right angles; the given frame does not, so it is reached only through the base transform.
error-tool_not_last_frame_standard = The last frame of a standard table has an x axis that crosses the last joint axis at right angles; the given tool does not, so it is reached only through the tool transform.
error-tool_not_last_frame_modified = The last frame of a modified table has z along the last joint axis and its origin on it; the given tool does not, so it is reached only through the tool transform.
