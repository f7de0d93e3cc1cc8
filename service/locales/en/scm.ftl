# The SCM method: chains of [X Y Z A B C].

error-scm_chain_empty = The chain has no joints. At least one row is needed.
error-scm_too_many_joints = The chain has { $joints } joints; at most { $limit } are read.
error-scm_chain_too_long = The entries together have { $length } characters; at most { $limit } are read.
error-scm_no_variable = Row { $joint } holds no joint variable. Write q{ $joint } in the entry that moves.
error-scm_two_variables = Row { $joint } holds its variable in both { $first } and { $second }. A row has exactly one.
error-scm_variable_of_other_row = { $name } is not the variable of row { $joint }; q{ $joint } is.
error-scm_variable_form = The variable must appear as +q{ $joint } or −q{ $joint }, with at most a constant added.
error-scm_variable_outside_joints = { $name } is a joint variable; only the rows of joints may hold one.
error-scm_parameter_two_kinds = { $name } measures a length in one entry and an angle in another. Use two names.
error-scm_prismatic_turns = Joint { $joint } is prismatic: its row may not turn the frame. Put constant rotations into the Final Transformation.
error-scm_prismatic_second_length = Joint { $joint } is prismatic: its row holds the variable and no other length. Put this length into the row before or after it.
error-scm_revolute_offset = Joint { $joint } is revolute: its angle may hold no offset. Put constant rotations into the Final Transformation.
error-scm_revolute_second_turn = Joint { $joint } turns about one axis only. Put constant rotations into the Final Transformation.
error-scm_limits_reversed = Joint { $joint }: limits are [low, high], both finite, with low not above high.
error-chain_or_robot = Give exactly one of chain and robot.
error-scm_six_entries = Six entries are needed: the list [X, Y, Z, A, B, C], or an object with some of x, y, z, a, b, c; those left out are 0.
error-matrix_not_rotation = The rotation part of this matrix is no rotation: its columns must be perpendicular unit vectors, right-handed, for all values of the joint variables. Only then does it have an angular velocity.
error-variable_name_invalid = { $name } cannot be the name of joint variable { $joint }: a name is a word with an index, such as a1, and each variable has its own.
error-no_derivative = A joint variable appears inside a function that is not differentiated here: write sines and cosines of it.
