"""Units written behind a number, in the languages of the pages: 90 grados, 12 mm, 30 градусів."""

from __future__ import annotations

import re

from kinematics.cells.refusals import CellRefusal

_WORDS = """
m mm cm in rad grad degree degrees radian radians metre metres meter meters millimetre millimetres
millimeter millimeters centimetre centimetres centimeter centimeters inch inches
grado grados radián radianes metro metros milímetro milímetros centímetro centímetros pulgada pulgadas
degré degrés degre degres radiant radiants mètre mètres millimètre millimètres centimètre centimètres
pouce pouces grau graus radiano radianos polegada polegadas
grade radiani metru metri milimetru milimetri centimetru centimetri țol țoli inci inchi
градус градуси градусів градусах град радіан радіани радіанів рад метр метри метрів м міліметр міліметри
міліметрів мм сантиметр сантиметри сантиметрів см дюйм дюйми дюймів
"""
_SHORT = 3
"""Words of so few letters are units in lower case only: M and In are names."""
_UNITS = frozenset(_WORDS.split())
_NUMBER_AND_WORD = re.compile(
    r"(?<![\w.])(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?[ \u00a0\u202f]*([^\W\d_]+)(?![\w(])"
)


def unit_refusal(text: str) -> CellRefusal | None:
    """The refusal of the first unit behind a number, which is stated once for the table; or None."""
    for found in _NUMBER_AND_WORD.finditer(text):
        word = found[1]
        if word.lower() in _UNITS and (len(word) > _SHORT or word.islower()):
            return CellRefusal("unit_in_cell", column=found.start(1) + 1, name=word)
    return None
