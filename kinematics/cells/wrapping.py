r"""What a cell is wrapped in when it is pasted from a program: fonts, quotes, modules, braces, markup.

Formula editors put every name into braces, `{{\theta }_{1}}`, computer algebra writes
`Subscript[\[Theta], 1]`, and pages write `&theta;<sub>1</sub>`. All of it is taken away, and the text stays
as long as it was, so that columns remain those of what was typed.
"""

import re
from collections.abc import Callable
from html import unescape

from kinematics.cells.characters import GREEK, SUBSCRIPTS

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
_BRACED = re.compile(
    r"((?:^|[-+*/({\u2212])\s*)\{"
    rf"(\s*\\?[^\W\d_]+\s*(?=\}}(?![^\W\d_{''.join(SUBSCRIPTS)}]))"
    r"|\s*\\?[^\W\d_]+\s*_\s*(?:\w+|\{\s*\w+\s*\})\s*(?=\}(?![^\W_]))"
    r"|\s*[\d.]+\s*(?=\}\s*\^))\}"
)
"""A name, one with its index, or a number with a power, in braces of its own, as formula editors write it:
{\\theta}_1. A letter behind it is another name's, and a digit behind an index no part of that."""
_EMPTY_BRACES = re.compile(r"\{\s*\}(?=\s*\^)")
_DISPLAYED = re.compile(r"(\s*)\\\[(.*)\\\](\s*)", re.DOTALL)
_SWITCH = re.compile(r"\\(?:it|rm|bf|sf|mit|displaystyle|textstyle)(?![A-Za-z])")
_ANGLE = re.compile(r"(\\ang *\{)([^{};]*)\}")  # An angle in degrees as siunitx takes it: \ang{90}.
_ESCAPED_INDEX = re.compile(r"\\(_\w+)")
_ENTITY = re.compile(r"&(?:#[0-9]{1,6}|#x[0-9A-Fa-f]{1,5}|[A-Za-z]{2,8}[0-9]{0,2});")
_LOWERED = re.compile(r"<sub>\s*(\w+)\s*</sub>", re.IGNORECASE)
_ALGEBRA_LETTER = re.compile(r"\\\[(?:Curly|Script)?(Capital)?([A-Z][a-z]+)\]")
"""A letter, or the degree sign, in Mathematica: \\[Theta], \\[CapitalTheta], \\[Degree]."""
_ALGEBRA_INDEX = re.compile(r"(?<![^\W\d_])Subscript\[\s*([^\W\d_]+)\s*,\s*(\w+)\s*\]")
_ALGEBRA_CALL = re.compile(r"(?<![^\W_])((?:Arc)?(?:Sin|Cos)|Tan|Sqrt)\[([^\[\]]*)\]")
"""What Mathematica calls: Cos[q1]; its ArcTan takes x before y."""
_LETTERS = {name: letter for letter, name in GREEK.items()}


def without_wrapping(text: str) -> str:
    r"""Return a cell without it, as long as before: what was wrapped ends where the wrapping did.

    `\mathrm{L}_1` is `L_1`, and `10\,\mathrm{mm}` is 10 with a unit; an `=` counts at the beginning alone,
    quotes about the whole of it.
    """
    quoted = _QUOTED.fullmatch(text)
    if quoted:
        start, end = next(quoted.span(i) for i in range(2, 7) if quoted[i])
        text = " " * start + text[start:end] + " " * (len(text) - end)
    text = _without_markup(text)
    text = _MODULE.sub(lambda module: " " * len(module[0]), text)
    if _EQUALS.match(text):
        text = _EQUALS.sub(r"\1 ", text, count=1)
    text = _COUNTED.sub(r"\1_\2 ", text)
    if "[" in text:
        text = _from_within(_ALGEBRA_CALL, r"\1(\2)", text)
    text = _STAR_FIRST.sub(lambda star: f"{star[1]}{star[2]}".ljust(len(star[0])), text)
    if "{" in text:
        text = _EMPTY_BRACES.sub(lambda braces: " " * len(braces[0]), text)
        text = _from_within(_BRACED, r"\1  \2", text)
    return _SPACING.sub("  ", _from_within(_FONT, _unwrapped, text)) if "\\" in text else text


def _from_within(wrapped: re.Pattern[str], plain: str | Callable[[re.Match[str]], str], text: str) -> str:
    """Return a text without what may stand in itself, the innermost first."""
    before = ""
    while before != text:
        before, text = text, wrapped.sub(plain, text)
    return text


def _without_markup(text: str) -> str:
    if "&" in text:
        text = _ENTITY.sub(_character, text)
    if "<" in text:
        text = _LOWERED.sub(lambda lowered: f"_{lowered[1]}".ljust(len(lowered[0])), text)
    if "[" in text:
        text = _DISPLAYED.sub(lambda shown: f"{shown[1]}  {shown[2]}  {shown[3]}", text)
        text = _ALGEBRA_LETTER.sub(_letter, text)
        text = _ALGEBRA_INDEX.sub(lambda name: f"{name[1]}_{name[2]}".ljust(len(name[0])), text)
    if "\\" in text:
        text = _SWITCH.sub(lambda switch: " " * len(switch[0]), text)
        text = _ESCAPED_INDEX.sub(r"\1 ", text)
        text = _ANGLE.sub(lambda angle: f"{' ' * len(angle[1])}{angle[2]}°", text)
    return text


def _character(entity: re.Match[str]) -> str:
    """What an entity stands for: before what follows if it is a letter, else behind what it belongs to."""
    text = unescape(entity[0])
    if len(text) != 1:
        return entity[0]
    return text.rjust(len(entity[0])) if text in GREEK else text.ljust(len(entity[0]))


def _letter(found: re.Match[str]) -> str:
    capital, name = found.groups()
    if name == "Degree":
        return "°".ljust(len(found[0]))
    letter = _LETTERS.get(name if capital else name.lower())
    return letter.rjust(len(found[0])) if letter else found[0]


def _unwrapped(match: re.Match[str]) -> str:
    inner, width = match[1].strip(), len(match[0])
    if match.string[: match.start()].endswith(("_", "^")):
        return "{" + inner.rjust(width - 2) + "}"
    return inner.rjust(width)
