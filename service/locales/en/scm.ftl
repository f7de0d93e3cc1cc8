# The SCM method: chains of [X Y Z A B C].

error-scm_chain_empty = The chain has no joints. At least one row is needed.
error-scm_too_many_joints = The chain has { $joints } joints; at most { $limit } are read.
error-scm_chain_too_long = The entries together have { $length } characters; at most { $limit } are read.
error-scm_no_variable = Row { $joint } holds no joint variable. Write q{ $joint } in the entry that moves.
error-scm_two_variables = Row { $joint } holds its variable in { $first } and in { $second }. A row has exactly one.
error-scm_variable_of_other_row = { $name } is not the variable of row { $joint }; q{ $joint } is.
error-scm_variable_form = The variable must enter as +q{ $joint } or −q{ $joint }, plus a constant at most.
error-scm_variable_outside_joints = { $name } is a joint variable; only the rows of joints may hold one.
error-scm_parameter_two_kinds = { $name } measures a length in one entry and an angle in another. Use two names.
error-scm_prismatic_turns = Joint { $joint } is prismatic: its row may not turn the frame. Put constant turns into the Final Transformation.
error-scm_prismatic_second_length = Joint { $joint } is prismatic: its row holds the variable and no other length. Put this one into a row before or after.
error-scm_revolute_offset = Joint { $joint } is revolute: its angle may hold no offset. Put constant turns into the Final Transformation.
error-scm_revolute_second_turn = Joint { $joint } turns about one axis only. Put constant turns into the Final Transformation.
error-scm_limits_reversed = Joint { $joint }: limits are [low, high], both finite and low not above high.
error-chain_or_robot = Give either chain or robot, exactly one of them.
error-scm_six_entries = Six entries are needed: the list [X, Y, Z, A, B, C], or an object with some of x, y, z, a, b, c; what is left out is 0.
error-no_derivative = A joint variable stands in a function that is not differentiated here: write sines and cosines of it.
