"""Closed forms beside SymPy and roboticstoolbox: time, operations, and what they are worth as an oracle."""

from __future__ import annotations

import os
import random
import time
from collections.abc import Callable
from itertools import chain
from typing import Any

import numpy as np

from bench import Better, Outcome, measured

TITLE = "Closed forms"
ABOUT = """
PUMA 560 with the lengths a2, a3, d3, d4 as symbols, unless the row says otherwise. SymPy: the product of its
elementary matrices (twists exact), every entry through `trigsimp`; `ETS.fkine` of roboticstoolbox with SymPy
symbols, as it returns it. Both are timed once, for they take seconds. Operations are counted by SymPy's
`count_ops` over the twelve entries, ours read from the infix text. Rows beside a bar of milliseconds
have the bar as their peer. The random tables have seven rows and general numeric twists; the oracle is held
against pairs that were made equal by identities, or unequal by one change (tests/kinematics/symbolic).
"""

SYMPY, TOOLBOX = "SymPy product + `trigsimp`", "roboticstoolbox `ETS.fkine`"
TABLES = int(os.environ.get("FRAMEWISE_TABLES", "1000"))
PAIRS = int(os.environ.get("FRAMEWISE_PAIRS", "10000"))
_FAST = 15


def rows() -> list[Outcome]:
    """Measure."""
    return [*_transform(), *_jacobian(), *_catalogue(), *_random_tables(), *_oracle(), *_proof()]


def _transform() -> list[Outcome]:
    import sympy

    from kinematics.printing import Format, MatrixPrinter, Notation, Purpose
    from kinematics.symbolic.closed_form import MatrixWriter
    from kinematics.symbolic.motions import motions_of
    from kinematics.table import Convention
    from tests.kinematics.symbolic.tables import PUMA_LENGTHS, puma

    table = puma(Convention.STANDARD)
    purpose = Purpose(name="T_0_6", meaning="The pose.")

    def ours() -> dict[str, Any]:
        matrix = MatrixWriter().matrix(chain.from_iterable(motions_of(table)))
        printer = MatrixPrinter(n_joints=6, parameters=PUMA_LENGTHS, notation=Notation.SHORT)
        return printer.write(matrix, (Format.LATEX,), purpose)

    seconds = _median(ours)
    matrix = MatrixWriter().matrix(chain.from_iterable(motions_of(table)))
    printer = MatrixPrinter(n_joints=6, parameters=PUMA_LENGTHS)
    text = printer.write(matrix, (Format.TEXT,), purpose)["text"]
    entries = [sympy.sympify(entry) for row in text[:3] for entry in row]
    product, product_seconds = _timed(_sympy_puma)
    toolbox, toolbox_seconds = _timed(_toolbox_puma)
    toolbox = [sympy.nsimplify(entry) for entry in toolbox]  # without the factors 1.0 that it leaves
    for theirs in (product, toolbox):
        _agree(entries, theirs)
    operations = sum(map(sympy.count_ops, entries))
    outcomes: list[Outcome] = [
        measured(
            "⁰T_6 and its LaTeX",
            peer="a bar of 2 ms",
            ours=seconds,
            theirs=2e-3,
            unit="s",
            better=Better.LESS,
            bar=1,
        )
    ]
    for peer, theirs, taken in ((SYMPY, product, product_seconds), (TOOLBOX, toolbox, toolbox_seconds)):
        counted = sum(map(sympy.count_ops, theirs))
        outcomes += [
            measured(
                "⁰T_6 and its LaTeX",
                peer=peer,
                ours=seconds,
                theirs=taken,
                unit="s",
                better=Better.LESS,
                bar=1000,
            ),
            measured(
                "operations in ⁰T_6",
                peer=peer,
                ours=operations,
                theirs=counted,
                unit="operations",
                better=Better.LESS,
                bar=1,
            ),
        ]
    outcomes.append(
        measured(
            "operations in ⁰T_6",
            peer="a bar of 265",
            ours=operations,
            theirs=265,
            unit="operations",
            better=Better.LESS,
            bar=1,
        )
    )
    return outcomes


def _jacobian() -> list[Outcome]:
    import sympy

    from kinematics.jacobian import JacobianFrame
    from kinematics.symbolic import jacobian
    from kinematics.table import Convention
    from tests.kinematics.symbolic.tables import puma

    table = puma(Convention.STANDARD)
    q = _joints()
    position = _unsimplified()[:3, 3]

    def theirs() -> sympy.Matrix:
        return position.jacobian(q).applyfunc(sympy.trigsimp)

    _, taken = _timed(theirs)
    outcomes: list[Outcome] = []
    for name, frame in (("J0", JacobianFrame.BASE), ("Jn", JacobianFrame.END)):
        seconds = _median(lambda frame=frame: jacobian(table, frame))
        outcomes.append(
            measured(
                f"symbolic {name}, 6×6",
                peer="a bar of 5 ms",
                ours=seconds,
                theirs=5e-3,
                unit="s",
                better=Better.LESS,
                bar=1,
            )
        )
        if name == "J0":
            outcomes.append(
                measured(
                    f"symbolic {name}, 6×6",
                    peer="SymPy derivative (3×6) + `trigsimp`",
                    ours=seconds,
                    theirs=taken,
                    unit="s",
                    better=Better.LESS,
                    bar=200,
                )
            )
    return outcomes


def _catalogue() -> list[Outcome]:
    from kinematics.catalogue import robots
    from kinematics.printing import Format, MatrixPrinter, Notation, Purpose
    from kinematics.symbolic import closed_form
    from kinematics.table import table_parameters

    worst: dict[str, tuple[float, str]] = {"⁰T_N": (0.0, ""), "every matrix": (0.0, "")}
    for robot in robots():
        table = robot.table.table

        def written(table: Any = table, *, everything: bool) -> None:
            form = closed_form(table)
            printer = MatrixPrinter(
                n_joints=table.n_joints, parameters=table_parameters(table), notation=Notation.SHORT
            )
            matrices = (form.transform, *form.links, *form.frames[:-1]) if everything else (form.transform,)
            for matrix in matrices:
                printer.write(matrix, Format, Purpose(name="f", meaning="A matrix."))

        for name, everything in (("⁰T_N", False), ("every matrix", True)):
            seconds = _median(lambda everything=everything: written(everything=everything))
            worst[name] = max(worst[name], (seconds, robot.id))
    return [
        measured(
            f"{name} of a catalogue robot in all nine formats; the slowest is {worst[name][1]}",
            peer="a bar of 20 ms",
            ours=worst[name][0],
            theirs=20e-3,
            unit="s",
            better=Better.LESS,
            bar=1 if name == "⁰T_N" else None,
        )
        for name in worst
    ]


def _random_tables() -> list[Outcome]:
    import sympy

    from kinematics.printing import Format, MatrixPrinter, Purpose
    from kinematics.symbolic import closed_form
    from tests.kinematics.symbolic.tables import general_table, sympy_product

    q = sympy.symbols("q1:8")
    printer = MatrixPrinter(n_joints=7, parameters=())
    purpose = Purpose(name="pose", meaning="The pose.")
    agreeing, slowest = 0, 0.0
    for seed in range(TABLES):
        table = general_table(random.Random(seed))
        start = time.perf_counter()
        written = printer.write(closed_form(table).transform, (Format.NUMPY, Format.LATEX), purpose)
        slowest = max(slowest, time.perf_counter() - start)
        scope: dict[str, Any] = {}
        exec(written["numpy"], scope)
        joints = np.random.default_rng(seed).uniform(-np.pi, np.pi, (100, 7))
        product = sympy.lambdify([q], sympy_product(table, q), "numpy", cse=True)
        theirs = np.array([product(configuration) for configuration in joints], dtype=float)
        agreeing += bool(np.abs(scope["pose"](joints) - theirs).max() <= 1e-12)
    return [
        measured(
            f"{TABLES} random tables of 7 general rows that agree with SymPy to 1e-12 at 100 configurations",
            peer="all of them",
            ours=agreeing,
            theirs=TABLES,
            unit="tables",
            better=Better.MORE,
            bar=1,
        ),
        measured(
            "the slowest of them, closed form with LaTeX and NumPy",
            peer="a bar of 50 ms",
            ours=slowest,
            theirs=50e-3,
            unit="s",
            better=Better.LESS,
            bar=1,
        ),
    ]


def _oracle() -> list[Outcome]:
    from kinematics.symbolic import Verdict, compare
    from tests.kinematics.symbolic.rewriting import changed, random_expression, rewritten

    right = {"equal": 0, "unequal": 0}
    for seed in range(PAIRS):
        rng = random.Random(seed)
        first = random_expression(rng)
        right["equal"] += compare(first, rewritten(first, rng, rng.randrange(1, 9))) is Verdict.PROVED
        rng = random.Random(-1 - seed)
        first = random_expression(rng)
        other = changed(rewritten(first, rng, rng.randrange(0, 6)), rng)
        right["unequal"] += compare(first, other) is not Verdict.PROVED
    return [
        measured(
            f"{PAIRS} pairs made {kind}, decided rightly",
            peer="all of them",
            ours=count,
            theirs=PAIRS,
            unit="pairs",
            better=Better.MORE,
            bar=1,
        )
        for kind, count in right.items()
    ]


def _proof() -> list[Outcome]:
    import sympy
    from sympy.core.cache import clear_cache

    from kinematics.expressions import ZERO
    from kinematics.symbolic import prove_identity
    from kinematics.table import Convention
    from tests.kinematics.symbolic.tables import other_convention, puma

    table = puma(Convention.STANDARD)
    other = other_convention(table)
    simplified = _sympy_puma_matrix()

    def ours() -> None:
        proof = prove_identity(table, other, signs=(1,) * 6, offsets=(ZERO,) * 6)
        assert proof.verdict.value == "proved"

    def theirs() -> None:
        clear_cache()
        difference = _unsimplified() - simplified
        expanded = difference.applyfunc(lambda entry: sympy.expand(sympy.expand_trig(entry)))
        assert expanded.applyfunc(sympy.trigsimp) == sympy.zeros(4, 4)

    _, taken = _timed(theirs)
    return [
        measured(
            "exact proof that two tables are one robot (PUMA 560, standard and modified)",
            peer="SymPy `expand`, `expand_trig`, `trigsimp` of a difference",
            ours=_median(ours),
            theirs=taken,
            unit="s",
            better=Better.LESS,
        )
    ]


def _median(function: Callable[[], object]) -> float:
    function()
    samples = []
    for _ in range(_FAST):
        start = time.perf_counter()
        function()
        samples.append(time.perf_counter() - start)
    return sorted(samples)[_FAST // 2]


def _timed(function: Callable[[], Any]) -> tuple[Any, float]:
    start = time.perf_counter()
    result = function()
    return result, time.perf_counter() - start


def _joints() -> tuple[Any, ...]:
    import sympy

    joints: tuple[Any, ...] = sympy.symbols("q1:7")
    return joints


def _unsimplified() -> Any:
    """The product A_1 ⋯ A_6 with exact twists, as SymPy forms it."""
    import sympy

    a2, a3, d3, d4 = sympy.symbols("a2 a3 d3 d4")
    right = sympy.pi / 2
    cells = [(right, 0, 0), (0, a2, 0), (-right, a3, d3), (right, 0, d4), (-right, 0, 0), (0, 0, 0)]
    product = sympy.eye(4)
    for angle, (alpha, a, d) in zip(_joints(), cells, strict=True):
        c, s, ca, sa = sympy.cos(angle), sympy.sin(angle), sympy.cos(alpha), sympy.sin(alpha)
        product *= sympy.Matrix(
            [[c, -s * ca, s * sa, a * c], [s, c * ca, -c * sa, a * s], [0, sa, ca, d], [0, 0, 0, 1]]
        )
    return product


def _sympy_puma_matrix() -> Any:
    import sympy

    return _unsimplified().applyfunc(sympy.trigsimp)


def _sympy_puma() -> list[Any]:
    return list(_sympy_puma_matrix()[:3, :])


def _toolbox_puma() -> list[Any]:
    import roboticstoolbox as rtb
    import sympy

    a2, a3, d3, d4 = sympy.symbols("a2 a3 d3 d4")
    right = sympy.pi / 2
    cells = [(right, 0, 0), (0, a2, 0), (-right, a3, d3), (right, 0, d4), (-right, 0, 0), (0, 0, 0)]
    ets = rtb.ETS()
    for joint, (alpha, a, d) in enumerate(cells):
        ets *= rtb.ET.Rz(jindex=joint) * rtb.ET.tz(d) * rtb.ET.tx(a) * rtb.ET.Rx(alpha)
    pose = ets.fkine(np.array(_joints(), dtype=object))
    matrix = sympy.Matrix(np.array(pose.A if hasattr(pose, "A") else pose))
    return list(matrix[:3, :])


def _agree(ours: list[Any], theirs: list[Any]) -> None:
    """Both are the same function, at a few configurations."""
    import sympy

    names = sorted(set().union(*(entry.free_symbols for entry in ours)), key=str)
    for shift in (0.0, 0.7):
        point = {name: 0.31 + 0.17 * i + shift for i, name in enumerate(names)}
        for mine, other in zip(ours, theirs, strict=True):
            assert abs(sympy.N(mine.subs(point) - other.subs(point))) < 1e-9
