"""What a cell is wrapped in when it is pasted: quotes, a spreadsheet's =, modules, the fonts of LaTeX."""

from __future__ import annotations

import re

_EQUALS = re.compile(r"(\s*)=(?=\s*\S)")
_FONT = re.compile(
    r"\\(?:math(?:rm|it|bf|sf|normal)|boldsymbol|operatorname|text(?:rm|it|bf|sf|normal)?) *"
    r"\{((?:[^{}]|\{[^{}]*\})*)\}"
)
_QUOTED = re.compile(r"""(\s*)(?:"([^"]+)"|'([^']+)'|`([^`]+)`|[“„]([^“”„]+)[“”]|‘([^‘’]+)’)(\s*)""")
_MODULE = re.compile(r"(?<![\w.\\])(?:np|numpy|math|Math|sp|sympy)\.(?=[A-Za-z])", re.ASCII)
_SPACING = re.compile(r"\\[,;: ]")


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
