"""PUMA 560 with symbolic lengths as SymPy and roboticstoolbox write it."""

from functools import cache
from typing import Any

import numpy as np


@cache
def joints() -> tuple[Any, ...]:
    """The joint variables q1 … q6."""
    import sympy

    symbols: tuple[Any, ...] = sympy.symbols("q1:7")
    return symbols


@cache
def unsimplified() -> Any:
    """The product A_1 ⋯ A_6 with exact twists, as SymPy forms it."""
    import sympy

    product = sympy.eye(4)
    for angle, (alpha, a, d) in zip(joints(), _cells(), strict=True):
        c, s, ca, sa = sympy.cos(angle), sympy.sin(angle), sympy.cos(alpha), sympy.sin(alpha)
        product *= sympy.Matrix(
            [[c, -s * ca, s * sa, a * c], [s, c * ca, -c * sa, a * s], [0, sa, ca, d], [0, 0, 0, 1]]
        )
    return product


def simplified() -> Any:
    """The same with every entry through `trigsimp`."""
    import sympy

    return unsimplified().applyfunc(sympy.trigsimp)


def by_toolbox() -> Any:
    """⁰T_6 by `ETS.fkine` of roboticstoolbox with SymPy symbols, as it returns it."""
    import roboticstoolbox as rtb
    import sympy

    ets = rtb.ETS()
    for joint, (alpha, a, d) in enumerate(_cells()):
        ets *= rtb.ET.Rz(jindex=joint) * rtb.ET.tz(d) * rtb.ET.tx(a) * rtb.ET.Rx(alpha)
    pose = ets.fkine(np.array(joints(), dtype=object))
    return sympy.Matrix(np.array(pose.A if hasattr(pose, "A") else pose))


def assert_agree(ours: list[Any], theirs: list[Any]) -> None:
    """Both are the same functions, at a few configurations."""
    import sympy

    names = sorted(set().union(*(entry.free_symbols for entry in ours)), key=str)
    for shift in (0.0, 0.7):
        point = {name: 0.31 + 0.17 * i + shift for i, name in enumerate(names)}
        for mine, other in zip(ours, theirs, strict=True):
            assert abs(sympy.N(mine.subs(point) - other.subs(point))) < 1e-9


def _cells() -> list[tuple[Any, Any, Any]]:
    import sympy

    a2, a3, d3, d4 = sympy.symbols("a2 a3 d3 d4")
    right = sympy.pi / 2
    return [(right, 0, 0), (0, a2, 0), (-right, a3, d3), (right, 0, d4), (-right, 0, 0), (0, 0, 0)]
