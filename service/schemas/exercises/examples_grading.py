"""Requests about exercises that the OpenAPI document shows; a test sends every one of them."""

from __future__ import annotations

from typing import Any

from exercises.instance import SEED_CHARACTERS
from service.messages import languages

EXERCISE_ID: dict[str, Any] = {
    "name": "exercise_id",
    "in": "path",
    "required": True,
    "description": "id of the exercise",
    "schema": {"type": "string", "maxLength": 64},
    "examples": {"SCARA": {"value": "scara"}},
}
SEED: dict[str, Any] = {
    "name": "seed",
    "in": "query",
    "required": False,
    "description": "names a student or a try; the same seed gives the same values",
    "schema": {"type": "string", "maxLength": SEED_CHARACTERS},
}
LANGUAGE: dict[str, Any] = {
    "name": "lang",
    "in": "query",
    "required": False,
    "description": "en, es, fr, pt, ro or uk; else Accept-Language decides",
    "schema": {"type": "string", "enum": list(languages())},
}

SCARA: dict[str, Any] = {
    "convention": "modified",
    "angle_unit": "deg",
    "rows": [
        {"alpha": 0, "a": 0, "d": 0, "theta": "q1"},
        {"alpha": 0, "a": "a2", "d": 0, "theta": "q2"},
        {"alpha": 180, "a": "a3", "d": "q3", "theta": 0},
        {"alpha": 0, "a": 0, "d": 0, "theta": "q4"},
    ],
}

SCARA_BY_THE_BOOK: dict[str, Any] = {
    "convention": "standard",
    "angle_unit": "deg",
    "rows": [
        {"theta": "q1", "d": 0, "a": "a2", "alpha": 0},
        {"theta": "q2", "d": 0, "a": "a3", "alpha": 180},
        {"theta": 0, "d": "q3", "a": 0, "alpha": 0},
        {"theta": "q4", "d": 0, "a": 0, "alpha": 0},
    ],
}

RX90: dict[str, Any] = {
    "convention": "modified",
    "angle_unit": "deg",
    "rows": [
        {"alpha": 0, "a": 0, "d": 0, "theta": "q1"},
        {"alpha": 90, "a": 0, "d": 0, "theta": "q2"},
        {"alpha": 0, "a": "D3", "d": 0, "theta": "q3"},
        {"alpha": -90, "a": 0, "d": "RL4", "theta": "q4"},
        {"alpha": 90, "a": 0, "d": 0, "theta": "q5"},
        {"alpha": -90, "a": 0, "d": 0, "theta": "q6"},
    ],
}

ANSWERS: dict[str, Any] = {
    "a table, with frames chosen otherwise than in the key": {"table": SCARA_BY_THE_BOOK},
    "all parts": {
        "table": SCARA_BY_THE_BOOK,
        "schematic": {
            "joints": ["revolute", "revolute", "prismatic", "revolute"],
            "relations": ["parallel", "parallel", "coincident"],
        },
        "link_matrices": [
            [["c1", "-s1", 0, "a2*c1"], ["s1", "c1", 0, "a2*s1"], [0, 0, 1, 0], [0, 0, 0, 1]],
            [["c2", "s2", 0, "a3*c2"], ["s2", "-c2", 0, "a3*s2"], [0, 0, -1, 0], [0, 0, 0, 1]],
            [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, "q3"], [0, 0, 0, 1]],
            None,
        ],
        "transform": [
            ["cos(q1+q2-q4)", "sin(q1+q2-q4)", 0, "a2*c1 + a3*c12"],
            ["sin(q1+q2-q4)", "-cos(q1+q2-q4)", 0, "a2*s1 + a3*s12"],
            [0, 0, -1, "-q3"],
            [0, 0, 0, 1],
        ],
        "workspace": {"inner": "a2 - a3", "outer": "a2 + a3"},
        "help": "kind",
    },
}

GRADE: dict[str, Any] = {
    "another choice of frames": {"reference": SCARA, "submission": SCARA_BY_THE_BOOK},
    "a wrong answer, told by row only": {
        "reference": RX90,
        "submission": {
            **RX90,
            "rows": [*RX90["rows"][:3], {**RX90["rows"][3], "alpha": 0}, *RX90["rows"][4:]],
        },
        "policy": {"tool": "axis"},
        "help": "row",
    },
    "several submissions": {"reference": SCARA, "submissions": [SCARA, SCARA_BY_THE_BOOK]},
}
