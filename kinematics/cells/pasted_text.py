"""What a pasted cell comes in (quotes, fonts, prefixes of modules), and other spellings of an index.

Each is written over where it stands, so that every character that is left keeps its column.
"""

import re

_QUOTED = re.compile(r"""(\s*)(?:"([^"]+)"|'([^']+)'|`([^`]+)`|[“„]([^“”„]+)[“”]|‘([^‘’]+)’)(\s*)""")
_FONT = re.compile(
    r"\\(?:math(?:rm|it|bf|sf|normal)|boldsymbol|operatorname|text(?:rm|it|bf|sf|normal)?) *"
    r"\{((?:[^{}]|\{[^{}]*\})*)\}"
)
_SPACING = re.compile(r"\\[,;: ]")
_MODULE = re.compile(r"(?<![\w.\\])(?:np|numpy|math|Math|sp|sympy)\.(?=[A-Za-z])", re.ASCII)
_EQUALS = re.compile(r"\A(\s*)=(?=\s*\S)")
_COUNTED = re.compile(r"(?<![^\W_])(\\?(?:var)?[Tt]heta|[^\W\d_])\[([0-9]{1,4})\]")
"""What computer algebra writes for an index: theta[1]."""
_STAR_FIRST = re.compile(
    r"(?<![^\W_])(\\?(?:var)?[Tt]heta|[θΘϑqQd])(?:\^ *)?(?:[*\u2217\u22c6]|\{ *(?:\*|\\ast) *\}|\\ast *)"
    r"(_(?:[0-9]+|\{ *[0-9]+ *\})|[₀-₉]+)"
)
"""The mark of a joint variable before its index: q^*_1."""
_BRACED = re.compile(r"((?:^|[-+*/(\u2212])\s*)\{(\s*\\?[^\W\d_]+\s*(?:_(?:\w+|\{\w+\}))?)\}")
"""A name in braces of its own, as formula editors write it: {\\theta}_1."""


def _plain(match: re.Match[str]) -> str:
    """What is meant, the groups of a match, and spaces up to where the match ended."""
    return "".join(match.groups()).ljust(len(match[0]))


_SPELLINGS = (
    (".", _MODULE, _plain),
    ("=", _EQUALS, _plain),
    ("[", _COUNTED, r"\1_\2 "),
    ("", _STAR_FIRST, _plain),
    ("{", _BRACED, r"\1  \2"),
)
"""A character without which there is none of a kind, the kind, and what stands for it; in this order."""


def without_wrapping(text: str) -> str:
    r"""Return a cell without it, as long as before: what was wrapped ends where the wrapping did.

    `\mathrm{L}_1` is `L_1`, and `10\,\mathrm{mm}` is 10 with a unit; an `=` counts at the beginning alone,
    quotes about the whole of it.
    """
    quoted = _QUOTED.fullmatch(text)
    if quoted:
        start, end = next(quoted.span(i) for i in range(2, 7) if quoted[i])
        text = " " * start + text[start:end] + " " * (len(text) - end)
    for sign, spelling, plain in _SPELLINGS:
        if sign in text:
            text = spelling.sub(plain, text)
    if "\\" not in text:
        return text
    before, bare = "", text
    while before != bare:
        before, bare = bare, _FONT.sub(_unwrapped, bare)
    return bare if bare == text else _SPACING.sub("  ", bare)


def _unwrapped(match: re.Match[str]) -> str:
    inner, width = match[1].strip(), len(match[0])
    if match.string[: match.start()].endswith(("_", "^")):
        return "{" + inner.rjust(width - 2) + "}"
    return inner.rjust(width)
