"""Whole answers to the model exercises, worked out here and not by the service."""

import math
from collections.abc import Mapping, Sequence
from functools import reduce

import numpy as np
import sympy as sp
from numpy.typing import NDArray

from tests.web.driving import PUMA, RX90, SCARA, Table

Matrix = Sequence[Sequence[str]]


def _symbol(text: str) -> sp.Expr:
    return sp.sympify(text.replace("θ", "q"), {name: sp.Symbol(name) for name in ("a2", "a3", "d3", "d4")})


def link(row: Mapping[str, str]) -> sp.Matrix:
    """Craig's modified link matrix, element by element."""
    alpha = sp.Rational(row["alpha"]) * sp.pi / 180
    a, d, theta = (_symbol(row[name]) for name in ("a", "d", "theta"))
    c, s, ca, sa = sp.cos(theta), sp.sin(theta), sp.cos(alpha), sp.sin(alpha)
    return sp.Matrix(
        [
            [c, -s, 0, a],
            [s * ca, c * ca, -sa, -sa * d],
            [s * sa, c * sa, ca, ca * d],
            [0, 0, 0, 1],
        ]
    )


def text(matrix: sp.Matrix) -> Matrix:
    return [[str(entry) for entry in matrix.row(i)] for i in range(4)]


def link_matrices(table: Table) -> list[Matrix]:
    return [text(link(row)) for row in table["rows"]]


def transform(table: Table) -> Matrix:
    """⁰T_N, the parallel axes 2 and 3 put together so that the entries stay short."""
    links = [link(row) for row in table["rows"]]
    inner = sp.trigsimp(sp.expand(links[1] * links[2]))
    wrist = reduce(lambda one, other: one * other, links[3:])
    return text(links[0] * (inner * wrist))


def pose(table: Table, values: Mapping[str, float], joints: Sequence[float]) -> Matrix:
    """⁰T_N in numbers; revolute joints in degrees."""
    total: NDArray[np.float64] = np.eye(4)
    for i, (row, q) in enumerate(zip(table["rows"], joints, strict=True), 1):
        angle = math.radians(q) if row["joint"] == "revolute" else q
        numbers = {sp.Symbol(f"q{i}"): angle, sp.Symbol(f"d{i}"): angle if row["joint"] == "prismatic" else 0}
        numbers |= {sp.Symbol(name): value for name, value in values.items()}
        total = total @ np.array(link(row).subs(numbers), dtype=np.float64)
    return [[f"{entry:.6f}" for entry in line] for line in total]


WRIST = ["intersecting_perpendicular", "intersecting_perpendicular"]
PUMA_VALUES = {"a2": 0.4318, "a3": 0.0203, "d3": 0.15005, "d4": 0.4318}
ANSWERS: dict[str, dict[str, object]] = {
    "puma560": {
        "table": PUMA,
        "schematic": (
            ["revolute"] * 6,
            ["intersecting_perpendicular", "parallel", "skew_perpendicular", *WRIST],
        ),
        "values": PUMA_VALUES,
        "joints": [30, 45, -60, 90, 45, -30],
        # The distance of wrist and shoulder, with upper arm and forearm in one line and folded.
        "radii": (
            math.hypot(0.15005, math.hypot(0.0203, 0.4318) - 0.4318),
            math.hypot(0.15005, math.hypot(0.0203, 0.4318) + 0.4318),
        ),
    },
    "scara": {
        "table": SCARA,
        "schematic": (
            ["revolute", "revolute", "prismatic", "revolute"],
            ["parallel", "parallel", "parallel"],
        ),
        "values": {"a2": 0.4, "a3": 0.3},
        "joints": [30, 60, 0.1, 45],
        "radii": (0.1, 0.7),
    },
    "rx90": {
        "table": RX90,
        "schematic": (
            ["revolute"] * 6,
            ["intersecting_perpendicular", "parallel", "intersecting_perpendicular", *WRIST],
        ),
        "values": {"D3": 0.45, "RL4": 0.45},
        "joints": [30, 45, -60, 90, 45, -30],
        "radii": (0.0, 0.9),
    },
}
