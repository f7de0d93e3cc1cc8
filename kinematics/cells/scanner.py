"""From the text of a cell to its tokens.

Every token knows its column, counted from 1 in the text as typed. What people paste is understood here:
Greek letters, subscripts, superscripts, a little LaTeX. The grammar proper is in `grammar`.
"""

import re
from collections.abc import Callable
from functools import lru_cache
from itertools import pairwise

from lark import Token

from kinematics.cells.bare_arguments import with_braces, with_brackets
from kinematics.cells.characters import (
    DOT_ABOVE,
    GREEK,
    SUBSCRIPTS,
    SUPERSCRIPT_MINUS,
    SUPERSCRIPTS,
    VULGAR_FRACTIONS,
    translated,
)
from kinematics.cells.limits import DEFAULT, Limits
from kinematics.cells.refusals import CellRefusal
from kinematics.cells.scanned_names import Scanned, scan_command, scan_name, token_at
from kinematics.cells.unit_words import unit_refusal
from kinematics.cells.variable_marks import without_marks
from kinematics.cells.wrapping import without_wrapping
from kinematics.expressions import Function

_OPERATORS = {
    "+": "PLUS",
    "-": "MINUS",
    "*": "STAR",
    "/": "SLASH",
    "^": "POW",
    "(": "LPAR",
    ")": "RPAR",
    "{": "LBRACE",
    "}": "RBRACE",
    ",": "COMMA",
    "°": "DEGREE",
    "√": "ROOT",
}
_ABSOLUTE = ((("FUNCTION", "abs"), ("LPAR", "(")), (("RPAR", ")"),))
"""What two bars in a cell mean: |L1 - L2|."""
_VALUES_END = {"NUMBER", "NAME", "PI", "RPAR", "RBRACE", "DEGREE", "SUPERSCRIPT"}
_NO_VALUE = re.compile(r"\s*n *(?:/ *a|\. *a\.?)\s*", re.IGNORECASE)
"""What stands in a table for nothing: n/a."""
_NUMBER = re.compile(r"(?:[0-9]+\.?[0-9]*|\.[0-9]+)(?:[eE][+-]?[0-9]+)?")
_MATH = re.compile(r"\$(.*)\$|\\\((.*)\\\)", re.DOTALL)
_DEGREE_POWER = re.compile(r"\^ *(?:\{ *\^? *(?:\\circ|°|o) *\}|\\circ(?![A-Za-z])|°|o(?!\w))")
_SUPERSCRIPT = re.compile(f"{SUPERSCRIPT_MINUS}?[{''.join(SUPERSCRIPTS)}]+")
_FORTRAN_EXPONENT = re.compile(r"[dD]([+-][0-9]+)(?![0-9A-Za-z_.(])")
"""What Fortran writes for e: 1.5D-03. Behind a number it may be a name too: 2D-3 is 2*D - 3."""
_TIMES_TEN = re.compile(rf" ?[xX](?= ?10 ?(?:\^|\*\*|{SUPERSCRIPT_MINUS}|[{''.join(SUPERSCRIPTS)}]))")
_ALIEN_NUMBER = re.compile(r"0[xXbBoO][0-9A-Fa-f]+|[0-9.]+_[0-9_.]*|[0-9]*\.[0-9]*\.[0-9.]*")


def scan(text: str, limits: Limits = DEFAULT) -> list[Token]:
    """Return the tokens of a cell.

    Raises:
        CellRefusal: a character, a number or a name is none of a cell's; the first one, with its column.
    """
    if len(text) > limits.cell_characters:
        raise CellRefusal("cell_too_long", length=len(text), limit=limits.cell_characters)
    if _NO_VALUE.fullmatch(text):
        raise CellRefusal("cell_dash")
    plain = _without_math_marks(_translated(text))
    tokens: list[Token] = []
    position = 0
    bars = iter(_ABSOLUTE if plain.count("|") == 2 else ())
    while position < len(plain):
        if plain[position] == " ":
            position += 1
            continue
        if plain[position] == "|" and (bar := next(bars, None)):
            tokens += [token_at(kind, text, position) for kind, text in bar]
            position += 1
            continue
        if plain[position] in VULGAR_FRACTIONS and tokens and tokens[-1].type in _VALUES_END:
            raise CellRefusal("number_after_value", column=position + 1)
        scanned, position = _handler(plain[position])(plain, position, limits)
        tokens.extend(scanned)
    if not tokens:
        raise CellRefusal("cell_empty")
    tokens = with_brackets(with_braces(without_marks(tokens)))
    _refuse_calls(tokens)
    return tokens


def _translated(text: str) -> str:
    """The text in the scanner's characters; a unit is told before the foreign letters in it."""
    text = without_wrapping(text)
    unit = unit_refusal(text)
    try:
        plain = translated(text)
    except CellRefusal as refusal:
        raise unit if unit and unit.column <= refusal.column else refusal from None
    if unit:
        raise unit
    return plain


@lru_cache(maxsize=4096)
def canonical_name(text: str) -> str | None:
    """Return the one spelling of a name: L1 for L_1, L_{1}, L₁; None if the text is not one name."""
    try:
        tokens = scan(text)
    except CellRefusal:
        return None
    return str(tokens[0]) if len(tokens) == 1 and tokens[0].type == "NAME" else None


def _handler(first: str) -> Callable[[str, int, Limits], Scanned]:
    if first in "0123456789.":
        return _number
    if first.isalpha() and (first in GREEK or first.isascii()):
        return scan_name
    if first == "\\":
        return scan_command
    if first in VULGAR_FRACTIONS:
        return _vulgar_fraction
    if first in SUPERSCRIPTS or first == SUPERSCRIPT_MINUS:
        return _superscript
    return _operator


def _number(plain: str, start: int, limits: Limits) -> Scanned:
    alien = _ALIEN_NUMBER.match(plain, start)
    match = _NUMBER.match(plain, start)
    if alien or not match:
        text = alien.group() if alien else plain[start]
        raise CellRefusal("number_malformed", column=start + 1, text=text)
    text = match.group()
    if sum(character.isdigit() for character in text) > limits.digits:
        raise CellRefusal("number_too_long", column=start + 1, limit=limits.digits)
    fortran = _FORTRAN_EXPONENT.match(plain, match.end())
    if fortran:
        return [token_at("NUMBER", f"{text}e{_fortran_exponent(fortran, text, start)}", start)], fortran.end()
    tokens = [token_at("NUMBER", text, start)]
    times = _TIMES_TEN.match(plain, match.end())
    return ([*tokens, token_at("STAR", "x", match.end())], times.end()) if times else (tokens, match.end())


def _fortran_exponent(match: re.Match[str], number: str, start: int) -> str:
    """The exponent where it has zeros before it, as a program writes and nobody subtracts."""
    exponent = match.group(1)
    if len(exponent) > 2 and exponent[1] == "0":
        return exponent
    typed, sign, rest = match.group(), exponent[0], exponent[1:]
    raise CellRefusal(
        "exponent_ambiguous",
        column=start + 1,
        text=number + typed,
        number=f"{number}e{exponent}",
        difference=f"{number}*{typed[0]} {sign} {rest}",
    )


def _superscript(plain: str, start: int, limits: Limits) -> Scanned:
    match = _SUPERSCRIPT.match(plain, start)
    if not match:
        raise CellRefusal("script_misplaced", column=start + 1, character=plain[start])
    sign = "-" if match.group().startswith(SUPERSCRIPT_MINUS) else ""
    digits = "".join(SUPERSCRIPTS.get(character, "") for character in match.group())
    if len(digits) > limits.digits:
        raise CellRefusal("number_too_long", column=start + 1, limit=limits.digits)
    return [token_at("SUPERSCRIPT", sign + digits, start)], match.end()


def _vulgar_fraction(plain: str, start: int, limits: Limits) -> Scanned:
    top, bottom = VULGAR_FRACTIONS[plain[start]]
    parts = (("LPAR", "("), ("NUMBER", top), ("SLASH", "/"), ("NUMBER", bottom), ("RPAR", ")"))
    return [token_at(kind, text, start) for kind, text in parts], start + 1


def _operator(plain: str, start: int, limits: Limits) -> Scanned:
    if plain.startswith("**", start):
        return [token_at("POW", "**", start)], start + 2
    degree = _DEGREE_POWER.match(plain, start)
    if degree:
        return [token_at("DEGREE", "°", start)], degree.end()
    character = plain[start]
    if character == DOT_ABOVE:
        raise CellRefusal("character_invisible", column=start + 1, character=f"U+{ord(character):04X}")
    if character in SUBSCRIPTS:
        raise CellRefusal("script_misplaced", column=start + 1, character=character)
    if character == "_":
        raise CellRefusal("name_malformed", column=start + 1)
    if character not in _OPERATORS:
        raise CellRefusal(
            "character_not_allowed", column=start + 1, character=f"{character} (U+{ord(character):04X})"
        )
    return [token_at(_OPERATORS[character], character, start)], start + 1


def _without_math_marks(plain: str) -> str:
    stripped = plain.strip(" ")
    while wrapped := _MATH.fullmatch(stripped):
        stripped = wrapped[1] or wrapped[2] or ""
    first = plain.find(stripped) if stripped else len(plain)
    inner = stripped.find("$")
    if inner >= 0:
        raise CellRefusal("dollar_misplaced", column=first + inner + 1)
    return " " * first + stripped


def _refuse_calls(tokens: list[Token]) -> None:
    for name, bracket in pairwise(tokens):
        if name.type == "NAME" and bracket.type == "LPAR":
            functions = tuple(function.value for function in Function)
            raise CellRefusal(
                "function_unknown", column=name.column or 0, name=str(name), functions=functions
            )
    for token, following in pairwise([*tokens, Token("END", "")]):
        if token.type == "FUNCTION" and following.type not in {"LPAR", "LBRACE"}:
            raise CellRefusal("function_without_parentheses", column=token.column or 0, name=str(token))
