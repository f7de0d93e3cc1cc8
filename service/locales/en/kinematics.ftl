# Joint values, poses, screws and numeric tables.

error-target_unanswered = The computation stopped after { $seconds } s, with { $answered } of the targets answered. Send this target and those after it in another request.
error-joints_wrong_length =
    { $expected ->
        [one] The table has one joint, but a configuration of { $given ->
            [one] one value
           *[other] { $given } values
        } was given.
       *[other] The table has { $expected } joints, but a configuration of { $given ->
            [one] one value
           *[other] { $given } values
        } was given.
    }
error-joints_malformed = Joint values are numbers: one configuration [q1, …, qn], or a list of equally long ones.
error-joint_not_finite = The value of joint { $joint } is not a finite number.
error-result_not_finite = The result is too large for a double-precision number. Lengths and joint values must be smaller.
error-entry_not_finite = { $cell } is not a finite number.
error-value_undefined = The expression has no finite value for these parameters.

error-pose_not_numbers = A pose is a 4×4 matrix of numbers.
error-pose_wrong_shape = A pose is a 4×4 matrix of numbers; this one is { $shape }.
error-pose_not_finite = This entry is not a finite number.
error-pose_in_one_row = Sixteen numbers in one list are not a pose: write four rows of four numbers, [[…], […], […], [0, 0, 0, 1]].
error-inertia_in_one_row = An inertia is not one list of numbers: write three rows of three, [[Ixx, Ixy, Ixz], [Ixy, Iyy, Iyz], [Ixz, Iyz, Izz]], with Ixy = −∫ x y dm.
error-pose_bottom_row = The bottom row of a pose is 0, 0, 0, 1.
error-pose_not_orthonormal = The rotation part is not orthonormal (off by { $error }): its columns must be perpendicular unit vectors to within { $tolerance }. Give more digits or, in inverse kinematics, a `tolerance`.
error-pose_left_handed = The rotation part is left-handed: its determinant is −1, a reflection. It must be +1.

error-notation_wrong_length =
    { $expected ->
        [one] { $what } takes one number: { $names }.
       *[other] { $what } takes { $expected } numbers: { $names }.
    }
error-notation_not_finite = { $name } of { $what } is not a finite number.
error-quaternion_length = A quaternion whose length is zero or overflows does not describe an orientation. Give a unit quaternion.
error-axis_length = An axis whose length is zero or overflows has no direction. Give a unit vector.

error-screw_not_finite = A screw consists of six finite numbers.
error-screw_not_unit = The angular part of a revolute joint’s screw, and the linear part of a prismatic joint’s, must have length 1.
error-screw_has_pitch = This screw has a pitch of { $pitch } per radian. A joint either turns or slides.
error-screw_of_other_type = Screw { $joint } is not of the type that is declared: a revolute joint has an angular part, a prismatic one has none.
error-tree_after_unknown = Row { $row } follows frame { $given }; it must follow the base (0) or an earlier row. Closed loops are not supported.
error-frame_unknown = There is no frame { $given }; the last one is { $count }.
