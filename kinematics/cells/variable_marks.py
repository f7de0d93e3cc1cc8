"""Marks on joint variables: θ1*, θ1^*, q1(t), theta(1).

An asterisk marks what varies in many textbooks, (t) what depends on time, and programs count with
parentheses. All of them are the variable itself. An index that is no longer lowered stays one. A raised zero
or o behind a number is a degree sign.
"""

import re

from lark import Token

from kinematics.cells.characters import GREEK

_VARIABLE = re.compile(r"(?:q|Q|theta|Theta|d)[0-9]{1,4}")
_NUMBERLESS = re.compile(r"q|Q|theta|Theta|d")
_ANGLE_VARIABLE = re.compile(r"(?:q|Q|theta|Theta)[0-9]{0,4}")
_LETTER = re.compile("[A-DF-WYZa-df-wyz]|" + "|".join(GREEK.values()))
"""Names that a number behind them is an index of, L 1, as a PDF lowers nothing; not in 3 x 4 or 1 e 3."""
_LOWERED = re.compile("0|[1-9][0-9]?")
_RAISED_STAR = (("POW", "STAR"), ("POW", "LBRACE", "STAR", "RBRACE"))
_RAISED_ZERO = (("SUPERSCRIPT",), ("POW", "NUMBER"), ("POW", "LBRACE", "NUMBER", "RBRACE"))
_CALL = ("LPAR", "NAME", "RPAR")
_INDEX = ("LPAR", "NUMBER", "RPAR")


def is_joint_variable(name: str) -> bool:
    """Return whether a name with a number can only be the variable of a joint that turns."""
    return _ANGLE_VARIABLE.fullmatch(name) is not None and name[-1].isdigit()


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
    if _LETTER.fullmatch(name) and _is_index(tokens, position):
        name, position = Token("NAME", f"{name}{tokens[position]}", column=name.column), position + 1
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


def _is_index(tokens: list[Token], position: int) -> bool:
    """Whether a number behind a letter is its index: D 03 may be an exponent, and L 1/2 half of L."""
    if _types(tokens, position, 1) != ("NUMBER",) or not _LOWERED.fullmatch(tokens[position]):
        return False
    return _types(tokens, position + 1, 2) != ("SLASH", "NUMBER")


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
