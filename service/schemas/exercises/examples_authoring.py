"""Drafts that the OpenAPI document shows; a test sends every one of them."""

from __future__ import annotations

from base64 import b64encode
from typing import Any

from exercises.authoring.archive import archive_of_draft
from exercises.authoring.draft import ExerciseDraft

DRAWING: dict[str, Any] = {
    "length_unit": "m",
    "lengths": {"L0": 0.4, "L1": 0.5},
    "axes": [
        {"joint": "revolute", "point": [0, 0, 0], "direction": [0, 0, 1]},
        {
            "joint": "revolute",
            "point": {"on": 1, "at": "L0"},
            "direction": {"perpendicular": 1, "towards": [0, -1, 0]},
        },
        {"joint": "revolute", "point": {"from": 2, "by": ["L1", 0, 0]}, "direction": {"parallel": 2}},
    ],
}

TWO_LINKS: dict[str, Any] = {
    "id": "two-links",
    "definition": {
        "version": 1,
        "title": {"en": "Two links", "ro": "Două elemente"},
        "reference": {
            "convention": "standard",
            "angle_unit": "deg",
            "length_unit": "m",
            "rows": [
                {"joint": "revolute", "theta": "q1", "d": 0, "a": "L1", "alpha": 0},
                {"joint": "revolute", "theta": "q2", "d": 0, "a": "L2", "alpha": 0},
            ],
        },
        "policy": {"tool": "axis"},
        "parameters": {
            "L1": {"value": 0.5, "draw": {"from": 0.4, "to": 0.6, "step": 0.05}},
            "L2": {"value": 0.3},
        },
        "parts": [{"kind": "table", "points": 10}],
        "tests": {"misconceptions": ["convention", "a_value", "rows_swapped"]},
    },
    "statements": {"en": "Two links of lengths *L1* and *L2*.", "ro": "Două elemente, *L1* și *L2*."},
}

IMPORT = {
    "two links": {
        "archive": b64encode(
            archive_of_draft(
                ExerciseDraft(
                    id=TWO_LINKS["id"], definition=TWO_LINKS["definition"], statements=TWO_LINKS["statements"]
                )
            )
        ).decode()
    }
}
START = {
    "a robot of the catalogue": {"id": "my-scara", "source": {"robot": "scara"}},
    "drawn axes": {"id": "my-arm", "source": {"axes": DRAWING}},
}
DRAFT = {"two links": {"draft": TWO_LINKS}}
CHECK = {"two links, the values of a seed": {"draft": TWO_LINKS, "seed": 1}}
TRY = {
    "a right table": {
        "draft": TWO_LINKS,
        "answer": {
            "table": {
                "convention": "standard",
                "angle_unit": "deg",
                "rows": [
                    {"theta": "q1", "d": 0, "a": "L1", "alpha": 0},
                    {"theta": "q2", "d": 0, "a": "L2", "alpha": 0},
                ],
            }
        },
    }
}
