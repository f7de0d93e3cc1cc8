"""Why a cell or a table is refused: every code with its English sentence."""

from __future__ import annotations

from collections.abc import Mapping

from kinematics.errors import Fault, ParamValue

MESSAGES: Mapping[str, str] = {
    # what the cell is
    "cell_empty": "this cell is empty; write 0 where nothing is meant",
    "cell_not_a_value": "a cell is a number or an expression in text, not {kind}",
    "cell_too_long": "this cell has {length} characters; at most {limit} are read",
    "cell_too_deep": "this cell is nested deeper than {limit} levels",
    "cell_too_many_symbols": "this cell holds more than {limit} different names",
    # its characters
    "character_not_allowed": "at character {column}: {character} has no meaning in a cell",
    "character_invisible": "at character {column}: there is an invisible or control character "
    "({character}); delete it",
    "character_lookalike": "at character {column}: {character} only looks like the Latin letter {latin}; "
    "type {latin}",
    "character_full_width": "at character {column}: {character} is a full-width character; type {latin}",
    "dollar_misplaced": "at character {column}: $ may only enclose the whole cell",
    "command_unknown": "at character {column}: the command \\{command} is not understood",
    "script_misplaced": "at character {column}: {character} follows nothing that it could belong to",
    # its numbers
    "number_malformed": "at character {column}: {text} is not a decimal number; write digits and one point, "
    "without separators",
    "number_too_long": "at character {column}: a number may have at most {limit} digits",
    "number_out_of_range": "at character {column}: a number is 0 or between {smallest:g} and {largest:g} "
    "in size",
    "cell_not_finite": "a cell holds finite numbers only; NaN and infinity are refused",
    "decimal_comma": "at character {column}: write a decimal point instead of the comma: {suggestion}",
    # its names
    "names_run_together": "at character {column}: {text} runs into what follows; write a product with *",
    "name_malformed": "at character {column}: an underscore stands between a letter and its index only, "
    "as in L_1",
    "name_too_long": "at character {column}: a name may have at most {limit} characters",
    "name_is_not_a_number": "at character {column}: {name} is not a value; a cell holds finite numbers only",
    "unit_in_cell": "at character {column}: units are not written in cells; {name} is stated once for "
    "the table",
    "function_unknown": "at character {column}: {name} is no function here; there are {functions}; "
    "a product is written {name}*(...)",
    "function_without_parentheses": "at character {column}: write the argument of {name} in parentheses: "
    "{name}(x)",
    "function_arity": "at character {column}: {name} takes {expected} argument(s), not {given}",
    # its structure
    "value_missing": "at character {column}: a value is missing before {symbol}",
    "cell_incomplete": "at character {column}: the cell ends where a value should follow",
    "symbol_misplaced": "at character {column}: {symbol} cannot stand here",
    "comma_misplaced": "at character {column}: a comma only separates the two arguments of atan2",
    "parenthesis_not_closed": "at character {column}: this parenthesis is never closed",
    "parenthesis_not_opened": "at character {column}: this parenthesis closes nothing",
    "number_after_value": "at character {column}: a number cannot follow a value directly; "
    "is an operator missing?",
    "division_ambiguous": "at character {column}: it is unclear what this divides by; "
    "write a/(b*c) or (a/b)*c",
    # its value
    "exponent_not_constant": "at character {column}: an exponent is a rational number",
    "exponent_out_of_range": "at character {column}: an exponent is at most {limit} in size, "
    "and so is its denominator",
    "division_by_zero": "at character {column}: this divides by zero",
    "value_not_real": "this cell has no finite real value",
    "degree_of_angle": "at character {column}: the degree sign follows a number; this is an angle already",
    "degree_in_length": "at character {column}: a length is not in degrees",
    "angle_in_length": "at character {column}: {name} gives an angle in degrees, which is no length",
    "angle_product": "at character {column}: two angles are multiplied; an angle is multiplied by "
    "numbers only",
    "angle_in_denominator": "at character {column}: this divides by an angle; only numbers may divide here",
    "angle_power": "at character {column}: an angle is not raised to a power",
    "parameter_two_kinds": "at character {column}: {name} stands for {kind} here and for {other} elsewhere; "
    "use two names",
    # joint variables
    "variable_without_number": "at character {column}: {name} needs the number of its joint, as in "
    "{suggestion}",
    "variable_scaled": "at character {column}: {name} is multiplied by {factor}; a joint variable enters as "
    "+{name} or -{name}, for otherwise it would not be the motion of its joint",
    "variable_in_product": "at character {column}: {name} is multiplied by another quantity; "
    "a joint variable enters as +{name} or -{name} plus an offset",
    "variable_in_denominator": "at character {column}: {name} stands in a denominator; "
    "a joint variable enters as +{name} or -{name} plus an offset",
    "variable_in_power": "at character {column}: {name} is raised to a power; "
    "a joint variable enters as +{name} or -{name} plus an offset",
    "variable_in_function": "at character {column}: {name} stands inside a function; the cell holds the "
    "joint "
    "variable itself, sines and cosines follow from the table",
    "variable_in_constant_cell": "at character {column}: {name} stands under {cell}; length and twist "
    "of a link "
    "never vary, a joint variable stands under theta (revolute) or d (prismatic)",
    "variable_in_fixed_row": "at character {column}: {name} stands in a row that is stated to be fixed; "
    "a fixed row has no joint variable",
    "variable_in_wrong_cell": "at character {column}: {name} stands under {cell}, but the variable of a "
    "{joint} "
    "joint stands under {expected}",
    "variable_twice": "at character {column}: {name} occurs a second time; "
    "each joint variable stands in the table once",
    "variable_of_other_row": "at character {column}: {name} is not the variable of this row, {expected} is",
    "variable_numbering_mixed": "at character {column}: {name} is numbered by row while others are "
    "numbered by "
    "joint; number them q1 to q{joints} in joint order",
    # tables
    "table_empty": "the table has no rows; at least one is needed",
    "table_too_many_rows": "the table has {rows} rows; at most {limit} are read",
    "table_too_long": "all cells together have {length} characters; at most {limit} are read",
    "table_too_many_parameters": "the table holds more than {limit} different parameters",
    # parameters
    "parameter_missing": "the parameter {name} has no value",
    "parameter_unused": "the table holds no parameter {name}",
    "parameter_not_finite": "the value of {name} must be a finite number",
    "parameter_name_invalid": "{name} is not the name of a parameter; a name is a word with an index, "
    "like L1",
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
    return Fault(code=code, where=where, params=params)
