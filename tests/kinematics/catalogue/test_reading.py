"""Malformed catalogue files: every fault at once, each with the file and the path of its key."""

import re
from importlib.resources import files

import pytest

from kinematics import catalogue
from kinematics.errors import DescriptionError

PUMA = (files(catalogue) / "puma560.toml").read_text(encoding="utf-8")


def faults_of(text: str) -> list[tuple[str, tuple[str | int, ...]]]:
    with pytest.raises(DescriptionError) as caught:
        catalogue.read_robot("arm", text)
    for fault in caught.value.faults:
        assert fault.where[0] == "arm.toml"
    return [(fault.code, fault.where[1:]) for fault in caught.value.faults]


TYPE = "catalogue_value_type"
LAST_ROW = "  [0.0, 0.0, 0.0, 1.0],"
READY = "joints = [0, 90, -90, 0, 0, 0]"
POSITION = 'position = ["a3", "-d3", "a2 + d4"]'


@pytest.mark.parametrize(
    ("old", "new", "expected"),
    [
        ('name = "PUMA 560"', "name = 560", [(TYPE, ("name",))]),
        ('name = "PUMA 560"', 'name = " "', [(TYPE, ("name",))]),
        ('name = "PUMA 560"', "", [("catalogue_key_missing", ("name",))]),
        ('name = "PUMA 560"', 'name = "P"\nheight = 1', [("catalogue_key_unknown", ("height",))]),
        (
            "[source]",
            "[sauce]",
            [("catalogue_key_missing", ("source",)), ("catalogue_key_unknown", ("sauce",))],
        ),
        (
            'place = "',
            'places = "',
            [
                ("catalogue_key_missing", ("source", "place")),
                ("catalogue_key_unknown", ("source", "places")),
            ],
        ),
        ('convention = "standard"', 'convention = "Standard"', [(TYPE, ("table", "convention"))]),
        ('angle_unit = "deg"', "angle_unit = 1", [(TYPE, ("table", "angle_unit"))]),
        ('theta = "q3"', 'theta = "q3 +"', [("cell_incomplete", ("table", "rows", 2, "theta"))]),
        ('theta = "q3"', "theta = true", [("cell_not_a_value", ("table", "rows", 2, "theta"))]),
        (
            'joint = "revolute", theta = "q3"',
            'joint = "hinge", theta = "q3"',
            [
                (TYPE, ("table", "rows", 2, "joint")),
            ],
        ),
        ("a2 = 0.4318", "a2 = nan", [("parameter_not_finite", ("parameters", "a2"))]),
        ("a2 = 0.4318", "", [("parameter_missing", ("parameters", "a2"))]),
        ("a2 = 0.4318", "a2 = 0.4318\na9 = 1", [("parameter_unused", ("parameters", "a9"))]),
        ("[-160, 160]", "[160, -160]", [("catalogue_limits_reversed", ("limits", "joints", 0))]),
        ("[-160, 160], ", "", [(TYPE, ("limits", "joints"))]),
        ("[-160, 160]", '["-160", 160]', [(TYPE, ("limits", "joints", 0))]),
        (
            READY,
            "joints = [0, 90, -90, 0, 200, 0]",
            [
                ("catalogue_outside_limits", ("configurations", "ready", "joints", 4)),
            ],
        ),
        (
            READY,
            "joints = [0, 90]",
            [
                (TYPE, ("configurations", "ready", "joints")),
            ],
        ),
        (
            POSITION,
            'position = ["a3"]',
            [
                (TYPE, ("configurations", "ready", "position")),
            ],
        ),
        (
            POSITION,
            'position = ["a3", "-d3", "2 +"]',
            [
                ("cell_incomplete", ("configurations", "ready", "position", 2)),
            ],
        ),
        (
            '["L2", 0, 0, 0, "-a3", 0],',
            '["L2", 0, 0, 0, 0, 0],',
            [("scm_no_variable", ("chain", "joints", 2))],
        ),
        (
            '["L2", 0, 0, 0, "-a3", 0],',
            '["L2", 0, 0, 0, "-a3"],',
            [
                (TYPE, ("chain", "joints")),
                ("scm_chain_empty", ("chain", "joints")),
            ],
        ),
        ("final = [0, 0, 0, 0, 0, 0]", "final = 0", [(TYPE, ("chain", "final"))]),
        ('L1 = "d3"', "L1 = 3", [(TYPE, ("chain", "parameters", "L1"))]),
        (LAST_ROW, "  [0.0, 0.0, 0.0, 2.0],", [("pose_bottom_row", ("reference", "transform", 3))]),
        (LAST_ROW, "", [(TYPE, ("reference", "transform"))]),
        (LAST_ROW, '  [0.0, 0.0, 0.0, "1"],', [("pose_not_numbers", ("reference", "transform"))]),
    ],
)
def test_each_fault_has_its_place(old, new, expected):
    assert PUMA.count(old) >= 1
    assert faults_of(PUMA.replace(old, new, 1)) == expected


def test_all_faults_at_once():
    broken = PUMA
    for old, new in [
        ('name = "PUMA 560"', "name = 1"),
        ('theta = "q3"', 'theta = "2*q3"'),
        ("[-160, 160]", "[160, -160]"),
        ('meaning = "upper', 'meanings = "upper'),
        ("[reference]", "[reverence]"),
    ]:
        assert old in broken
        broken = broken.replace(old, new, 1)
    assert [where for _, where in faults_of(broken)] == [
        ("name",),
        ("table", "rows", 2, "theta"),
        ("limits", "joints", 0),
        ("configurations", "zero", "meaning"),
        ("configurations", "zero", "meanings"),
        ("reference",),
        ("reverence",),
    ]


@pytest.mark.parametrize("text", ["", "name = 1", "[table]\nrows = [1]", "table = 3", "table = {rows = 3}"])
def test_nothing_but_our_error_comes_out(text):
    assert faults_of(text)


def test_every_code_is_met_here():
    from pathlib import Path

    text = "".join(path.read_text(encoding="utf-8") for path in Path(__file__).parent.glob("test_*.py"))
    source = "".join(
        path.read_text(encoding="utf-8") for path in Path(catalogue.__file__).parent.glob("*.py")
    )
    codes = set(re.findall(r'"(catalogue_\w+)"', source)) - {"catalogue_not_toml"}
    assert codes
    assert [code for code in codes if f'"{code}"' not in text] == []
