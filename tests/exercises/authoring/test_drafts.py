"""A draft is its folder: nothing is lost on the way, and what is hostile stays outside."""

import copy
import functools
import io
import json
import stat
import tomllib
import zipfile
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from exercises.authoring.archive import LARGEST_FILE, MOST_FILES, archive_of_draft, draft_of_archive
from exercises.authoring.draft import (
    ExerciseDraft,
    exercise_of_draft,
    files_of_draft,
)
from exercises.authoring.scaffold import started
from exercises.authoring.sources import read_source
from exercises.authoring.toml_text import toml_text
from exercises.errors import DefinitionError, ExerciseError
from exercises.library import ROOT, packaged
from exercises.loader import load_exercise
from service.messages import robot_name
from tests.exercises.authoring.test_drawn_robots import UR5
from tests.exercises.folders import TWO_LINKS, draft_of, folder

NUMBERS = st.one_of(st.integers(-(2**53), 2**53), st.floats(allow_nan=False, allow_infinity=False, width=64))
TEXTS = st.text(st.characters(exclude_categories=("Cs",)), max_size=20)
VALUES = st.recursive(
    st.one_of(st.booleans(), NUMBERS, TEXTS),
    lambda inner: st.one_of(st.lists(inner, max_size=4), st.dictionaries(TEXTS, inner, max_size=4)),
    max_leaves=12,
)


@given(
    st.dictionaries(
        st.one_of(TEXTS, st.sampled_from(["parts", "figure", "parameters", "reference", "tests"])), VALUES
    )
)
def test_what_is_written_is_what_is_read(definition: dict[str, object]) -> None:
    assert tomllib.loads(toml_text(definition)) == definition


@pytest.mark.parametrize("exercise_id", packaged().ids)
def test_a_shipped_folder_comes_back_byte_for_byte(exercise_id: str) -> None:
    own = ROOT / exercise_id
    draft = draft_of(own)
    sent = json.loads(json.dumps({"definition": draft.definition, "statements": draft.statements}))
    again = draft_of_archive(archive_of_draft(ExerciseDraft(id=exercise_id, **sent)))
    assert again == draft
    assert files_of_draft(again) == {file.name: file.read_bytes() for file in own.iterdir()}
    assert exercise_of_draft(again).parts == packaged().exercise(exercise_id).parts


def draft(tmp_path: Path, text: str = TWO_LINKS, **changes: str) -> ExerciseDraft:
    return draft_of(folder(tmp_path, text, **changes))


def codes(work: object) -> set[str]:
    with pytest.raises(DefinitionError) as caught:
        work()  # type: ignore[operator]
    return {fault.code for fault in caught.value.faults}


@pytest.mark.parametrize(
    ("text", "code"),
    [
        ("<script>alert(1)</script>", "text_markup"),
        ("Two <svg onload=alert(1)>", "text_markup"),
        ("<!-- -->", "text_markup"),
        ("Two \u202e links", "text_control_character"),
        ("Two\x00", "text_control_character"),
        ("x" * 30_000, "text_too_long"),
    ],
)
def test_texts_hold_no_markup(tmp_path: Path, text: str, code: str) -> None:
    good = draft(tmp_path)
    titled = ExerciseDraft(
        id="two", definition={**good.definition, "title": {"en": text}}, statements=good.statements
    )
    stated = ExerciseDraft(id="two", definition=good.definition, statements={"en": text})
    remarked = ExerciseDraft(
        id="two",
        definition={**good.definition, "remarks": {"a_sign": {"en": text}}},
        statements=good.statements,
    )
    for hostile in (titled, stated, remarked):
        assert codes(lambda hostile=hostile: exercise_of_draft(hostile)) == {code}


def test_less_than_is_no_markup(tmp_path: Path) -> None:
    assert exercise_of_draft(draft(tmp_path, statement="Here *L2* < *L1*, and 3 > 2."))


@pytest.mark.parametrize("name", ["", "../two", "two/..", "a b", "-a", "con\x00", "a" * 61, "ä", "a--b"])
def test_an_id_is_a_name_of_a_folder_everywhere(tmp_path: Path, name: str) -> None:
    good = draft(tmp_path)
    hostile = ExerciseDraft(id=name, definition=good.definition, statements=good.statements)
    assert codes(lambda: exercise_of_draft(hostile)) == {"exercise_id_invalid"}
    assert codes(lambda: archive_of_draft(hostile)) == {"exercise_id_invalid"}


@pytest.mark.parametrize(
    "hostile",
    [
        {"figure": {"points": {f"P{i}": {"frame": 0} for i in range(10_000)}}},
        {"needs": ["L1"] * 1000},
        {"figure": {"links": [[[[[[[[[["P"]]]]]]]]]]}},
    ],
)
def test_a_definition_is_no_larger_than_a_robot(tmp_path: Path, hostile: dict[str, object]) -> None:
    good = draft(tmp_path)
    large = ExerciseDraft(id="two", definition={**good.definition, **hostile}, statements=good.statements)
    assert codes(lambda: exercise_of_draft(large)) == {"draft_too_large"}


@pytest.mark.parametrize(
    ("hostile", "code"),
    [
        ({"L" * 100_000: 1}, "text_too_long"),
        ({"parameters": {"L1": {"value": 1, "aliases": ["?" * 100_000]}}}, "name_invalid"),
        ({"needs": ["L" * 100_000]}, "need_unknown"),
    ],
)
def test_a_refusal_does_not_repeat_a_long_text(tmp_path: Path, hostile: dict[str, object], code: str) -> None:
    good = draft(tmp_path)
    long = ExerciseDraft(id="two", definition={**good.definition, **hostile}, statements=good.statements)
    with pytest.raises(DefinitionError) as refused:
        exercise_of_draft(long)
    assert code in {fault.code for fault in refused.value.faults}
    assert len(str(refused.value.faults)) < 2000


def leaves(value: Any, where: tuple[str | int, ...] = ()) -> Iterator[tuple[str | int, ...]]:
    """Places of the texts and numbers of a definition."""
    if isinstance(value, dict | list):
        for step, inner in value.items() if isinstance(value, dict) else enumerate(value):
            yield from leaves(inner, (*where, step))
    else:
        yield where


def test_a_draft_about_a_catalogue_robot_bears_its_name() -> None:
    """It was called "Robot arm"."""
    titles = started("arm", read_source({"robot": "cloos"}), robot_name).definition["title"]
    assert (titles["en"], titles["uk"]) == ("Cloos welding robot", "Зварювальний робот Cloos")
    assert set(started("arm", read_source({"robot": "ur5"})).definition["title"].values()) == {
        "Universal Robots UR5"
    }
    assert started("arm", read_source({"axes": UR5})).definition["title"]["en"] == "Robot arm"


@pytest.mark.parametrize(
    "extreme", [1.7e308, -1e308, 10**400, 10**15, 5e-324, 0, -1, float("nan"), "9" * 300]
)
def test_a_number_of_any_size_at_any_place_is_taken_or_refused(extreme: object) -> None:
    start = started("arm", read_source({"axes": UR5}))
    refused = 0
    for *path, last in leaves(start.definition):
        definition: Any = copy.deepcopy(start.definition)
        functools.reduce(lambda inner, step: inner[step], path, definition)[last] = extreme
        try:
            exercise_of_draft(replace(start, definition=definition))
        except ExerciseError:
            refused += 1
    assert refused > 40


def zipped(entries: dict[str, bytes], **attributes: int) -> bytes:
    stream = io.BytesIO()
    with zipfile.ZipFile(stream, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, content in entries.items():
            entry = zipfile.ZipInfo(name)
            entry.compress_type = zipfile.ZIP_DEFLATED
            for key, value in attributes.items():
                setattr(entry, key, value)
            archive.writestr(entry, content)
    return stream.getvalue()


GOOD = {"two/exercise.toml": TWO_LINKS.encode(), "two/statement.en.md": b"Links *L1*, *L2*."}


def test_the_good_archive_is_taken() -> None:
    read = draft_of_archive(zipped({**GOOD, "__MACOSX/two/._x": b"", "two/": b""}))
    assert read.id == "two"
    assert exercise_of_draft(read).points == 10


@pytest.mark.parametrize(
    "name",
    [
        "../exercise.toml",
        "two/../../etc/passwd",
        "/etc/passwd",
        "two/deep/statement.en.md",
        "..\\exercise.toml",
        "C:/statement.en.md",
        "two/statement.en.md.exe",
        "two/index.html",
        "two/../statement.ro.md",
    ],
)
def test_paths_that_lead_elsewhere_are_refused(name: str) -> None:
    assert codes(lambda: draft_of_archive(zipped({**GOOD, name: b"x"}))) <= {"archive_entry"}


def test_a_second_folder_is_refused() -> None:
    other = zipped({**GOOD, "other/statement.ro.md": b"x"})
    assert codes(lambda: draft_of_archive(other)) == {"archive_no_exercise"}


def test_a_link_is_no_file() -> None:
    link = zipped(GOOD, external_attr=(stat.S_IFLNK | 0o777) << 16)
    assert codes(lambda: draft_of_archive(link)) == {"archive_entry"}


def test_a_bomb_is_not_unpacked() -> None:
    bomb = zipped({**GOOD, "two/statement.ro.md": b"0" * (100 * 1024 * 1024)})
    assert len(bomb) < 200_000
    assert codes(lambda: draft_of_archive(bomb)) == {"archive_file_too_large"}


def test_a_size_that_lies_helps_nobody() -> None:
    data = bytearray(zipped({**GOOD, "two/statement.ro.md": b"0" * (10 * LARGEST_FILE)}))
    size = (10 * LARGEST_FILE).to_bytes(4, "little")
    assert bytes(data).count(size) >= 1
    lying = bytes(data).replace(size, (5).to_bytes(4, "little"))
    assert codes(lambda: draft_of_archive(lying)) <= {"archive_not_zip", "archive_file_too_large"}


def test_many_files_are_refused() -> None:
    many = zipped({**GOOD, **{f"two/statement.{a}{b}.md": b"x" for a in "abcdef" for b in "abcdefghijklm"}})
    assert len(zipfile.ZipFile(io.BytesIO(many)).infolist()) > MOST_FILES
    assert codes(lambda: draft_of_archive(many)) == {"archive_too_many_files"}
    hundred_thousand = zipped({f"two/{i}": b"" for i in range(100_000)})
    assert codes(lambda: draft_of_archive(hundred_thousand)) == {"archive_too_large"}


@pytest.mark.parametrize(
    "data", [b"", b"PK", b"hello" * 100, zipped(GOOD)[:-30], zipped(GOOD)[40:] + b"PK\x05\x06"]
)
def test_what_is_no_zip_is_refused(data: bytes) -> None:
    assert codes(lambda: draft_of_archive(data)) == {"archive_not_zip"}


@pytest.mark.parametrize(
    "toml",
    [b"a = " + b"[" * 5000, b"a = " + b"9" * 20_000, b"\xff", b"a = {", b"title = { en = '\x01' }"],
)
def test_toml_that_no_reader_likes_is_refused(toml: bytes) -> None:
    hostile = zipped({**GOOD, "two/exercise.toml": toml})
    assert codes(lambda: draft_of_archive(hostile)) == {"exercise_file_not_toml"}


def test_dates_and_infinities_are_no_values_of_a_definition(tmp_path: Path) -> None:
    odd = "posted = 2020-01-01\nfar = inf\n" + TWO_LINKS
    found = codes(lambda: load_exercise(folder(tmp_path, odd)))
    assert found == {"exercise_key_unknown"}
