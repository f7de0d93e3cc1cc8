"""What a cell is wrapped in when it is pasted, and marks on joint variables: θ1*, θ1^*, q1(t), theta(1).

An asterisk marks what varies in many textbooks, (t) what depends on time, and programs count with
parentheses. All of them are the variable itself. A raised zero or o behind a number is a degree sign.
"""

import re

from lark import Token

_VARIABLE = re.compile(r"(?:q|Q|theta|Theta|d)[0-9]{1,4}")
_NUMBERLESS = re.compile(r"q|Q|theta|Theta|d")
_ANGLE_VARIABLE = re.compile(r"(?:q|Q|theta|Theta)[0-9]{0,4}")
_RAISED_STAR = (("POW", "STAR"), ("POW", "LBRACE", "STAR", "RBRACE"))
_RAISED_ZERO = (("SUPERSCRIPT",), ("POW", "NUMBER"), ("POW", "LBRACE", "NUMBER", "RBRACE"))
_CALL = ("LPAR", "NAME", "RPAR")
_INDEX = ("LPAR", "NUMBER", "RPAR")


def without_marks(tokens: list[Token]) -> list[Token]:
    """Return the tokens with marked joint variables as plain names."""
    if len(tokens) < 2:
        return tokens
    found: list[Token] = []
    position = 0
    while position < len(tokens):
        token = tokens[position]
        position += 1
        if token.type == "NAME":
            token, position = _unmarked(token, tokens, position)
        found.append(token)
        # a power of ten is a factor, and ** is a program's
        if token.type == "NUMBER" and not (found[-1:] == ["10"] and _types(found[-2:], 0, 1) == ("STAR",)):
            for mark in _RAISED_ZERO:
                raised = tokens[position : position + len(mark)]
                if tuple(part.type for part in raised) == mark and "0" in raised and "**" not in raised:
                    found.append(Token("DEGREE", "°", column=raised[0].column))
                    position += len(mark)
                    break
    return found


def _unmarked(name: Token, tokens: list[Token], position: int) -> tuple[Token, int]:
    """A name and the position behind its marks."""
    if _NUMBERLESS.fullmatch(name) and _types(tokens, position, 3) == _INDEX:
        index = tokens[position + 1]
        if index.isdecimal():
            name, position = Token("NAME", f"{name}{int(index)}", column=name.column), position + 3
    # θ* and θ(t) only lack a number, which is told later of θ itself
    if not _VARIABLE.fullmatch(name) and not _ANGLE_VARIABLE.fullmatch(name):
        return name, position
    if _types(tokens, position, 3) == _CALL and tokens[position + 1] == "t":
        position += 3
    for mark in _RAISED_STAR:
        if _types(tokens, position, len(mark)) == mark:
            return name, position + len(mark)
    return name, position + _is_star_mark(name, tokens, position)


def _is_star_mark(name: Token, tokens: list[Token], position: int) -> bool:
    """Whether a star marks the name: nothing follows that it could multiply, or only a signed offset.

    A joint variable times a signed number is no entry of a table, but for q1*-1.
    """
    if _types(tokens, position, 1) != ("STAR",):
        return False
    following = _types(tokens, position + 1, 1)
    if following in {(), ("RPAR",)}:
        return True
    unit = _types(tokens, position + 2, 1) == ("NUMBER",) and tokens[position + 2] == "1"
    signed = following in {("PLUS",), ("MINUS",)} and not unit
    return signed and _ANGLE_VARIABLE.fullmatch(name) is not None


def _types(tokens: list[Token], start: int, length: int) -> tuple[str, ...]:
    return tuple(token.type for token in tokens[start : start + length])


_EQUALS = re.compile(r"(\s*)=(?=\s*\S)")
_FONT = re.compile(
    r"\\(?:math(?:rm|it|bf|sf|normal)|boldsymbol|operatorname|text(?:rm|it|bf|sf|normal)?) *"
    r"\{((?:[^{}]|\{[^{}]*\})*)\}"
)
_QUOTED = re.compile(r"""(\s*)(?:"([^"]+)"|'([^']+)'|`([^`]+)`|[“„]([^“”„]+)[“”]|‘([^‘’]+)’)(\s*)""")
_MODULE = re.compile(r"(?<![\w.\\])(?:np|numpy|math|Math|sp|sympy)\.(?=[A-Za-z])", re.ASCII)
_SPACING = re.compile(r"\\[,;: ]")
_COUNTED = re.compile(r"(?<![^\W_])(\\?(?:var)?[Tt]heta|[^\W\d_])\[([0-9]{1,4})\]")
"""What computer algebra writes for an index: theta[1]."""
_STAR_FIRST = re.compile(
    r"(?<![^\W_])(\\?(?:var)?[Tt]heta|[θΘϑqQd])(?:\^ *)?(?:[*\u2217\u22c6]|\{ *(?:\*|\\ast) *\}|\\ast *)"
    r"(_(?:[0-9]+|\{ *[0-9]+ *\})|[₀-₉]+)"
)
_BRACED = re.compile(r"((?:^|[-+*/(\u2212])\s*)\{(\s*\\?[^\W\d_]+\s*(?:_(?:\w+|\{\w+\}))?)\}")
"""A name in braces of its own, as formula editors write it: {\\theta}_1."""


def without_wrapping(text: str) -> str:
    r"""Return a cell without it, as long as before: what was wrapped ends where the wrapping did.

    `\mathrm{L}_1` is `L_1`, and `10\,\mathrm{mm}` is 10 with a unit; an `=` counts at the beginning alone,
    quotes about the whole of it.
    """
    quoted = _QUOTED.fullmatch(text)
    if quoted:
        start, end = next(quoted.span(i) for i in range(2, 7) if quoted[i])
        text = " " * start + text[start:end] + " " * (len(text) - end)
    text = _MODULE.sub(lambda module: " " * len(module[0]), text)
    plain = _EQUALS.sub(r"\1 ", text, count=1) if _EQUALS.match(text) else text
    plain = text = _COUNTED.sub(r"\1_\2 ", plain)
    plain = text = _STAR_FIRST.sub(lambda star: f"{star[1]}{star[2]}".ljust(len(star[0])), plain)
    plain = text = _BRACED.sub(r"\1  \2", plain)
    if "\\" not in plain:
        return plain
    before = ""
    while before != plain:
        before, plain = plain, _FONT.sub(_unwrapped, plain)
    return plain if plain == text else _SPACING.sub("  ", plain)


def _unwrapped(match: re.Match[str]) -> str:
    inner, width = match[1].strip(), len(match[0])
    if match.string[: match.start()].endswith(("_", "^")):
        return "{" + inner.rjust(width - 2) + "}"
    return inner.rjust(width)
