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
        [link] The table is right. Somebody wrote the matrix of its row { $row }, from frame { $row } to the one before, and made one mistake.
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
