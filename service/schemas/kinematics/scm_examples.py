"""Chains that the examples of the SCM calls speak of."""

from __future__ import annotations

from typing import Any

STANFORD: dict[str, Any] = {
    "joints": [
        {"z": "L0", "a": "a1"},
        {"y": "L1", "b": "a2"},
        {"z": "d3"},
        {"a": "a4"},
        {"b": "a5"},
        {"z": "L2", "a": "a6"},
    ],
    "angle_unit": "deg",
}
LENGTHS = {"L0": 0.412, "L1": 0.154, "L2": 0.263}
SCARA: dict[str, Any] = {
    "joints": [
        [0, 0, "L0", "a1", 0, 0],
        ["L1", 0, 0, "-a2", 0, 0],
        [0, 0, "-d3", 0, 0, 0],
        ["L2", 0, 0, "-a4", 0, 0],
    ],
    "final": [0, 0, "-L3", 0, 0, "pi"],
}
