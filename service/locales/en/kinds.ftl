### Kinds of question: what is asked, what is said of answers.

field-matrix = Matrix
field-component_order = Order of the quaternion’s components
field-quaternion = Quaternion
field-axis = Axis of rotation
field-angle = Angle of rotation
field-angles = Triples of angles
field-middle = At gimbal lock: the middle angle
field-combination = At gimbal lock: which combination of the first and the last angle is fixed
field-value = Its value
field-matrix_claim = This matrix
field-pose_claim = This pose
field-position_claim = This position
field-pose = Pose
option-wxyz = w, x, y, z: scalar first
option-xyzw = x, y, z, w: scalar last
option-sum = the sum: first + last
option-difference = the difference: first − last
option-rotation = is a rotation
option-unit_columns = is not a rotation: a column is not of length 1
option-perpendicular_columns = is not a rotation: two columns are not at right angles
option-right_handed = is not a rotation: its columns are left-handed (determinant −1)
given-rotation = The orientation as a rotation matrix
given-quaternion = The orientation as a unit quaternion
given-axis_angle = The orientation as axis and angle
given-angles = The orientation in angles
given-matrix = The matrix
given-frame-pose = Pose of frame { $end } in frame { $start }

task-orientation =
    { $given ->
        [angles] A frame is turned by three angles about the { $turning ->
            [fixed] fixed
           *[current] current
        } axes { $axes }, in this order.
       *[other] The orientation of a frame is given.
    } Write it in the notations below.{ $ask ->
        [every] {" "}Of the angles about the { $asked_turning ->
            [fixed] fixed
           *[current] current
        } axes { $asked_axes } give every triple: both, or at gimbal lock the middle angle and the combination of the other two that is fixed.
        [one] {" "}Of the angles about the { $asked_turning ->
            [fixed] fixed
           *[current] current
        } axes { $asked_axes } one triple is enough.
       *[none] {""}
    }
task-rotation-check = Is this matrix a rotation? If not, say which property of a rotation it lacks.
task-frame-chain = The poses below are known. Write the pose of frame { $end } in frame { $start } as a 4×4 matrix, lengths in { unit-word }.
feedback-orientation_right = Every notation describes the given orientation.
feedback-orientation_wrong =
    { $notation ->
        [matrix] The matrix is not that of this orientation.
        [quaternion] The quaternion is not that of this orientation.
        [axis_angle] Axis and angle are not those of this orientation.
        [angles] The angles are not those of this orientation.
       *[other] The angles are not all right, or not all there.
    }
feedback-orientation_missing =
    { $notation ->
        [matrix] The matrix is missing.
        [quaternion] The quaternion is missing.
        [axis_angle] Axis and angle are missing.
       *[other] The angles are missing.
    }

feedback-rotation_transposed = This is the inverse rotation: rows and columns have been interchanged, or the sense of rotation reversed.
feedback-rotation_order_reversed = The rotations were multiplied in reverse order: fixed axes and current axes have been confused.
feedback-rotation_degrees = An angle in degrees was taken for radians, or the reverse.
feedback-rotation_handedness = Everything turns the other way: this follows the left-hand rule.
feedback-rotation_half_angle = This quaternion turns twice as far: it needs the sine and the cosine of half the angle.
feedback-rotation_component_order = In the other order of components this quaternion would be right.
feedback-rotation_not_unit = The quaternion is not of length 1.
feedback-rotation_no_axis = The axis is of length zero.
feedback-rotation_solution_missing = There is a second triple with the same orientation.
feedback-rotation_solution_twice = Your triples differ by full turns only: they are the same. There is another one.
feedback-rotation_family_missing = This is gimbal lock: there are infinitely many triples. Say which combination of the first and the last angle is fixed.
feedback-rotation_combination = The other combination is fixed: take the difference instead of the sum, or the sum instead of the difference.
feedback-rotation_not_locked = This is not gimbal lock: exactly two triples have this orientation.
feedback-rotation_quadrant = An angle lies in the wrong quadrant, half a turn away: take atan2 instead of atan.
feedback-rotation_angle_sign = An angle, or a combination of angles, has the wrong sign.
feedback-rotation_rounded = The entries are rounded too much: work with more decimal places.
feedback-rotation_unit_columns = This is not a rotation: a column is not of length 1.
feedback-rotation_perpendicular_columns = This is not a rotation: two columns are not at right angles.
feedback-rotation_right_handed = This is not a rotation but a reflection: its determinant is −1.
feedback-claim_right = That is true of this matrix.
feedback-claim_not_rotation = It is not a rotation: check the lengths of the columns, the angles between them, and the determinant.
feedback-claim_rotation = It is a rotation after all: columns of length 1, at right angles, determinant +1.
feedback-claim_other_property = It is not a rotation, but this property holds; another one fails.
feedback-chain_right = The pose is the one that follows from the chain of frames.
feedback-chain_wrong = This is not the pose that follows from the known ones.
feedback-chain_rotation_right = Its rotation is right.
feedback-chain_position_right = Its position is right.
feedback-chain_inverted = This is the inverse: the pose of the first frame in the last.
feedback-chain_not_inverted = A known pose that has to be inverted first was used as it is.
feedback-chain_inverse_without_transpose = The inverse of a pose was formed with R; it needs Rᵀ: (Rᵀ, −Rᵀp).
feedback-chain_inverse_position = The position of an inverse is −Rᵀp, not −p.
feedback-chain_order_reversed = The factors were multiplied in reverse order.
feedback-chain_transposed = The rotation is transposed.
feedback-chain_not_rigid = This is not a rigid motion: its columns are not unit vectors at right angles, or they are left-handed (determinant −1), or its last row is not 0 0 0 1.
error-euler_axes_unknown = { $axes } is not a sequence of axes: name three of X, Y and Z, neighbours different.
error-component_order_missing = Say where the scalar of the quaternion is: wxyz or xyzw.
error-axis_and_angle = An axis needs an angle, and an angle an axis.
error-family_incomplete = A family of triples needs all three: the middle angle, sum or difference, and its value.
error-orientation_empty = Write the orientation in one of the notations that are asked for.
error-mistake_empty = Say where the mistake is, what it is, or how to correct it.
error-frames_not_connected = The known poses do not lead from frame { $start } to frame { $end }.
error-pose_without_table = A pose is that of a student’s own table or ⁰T: ask for one of them, too, or let the policy fix zero, direction, base frame and tool frame.

error-one_notation = Give the orientation in one notation: { $known }.
error-name_without_value = The name { $name } has no value here.{ $found ->
    [0] {""}
   *[one] {" "}Did you mean { $close }?
} Known names: { $known }.
error-rate_in_marks = { $text } is not a known name. Did you mean the joint rate { $suggestion }?
error-expected_not_rotation =
    The expected matrix is not a rotation: { $property ->
        [unit_columns] a column is not of length 1.
        [perpendicular_columns] two columns are not at right angles.
       *[right_handed] it is a reflection, with determinant −1.
    }

field-solutions = Joint values
field-combinations = If there are infinitely many: the combination that stays constant (coefficients)
option-finite = is reached by these joint values
option-infinite = is reached by infinitely many; these are some of them
option-out_of_reach = is out of reach
option-joint_limits = is not reached within the limits of the joints
given-target = The pose
given-target-position = The position of the last origin
given-table = The DH table, { $convention ->
    [modified] modified
   *[standard] standard
} convention

task-inverse-kinematics =
    { $variables ->
        [own] Which values of your own joint variables bring the last frame to this place in frame 0?
       *[given] The table of the robot is given. Which joint values bring its last frame to this place in frame 0?
    } { $solutions ->
        [one] One solution is enough.
       *[all] Give all of them; full turns do not count.
    } { $reach ->
        [position] Only the position of the last origin matters, in { unit-word }.
       *[pose] The position, in { unit-word }, and the orientation both matter.
    }

feedback-joints_right = The answer is right: everything that was asked for is there.
feedback-joints_searched = For this pose the solutions were found by search; there may be more than these.
feedback-joints_need_table = The joint values are those of your own variables: hand in a table that is right, too.
feedback-claim_wrong = That is not so: count again how many solutions this pose has, if any.
feedback-joints_wrong = Row { $row } does not reach the pose.
feedback-joints_twice = Rows { $other } and { $row } differ by full turns only: they are one solution.
feedback-joints_missing =
    { $count ->
        [one] One solution is missing.
       *[other] { $count } solutions are missing.
    }
feedback-branch_shoulder =
    { $count ->
        [one] The arm may also reach backwards over its shoulder.
       *[other] The arm may also reach backwards over its shoulder: { $count } such solutions are missing.
    }
feedback-branch_elbow =
    { $count ->
        [one] The elbow may also bend the other way.
       *[other] The elbow may also bend the other way: { $count } such solutions are missing.
    }
feedback-branch_wrist =
    { $count ->
        [one] The wrist may also be flipped.
       *[other] The wrist may also be flipped: { $count } such solutions are missing.
    }
feedback-branch_other =
    { $count ->
        [one] There is another branch of solutions.
       *[other] There are { $count } other branches of solutions.
    }
feedback-joints_quadrant = Row { $row }: q{ $joint } lies in the wrong quadrant, half a turn away. Take atan2 instead of atan.
feedback-joints_sign = Row { $row }: q{ $joint } has the wrong sign.
feedback-joints_degrees = Row { $row }: degrees were taken for radians, or the reverse.
feedback-joints_swapped = Row { $row }: q{ $joint } is 90° minus what it should be; the arguments of atan2 are swapped.
feedback-joints_half_branch = Row { $row } is row { $other } with only q{ $joint } changed: in another branch, other joints change with it.
feedback-joints_position_only = Row { $row } reaches the position, but not the orientation.
feedback-joints_orientation_only = Row { $row } reaches the orientation, but not the position.
feedback-joints_limits = Row { $row } reaches the pose with joint { $joint } beyond its limit.
feedback-joints_rounded = Row { $row } comes close to a solution, but not close enough: work with more decimal places.
feedback-joints_family_missing = The pose is singular: say which combination of joint variables stays the same along the solutions.
feedback-joints_taken_off = Points are taken off for what is wrong, so that guessing earns nothing. Here nothing is left of what the right rows earned.
feedback-joints_combination_wrong = Combination { $row } does not stay the same along the solutions.
feedback-joints_combination_zero = Combination { $row } is 0 whatever the joints do, so it says nothing.
feedback-joints_combination_loose = Combination { $row } stays the same along the solutions, but that is not enough: other joint values with the same combination do not reach the pose.
error-pose_frames_free = The pose is given in frame 0 and for the last frame: the policy has to fix both, base = "frame" and tool = "frame".
error-pose_within_reach = This arm reaches poses however far away, as prismatic joints have no limits here: leave out_of_reach out of cases.
error-joint_row_length = A row holds one value for each joint: { $expected } are needed, and { $given } were given.
error-joint_rows_empty = Give the joint values that reach the pose.

field-row = Row with the mistake
field-name = What is wrong
field-mended = The row as it should be
field-verdict = The two tables describe
field-reason = because
option-alpha_sign = α has the wrong sign
option-alpha_value = α has the wrong value
option-a_sign = a has the wrong sign
option-d_sign = d has the wrong sign
option-a_value = a has the wrong value
option-d_value = d has the wrong value
option-a_d_swapped = a and d are swapped
option-a_missing = a is zero, but should not be
option-a_not_zero = a is not zero, but should be
option-d_missing = an offset d is left out
option-d_not_zero = d is not zero, but should be
option-angles_in_degrees = all angles in degrees, though radians are declared
option-angles_in_radians = all angles in radians, though degrees are declared
option-cell_in_degrees = one angle in degrees among radians
option-cell_in_radians = one angle in radians among degrees
option-cell_length_unit = one length in another unit
option-cell_parameter = a different dimension of the figure is used
option-columns_early = a and α one row too high
option-columns_late = a and α one row too low
option-columns_exchanged = two columns exchanged
option-columns_reordered = columns in another order
option-convention = the wrong convention is declared
option-fixed_row_missing = the last row, without a variable, is missing
option-joint_fixed = a joint without its variable
option-joint_moving = a variable where nothing moves
option-joint_type = the joint has the wrong type
option-length_unit = all lengths in another unit
option-parameter_misnamed = a name that is not in the figure
option-parameters_swapped = two dimensions exchanged
option-row_extra = a row too many
option-row_missing = a row is missing
option-rows_swapped = two rows exchanged
option-theta_offset = the constant added to the variable θ is wrong
option-d_offset = the constant added to the variable d is wrong
option-theta_value = the constant θ has the wrong value
option-turns_all_reversed = every joint angle increases in the wrong direction
option-twists_all_reversed = every α has the wrong sign
option-twists_early = α alone one row too high
option-twists_swapped = α of two rows exchanged
option-twists_late = α alone one row too low
option-variable_sign = a joint variable increases in the wrong direction
option-same = the same robot
option-different = different robots
option-axis_reversed = the frames differ: a z axis, or a joint variable, is reversed
option-x_turned = the frames differ: an x axis is turned, and the variable is zero elsewhere
option-origin_moved = the frames differ: an origin lies elsewhere, or the first or last frame stands differently
option-other_convention = the frames differ: the tables are in different conventions
option-twist = the angle between two axes differs
option-length = the distance between two axes differs
option-offset = an offset along an axis, or a constant angle about it, differs
given-table-with-mistake = The table with a mistake ({ $convention ->
    [modified] modified convention
   *[standard] standard convention
})
given-first-table = The first table ({ $convention ->
    [modified] modified convention
   *[standard] standard convention
})
given-second-table = The second table ({ $convention ->
    [modified] modified convention
   *[standard] standard convention
})

task-find-mistake = This table should describe the robot of the figure, but one row has a mistake. Which row, what is wrong, and how should the row read?
task-compare-tables = Do these two tables describe the same robot, whichever way the frames were chosen? Say why.

feedback-mistake_found = You found the mistake, named it and corrected it.
feedback-mistake_row_wrong = The mistake is in another row.
feedback-mistake_name_wrong = The mistake is of another kind.
feedback-mistake_not_mended = With this row the table still does not describe the robot.
feedback-mistake_missing =
    { $what ->
        [row] Say which row holds the mistake.
        [name] Say what is wrong.
       *[mended] Write the row as it should be.
    }
feedback-tables_right = Right, and for the right reason.
feedback-tables_same = They are the same robot: only the frames were chosen differently.
feedback-tables_different = They are different robots: no choice of frames turns one table into the other.
feedback-tables_reason_wrong = The verdict is right, but not for this reason.
feedback-tables_reason_missing = The verdict is right; say why, too.
error-row_unknown = Give the number of a row, from 1 to { $count }.
error-column_unknown = Give the number of a column, from 1 to { $count }.
error-vector_length = The vector has { $expected } components, and { $given } were given.
error-joint_variable_in_number = { $name } is a joint variable, and a number is asked for here: put in its value.
error-no_mistake_does_harm = None of these mistakes changes this robot under its policy.
error-frame_mistakes_not_shown = This robot’s frames can show none of these mistakes. What they can show: { $known }.
error-key_given_away = This part shows a table; an exercise that asks for the table cannot have it.
error-not_plantable = None of the mistakes that were asked for changes this robot.

field-frame = The screws are written in
field-order = Order of v and ω
field-screws = Screws, one row for each joint
field-home = Home pose M
option-space = the fixed frame (space)
option-body = the tool’s frame at the zero position (body)
option-linear_first = v, ω: linear part first
option-angular_first = ω, v: angular part first

task-screws = Write the robot as a product of exponentials: the screws of joints 1 to { $n } and the home pose M, lengths in { unit-word }. Choose the frame, the zero position and the sense of each axis within the rules.

feedback-screws_right = The screws and the home pose describe this robot.
feedback-screws_right_robot = This product of exponentials describes the right robot, but does not meet all the requirements of the exercise.
feedback-screws_wrong = This product of exponentials does not describe the robot, whichever frame, zero and senses were chosen.
feedback-screw_not_unit = Joint { $joint }: ω of a revolute joint is a unit vector.
feedback-screw_pitch = Joint { $joint }: v has a part along ω; a revolute joint does not advance along its axis.
feedback-screw_joint_type = Joint { $joint }: a prismatic joint has ω = 0 and a unit vector v; a revolute joint has ω of length 1.
feedback-screw_halves = v and ω are exchanged: in the other order the rows would be right.
feedback-screw_moment_sign =
    { $joint ->
        [0] Every v has the wrong sign
       *[other] Joint { $joint }: v has the wrong sign
    }: v = −ω × p, with p any point on the axis.
feedback-screw_other_frame = These are the screws in the other frame: space and body have been confused.
feedback-screw_home_inverted = The home pose is inverted.
feedback-screw_sign_or_home = Either v has the wrong sign throughout (v = −ω × p, with p any point on the axis), or the home pose is inverted.
feedback-screw_home = The screws are right; the home pose M is not.
feedback-screw_not_rigid = The home pose is not a rigid motion: its columns are not unit vectors at right angles, or they are left-handed (determinant −1), or its last row is not 0 0 0 1.
feedback-screw_length_unit = The lengths are in a different unit from the robot’s: in its unit the rows would be right.
feedback-screw_exchanged = The rows of joint { $joint } and of the next one are exchanged.
feedback-screw_reversed = The rows are in the reverse order: the first one belongs to the joint next to the base.
feedback-screws_relation_wrong = The axes of joints { $joint } and { $next } are not arranged as in the figure.
error-screw_count = The robot has { $expected ->
    [one] one joint
   *[other] { $expected } joints
}, and { $given ->
    [one] one screw was
   *[other] { $given } screws were
} given.

error-screw_too_large = A number is too large for a robot; the largest is { $limit }.

field-jacobian = Jacobian, one column for each joint
field-forces = Joint torques and forces
given-configuration = The configuration
given-wrench = Force and moment that the tool exerts

task-jacobian =
    { $variables ->
        [own] Take your own table and your own joint variables at these values.
       *[given] The table of the robot and a configuration are given.
    } { $ask ->
        [jacobian] Write the geometric Jacobian of the last origin, lengths in { unit-word }, per radian.
        [forces] Which joint torques and forces, τ = Jᵀ(f, m), belong to the force and moment at the last origin, lengths in { unit-word }?
       *[both] Write the geometric Jacobian of the last origin, lengths in { unit-word }, per radian, and the joint torques and forces τ = Jᵀ(f, m).
    } { $frame ->
        [end] All vectors are in the axes of the last frame.
       *[base] All vectors are in the axes of frame 0.
    }

feedback-jacobian_right = Everything is right.
feedback-jacobian_follows_table = This follows from your table and earns its points, although the table is not right.
feedback-jacobian_needs_table = The Jacobian is that of your own table: hand in the table, with all joints, too.
feedback-jacobian_missing =
    { $what ->
        [jacobian] The Jacobian is missing.
       *[forces] The joint torques and forces are missing.
    }
feedback-jacobian_wrong = Not every column of the Jacobian is right.
feedback-forces_wrong = Not every joint torque or force is right.
feedback-jacobian_next_axis =
    { $count ->
        [1] Column { $joint } uses the axis of a neighbouring joint: mind which z belongs to which joint in your convention.
       *[other] Columns { $joints } use the axis of a neighbouring joint: mind which z belongs to which joint in your convention.
    }
feedback-jacobian_point_swapped =
    { $count ->
        [1] Column { $joint }: the linear part is z × (pₙ − p), not z × (p − pₙ).
       *[other] Columns { $joints }: the linear part is z × (pₙ − p), not z × (p − pₙ).
    }
feedback-jacobian_prismatic =
    { $count ->
        [1] Column { $joint }: a prismatic joint gives (z, 0), a revolute joint (z × (pₙ − p), z).
       *[other] Columns { $joints }: a prismatic joint gives (z, 0), a revolute joint (z × (pₙ − p), z).
    }
feedback-jacobian_other_frame =
    { $count ->
        [0] This is the Jacobian in the axes of the other frame.
        [1] Column { $joint } is in the axes of the other frame.
       *[other] Columns { $joints } are in the axes of the other frame.
    }
feedback-jacobian_rows_exchanged = The linear and the angular rows are swapped.
feedback-jacobian_spatial = This is the velocity of the point at the origin of frame 0; the origin of the last frame is asked for.
feedback-forces_sign = Every sign is reversed: τ = Jᵀ(f, m) is asked for, with the force and moment as given.
feedback-forces_other_frame = Force and moment were taken in the axes of the other frame.
feedback-forces_rows_exchanged = Force and moment were exchanged.
feedback-forces_spatial = The force was taken to act at the origin of frame 0.
error-row_order_missing = Say which rows come first: (v, ω) or (ω, v).
error-jacobian_empty = Give the Jacobian or the joint torques and forces.

error-wrench_missing = Joint torques and forces belong to a force and a moment: give the wrench.
