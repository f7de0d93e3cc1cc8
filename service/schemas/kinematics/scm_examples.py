"""Requests to the SCM calls that the OpenAPI document shows; a test sends every one of them."""

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

FORWARD_KINEMATICS: dict[str, Any] = {
    "Stanford arm in numbers": {
        "chain": STANFORD,
        "parameters": LENGTHS,
        "joints": [30, 60, 0.5, 0, 45, 90],
    },
    "SCARA in closed form": {"chain": SCARA, "formats": ["text", "latex"]},
    "a robot of the catalogue": {"robot": "kr125", "joints": [0, -90, 90, 0, 45, 0]},
}
INVERSE_TRANSFORM: dict[str, Any] = {
    "SCARA in closed form": {"chain": SCARA, "formats": ["text"], "notation": "full"},
    "a robot of the catalogue": {"robot": "uw", "joints": [10, 20, 30]},
}
JACOBIAN: dict[str, Any] = {
    "Stanford arm by inspection": {
        "chain": STANFORD,
        "parameters": LENGTHS,
        "joints": [30, 60, 0.5, 0, 45, 90],
    },
    "two links by differentiation": {"robot": "twolink", "joints": [20, 40], "method": "differentiation"},
    "two links in closed form": {"robot": "twolink", "formats": ["text"]},
}
INVERSE_KINEMATICS: dict[str, Any] = {
    "two links": {"robot": "twolink", "target": [1, 1, 0, 90, 0, 0]},
    "PUMA 560 near given joints": {
        "robot": "puma560",
        "target": [[1, 0, 0, 0.4], [0, 1, 0, -0.15005], [0, 0, 1, 0.3], [0, 0, 0, 1]],
        "start": [0, 45, -90, 0, 0, 0],
    },
}
RANDOM_CONFIGURATION: dict[str, Any] = {
    "three configurations": {"chain": STANFORD, "parameters": LENGTHS, "count": 3, "seed": 1},
    "within limits": {"robot": "twolink", "limits": [[-90, 90], [0, 120]]},
}

PRODUCTS: dict[str, Any] = {
    "a shift along x and a turn about x commute": {
        "products": [[{"x": "X"}, {"c": "C"}], [{"c": "C"}, {"x": "X"}]],
    },
    "those along y and about x do not": {
        "products": [[{"y": "Y"}, {"c": "C"}], [{"c": "C"}, {"y": "Y"}]],
    },
    "a matrix of ones own its Jacobian and its values": {
        "products": [
            [
                [
                    ["cos(q1)", "-sin(q1)", 0, "L1*cos(q1)"],
                    ["sin(q1)", "cos(q1)", 0, "L1*sin(q1)"],
                    [0, 0, 1, 0],
                    [0, 0, 0, 1],
                ],
                {"a": "q2"},
                {"x": "L2"},
            ],
            [{"a": "q1"}, {"x": "L1"}, {"a": "q2"}, {"x": "L2"}],
        ],
        "parameters": {"L1": 0.4, "L2": 0.3},
        "joints": [30, 45],
        "angle_unit": "deg",
        "jacobian": True,
    },
    "two frames multiplied": {
        "products": [[[0.1, 0, 0.3, 90, 0, 0], [0, 0.2, 0, 0, 30, 0]]],
        "angle_unit": "deg",
    },
}
