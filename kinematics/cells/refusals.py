"""Why a cell or a table is refused: every code with its English sentence."""

from __future__ import annotations

from collections.abc import Mapping

from kinematics.errors import Fault, ParamValue

MESSAGES: Mapping[str, str] = {
    # what the cell is
    "cell_empty": "this cell is empty; write 0 where nothing is meant",
    "cell_not_a_value": "a cell is a number or an expression in text, not {kind}",
    "cell_too_long": "this cell has {length} characters; at most {limit} are read",
    "cell_too_deep": "this cell nests deeper than {limit} levels (column {column})",
    "cell_too_many_symbols": "this cell holds more than {limit} different names (column {column})",
    # its characters
    "character_not_allowed": "column {column}: {character} has no meaning in a cell",
    "character_invisible": "column {column}: there is an invisible or control character ({character}); delete it",
    "character_lookalike": "column {column}: {character} only looks like the Latin letter {latin}; type {latin}",
    "character_full_width": "column {column}: {character} is a full-width character; type {latin}",
    "dollar_misplaced": "column {column}: $ may only enclose the whole cell",
    "command_unknown": "column {column}: \\{command} is not understood",
    "script_misplaced": "column {column}: {character} follows nothing that it could belong to",
    # its numbers
    "number_malformed": "column {column}: {text} is not a decimal number; write digits, one point and no separators",
    "number_too_long": "column {column}: a number may have at most {limit} digits",
    "number_out_of_range": "column {column}: a number may be 0 or between {smallest} and {largest} in size",
    "number_not_finite": "a cell holds finite numbers only; NaN and infinity are refused",
    "decimal_comma": "column {column}: write the decimal sign as a point: {suggestion}",
    # its names
    "names_run_together": "column {column}: {text} runs into what follows; write a product with *",
    "name_malformed": "column {column}: an underscore stands between a letter and an index, as in L_1",
    "name_too_long": "column {column}: a name may have at most {limit} characters",
    "name_is_not_a_number": "column {column}: {name} is not a value; a cell holds finite numbers only",
    "unit_in_cell": "column {column}: units are not written in cells; {name} is given once for the table",
    "function_unknown": "column {column}: {name} is not a function here; the functions are {functions}; "
    "write a product as {name}*( )",
    "function_without_parentheses": "column {column}: write the argument of {name} in parentheses, as in {name}(x)",
    "function_arity": "column {column}: {name} takes {expected} argument(s), not {given}",
    # its structure
    "value_missing": "column {column}: a value is missing before {symbol}",
    "cell_incomplete": "column {column}: the cell ends where a value should follow",
    "symbol_misplaced": "column {column}: {symbol} cannot stand here",
    "comma_misplaced": "column {column}: a comma only separates the arguments of atan2",
    "parenthesis_not_closed": "column {column}: this parenthesis is never closed",
    "parenthesis_not_opened": "column {column}: this parenthesis closes nothing",
    "number_after_value": "column {column}: a number cannot follow a value directly; is an operator missing?",
    "division_ambiguous": "column {column}: it is unclear what is divided by; write a/(b*c) or (a/b)*c",
    # its value
    "exponent_not_constant": "column {column}: an exponent must be a rational number",
    "exponent_out_of_range": "column {column}: an exponent may be at most {limit} in size, its denominator too",
    "division_by_zero": "column {column}: this divides by zero",
    "value_not_real": "this cell has no finite real value",
    "degree_of_angle": "column {column}: the degree sign follows a number; this is an angle already",
    "degree_in_length": "column {column}: a length cannot be in degrees",
    "angle_in_length": "column {column}: {name} gives an angle in degrees, which cannot be a length",
    "angle_product": "column {column}: an angle is multiplied by an angle; an angle may be multiplied by "
    "numbers only",
    "angle_in_denominator": "column {column}: this divides by an angle; an angle may be divided by numbers only",
    "angle_power": "column {column}: an angle cannot be raised to a power",
    "parameter_two_kinds": "column {column}: {name} is used as {kind} here and as {other} before; "
    "use two names",
    # joint variables
    "variable_without_number": "column {column}: {name} needs the number of its joint, as in {suggestion}",
    "variable_scaled": "column {column}: {name} is multiplied by {factor}; a joint variable enters as +{name} "
    "or -{name}, for otherwise the joint would turn or slide by something else than its variable",
    "variable_in_product": "column {column}: {name} is multiplied by another quantity; a joint variable enters as "
    "+{name} or -{name} plus an offset",
    "variable_in_denominator": "column {column}: {name} stands in a denominator; a joint variable enters as "
    "+{name} or -{name} plus an offset",
    "variable_in_power": "column {column}: {name} is raised to a power; a joint variable enters as +{name} or "
    "-{name} plus an offset",
    "variable_in_function": "column {column}: {name} stands in a function; the cell holds the joint variable "
    "itself, and the sines and cosines follow from the table",
    "variable_in_constant_cell": "column {column}: {name} stands in the {cell} column; a link's length and twist "
    "never vary, a joint variable stands under theta (revolute) or d (prismatic)",
    "variable_in_fixed_row": "column {column}: {name} stands in a row that is given as fixed; "
    "a fixed row has no joint variable",
    "variable_in_wrong_cell": "column {column}: {name} stands under {cell}, but the variable of a {joint} joint "
    "stands under {expected}",
    "variable_twice": "column {column}: {name} occurs a second time; each joint variable stands in the table once",
    "variable_of_other_row": "column {column}: {name} does not belong to this row; here the variable is {expected}",
    "variable_numbering_mixed": "column {column}: some variables are numbered by joint and some by row ({name}); "
    "number them by joint, q1 to q{joints}",
    # tables
    "table_empty": "the table has no rows; at least one is needed",
    "table_too_many_rows": "the table has {rows} rows; at most {limit} are read",
    "table_too_many_parameters": "the table holds more than {limit} different parameters",
    # parameters
    "parameter_missing": "the parameter {name} has no value",
    "parameter_unused": "the table holds no parameter {name}",
    "parameter_not_finite": "the value of {name} must be a finite number",
    "parameter_name_invalid": "{name} is not the name of a parameter; a name is a word with an index, such as L1",
    "parameter_given_twice": "{name} and {other} are the same parameter; give its value once",
}


class Refusal(Exception):  # noqa: N818 - it becomes a Fault of a CellError where the cell's place is known
    """A cell cannot be read: the code and values of a fault that doesn't know its place yet."""

    def __init__(self, code: str, **params: ParamValue) -> None:
        super().__init__(code)
        self.code = code
        self.params = params

    def at(self, *where: str | int) -> Fault:
        """The fault, at its place."""
        return fault(self.code, *where, **self.params)


def fault(code: str, *where: str | int, **params: ParamValue) -> Fault:
    """A fault with its English sentence."""
    return Fault(code=code, message=MESSAGES[code].format(**params), where=where, params=params)
