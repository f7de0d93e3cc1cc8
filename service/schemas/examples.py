"""Requests that the OpenAPI document shows; a test sends every one of them."""

from __future__ import annotations

from typing import Any

PUMA_560: dict[str, Any] = {
    "convention": "standard",
    "angle_unit": "deg",
    "length_unit": "m",
    "rows": [
        {"joint": "revolute", "alpha": 90, "a": 0, "d": 0, "theta": "q1"},
        {"joint": "revolute", "alpha": 0, "a": 0.4318, "d": 0, "theta": "q2"},
        {"joint": "revolute", "alpha": -90, "a": 0.0203, "d": 0.15005, "theta": "q3"},
        {"joint": "revolute", "alpha": 90, "a": 0, "d": 0.4318, "theta": "q4"},
        {"joint": "revolute", "alpha": -90, "a": 0, "d": 0, "theta": "q5"},
        {"joint": "revolute", "alpha": 0, "a": 0, "d": 0, "theta": "q6"},
    ],
}

CYLINDRICAL: dict[str, Any] = {
    "convention": "modified",
    "angle_unit": "deg",
    "length_unit": "mm",
    "rows": [
        {"alpha": 0, "a": 0, "d": "L1", "theta": "θ1"},
        {"alpha": "-90", "a": 0, "d": "d2 + L2", "theta": 0},
        {"alpha": 90, "a": "2L3", "d": 0, "theta": 0},
    ],
}

FORWARD_KINEMATICS: dict[str, Any] = {
    "PUMA 560, one configuration": {"table": PUMA_560, "joints": [0, 45, -90, 0, 30, 0]},
    "a batch with parameters, base and inverse": {
        "table": CYLINDRICAL,
        "parameters": {"L1": 400, "L2": 120, "L3": 75.5},
        "joints": [[0, 100], [90, 250], [-45, 0]],
        "base": [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 850], [0, 0, 0, 1]],
        "inverse": True,
    },
    "two parts of the answer": {
        "table": PUMA_560,
        "joints": [10, 20, 30, 40, 50, 60],
        "parts": ["position", "orientation"],
    },
}

ELBOW: dict[str, Any] = {
    "convention": "standard",
    "angle_unit": "deg",
    "rows": [
        {"theta": "q1", "d": 0.4, "a": 0, "alpha": 90},
        {"theta": "q2", "d": 0, "a": 0.5, "alpha": 0},
        {"theta": "q3", "d": 0, "a": 0.3, "alpha": 0},
    ],
}
TWO_LINKS: dict[str, Any] = {
    "convention": "standard",
    "rows": [
        {"joint": "revolute", "alpha": 0, "a": "L1", "d": 0, "theta": "q1"},
        {"joint": "revolute", "alpha": 0, "a": "L2", "d": 0, "theta": "q2"},
    ],
}

JACOBIAN: dict[str, Any] = {
    "PUMA 560, wrist stretched": {"table": PUMA_560, "joints": [0, 45, -90, 0, 0, 0]},
    "two links, in the axes of the base alone": {
        "table": TWO_LINKS,
        "parameters": {"L1": 0.4, "L2": 0.3},
        "joints": [[0.3, 1.2], [0.3, 0]],
        "frame": "base",
    },
}

TURNING_ARM = """\
<robot name="turning_arm">
  <link name="floor"/><link name="post"/><link name="arm"/><link name="hand"/><link name="camera"/>
  <joint name="turn" type="continuous">
    <parent link="floor"/><child link="post"/><origin xyz="0 0 0.4"/><axis xyz="0 0 1"/>
  </joint>
  <joint name="lift" type="revolute">
    <parent link="post"/><child link="arm"/><origin xyz="0.1 0 0" rpy="-1.5707963267948966 0 0"/>
    <axis xyz="0 0 1"/><limit lower="-1.5" upper="1.5" effort="10" velocity="1"/>
  </joint>
  <joint name="grip" type="fixed"><parent link="arm"/><child link="hand"/><origin xyz="0.5 0 0"/></joint>
  <joint name="mount" type="fixed"><parent link="post"/><child link="camera"/></joint>
</robot>
"""

CONVERT: dict[str, Any] = {
    "PUMA 560 to the modified convention": {"table": PUMA_560, "to": "modified"},
    "a table with parameters to the standard convention": {"table": CYLINDRICAL, "to": "standard"},
    "a robot of the catalogue to a product of exponentials": {"robot": "scara", "to": "poe"},
    "an SCM chain to the modified convention (SCM2DH)": {
        "scm": {"joints": [{"a": "a1"}, {"x": "L1", "a": "-a2"}, {"z": "-d3"}], "final": {"c": "pi"}},
        "to": "modified",
    },
    "a robot of the catalogue to URDF": {"robot": "rx90", "to": "urdf"},
    "a table to an SCM chain": {"robot": "twolink", "to": "scm"},
    "a product of exponentials to the standard convention": {
        "poe": {
            "screws": [
                {"linear": [0, 0, 0], "angular": [0, 0, 1]},
                {"linear": [0, -0.5, 0], "angular": [0, 0, 1]},
            ],
            "home": [[1, 0, 0, 0.8], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]],
        },
        "to": "standard",
    },
    "a chain of a URDF description to the standard convention": {
        "urdf": TURNING_ARM,
        "base_link": "floor",
        "tip_link": "hand",
        "to": "standard",
    },
}
