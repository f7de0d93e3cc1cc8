r"""Functions as they are printed: sin θ1, cos²(q2), \sin^{2}{\left(q_{2} \right)}, \frac12.

What is read in one way only is put into brackets, and the power behind them. What follows may make it
ambiguous: sin θ1 L1, sin θ1/2 and sin θ1² are left as they are, and refused. What LaTeX takes for the parts
of a fraction without braces is one digit or π each.
"""

from lark import Token

_PRINTED = {"sin", "cos", "tan"}
_SQUARED = (("POW", "NUMBER"), ("POW", "LBRACE", "NUMBER", "RBRACE"), ("SUPERSCRIPT",))
_CLOSING = {"LPAR": "RPAR", "LBRACE": "RBRACE"}
_ENDS = {"PLUS", "MINUS", "STAR", "RPAR", "RBRACE", "COMMA", "FUNCTION"}


def with_braces(tokens: list[Token]) -> list[Token]:
    """Return the tokens with braces about the bare digits, and π, that are parts of a fraction."""
    found: list[Token] = []
    awaited = [0]  # parts of a fraction that are still to come, in each brace that is open
    rest = tokens[::-1]
    while rest:
        token = rest.pop()
        if awaited[-1] and (token.type == "PI" or token.isdecimal()):
            awaited[-1] -= 1
            if token.type == "NUMBER" and len(token) > 1:
                rest.append(Token("NUMBER", token[1:], column=(token.column or 0) + 1))
                token = Token("NUMBER", token[0], column=token.column)
            found += [
                Token("LBRACE", "{", column=token.column),
                token,
                Token("RBRACE", "}", column=token.column),
            ]
            continue
        found.append(token)
        if token.type == "LBRACE":
            awaited[-1] = max(awaited[-1] - 1, 0)
            awaited.append(0)
        elif token.type == "RBRACE":
            awaited[1:] = awaited[1:-1]
        else:
            awaited[-1] = 2 if token.type == "FRACTION" else 0
    return found


def with_brackets(tokens: list[Token]) -> list[Token]:
    """Return the tokens with brackets about bare arguments, and powers of functions behind their values."""
    found: list[Token] = []
    pending: list[tuple[int, list[Token]]] = []
    opened = 0
    position = 0
    while position < len(tokens):
        token = tokens[position]
        position += 1
        found.append(token)
        opened += (token.type in _CLOSING) - (token.type in _CLOSING.values())
        while pending and token.type in _CLOSING.values() and opened == pending[-1][0]:
            found.extend(pending.pop()[1])
        if token.type != "FUNCTION" or str(token) not in _PRINTED:
            continue
        power = _power(tokens, position)
        behind = position + len(power)
        if _kind(tokens, behind) in _CLOSING:
            position = behind
            if power:
                pending.append((opened, power))
        elif _kind(tokens, behind) in {"NAME", "PI"} and _kind(tokens, behind + 1) in {*_ENDS, ""}:
            name = tokens[behind]
            found.append(Token("LPAR", "(", column=name.column))
            found.extend((name, Token("RPAR", ")", column=name.column), *power))
            position = behind + 1
    return found


def _power(tokens: list[Token], start: int) -> list[Token]:
    """The tokens of a power that is a whole number, 1 or more; sin⁻¹ is another function."""
    for form in _SQUARED:
        given = tokens[start : start + len(form)]
        number = next((token for token in given if token.type in {"NUMBER", "SUPERSCRIPT"}), None)
        if tuple(token.type for token in given) == form and number is not None:
            return given if number.isdecimal() and int(number) else []
    return []


def _kind(tokens: list[Token], position: int) -> str:
    return str(tokens[position].type) if position < len(tokens) else ""
