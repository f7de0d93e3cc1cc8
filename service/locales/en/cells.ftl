# Why a cell, a table or a parameter is refused.

error-cell_empty = This cell is empty. If the value is zero, write 0.
error-cell_dash = This cell holds no value. If the value is zero, write 0.
error-cell_not_a_value =
    A cell is a number or an expression in text, not { $kind ->
        [list] a list
        [dict] an object
       *[other] { $kind }
    }.
error-cell_too_long = This cell has { $length } characters; at most { $limit } are read.
error-cell_too_deep = This cell is nested deeper than { $limit } levels.
error-cell_too_many_symbols = This cell holds more than { $limit } different names.

error-character_not_allowed = At character { $column }: { $character } has no meaning in a cell.
error-character_invisible = At character { $column }: there is an invisible or control character ({ $character }). Delete it.
error-character_lookalike = At character { $column }: { $character } only looks like the Latin letter { $latin }. Type { $latin }.
error-character_full_width = At character { $column }: { $character } is a full-width character. Type { $latin }.
error-dollar_misplaced = At character { $column }: $ may only enclose the whole cell.
error-command_unknown = At character { $column }: the command \{ $command } is not understood.
error-script_misplaced = At character { $column }: { $character } follows nothing that it could belong to.

error-number_malformed = At character { $column }: { $text } is not a decimal number. Write digits and one point, without separators.
error-number_too_long = At character { $column }: a number may have at most { $limit } digits.
error-number_out_of_range =
    { $size ->
        [small] At character { $column }: this number is too close to 0 to be read. Write 0.
       *[large] At character { $column }: a number is at most { $largest } in size.
    }
error-cell_not_finite = A cell holds finite numbers only; NaN and infinity are refused.
error-decimal_comma = At character { $column }: write a decimal point instead of the comma: { $suggestion }.
error-minutes_in_cell = At character { $column }: minutes and seconds of arc are not read. In decimals, { $text } is { $suggestion }.
error-about_in_cell = At character { $column }: a cell says what a value is, without { $character }. Write { $suggestion }.

error-names_run_together = At character { $column }: { $text } runs into what follows. Write a product with *.
error-name_malformed = At character { $column }: an underscore stands between a letter and its index only, as in L_1.
error-name_too_long = At character { $column }: a name may have at most { $limit } characters.
error-name_is_not_a_number = At character { $column }: { $name } is not a value. A cell holds finite numbers only.
error-unit_in_cell = At character { $column }: units are not written in cells. If the unit that is asked for is { $name }, write { $suggestion }; if it is not, convert first.
error-function_unknown = At character { $column }: { $name } is not a known function. Available: { $functions }. A product is written { $name }*(…).
error-function_without_parentheses =
    At character { $column }: write the argument of { $name } in parentheses: { $name }({ $name ->
        [atan2] y, x
        [arctan2] y, x
       *[other] x
    }).
error-function_arity =
    { $expected ->
        [one] At character { $column }: { $name } takes one argument, not { $given }.
       *[other] At character { $column }: { $name } takes { $expected } arguments, not { $given }.
    }

error-value_missing = At character { $column }: a value is missing before { $symbol }.
error-cell_incomplete = At character { $column }: the cell ends where a value should follow.
error-symbol_misplaced = At character { $column }: { $symbol } cannot stand here.
error-comma_misplaced = At character { $column }: a comma only separates the two arguments of atan2.
error-parenthesis_not_closed = At character { $column }: this parenthesis is never closed.
error-parenthesis_not_opened = At character { $column }: this parenthesis closes nothing.
error-number_after_value = At character { $column }: a number cannot follow a value directly. Is an operator missing?
error-division_ambiguous = At character { $column }: it is unclear what this divides by. Write a/(b*c) or (a/b)*c.
error-exponent_ambiguous = At character { $column }: { $text } may mean { $number } or { $difference }. Write one of these.

error-exponent_not_constant = At character { $column }: an exponent is a rational number.
error-exponent_out_of_range = At character { $column }: an exponent is at most { $limit } in size, and so is its denominator.
error-division_by_zero = At character { $column }: this divides by zero.
error-value_not_real = This cell has no finite real value.
error-degree_of_angle = At character { $column }: the degree sign follows a number; this is an angle already.
error-degree_in_length = At character { $column }: a length is not in degrees.
error-angle_in_length = At character { $column }: { $name } gives an angle in degrees, not a length.
error-angle_product = At character { $column }: two angles are multiplied. An angle is multiplied by numbers only.
error-angle_in_denominator = At character { $column }: this divides by an angle. Only numbers may divide here.
error-angle_power = At character { $column }: an angle is not raised to a power.
error-parameter_two_kinds =
    At character { $column }: { $name } stands for { $kind ->
        [angle] an angle
       *[length] a length
    } here and for { $other ->
        [angle] an angle
       *[length] a length
    } elsewhere. Use two names.

error-variable_without_number = At character { $column }: { $name } needs the number of its joint, as in { $suggestion }.
error-variable_misspelled = At character { $column }: { $name } is not a joint variable. Write { $suggestion } or θ with the number of the joint.
error-variable_called = At character { $column }: { $name } is a joint variable, so nothing in parentheses follows it. Write an offset as a sum: { $name } + ….
error-variable_scaled = At character { $column }: { $name } is multiplied by { $factor }. A joint variable enters as +{ $name } or -{ $name }; otherwise it would not be the motion of its joint.
error-variable_in_product = At character { $column }: { $name } is multiplied by another quantity. A joint variable enters as +{ $name } or -{ $name } plus an offset.
error-variable_in_denominator = At character { $column }: { $name } stands in a denominator. A joint variable enters as +{ $name } or -{ $name } plus an offset.
error-variable_in_power = At character { $column }: { $name } is raised to a power. A joint variable enters as +{ $name } or -{ $name } plus an offset.
error-variable_in_function = At character { $column }: { $name } stands inside a function. The cell holds the joint variable itself; sines and cosines follow from the table.
error-variable_in_constant_cell = At character { $column }: { $name } stands under { $cell }. Length and twist of a link never vary; a joint variable stands under θ (revolute) or d (prismatic).
error-variable_in_fixed_row = At character { $column }: { $name } stands in a row that is stated to be fixed. A fixed row has no joint variable.
error-variable_in_wrong_cell =
    At character { $column }: { $name } stands under { $cell }, but the variable of a { $joint ->
        [prismatic] prismatic
       *[revolute] revolute
    } joint stands under { $expected }.
error-variable_twice = At character { $column }: { $name } occurs a second time. Each joint variable stands in the table once.
error-variable_of_other_row = At character { $column }: { $name } is not the variable of this row, { $expected } is. If the drives of two joints are coupled, as in { $expected } + { $name }, write { $expected } alone and give the sum as its value.
error-variable_numbering_mixed = At character { $column }: { $name } is numbered by row while others are numbered by joint. Number them q1 to q{ $joints } in joint order.

error-table_empty = The table has no rows; at least one is needed.
error-table_too_many_rows = The table has { $rows } rows; at most { $limit } are read.
error-table_too_long = The cells together have { $length } characters; at most { $limit } are read.
error-table_too_many_parameters = The table holds more than { $limit } different parameters.

error-parameter_missing = The parameter { $name } has no value.
error-parameter_unused = The table holds no parameter { $name }.
error-parameter_not_finite = The value of { $name } must be a finite number.
error-parameter_name_invalid = { $name } is not the name of a parameter. A name is a word with an index, like L1.
error-parameter_given_twice = { $name } and { $other } are the same parameter. Give its value once.
