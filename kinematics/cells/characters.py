"""The characters of a cell: what pasted text is translated to, and what is refused.

Text copied from a PDF, a word processor or a spreadsheet holds typographic minus signs, thin spaces, ring
signs for degrees. `translated` maps each of them to the one character that means it, one for one, so that
columns stay those of the text as typed.
"""

import re
import unicodedata

from kinematics.cells.refusals import CellRefusal

_TRANSLATED = {
    **dict.fromkeys(
        "\t\n\r\u00a0\u2002\u2003\u2004\u2005\u2006\u2007\u2008\u2009\u200a\u202f\u205f\u3000", " "
    ),
    **dict.fromkeys("\u2212\u2010\u2011\u2012\u2013\u2014\ufe63", "-"),
    **dict.fromkeys("\u00d7\u00b7\u22c5\u2219\u2022\u2217\u22c6", "*"),
    **dict.fromkeys("\u00f7\u2215\u2044", "/"),
    **dict.fromkeys("\u00ba\u02da\u25e6\u2218", "°"),
    "\u03c2": "σ",
    "\u03d1": "θ",
    "\u03d5": "φ",
    "\u03f5": "ε",
    "\u03f1": "ρ",
    "\u03f0": "κ",
    "\u00b5": "μ",
    **dict.fromkeys("\u0472\u0473\u04e8\u04e9", "θ"),
    **dict.fromkeys("\u03d6\u1d28\u220f", "π"),
    "\u2113": "l",
    "\u2126": "Ω",
    "\u207b": "⁻",
    "\u208b": "₋",
}

_GREEK_NAMES = (
    "alpha beta gamma delta epsilon zeta eta theta iota kappa lambda mu "
    "nu xi omicron pi rho sigma tau upsilon phi chi psi omega"
)
GREEK = dict(
    zip(
        "αβγδεζηθικλμνξοπρστυφχψωΑΒΓΔΕΖΗΘΙΚΛΜΝΞΟΠΡΣΤΥΦΧΨΩ",
        f"{_GREEK_NAMES} {_GREEK_NAMES.title()}".split(),
        strict=True,
    )
)
"""Greek letters and the names that they are spelled with."""

SUPERSCRIPTS = {"⁰": "0", "¹": "1", "²": "2", "³": "3"} | {chr(0x2070 + n): str(n) for n in range(4, 10)}
SUPERSCRIPT_MINUS = "⁻"
SUBSCRIPTS = {chr(0x2080 + n): str(n) for n in range(10)} | dict(
    zip("ₐₑₒₓₕₖₗₘₙₚₛₜᵢⱼᵣᵤᵥ", "aeoxhklmnpstijruv", strict=True)
)

VULGAR_FRACTIONS = {
    character: (top, bottom)
    for character in "½⅓⅔¼¾⅕⅖⅗⅘⅙⅚⅛⅜⅝⅞"
    for top, bottom in [unicodedata.normalize("NFKC", character).split("\u2044")]
}

_MATHEMATICAL_LETTERS = range(0x1D400, 0x1D800)
_FULL_WIDTH = range(0xFF01, 0xFF5F)
DOT_ABOVE = "\u0307"
LOOKALIKES = dict(zip("АВЕКМНОРСТХаеорсухіІјЈѕЅԁԛһԚ", "ABEKMHOPCTXaeopcyxiIjJsSdqhQ", strict=True))
_ALLOWED = re.compile(
    "[A-Za-z0-9+\\-*/^()._, {}$\\\\°√;:!|"
    + DOT_ABOVE
    + "".join(GREEK)
    + "".join(SUPERSCRIPTS)
    + "⁻"
    + "".join(VULGAR_FRACTIONS)
    + "".join(SUBSCRIPTS)
    + "]*"
)

_CYRILLIC_PI = re.compile("(?<![^\\W\\d_])[пП](?![^\\W_])")
_CYRILLIC_WORD = re.compile("(?<![^\\W\\d_])[пП][іи](?![^\\W_])")
"""π as it is written on a keyboard without Greek letters: п/2, пі/2."""

_RAISED_POINT = re.compile("(?<![\\w.,])0[\u00b7\u22c5\u2219\u2022] *[0-9]+")

_LOST_POWER = re.compile(r"(?<![\w.^*])([0-9.]+) *\* *10([+-]) *([0-9]{1,2})(?![0-9A-Za-z_.(^*/°])")
"""A power of ten from a PDF that raises nothing: 4×10-1 may be 4×10⁻¹."""
_MINUTES = re.compile(
    "(?<![\\w.,])([0-9]{1,4})[°\u00ba\u02da] *([0-5]?[0-9](?:\\.[0-9]{1,6})?) *(?:'(?!')|[\u2032\u2019])"
    " *(?:([0-5]?[0-9](?:\\.[0-9]{1,6})?) *(?:\"|''|[\u2033\u201d]))?"
)
_ABOUT = re.compile(" *([~\u2248\u2243\u2245\u223c])(?= *[^ ])")


def translated(text: str) -> str:
    """Return the text in the characters that the scanner knows, as many as before.

    Raises:
        CellRefusal: a character has no meaning in a cell; the first such one, with its column. An angle in
            degrees and minutes is told in decimals, a number behind ≈ without it.
    """
    raised = _RAISED_POINT.search(text)
    if raised:  # half of something by hand, and no product that anybody writes
        text = raised.group().replace(" ", "")
        raise CellRefusal("number_malformed", column=raised.start() + 1, text=text)
    if minutes := _MINUTES.search(text):
        degrees, *parts = (float(part or 0) for part in minutes.groups())
        decimal = degrees + parts[0] / 60 + parts[1] / 3600
        raise CellRefusal(
            "minutes_in_cell",
            column=minutes.start() + 1,
            text=minutes.group().strip(),
            suggestion=f"{decimal:.10g}°",
        )
    if about := _ABOUT.match(text):
        column, character = about.start(1) + 1, about.group(1)
        rest = text[about.end() :].strip()
        raise CellRefusal("about_in_cell", column=column, character=character, suggestion=rest)
    text = _CYRILLIC_WORD.sub("pi", _CYRILLIC_PI.sub("π", text))
    plain = "".join(_TRANSLATED.get(character, character) for character in text)
    if any(ord(character) >= _MATHEMATICAL_LETTERS.start for character in plain):
        plain = "".join(
            unicodedata.normalize("NFKC", character) if ord(character) in _MATHEMATICAL_LETTERS else character
            for character in plain
        )
        plain = "".join(_TRANSLATED.get(character, character) for character in plain)
    match = _ALLOWED.match(plain)
    reached = match.end() if match else 0
    if reached < len(plain):
        raise _refusal(plain[reached], reached + 1)
    _refuse_lost_power(plain)
    return plain


def _refuse_lost_power(plain: str) -> None:
    if lost := _LOST_POWER.search(plain):
        number, sign, power = lost.groups()
        raise CellRefusal(
            "exponent_ambiguous",
            column=lost.start() + 1,
            text=lost.group().replace(" ", ""),
            number=f"{number}e{sign}{power}",
            difference=f"{number}*10 {sign} {power}",
        )


def _refusal(character: str, column: int) -> CellRefusal:
    code_point = f"U+{ord(character):04X}"
    if character in LOOKALIKES:
        return CellRefusal(
            "character_lookalike", column=column, character=code_point, latin=LOOKALIKES[character]
        )
    if ord(character) in _FULL_WIDTH:
        latin = unicodedata.normalize("NFKC", character)
        return CellRefusal("character_full_width", column=column, character=code_point, latin=latin)
    if unicodedata.category(character) in {"Cc", "Cf", "Cs", "Co", "Cn", "Zl", "Zp", "Mn", "Me"}:
        return CellRefusal("character_invisible", column=column, character=code_point)
    return CellRefusal("character_not_allowed", column=column, character=f"{character} ({code_point})")
