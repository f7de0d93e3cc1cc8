"""Closed forms beside SymPy and roboticstoolbox: time, operations, and what they are worth as an oracle."""

import gc
import os
import time
from collections.abc import Callable
from typing import Any

from bench import Better, Outcome, measured, sympy_puma
from bench.symbolic_oracles import pairs, random_tables

TITLE = "Closed forms"
ABOUT = """
PUMA 560 with the lengths a2, a3, d3, d4 as symbols, unless the row says otherwise. SymPy: the product of its
elementary matrices (twists exact), every entry through `trigsimp`; `ETS.fkine` of roboticstoolbox with SymPy
symbols, as it returns it. Both are timed once, for they take seconds. Operations are counted by SymPy's
`count_ops` over the twelve entries, ours read from the infix text. Rows beside a bar of milliseconds
have the bar as their peer. The random tables have seven rows and general numeric twists; SymPy's product is
evaluated link by link. The oracle is held against pairs made equal by identities (addition theorems, double
and triple angles, products to sums, Pythagoras, surds) and against pairs with one number, sign, function or
symbol changed, by as little as 10⁻¹⁵; mpmath at sixty digits judges both (tests/kinematics/symbolic).
FRAMEWISE_PAIRS and FRAMEWISE_TABLES set how many there are.

Code is printed by SymPy, in a worker process, and only where it is asked for; the bars of 20 and 50 ms are of
what is written without it.
"""

SYMPY, TOOLBOX = "SymPy product + `trigsimp`", "roboticstoolbox `ETS.fkine`"
TABLES = int(os.environ.get("FRAMEWISE_TABLES", "1000"))
PAIRS = int(os.environ.get("FRAMEWISE_PAIRS", "10000"))
_FAST = 15


def rows() -> list[Outcome]:
    """Measure."""
    return [*_transform(), *_jacobian(), *_catalogue(), *_proof(), *random_tables(TABLES), *pairs(PAIRS)]


def _transform() -> list[Outcome]:
    import sympy

    from kinematics.printing import Format, MatrixPrinter, Notation, Purpose
    from kinematics.symbolic import Workings
    from kinematics.table import Convention
    from tests.kinematics.symbolic.tables import PUMA_LENGTHS, puma

    table = puma(Convention.STANDARD)
    purpose = Purpose(name="T_0_6", meaning="The pose.")

    def ours() -> dict[str, Any]:
        matrix = Workings(table).transform
        printer = MatrixPrinter(n_joints=6, parameters=PUMA_LENGTHS, notation=Notation.SHORT)
        return printer.write(matrix, (Format.LATEX,), purpose)

    seconds = _median(ours)
    matrix = Workings(table).transform
    printer = MatrixPrinter(n_joints=6, parameters=PUMA_LENGTHS)
    text = printer.write(matrix, (Format.TEXT,), purpose)["text"]
    entries = [sympy.sympify(entry) for row in text[:3] for entry in row]
    product, product_seconds = _timed(sympy_puma.simplified)
    toolbox, toolbox_seconds = _timed(sympy_puma.by_toolbox)
    product = list(product[:3, :])
    toolbox = [sympy.nsimplify(entry) for entry in toolbox[:3, :]]  # without the factors 1.0 that it leaves
    for theirs in (product, toolbox):
        sympy_puma.assert_agree(entries, theirs)
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
    position = sympy_puma.unsimplified()[:3, 3]

    def theirs() -> sympy.Matrix:
        return position.jacobian(sympy_puma.joints()).applyfunc(sympy.trigsimp)

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
    from kinematics.printing import SOURCES, Format, Notation
    from service.wire.kinematics.symbolic_forms import FormPart, SymbolicTask, written_answer

    measures = {"⁰T_N": (FormPart.TRANSFORM,), "links, frames, ⁰T_N, its inverse, J0, Jn": tuple(FormPart)}
    typeset = tuple(form for form in Format if form not in SOURCES)

    def slowest(parts: tuple[FormPart, ...], formats: tuple[Format, ...]) -> tuple[float, str]:
        tasks = {
            robot.id: SymbolicTask(
                table=robot.table.table, parts=parts, formats=formats, notation=Notation.SHORT, head={}
            )
            for robot in robots()
        }
        return max((_median(lambda task=task: written_answer(task)), name) for name, task in tasks.items())

    outcomes: list[Outcome] = []
    for name, parts in measures.items():
        seconds, robot = slowest(parts, typeset)
        outcomes.append(
            measured(
                f"{name} of a catalogue robot as LaTeX, MathML, text, trees, entries; the slowest is {robot}",
                peer="a bar of 20 ms",
                ours=seconds,
                theirs=20e-3,
                unit="s",
                better=Better.LESS,
                bar=1,
            )
        )
        in_all, robot = slowest(parts, tuple(Format))
        outcomes.append(
            measured(
                f"the same with code in {len(SOURCES)} languages by SymPy's printers; the slowest is {robot}",
                peer="without code",
                ours=in_all,
                theirs=seconds,
                unit="s",
                better=Better.LESS,
            )
        )
    return outcomes


def _proof() -> list[Outcome]:
    import sympy
    from sympy.core.cache import clear_cache

    from kinematics.expressions import ZERO
    from kinematics.symbolic import prove_identity
    from kinematics.table import Convention
    from tests.kinematics.symbolic.tables import other_convention, puma

    table = puma(Convention.STANDARD)
    other = other_convention(table)
    simplified = sympy_puma.simplified()

    def ours() -> None:
        proof = prove_identity(table, other, signs=(1,) * 6, offsets=(ZERO,) * 6)
        assert proof.verdict.value == "proved"

    def theirs() -> None:
        clear_cache()
        difference = sympy_puma.unsimplified() - simplified
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
    gc.collect()
    gc.disable()
    for _ in range(_FAST):
        start = time.perf_counter()
        function()
        samples.append(time.perf_counter() - start)
    gc.enable()
    return sorted(samples)[_FAST // 2]


def _timed(function: Callable[[], Any]) -> tuple[Any, float]:
    start = time.perf_counter()
    result = function()
    return result, time.perf_counter() - start
