"""Settings of a link: a slip is refused where it is made, and harms nobody where it stands."""

from typing import Any

import pytest

from courses.links.link_settings import LinkSettingsError, read, stored, written
from courses.policies import Mode

PARTS, LANGUAGES = ("table", "pose"), ("en", "fr")


def made(**values: Any) -> Any:
    return read("scara", values, parts=PARTS, languages=LANGUAGES)


@pytest.mark.parametrize(
    ("name", "value"),
    [
        ("help", "hints"),
        ("help", 3),
        ("language", "xx"),
        ("language", "../fr"),
        ("parts", 5),
        ("parts", "table"),
        ("parts", {"table": True}),
        ("parts", [["table"]]),
        ("parts", ["workspace"]),
        ("per_student", "no"),
        ("per_student", 1),
        ("points", 0),
        ("attempts", 0),
        ("closes", "2027-03-28T02:30:00"),
        ("closes", "9999-12-31T23:59:59Z"),
        ("penalti", 0.5),
    ],
)
def test_a_slip_is_refused_with_its_place(name: str, value: object) -> None:
    with pytest.raises(LinkSettingsError) as refused:
        made(**{name: value})
    assert [fault.where for fault in refused.value.faults] == [(name,)]


def test_all_slips_are_told_at_once() -> None:
    with pytest.raises(LinkSettingsError) as refused:
        made(help="hints", penalty=2, penalti=1)
    assert {fault.where for fault in refused.value.faults} == {("help",), ("penalty",), ("penalti",)}


def test_what_is_meant_comes_back_as_it_was() -> None:
    values = {
        "help": "row",
        "language": "fr",
        "parts": ["pose", "table"],
        "per_student": True,
        "mode": "exam",
    }
    settings = made(**values)
    assert {name: written(settings)[name] for name in values} == values
    assert stored("scara", written(settings)) == settings


def test_a_slip_that_stands_takes_only_its_own_setting_away() -> None:
    settings = stored("scara", {"help": "hints", "parts": 5, "points": 0, "mode": "exam", "attempts": 2})
    assert (settings.help, settings.parts, settings.points) == (None, (), 1.0)
    assert (settings.policy.mode, settings.policy.attempts) == (Mode.EXAM, 2)
