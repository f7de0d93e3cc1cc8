"""A second derivation of what the service answers: elementary motions multiplied one by one."""

import math
from typing import Any

import numpy as np

UNIT = {"deg": math.pi / 180, "rad": 1.0}


def turn(axis: str, angle: float) -> np.ndarray:
    i, j = {"x": (1, 2), "y": (2, 0), "z": (0, 1)}[axis]
    matrix = np.eye(4)
    matrix[i, i] = matrix[j, j] = math.cos(angle)
    matrix[j, i] = math.sin(angle)
    matrix[i, j] = -math.sin(angle)
    return matrix


def shift(axis: str, length: float) -> np.ndarray:
    matrix = np.eye(4)
    matrix["xyz".index(axis), 3] = length
    return matrix


def links(table: dict[str, Any], joints: list[float]) -> list[np.ndarray]:
    """Link transforms of a table whose rows state their joint and hold numbers, or the bare variable."""
    unit = UNIT[table.get("angle_unit", "rad")]
    values = iter(joints)
    found = []
    for row in table["rows"]:
        theta, d = (0.0 if isinstance(row[cell], str) else row[cell] for cell in ("theta", "d"))
        if row["joint"] == "revolute":
            theta += next(values)
        elif row["joint"] == "prismatic":
            d += next(values)
        z = turn("z", theta * unit) @ shift("z", d)
        x = shift("x", row["a"]) @ turn("x", row["alpha"] * unit)
        found.append(z @ x if table["convention"] == "standard" else x @ z)
    return found


def product(matrices: list[np.ndarray]) -> np.ndarray:
    total = np.eye(4)
    for matrix in matrices:
        total = total @ matrix
    return total
