field-cell_row = Row of a wrong entry
field-cell_column = Column of a wrong entry
field-mistake = What is wrong
field-mended_matrix = The matrix as it should be
option-entry_sign = one entry of the rotation has the wrong sign
option-sine_for_cosine = one entry of the rotation has sine and cosine exchanged
option-position_sign = one entry of the position has the wrong sign
option-position_missing = one entry of the position is missing
option-position_sine_for_cosine = one entry of the position has sine and cosine exchanged
option-rotation_transposed = the rotation is transposed
option-matrix_other_convention = it was formed in the other convention
option-link_missing = one link was left out of the product
given-matrix-with-mistake =
    { $matrix ->
        [link] The matrix of row { $row }, with a mistake
       *[transform] ⁰T_N, with a mistake
    }

task-matrix-mistake =
    { $matrix ->
        [link] The table is right. Somebody wrote the matrix of its row { $row }, the pose of frame { $row } in the one before, and made one mistake.
       *[transform] The table is right. Somebody wrote ⁰T_N, the product of all its matrices, and made one mistake.
    } Give one entry that is wrong, say what is wrong with it, and write the whole matrix as it should be.

feedback-matrix_mistake_place_wrong = This entry is right; the mistake is elsewhere.
feedback-matrix_mistake_name_wrong = The mistake is of another kind.
feedback-matrix_not_mended = This is not yet the matrix of the table.
feedback-matrix_mistake_missing =
    { $what ->
        [cell_row] Give the row and the column of a wrong entry.
        [mistake] Say what is wrong.
       *[mended_matrix] Write the matrix as it should be.
    }

field-wrong_frame = Frame with the mistake
field-mended_origin = Its origin as it should be
field-mended_x = Its x axis as it should be
field-mended_y = Its y axis as it should be
field-mended_z = Its z axis as it should be
option-z_not_along_axis = z does not lie along the axis of its joint
option-origin_not_on_axis = the origin is not on the axis of its joint
option-origin_not_on_common_normal = the origin is not on the common normal
option-origin_not_at_intersection = the origin is not where the two axes meet
option-x_not_across_z = x is not at right angles to z
option-x_not_along_common_normal = x does not lie along the common normal
option-x_not_across_both_axes = x is not at right angles to both axes
option-first_x_misses_axis = x of the first frame does not meet axis 1 at right angles
option-last_x_misses_axis = x of the last frame does not meet the last axis at right angles
option-y_left_handed = the frame is left-handed: y is not z × x
given-drawn-frames = The frames as they are drawn

task-frame-mistake =
    { $convention ->
        [standard] The frames in the figure should follow the standard convention, z of frame i along joint i+1
       *[modified] The frames in the figure should follow the modified convention, z of frame i along joint i
    }, but one of them has a mistake. Which frame is wrong, what is wrong with it, and how should it stand? Points and directions are given in the coordinates of the figure; any length of a direction will do. { figure-place }

feedback-frame_mistake_place_wrong = This frame is right; the mistake is in another one.
feedback-frame_mistake_name_wrong = The mistake is of another kind.
feedback-frame_not_mended = With this frame the drawing still breaks a rule.
feedback-frame_mistake_missing =
    { $what ->
        [wrong_frame] Say which frame is wrong.
        [mistake] Say what is wrong.
       *[mended_origin] Give origin, x, y and z as they should be.
    }
