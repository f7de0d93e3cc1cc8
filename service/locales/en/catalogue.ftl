# Files of the robot catalogue.

error-catalogue_not_toml = This is not TOML: { $reason }.
error-catalogue_key_missing = { $key } is missing.
error-catalogue_key_unknown = { $key } is not a known key. Known keys are { $known }.
error-catalogue_value_type = { $key } must be { expected-value }.
error-catalogue_limits_reversed = Joint { $joint }: the lower limit must be below the upper one.
error-catalogue_outside_limits = Joint { $joint } of this configuration is outside its limits.
error-robot_unknown = The catalogue holds no robot { $robot }. It holds { $known }.
expected-value = { $expected ->
    [text] text that is not empty
    [texts] a list of texts
    [number] a number of at most 10^15 in size
    [integer] a whole number
    [count] a whole number of at least 1
    [flag] true or false
    [table] a table
    [tables] a list of tables
    [cell] a number or an expression
    [cells] a list of { $count } numbers or expressions
    [choice] one of: { $known }
    [direction] a list of three numbers that are not all zero
    [point_names] a list of { $count } names of points
    [point_chains] a list of lists of at least two names of points
    [help_levels] a list of at least one help level
    [numbers] { $count ->
        [0] a list of finite numbers
       *[other] a list of { $count } finite numbers
    }
    [rows] { $count ->
        [0] a list of lists of { $width } entries
       *[other] a list of { $count } lists of { $width } entries
    }
   *[other] of another type
}
