### Exercises: what is asked, what is said of answers, what a definition may not say.

## The figure in words

figure-title = { $title }: joints, axes and dimensions
figure-coordinates = { $joints ->
    [one] A robot with one joint.
   *[other] A robot with { $joints } joints, one behind the other, counted from the base.
} Positions are given in { unit-word } as (X; Y; Z). { figure-place }
figure-place = X points { $x ->
    [back] to the back, Y to the left
    [left] to the left, Y to the front
    [front] to the front, Y to the right
   *[right] to the right, Y to the back
}, Z up; { $fixed ->
    [ground] the robot is fixed
   *[joint] the body of joint 1 stands
} at { $at }.
figure-joint-revolute = Joint { $joint } turns. Its body stands at { $place }; its axis { $course ->
    [vertical] is vertical
    [sideways] runs from left to right
    [depthways] runs from front to back
   *[oblique] runs along { $direction }
}.
figure-joint-revolute-signed = Joint { $joint } turns. Its body stands at { $place }; its axis { $course ->
    [vertical] is vertical
    [sideways] runs from left to right
    [depthways] runs from front to back
   *[oblique] is oblique
}. By the right-hand rule, the joint variable is positive about { $direction }.
figure-joint-prismatic = Joint { $joint } slides. Its body stands at { $place }; its direction { $course ->
    [vertical] is vertical
    [sideways] runs from left to right
    [depthways] runs from front to back
   *[oblique] is along { $direction }
}.
figure-joint-prismatic-signed = Joint { $joint } slides. Its body stands at { $place }; its direction { $course ->
    [vertical] is vertical
    [sideways] runs from left to right
    [depthways] runs from front to back
   *[oblique] is oblique
}. The joint variable is positive along { $direction }.
figure-dimension = { $name } is { $length } { $unit }, measured { $course ->
    [vertical] vertically
    [sideways] from left to right
    [depthways] from front to back
   *[oblique] obliquely
}, between { $start } and { $end }.
figure-point = Point { $name } lies at { $place }.
figure-frame = Frame { $number } has its origin at { $place }; its x axis points along { $x }, its z axis along { $z }.
figure-not-to-scale = The drawing is not to scale: in it, { $names } { $count ->
    [one] is not as long as it is
   *[other] are not as long as they are
} here.
figure-note = not to scale

## What is free and what is fixed

rule-convention-any = The standard and the modified convention are both accepted.
rule-convention-standard = Write the table in the standard convention.
rule-convention-modified = Write the table in the modified convention.
rule-base-free = Frame 0 may lie anywhere on the base.
rule-base-axis = The z axis of frame 0 lies on the axis of joint 1, either way round.
rule-base-origin = The origin of frame 0 lies at the marked point O0; you choose its directions.
rule-base-frame = Frame 0 is prescribed; the figure shows it.
rule-tool-free = The last frame may lie anywhere on the last link.
rule-tool-point = The origin of the last frame lies at the marked point { $points }.
rule-tool-axis = The z axis of the last frame lies on the axis of the last joint, either way round; its origin may lie anywhere on it.
rule-tool-frame = The last frame is prescribed; the figure shows it.
rule-zero-free = You choose where each joint variable is zero.
rule-zero-figure = In the configuration shown in the figure, all joint variables are zero.
rule-direction-free = You choose which way each axis points.
rule-direction-figure = The joint variables are positive in the direction of the arrows in the figure.

## What is asked

task-schematic = Describe the structure: the type of each joint, and how the axis of each joint lies relative to the axis of the next.
task-table = Choose frames and write the DH table. The cells may hold { $names }, numbers and the joint variables q1 to q{ $n }.
task-link-matrices = For each row of your table, write its link matrix, the pose of frame i in frame i−1. You may shorten cos(q1) to c1 and sin(q1 + q2) to s12.
task-transform = Write ⁰T, the pose of the last frame in frame 0, in closed form.
task-pose = Evaluate your ⁰T for { $joints } and the dimensions given here, lengths in { unit-word }.
task-workspace-axis = How near to the axis of joint 1 can { $point } be brought, and how far from it? { $limits ->
    [none] Every joint may take any value.
   *[some] The joints keep to their limits: { $ranges }; in the figure, { $drawn }.
} Give both radii in { unit-word }.
task-workspace-point = What are the least and the greatest distance of { $point } from { $origin }? { $limits ->
    [none] Every joint may take any value.
   *[some] The joints keep to their limits: { $ranges }; in the figure, { $drawn }.
} Give both radii in { unit-word }.

## Feedback on the parts

feedback-part_wrong = This part is not right yet.
feedback-schematic_right = The structure is right.
feedback-schematic_joint_count = You list { $given ->
    [one] one joint
   *[other] { $given } joints
}; count again how many can move.
feedback-schematic_joint_type = The type of joint { $joint } is not right.
feedback-schematic_relation = How axes { $first } and { $second } are arranged is not right.
feedback-schematic_angle_right = Axes { $first } and { $second }: the angle between them is right, but not whether they meet.
feedback-schematic_meeting_right = Axes { $first } and { $second } do meet, but not at this angle.
feedback-matrices_right = The link matrices are right.
feedback-matrices_follow_table = The link matrices follow from your table and earn their points, although the table is not right.
feedback-matrices_right_not_from_table = The link matrices are right for the robot, although they do not follow from your table.
feedback-matrices_product_wrong = Multiplied together, your link matrices do not describe this robot.
feedback-matrix_missing = Matrix { $matrix } is missing.
feedback-matrix_wrong = Matrix { $matrix } does not belong to row { $matrix } of your table.
feedback-matrix_cells_wrong = Matrix { $matrix } differs from row { $matrix } of your table in these cells (row,column): { $cells }.
feedback-matrix_inverse = Matrix { $matrix } is inverted: it is the pose of frame i−1 in frame i.
feedback-matrix_rotation_transposed = The rotation in matrix { $matrix } is transposed.
feedback-matrix_other_convention = Matrix { $matrix } was formed by the rule of the other convention.
feedback-matrix_without_variable = Matrix { $matrix } was written for a joint variable of zero; keep the variable.
feedback-matrix_of_other_row = Matrix { $matrix } is that of row { $other }.
feedback-matrix_not_rigid = Matrix { $matrix } is not a rigid motion: its columns are not unit vectors at right angles, or they are left-handed (determinant −1), or its last row is not 0 0 0 1.
feedback-transform_right = ⁰T is right.
feedback-transform_follows_table = ⁰T follows from your table and earns its points, although the table is not right.
feedback-transform_right_not_from_table = ⁰T is right for the robot, although it does not follow from your table.
feedback-table_says_little = Your table has fewer than half of the lengths and twists that it takes to describe this robot; what follows from it earns only part of its points, and what follows from a table of zeros earns none.
feedback-transform_wrong = This ⁰T does not describe the robot.
feedback-transform_rotation_right = The rotation in ⁰T is right.
feedback-transform_position_right = The position in ⁰T is right.
feedback-transform_cells_wrong = ⁰T differs from your table in these cells (row,column): { $cells }.
feedback-transform_not_rigid = ⁰T is not a rigid motion: its columns are not unit vectors at right angles, or they are left-handed (determinant −1), or its last row is not 0 0 0 1.
feedback-transform_inverse = This is the inverse of ⁰T: the pose of frame 0 in the last frame.
feedback-transform_rotation_transposed = The rotation in ⁰T is transposed.
feedback-transform_order_reversed = The link matrices were multiplied in reverse order.
feedback-transform_links_missing = This is the product up to frame { $last } only; go on to the last frame.
feedback-pose_right = The pose is right.
feedback-pose_follows_table = The pose follows from your table and earns its points, although the table is not right.
feedback-pose_wrong = The pose is not the one that your table gives for these joint values.
feedback-pose_last_row = The last row of a pose is 0 0 0 1; with another one the matrix is not a pose and earns no points.
feedback-pose_rotation_right = The rotation is right.
feedback-pose_position_right = The position is right.
feedback-pose_inverse = This is the inverse of the pose.
feedback-pose_rotation_transposed = The rotation is transposed.
feedback-pose_degrees_as_radians = The sines and cosines were computed as if the angles in degrees were in radians.
feedback-workspace_right = Both radii are right.
feedback-workspace_inner_wrong = The inner radius is not right.
feedback-workspace_outer_wrong = The outer radius is not right.
feedback-workspace_swapped = The inner and the outer radius are swapped.
feedback-workspace_diameters = These are diameters; the radii are asked for.
feedback-workspace_other_length_unit = The radii are right in another unit; they are asked for in { unit-word }.

## Why an answer cannot be graded

problem-note-ungraded = This answer was not graded and costs no attempt.
error-answer_empty = Nothing was handed in. The exercise asks for { $known }.
error-part_not_asked = The exercise does not ask for { $part }; it asks for { $known }.
error-link_matrices_count = The table has { $expected ->
    [one] one row
   *[other] { $expected } rows
}, but { $given ->
    [one] one link matrix is given
   *[other] { $given } link matrices are given
}. Give one for each row; null skips one.
error-link_matrices_need_table = Without the table, link matrices are judged by their product. Give all of them.
error-pose_needs_table = The pose is that of your own table. Hand in the table, too.
error-matrix_not_4x4 = A matrix has four rows of four cells.
error-joint_variable_unknown = There is no { $name }; the robot has { $joints ->
    [one] one joint
   *[other] { $joints } joints
}.{ $summed ->
    [0] {""}
   *[other] {" "}A sum is written out: { $sum }.
}
error-short_form_unknown = { $name } is read as a cosine or a sine, but not all of its indices are revolute joints; the robot has { $joints ->
    [one] one joint
   *[other] { $joints } joints
}.
error-radius_negative = A radius cannot be negative.
error-schematic_fixed_joint = The structure lists the joints that move: revolute or prismatic.
error-schematic_relations_count = { $joints ->
    [one] One joint has
   *[other] { $joints } joints have
} { $expected ->
    [one] one pair
   *[other] { $expected } pairs
} of neighbouring axes. Give one relation for each pair.
error-seed_invalid = A seed is a text or a whole number.
error-seed_too_long = A seed has at most { $limit } characters.
error-exercise_unknown = There is no exercise { $id }. Available: { $known }.
error-language_unknown = { $language } is not supported. Available: { $known }.

## Why a definition cannot be read

error-exercise_file_missing = The file exercise.toml is missing.
error-exercise_file_not_toml = This is not TOML: { $reason }
error-exercise_key_missing = { $key } is missing.
error-exercise_key_unknown = { $key } is not a known key. Known keys are { $known }.
error-exercise_value_type = { $key } must be { expected-value }.
error-exercise_value_unknown = { $key } must be one of: { $known }.
error-exercise_robot_unknown = The catalogue holds no robot { $robot }. It holds { $known }.
error-exercise_limits_reversed = The limits of joint { $joint } are given as [lowest, highest].
error-exercise_limits_unknown = The catalogue knows no limits of this robot.
error-folder_missing = There is no folder { $folder }.
error-exercise_id_invalid = { $id } is not the id of an exercise; an id has letters, digits and single hyphens.
error-exercise_exists = The exercise { $id } exists already.
error-source_unreadable = The file cannot be read: { $reason }
error-robot_and_reference = Give either robot or [reference], not both.
error-statement_missing = The statement in the language { $language } is missing.
error-statement_name_unknown = { $name } is neither a dimension of the robot nor a point or a dimension of the figure.
error-misconception_unknown = { $name } is not a listed mistake. Available: { $known }.
error-nothing_asked = An exercise has to ask for something: add a part.
error-part_twice = { $kind } is asked for twice.
error-points_not_positive = A part is worth more than zero points.
error-draw_empty = There is no value to draw from: “from” must not lie above “to”, and “step” must be positive.
error-draw_too_large = A draw has at most { $limit } values.
error-variants_too_many = There are at most { $limit } variants.
error-tolerance_out_of_range = { $name } lies between 0 and 0.1.
error-name_invalid = { $name } is not the name of a dimension; a name looks like L1.
error-width_out_of_range = The width lies between 320 and 960.
error-unknown_point = There is no point { $name }. Available: { $known }.
error-unknown_frame = There is no such frame: frames are numbered from 0 to { $last }.
error-unknown_joint = There is no joint { $joint }: joints are numbered from 1 to { $last }.
error-point_without_form = A point is given by frame and at; by between and ratio; by from and by; or by from, joint and distance.
error-joint_off_axis = The point { $point } does not lie on the axis of joint { $joint }.
error-dimension_disagrees = The points of { $name } lie { $length } apart, but { $name } is { $value }.
error-dimension_too_short = { $name } is { $length }, too short to be shown in the figure: it is less than a millionth of the robot’s size. Give it another value, or write 0 in its place.
error-posture_not_zero = With zero = figure students are told that all joint variables are zero in the configuration of the figure: draw the robot there (posture 0 for each joint), or leave the zeros free.
error-tool_point_unmarked = With tool = point the last origin belongs at a marked point, but none of the marked points is the key’s last origin. Mark the origin of frame { $last }.
error-gripper_without_direction = The gripper and the point that it points away from are the same.
error-jaws_along_gripper = The jaws lie side by side, perpendicular to the gripper.

error-name_unknown = { $name } is none of the dimensions of this exercise.{ $unit ->
    [0] {""}
   *[one] {" "}Units are not written in cells: if { $name } is one, leave it out.
}{ $found ->
    [0] {""}
   *[one] {" "}Did you mean { $close }?
} Known names: { $known }.
error-need_unmet = No answer needs { $name } under this policy: students may choose frames in which it does not appear. { $rules ->
    [none] No rule of the policy changes that: remove it from needs.
   *[other] Each of these rules is enough for it to be needed: { $rules }.
}
error-need_unknown = { $name } is not a dimension of the table. Its dimensions: { $known }.
error-alias_taken = { $name } already has a meaning.
error-title_missing = A title in one language at least is needed: [title] with en = "…".
exercise-other-language = This exercise is not written in your language yet; its text is in { $language }.
rule-dimension-free = With suitable frames, your table can do without { $names }.
error-context_invalid = This link was not made here, or has been changed.
error-context_expired = This link has expired.
error-switched_off = { $path } is switched off for this exercise.
error-attempts_used_up = You have used { $limit ->
    [one] the one attempt
   *[other] all { $limit } attempts
}.
error-ladder_falls = Each attempt may be told as much as the one before it or more, never less.
task-frames = Place frames 0 to { $n } on the robot as the figure shows it: for each frame its origin, in { unit-word } and in the coordinates of the figure, and the directions of x and z. { figure-place }
error-frames_count = There are frames 0 to N: { $expected } are needed, and { $given } were given.
error-convention_not_asked = The exercise asks for the { $asked } convention.
error-weight_out_of_range = The weight of { $name } is a number from 0 to { $most }.
