### Kinds of question: what is asked, what is said of answers.

field-matrix = Matrix
field-component_order = Order of the components
field-quaternion = Quaternion
field-axis = Axis of rotation
field-angle = Angle of rotation
field-angles = Triples of angles
field-middle = At gimbal lock: the middle angle
field-combination = At gimbal lock: what of the first and the last angle is fixed
field-value = Its value
field-claim = This matrix
field-pose = Pose
option-wxyz = w, x, y, z: scalar first
option-xyzw = x, y, z, w: scalar last
option-sum = the sum: first + last
option-difference = the difference: first − last
option-rotation = is a rotation
option-unit_columns = is none: a column is not of length 1
option-perpendicular_columns = is none: two columns are not at right angles
option-right_handed = is none: its columns are left-handed (determinant −1)
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
    } Write it in the notations below. { $ask ->
        [every] Of the angles about the { $asked_turning ->
            [fixed] fixed
           *[current] current
        } axes { $asked_axes } all triples are asked: both, or at gimbal lock the middle angle and what is fixed of the other two.
        [one] Of the angles about the { $asked_turning ->
            [fixed] fixed
           *[current] current
        } axes { $asked_axes } one triple is enough.
       *[none] {""}
    }
task-rotation-check = Is this matrix a rotation? If it is none, say which property of rotations fails.
task-frame-chain = The poses below are known. Write the pose of frame { $end } in frame { $start } as a 4×4 matrix, lengths in { $unit }.
feedback-orientation_right = Every notation describes the given orientation.
feedback-orientation_wrong =
    { $notation ->
        [matrix] The matrix is not that of this orientation.
        [quaternion] The quaternion is not that of this orientation.
        [axis_angle] Axis and angle are not those of this orientation.
       *[other] The angles are not all that belong to this orientation.
    }
feedback-orientation_missing =
    { $notation ->
        [matrix] The matrix is missing.
        [quaternion] The quaternion is missing.
        [axis_angle] Axis and angle are missing.
       *[other] The angles are missing.
    }

feedback-rotation_transposed = This is the inverse rotation: rows and columns, or the sense of turning, have changed places.
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
feedback-rotation_quadrant = An angle lies in the wrong quadrant, half a turn away: take atan2 instead of atan, and mind the sign of the middle angle.
feedback-rotation_unit_columns = This is no rotation: a column is not of length 1.
feedback-rotation_perpendicular_columns = This is no rotation: two columns are not at right angles.
feedback-rotation_right_handed = This is no rotation but a reflection: its determinant is −1.
feedback-claim_right = That is true of this matrix.
feedback-claim_not_rotation = It is none: check the lengths of the columns, their right angles, and the determinant.
feedback-claim_rotation = It is a rotation after all: columns of length 1, at right angles, determinant +1.
feedback-claim_other_property = It is no rotation, but this property holds; another one fails.
feedback-chain_right = The pose is the one that follows from the chain of frames.
feedback-chain_wrong = This is not the pose that follows from the known ones.
feedback-chain_rotation_right = Its rotation is right.
feedback-chain_position_right = Its position is right.
feedback-chain_inverted = This is the inverse: the pose of the first frame in the last.
feedback-chain_not_inverted = A known pose was used as it is that has to be inverted first.
feedback-chain_inverse_without_transpose = The inverse of a pose was formed with R; it needs Rᵀ: (Rᵀ, −Rᵀp).
feedback-chain_inverse_position = The position of an inverse is −Rᵀp, not −p.
feedback-chain_order_reversed = The factors were multiplied in reverse order.
feedback-chain_transposed = The rotation is transposed.
feedback-chain_not_rigid = This is no rigid motion: its first three columns are not those of a rotation.
error-euler_axes_unknown = { $axes } is no sequence of axes: three of X, Y, Z, neighbours different.
error-component_order_missing = Say where the scalar of the quaternion stands: wxyz or xyzw.
error-axis_and_angle = An axis needs an angle, and an angle an axis.
error-family_incomplete = A family of triples needs all three: the middle angle, sum or difference, and its value.
error-orientation_empty = Write the orientation in one of the notations that are asked.
error-frames_not_connected = The known poses do not lead from frame { $start } to frame { $end }.

error-one_notation = Give the orientation in one notation: { $known }.
error-expected_not_rotation = The expected matrix is no rotation.
