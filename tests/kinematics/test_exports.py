"""What the package exports, and what importing it costs."""

import subprocess
import sys

import kinematics

HEAVY = ("sympy", "mpmath", "EAIK", "eaik", "lark", "defusedxml", "fastapi", "pydantic", "orjson")


def test_every_exported_name_exists_once():
    assert sorted(set(kinematics.__all__)) == sorted(kinematics.__all__)
    assert not [name for name in kinematics.__all__ if not hasattr(kinematics, name)]


def test_importing_the_numeric_core_loads_nothing_heavy():
    script = f"import kinematics, sys; print(*[m for m in {HEAVY} if m in sys.modules])"
    done = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True, check=True)
    assert done.stdout.split() == []


def test_the_front_page_example():
    """A PUMA 560 from its table to a pose, through exported names alone."""
    right = 1.5707963267948966
    rows = [
        (right, 0, 0),
        (0, 0.4318, 0),
        (-right, 0.0203, 0.15005),
        (right, 0, 0.4318),
        (-right, 0, 0),
        (0, 0, 0),
    ]
    table = kinematics.DHTable(
        convention=kinematics.Convention.STANDARD,
        rows=tuple(
            kinematics.DHRow(joint=kinematics.JointType.REVOLUTE, theta=0.0, d=d, a=a, alpha=alpha)
            for alpha, a, d in rows
        ),
    )
    pose = kinematics.forward_kinematics(table, [0.0] * 6).transform
    assert pose[:3, 3].round(5).tolist() == [0.4521, -0.15005, 0.4318]
