# What the grader says of a table: of a right one, of a wrong one, and what would mend it.

## A right answer, and how its frames lie against the reference solution's

feedback-same_frames = Your frames are those of the reference solution.
feedback-other_convention = Your table is written in the { $convention ->
    [modified] modified convention, the reference solution in the standard one
   *[standard] standard convention, the reference solution in the modified one
}; both describe the same robot.
feedback-axis_reversed = Your z{ $frame }, the axis of joint { $joint }, points the opposite way to the reference solution’s. Both ways are right, and the signs in your table agree with yours.
feedback-end_axis_reversed = Your z{ $frame } points the opposite way to the reference solution’s. Both ways are right.
feedback-x_turned = Your x{ $frame } is turned by { $degrees }° about z{ $frame } from where the reference solution has it. Your table takes this into account.
feedback-origin_slid = The origin of your frame { $frame } lies at a different place along z{ $frame } from that in the reference solution. Any place is right here.
feedback-axis_moved = Your z{ $frame } lies on a different line, parallel to that in the reference solution. Only its direction matters here.
feedback-frame_elsewhere = Your frame { $frame } lies elsewhere than in the reference solution. You were free to choose it.
feedback-variable_reversed = Your q{ $joint } increases in the opposite direction to the reference solution’s. Both directions are right.
feedback-variable_offset = Where the reference solution’s q{ $joint } is zero, yours has the value { $offset }. You are free to choose where a joint variable is zero.
feedback-rounded = Your entries agree with the reference solution within the tolerance, not exactly; they may have been rounded.

## A wrong answer: the whole

feedback-not_equivalent = Your table does not describe this robot, whichever way the frames are chosen.
feedback-right_robot = Your table describes the right robot, but does not meet all the requirements of the exercise.
feedback-not_accepted = Your table does not meet all the requirements of the exercise.
feedback-convention_not_asked = The exercise asks for the { $asked ->
    [modified] modified
   *[standard] standard
} convention; your table is in the { $given ->
    [modified] modified
   *[standard] standard
} one.
feedback-joint_count_wrong = { $given ->
    [0] Your table has no joints
    [one] Your table has one joint
   *[other] Your table has { $given } joints
}; the robot has { $asked }.
feedback-mirrored = Your table describes the mirror image of the robot: all lengths and angles fit, but one of them is measured in the wrong direction. Check the signs by the right-hand rule.
feedback-entries_imprecise = No length or angle of your table is off by more than rounding explains, but all the rounding together is more than the exercise allows. Write angles exactly, as pi/2 or 90°, and lengths with more digits.
feedback-lengths_rounded = Several lengths of your table have the right value, but with too few digits. Write them with more digits; the other remarks here are about separate mistakes.
feedback-base_axis_missed = Your z0 does not lie on the axis of joint 1.
feedback-base_origin_missed = The origin of your frame 0 is not where the exercise wants it.
feedback-base_frame_missed = Your frame 0 is not the one that the exercise prescribes.
feedback-tool_point_missed = The origin of your last frame is not at the marked point.
feedback-tool_axis_missed = The z axis of your last frame does not lie on the axis of the last joint.
feedback-tool_frame_missed = Your last frame is not the one that the exercise prescribes.
feedback-zero_missed = In the configuration of the figure all joint variables should be zero; yours are not.
feedback-direction_missed = The joint variables should increase in the direction of the arrows in the figure; not all of yours do.
feedback-whole_table = One mistake runs through your whole table.
feedback-columns_throughout = The columns a and α do not go with the convention that your table declares.
feedback-columns_in_disorder = The columns of your table are in another order.
feedback-angles_throughout = The angles of your table are not in the unit that it declares.
feedback-lengths_throughout = The lengths of your table are not in the unit that it declares.
feedback-turns_throughout = Your joint angles increase in the wrong direction throughout.
feedback-twists_throughout = The twists α of your table have the wrong sign throughout.
feedback-twists_out_of_place = The twists α of your table do not stand in the rows where they belong.
feedback-names_throughout = A dimension goes by the wrong name in your table.
feedback-parameter_unknown = The robot has no dimension called { $name }. Its dimensions are: { $known }.
feedback-names_asked = The robot’s dimensions have no values here. Write their names: { $known }.

## A wrong answer: its rows

feedback-one_of_these = Only one of the following is the mistake; the table alone does not show which.
feedback-row_wrong = Row { $row } is not right.
feedback-twist_wrong = Row { $row }: the twist α, the angle from z{ $before } to z{ $row }, is not right.
feedback-length_wrong = Row { $row }: the length a, the distance from z{ $before } to z{ $row }, is not right.
feedback-offset_wrong = Row { $row }: the offset d, the distance from x{ $before } to x{ $row } along z, is not right.
feedback-angle_wrong = Row { $row }: the angle θ, from x{ $before } to x{ $row } about z, is not right.
feedback-sign_wrong = Row { $row }: one sign is the wrong way round. Check: { $cells }.
feedback-joint_type_wrong = Row { $row }: the type of the joint is not right.
feedback-variable_zero_wrong = Row { $row }: in the configuration of the figure the joint variable is not zero.
feedback-variable_direction_wrong = Row { $row }: the joint variable increases against the arrow in the figure.
feedback-row_missing = A row is missing { $after ->
    [0] before row 1
   *[other] after row { $after }
}.
feedback-row_not_needed = Row { $row } is one too many.
feedback-rows_out_of_order = Rows { $row } and { $other } are in the wrong order.

## What would make it right

repair-convention = Read in the { $meant ->
    [modified] modified
   *[standard] standard
} convention your table would be right; you declared the { $declared ->
    [modified] modified
   *[standard] standard
} one.
repair-angles_in_degrees = The angles are in degrees, but the table declares radians.
repair-angles_in_radians = The angles are in radians, but the table declares degrees.
repair-length_unit = The lengths are in a different unit from the one that the table declares: millimetres for metres, for example.
repair-columns_late = The columns a and α stand one row too low, as in the other convention. Which link does each row belong to?
repair-columns_early = The columns a and α stand one row too high, as in the other convention. Which link does each row belong to?
repair-twists_late = The column α stands one row too low; a stands where it belongs. In one row, a and α belong to the same link.
repair-twists_early = The column α stands one row too high; a stands where it belongs. In one row, a and α belong to the same link.
repair-columns_exchanged = The columns { $one } and { $other } are exchanged. Compare the order of the columns with that of your notes.
repair-columns_reordered = What stands under α belongs under { $alpha }, what stands under a under { $a }, and what stands under d under { $d }. Compare the order of the columns with that of your notes.
repair-parameter_misnamed = { $name } is not a dimension of this robot. Which one of the figure do you mean?
repair-parameters_swapped = { $name } and { $other } are swapped. Compare them with the figure.
repair-alpha_sign = Row { $row }: α has the wrong sign. Turn z{ $before } onto z{ $row } about x, by the right-hand rule.
repair-alpha_value = Row { $row }: α has the wrong value. Look again at how z{ $before } and z{ $row } lie relative to each other.
repair-turns_all_reversed = Every joint angle increases in the wrong direction. Measure it about z by the right-hand rule, not the left-hand one.
repair-twists_all_reversed = Every α has the wrong sign. Turn one z axis onto the next about x by the right-hand rule, not the left-hand one.
repair-a_sign = Row { $row }: a has the wrong sign. It is measured along x.
repair-d_sign = Row { $row }: d has the wrong sign. It is measured along z.
repair-twists_swapped = Rows { $row } and { $other }: each has the other’s α.
repair-a_d_swapped = Row { $row }: a and d are swapped. a is measured along x, d along z.
repair-a_value = Row { $row }: a has the wrong value. Measure along the common normal of z{ $before } and z{ $row }.
repair-a_missing = Row { $row }: a should not be zero, because z{ $before } and z{ $row } do not meet.
repair-a_not_zero = Row { $row }: a should be zero, because z{ $before } and z{ $row } meet or coincide.
repair-d_value = Row { $row }: d has the wrong value. Measure along z, from x{ $before } to x{ $row }.
repair-d_missing = Row { $row }: the offset d along z, from x{ $before } to x{ $row }, has been left out.
repair-d_not_zero = Row { $row }: d should be zero, because x{ $before } and x{ $row } meet z at the same point.
repair-cell_length_unit = Row { $row }: one length is in a different unit from the others.
repair-cell_parameter = Row { $row }: another dimension of the figure belongs here.
repair-cell_in_degrees = Row { $row }: one angle is in degrees, but the table declares radians.
repair-cell_in_radians = Row { $row }: one angle is in radians, but the table declares degrees.
repair-theta_value = Row { $row }: the constant angle θ has the wrong value. Turn x{ $before } onto x{ $row } about z.
repair-theta_offset = Row { $row }: θ needs a different constant added to the variable, so that the variable is zero in the configuration of the figure.
repair-d_offset = Row { $row }: d needs a different constant added to the variable, so that the variable is zero in the configuration of the figure.
repair-variable_sign = Row { $row }: the joint variable increases in the wrong direction. Give it the opposite sign.
repair-joint_type = Row { $row }: this joint { $joint_type ->
    [prismatic] slides; its variable stands under d
   *[revolute] turns; its variable stands under θ
}.
repair-joint_fixed = Row { $row }: this joint moves; its variable is missing.
repair-joint_moving = Row { $row }: nothing moves here; the row holds constants only.
repair-rows_swapped = Rows { $row } and { $other } are swapped.
repair-fixed_row_missing = A last row without a variable is missing: it leads from the last joint to the marked point or to the prescribed last frame.
repair-row_missing = A row is missing { $after ->
    [0] before row 1
   *[other] after row { $after }
}.
repair-row_extra = Row { $row } is one too many.

## Refused

error-tables_without_value = No values of the parameters were found for which every cell of both tables has a value. Check the roots, quotients and inverse functions.

feedback-frame_wrong = Frame { $frame } breaks a rule.
feedback-frame_missing = Frame { $frame } has not been placed.
feedback-frame_z_not_along_axis = Frame { $frame }: { rule-z_not_along_axis }
feedback-frame_origin_not_on_axis = Frame { $frame }: { rule-origin_not_on_axis }
feedback-frame_origin_not_on_common_normal = Frame { $frame }: { rule-origin_not_on_common_normal }
feedback-frame_origin_not_at_intersection = Frame { $frame }: { rule-origin_not_at_intersection }
feedback-frame_x_not_across_z = Frame { $frame }: { rule-x_not_across_z }
feedback-frame_x_not_along_common_normal = Frame { $frame }: { rule-x_not_along_common_normal }
feedback-frame_x_not_across_both_axes = Frame { $frame }: { rule-x_not_across_both_axes }
feedback-frame_first_x_misses_axis = Frame { $frame }: { rule-first_x_misses_axis }
feedback-frame_last_x_misses_axis = Frame { $frame }: { rule-last_x_misses_axis }
feedback-frames_other_convention = These frames obey the rules of the other convention.
feedback-frames_not_as_asked = The frames obey the rules, but are not placed as the exercise asks.
feedback-frames_right = The frames are right.
feedback-repairs_one_cell = Several single changes would each make the table right; all of them are in cell { $cell ->
    [alpha] α
    [theta] θ
   *[other] { $cell }
} of row { $row }.
feedback-repairs_one_row = Several changes would each make the table right; all of them are in row { $row }.
feedback-repairs_one_column = Several changes would each make the table right; all of them are in the column { $cell ->
    [alpha] α
    [theta] θ
   *[other] { $cell }
}.
feedback-repairs_one_kind = { $count } changes would each make the table right; all of them are of the same kind.
