"""From letters and commands to tokens: names and their indices, functions, signs that LaTeX spells."""

import re

from lark import Token

from kinematics.cells.characters import DOT_ABOVE, GREEK, SUBSCRIPTS
from kinematics.cells.limits import Limits
from kinematics.cells.refusals import CellRefusal
from kinematics.expressions import Function

FUNCTION_NAMES = {function.value: function for function in Function} | {
    "arcsin": Function.ASIN,
    "arccos": Function.ACOS,
    "arctan": Function.ATAN,
    "arctan2": Function.ATAN2,
    "arctg": Function.ATAN,
    "arcsen": Function.ASIN,
    "sen": Function.SIN,
    "seno": Function.SIN,
    "tg": Function.TAN,
    "raiz": Function.SQRT,
    "raizq": Function.SQRT,
    "racine": Function.SQRT,
}
"""Names of functions, those of the documents' languages included."""

_TURNED = {"sin", "cos", "tan", "sen", "tg"}
"""Functions behind which a number is an argument, sin30, and no index."""
_TURNED_VARIABLE = re.compile(r"(sin|cos|tan|sen|tg)(q|theta)$", re.IGNORECASE)
"""A function that runs into its argument: cosq1."""
_NAME_CHARACTERS = 32  # Characters of a name; longer ones are text that was pasted by mistake.
_NOT_VALUES = {"nan", "inf", "infinity"}
_COMMANDS = {
    "pi": "PI",
    "cdot": "STAR",
    "times": "STAR",
    "ast": "STAR",
    "star": "STAR",
    "div": "SLASH",
    "circ": "DEGREE",
    "degree": "DEGREE",
    "textdegree": "DEGREE",
}
_FRACTIONS = {"frac", "dfrac", "tfrac"}
_LETTERS = {"ell": "l"}  # Letters that are commands.
_SPACING = {"left", "right", "quad", "qquad", ",", ";", ":", "!", " "}
_GREEK_NAMES = set(GREEK.values()) - {"pi"}

_SUBSCRIPT = "[" + "".join(SUBSCRIPTS) + "]+|_(?:[A-Za-z0-9]+|\\{ *[A-Za-z0-9]+ *\\})"
_NAME = re.compile(f"([A-Za-z]+|[{''.join(GREEK)}])([0-9]*)((?: *(?:{_SUBSCRIPT}))*)")
_SHORT_SINE = re.compile(r"([cs])_([0-9]+)(?=[cs]_?[0-9])")
"""A sine or cosine in short with another behind it, c_1c_2, as TeX sets it: the index is the number alone."""
_INDEX = re.compile(f"([0-9]*)((?: *(?:{_SUBSCRIPT}))*)")
_SEGMENT = re.compile(_SUBSCRIPT)
_COMMAND = re.compile(r"\\([A-Za-z]+|.?)", re.DOTALL)
_RATE = re.compile(rf"\\dot *(?:\{{ *(?:q|\\theta|θ) *\}}|q|\\theta|θ)([0-9]*)((?: *(?:{_SUBSCRIPT}))*)")
_DOTTED = re.compile(rf"[qθ]{DOT_ABOVE}([0-9]*)((?: *(?:{_SUBSCRIPT}))*)")
_FROM_DEGREES = re.compile(r"(?:radians|RADIANS|RADIANES|RADIANOS|deg2rad)(?= *\()")
"""What programs call the function whose argument is in degrees."""
_EMPTY_CALL = re.compile(r" *\( *\)")  # A spreadsheet writes PI().

Scanned = tuple[list[Token], int]


def token_at(kind: str, text: str, start: int) -> Token:
    """Return a token that begins at a position, counted from 0."""
    return Token(kind, text, column=start + 1)


def scan_name(plain: str, start: int, limits: Limits) -> Scanned:
    """Return the tokens of what begins with a letter, and where they end."""
    dotted = _DOTTED.match(plain, start)
    if dotted:
        name = _spelled("dq", dotted.group(1), dotted.group(2), start)
        return [token_at("NAME", name, start)], dotted.end()
    short = _SHORT_SINE.match(plain, start)
    if short:
        return [token_at("NAME", short[1] + short[2], start)], short.end()
    match = _NAME.match(plain, start)
    radians = _FROM_DEGREES.match(plain, start)
    if radians:
        return [token_at("RADIANS", radians.group(), start)], radians.end()
    assert match is not None
    word, digits, scripts = match.groups()
    turned = _TURNED_VARIABLE.match(word)
    if turned and (digits or scripts):
        index = start + turned.start(2)
        name = _spelled(turned[2], digits, scripts, index)
        function = token_at("FUNCTION", FUNCTION_NAMES[turned[1].lower()].value, start)
        return [function, token_at("NAME", name, index)], match.end()
    _refuse_what_runs_on(plain, match.group(), start, match.end())
    word = GREEK.get(word, word)
    if word.lower() == "pi" and (digits or scripts):
        raise CellRefusal("names_run_together", column=start + 1, text=word)
    if not digits and not scripts:
        if word.lower() == "pi":
            call = _EMPTY_CALL.match(plain, match.end())
            return [token_at("PI", "pi", start)], (call or match).end()
        if word in {"deg", "Deg", "DEG"}:
            return [token_at("DEGREE", "°", start)], match.end()
        if word.lower() in _NOT_VALUES:
            raise CellRefusal("name_is_not_a_number", column=start + 1, name=word)
    called = _function(word + digits) if not scripts else None
    if called is not None:
        return [token_at("FUNCTION", called.value, start)], match.end()
    if digits and not scripts and word in _TURNED:
        raise CellRefusal("function_without_parentheses", column=start + 1, name=word)
    return [token_at("NAME", _spelled(word, digits, scripts, start), start)], match.end()


def scan_command(plain: str, start: int, limits: Limits) -> Scanned:
    """Return the tokens of what begins with a backslash, and where they end."""
    match = _COMMAND.match(plain, start)
    assert match is not None
    word, end = match.group(1), match.end()
    rate = _RATE.match(plain, start)
    if rate:
        digits, scripts = rate.group(1) or "", rate.group(2) or ""
        return [token_at("NAME", _spelled("dq", digits, scripts, start), start)], rate.end()
    if word in _SPACING:
        return [], end
    if word in _COMMANDS:
        return [token_at(_COMMANDS[word], word, start)], end
    if word in _FRACTIONS:
        return [token_at("FRACTION", word, start)], end
    if word in FUNCTION_NAMES:
        return [token_at("FUNCTION", FUNCTION_NAMES[word].value, start)], end
    letter = _LETTERS.get(word)
    word = letter or word.removeprefix("var")
    if letter is None and word not in _GREEK_NAMES:
        raise CellRefusal("command_unknown", column=start + 1, command=word)
    index = _INDEX.match(plain, end)
    assert index is not None
    _refuse_what_runs_on(
        plain, plain[start : index.end()], start, index.end(), after_digits=bool(index.group())
    )
    return [token_at("NAME", _spelled(word, index.group(1), index.group(2), start), start)], index.end()


def _function(word: str) -> Function | None:
    lower = word.lower()
    # A spreadsheet's ATAN2 takes x before y: only the lower-case name is the mathematical atan2(y, x).
    return FUNCTION_NAMES.get(lower if lower not in {"atan2", "arctan2"} else word)


def _names_function(word: str, digits: str) -> bool:
    """Whether a word and the digits behind it are read as a function: cos1, atan2."""
    return word in _TURNED or _function(word + digits) is not None


def _spelled(word: str, digits: str, scripts: str, start: int) -> str:
    name = word + digits
    for segment in _SEGMENT.finditer(scripts):
        text = segment.group()
        plain = text.strip("_{} ") if text.startswith("_") else "".join(SUBSCRIPTS[c] for c in text)
        joined = plain[0].isdigit() and name[-1].isalpha() and not _names_function(name, plain)
        name += plain if joined else f"_{plain}"
    if len(name) > _NAME_CHARACTERS:
        raise CellRefusal("name_too_long", column=start + 1, limit=_NAME_CHARACTERS)
    return name


def _refuse_what_runs_on(plain: str, text: str, start: int, end: int, *, after_digits: bool = True) -> None:
    following = plain[end : end + 1]
    if following == "_":
        raise CellRefusal("name_malformed", column=end + 1)
    ended = text[-1] in GREEK or text[-1] in SUBSCRIPTS or text[-1] == "}"
    if following.isascii() and following.isalnum() and ((after_digits and not ended) or following.isdigit()):
        raise CellRefusal("names_run_together", column=start + 1, text=text)
