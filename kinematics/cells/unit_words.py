"""Units written behind a value, in the languages of the pages and in Russian: 90 grados, q1 градусів."""

import re

from kinematics.cells.characters import LOOKALIKES
from kinematics.cells.refusals import CellRefusal

_WORDS = """
kg nm newton newtons
m mm cm in rad grad degree degrees radian radians metre metres meter meters millimetre millimetres
millimeter millimeters centimetre centimetres centimeter centimeters inch inches
grado grados radián radianes metro metros milímetro milímetros centímetro centímetros pulgada pulgadas
degré degrés degre degres radiant radiants mètre mètres millimètre millimètres centimètre centimètres
pouce pouces grau graus radiano radianos polegada polegadas
grade radiani metru metri milimetru milimetri centimetru centimetri țol țoli inci inchi
градус градуса градуси градусів градусах град радіан радіана радіани радіанів рад метр метра метри метрів м
міліметр міліметра міліметри міліметрів мм сантиметр сантиметра сантиметри сантиметрів см дюйм дюйма дюйми
дюймів
градусов радиан радиана радианы радианов метры метров миллиметр миллиметра миллиметры миллиметров
сантиметры сантиметров дюймы дюймов
"""
_SYMBOLS = frozenset({"N", "g", "s", "J", "W", "Hz", "kN"})
"""Symbols of units that are names, too: a cell may hold them where they have a value."""
_ALSO_NAMES = {"m", "in", "м"}  # Units in lower case only: M and In are names.
_STOPPED = "deg."  # Without its full stop it is a degree sign.
_UNITS = frozenset(_WORDS.split())
_FOREIGN = frozenset("".join(_UNITS)).intersection(map(chr, range(0x400, 0x500))) - LOOKALIKES.keys()
_NUMBER = r"(?:\d++[.,]?\d*+|\.\d++)(?:[eE][+-]?\d++)?+"  # Never tried again with fewer digits.
_DECIMAL_COMMA = re.compile(r"(?<![\d.,])(\d+),(\d+)(?![\d.,])")
_VARIABLE = r"(?:[qθd]|theta)_?(?:\d+|[₀-₉]+)"
_VALUE_AND_WORD = re.compile(
    rf"(?<![\w.])(?:(?:{_NUMBER} *)?(?:pi|π|[пП][іи]?|{_VARIABLE})[ \u00a0\u202f]+"
    rf"|{_NUMBER}[ \u00a0\u202f]*)"
    r"((?:de )?([^\W\d_]+)(?:\.(?!\d))?)(?![\w(])"
)


_BRACKETED = re.compile(
    rf"(?:(?<![\w.]){_NUMBER}|pi|π|[^\W\d]_?(?:\d+|[₀-₉]+))[ \u00a0\u202f]*"
    r"([(\[] *([^\W\d_]+)\.? *[)\]])(?!\w)"
)
"""The same in brackets: d3 (m), 90 [deg]."""


def unit_refusal(text: str) -> CellRefusal | None:
    """Return the refusal of the first unit behind a value, with the cell as it is without any; or None."""
    units = [
        found
        for found in _VALUE_AND_WORD.finditer(text)
        if _is_unit(found[2]) or found[1].lower() == _STOPPED
    ]
    units += [found for found in _BRACKETED.finditer(text) if _is_unit(found[2]) or found[2] == "deg"]
    units.sort(key=lambda found: found.start(1))
    if not units:
        return None
    rest = text
    for found in reversed(units):
        rest = rest[: found.start(1)].rstrip() + rest[found.end(1) :]
    rest = _DECIMAL_COMMA.sub(r"\1.\2", rest)
    return CellRefusal(
        "unit_in_cell", column=units[0].start(1) + 1, name=units[0][2], suggestion=rest.strip()
    )


def is_symbol_of_unit(name: str) -> bool:
    """Return whether a name that has no meaning is likely to be a unit: the N of 10 N, the m of a2 m."""
    return name in _SYMBOLS or _is_unit(name)


def _is_unit(word: str) -> bool:
    """Return whether a word is a unit, or the beginning of one in letters that are in no name: 90 гра.

    A page reads cells while they are typed; letters that look like Latin ones may be meant as these.
    """
    lower = word.lower()
    if lower in _UNITS:
        return lower not in _ALSO_NAMES or word.islower()
    return not _FOREIGN.isdisjoint(lower) and any(unit.startswith(lower) for unit in _UNITS)
