"""`framewise grade` and `framewise receipts`, called as a person calls them."""

import csv
import io
import json
import re
import shutil
import subprocess
import sys
from dataclasses import replace
from pathlib import Path
from types import SimpleNamespace

import pytest
from uvicorn.supervisors.multiprocess import Process

from courses.storage.database import open_store
from service import __version__
from service.cli.commands import COMMANDS, main
from service.receipts.keys import read_keys, rotate
from service.receipts.receipt import issue
from tests.exercises.packaged import exercise
from tests.service.adapters.test_receipts import RECEIPT

RIGHT = "theta,d,a,alpha\nq1,0,L1,0\nq2,0,L2,0\n"
WRONG = "theta,d,a,alpha\nq1,0,L1,90\nq2,0,L2,0\n"


def test_a_folder_is_graded_into_a_file(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    folder = tmp_path / "class"
    folder.mkdir()
    (folder / "ann.csv").write_text(RIGHT)
    (folder / "bob.csv").write_text(WRONG)
    output = tmp_path / "marks.csv"
    arguments = ["--lang", "es", "grade", str(folder), "--exercise", "twolink", "--angle-unit", "deg"]
    assert main([*arguments, "--output", str(output), "--jobs", "1"]) == 0
    rows = list(csv.DictReader(io.StringIO(output.read_text(encoding="utf-8"))))
    assert [(row["student"], row["correct"]) for row in rows] == [("ann", "true"), ("bob", "false")]
    assert "not_equivalent" in capsys.readouterr().err
    assert main([*arguments, "--format", "json", "--jobs", "1"]) == 0
    lines = [json.loads(line) for line in capsys.readouterr().out.splitlines()]
    assert [line["points"] == line["max_points"] for line in lines] == [True, False]


def test_what_cannot_be_found_is_said(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["grade", str(tmp_path / "nowhere"), "--exercise", "twolink"]) == 2
    told = capsys.readouterr()
    assert "file_missing" in told.err
    (tmp_path / "a.csv").write_text(RIGHT)
    assert main(["grade", str(tmp_path / "a.csv"), "--exercise", "r2d2", "--jobs", "1"]) == 2
    told_of_exercise = capsys.readouterr()
    assert "exercise_unknown" in told_of_exercise.err
    assert (told.out, told_of_exercise.out) == ("", "")


@pytest.mark.parametrize("packed", [False, True])
def test_files_that_are_left_out_are_named(
    packed: bool, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    path = tmp_path / "class"
    path.mkdir()
    (path / "ann.csv").write_text(RIGHT)
    for name in ("x.pdf", "noext", "inner.zip", ".DS_Store"):
        (path / name).write_bytes(b"\0")
    if packed:
        path = Path(shutil.make_archive(str(tmp_path / "packed"), "zip", path))
    arguments = ["grade", str(path), "--exercise", "twolink", "--angle-unit", "deg", "--jobs", "1"]
    assert main(arguments) == 0
    told = capsys.readouterr()
    assert len(told.out.splitlines()) == 2
    assert "Files left out because of their type: 3 (inner.zip, noext, x.pdf)." in told.err
    for number in range(12):
        (tmp_path / "class" / f"{number:02}.doc").write_bytes(b"")
    assert main([*arguments[:1], str(tmp_path / "class"), *arguments[2:]]) == 0
    assert "type: 15 (00.doc, 01.doc," in (told := capsys.readouterr().err)
    assert "09.doc …)." in told


@pytest.mark.parametrize("arguments", [["grade"], ["grade", "-"]])
def test_a_class_is_not_read_from_where_one_happens_to_be(
    arguments: list[str], tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    (tmp_path / "ann.csv").write_text(RIGHT)
    assert main([*arguments, "--exercise", "twolink", "--jobs", "1"]) == 2
    told = capsys.readouterr()
    assert "grade_path_needed" in told.err
    assert not told.out


def test_marks_are_replaced_when_all_is_graded(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    marks, link = tmp_path / "marks.csv", tmp_path / "latest.csv"
    marks.write_text("of last week")
    marks.chmod(0o600)
    link.symlink_to(marks)
    arguments = ["--exercise", "twolink", "--angle-unit", "deg", "--jobs", "1", "--output", str(link)]
    assert main(["grade", str(tmp_path / "mistyped"), *arguments]) == 2
    assert "file_missing" in capsys.readouterr().err
    assert marks.read_text() == "of last week"
    (tmp_path / "ann.csv").write_text(RIGHT)
    assert main(["grade", str(tmp_path / "ann.csv"), *arguments]) == 0
    assert link.is_symlink()
    assert marks.read_text().startswith("student,")
    assert marks.stat().st_mode & 0o777 == 0o600
    assert not list(tmp_path.glob("*.part"))


def test_marks_go_into_a_device(tmp_path: Path) -> None:
    (tmp_path / "ann.csv").write_text(RIGHT)
    options = ["--exercise", "twolink", "--jobs", "1", "--output", "/dev/null"]
    assert main(["grade", str(tmp_path / "ann.csv"), *options]) == 0
    assert Path("/dev/null").is_char_device()


def test_an_autograder_is_spoken_to(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (tmp_path / "a.csv").write_text(RIGHT)
    arguments = ["grade", str(tmp_path / "a.csv"), "--exercise", "twolink", "--angle-unit", "deg"]
    assert main([*arguments, "--for", "nbgrader", "--points", "5"]) == 0
    assert capsys.readouterr().out == "5\n"


@pytest.mark.parametrize(
    ("arguments", "told"),
    [
        (["--for", "nbgrader", "--per-student", "--output", "x.csv"], "--per-student, --output"),
        (["--points", "5"], "--points"),
    ],
)
def test_an_option_that_would_do_nothing_is_refused(
    arguments: list[str], told: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "a.csv").write_text(RIGHT)
    assert main(["grade", str(tmp_path / "a.csv"), "--exercise", "twolink", *arguments]) == 2
    err = capsys.readouterr().err
    assert "options_without_effect" in err
    assert told in err


@pytest.mark.parametrize("points", ["0", "-5", "nan", "inf", "five"])
def test_an_assignment_is_worth_something(points: str, capsys: pytest.CaptureFixture[str]) -> None:
    with pytest.raises(SystemExit):
        main(["grade", "a.csv", "--for", "nbgrader", "--points", points])
    assert "a number above 0 is needed" in capsys.readouterr().err


def test_an_exercise_has_one_column_however_its_name_is_typed(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """What could not be graded stood in another one, under the name as typed."""
    (tmp_path / "ann.csv").write_text(RIGHT)
    (tmp_path / "bob.csv").write_text("nothing")
    options = ["--exercise", "Two-Link", "--format", "canvas", "--jobs", "1"]
    assert main(["grade", str(tmp_path), *options]) == 0
    head, *_ = csv.reader(io.StringIO(capsys.readouterr().out))
    assert head[4:] == ["twolink"]


def test_a_language_may_be_written_behind_an_equals_sign(capsys: pytest.CaptureFixture[str]) -> None:
    """`framewise --lang=es …` was taken for options of the server."""
    assert main(["--lang=es", "grade"]) == 2
    assert "Hace falta un archivo" in capsys.readouterr().err


def test_files_of_receipts_that_cannot_be_read_are_said_to_be_so(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    """UTF-16 was called forged, and what stood beyond a mebibyte was dropped."""
    monkeypatch.setenv("FRAMEWISE_RECEIPT_KEYS", str(tmp_path / "keys.json"))
    token = issue(RECEIPT, rotate(tmp_path / "keys.json"))
    folder = tmp_path / "handed-in"
    folder.mkdir()
    (folder / "ann.txt").write_text(token, encoding="utf-16")
    (folder / "bob.txt").write_text("x\n" * 700_000 + token)
    assert main(["receipts", "verify", str(folder)]) == 0
    assert capsys.readouterr().out.count("✓") == 2
    (folder / "cy.txt").write_bytes(b"\xff\xfex")
    (folder / "dan.mp4").write_bytes(b"x" * (8 * 1024 * 1024 + 1))
    assert main(["receipts", "verify", str(folder)]) == 1
    told = capsys.readouterr().out
    assert told.count("✓") == 2
    assert "✗ cy.txt… cy.txt cannot be read: it begins like UTF-16" in told
    assert "✗ dan.mp4… dan.mp4 cannot be read: > 8 MiB" in told


def test_a_name_in_a_receipt_writes_no_line_of_its_own(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    """Students type their names: one with a line break forged what the lecturer reads of another receipt."""
    monkeypatch.setenv("FRAMEWISE_RECEIPT_KEYS", str(tmp_path / "keys.json"))
    name = "Eve: x v1, 0/1\n✓ Ann: puma560 v1, 100/100, 2026-11-22T10:30:00+00:00\x1b[8m"
    token = issue(replace(RECEIPT, name=name), rotate(tmp_path / "keys.json"))
    (tmp_path / "eve.txt").write_text(token)
    assert main(["receipts", "verify", str(tmp_path / "eve.txt")]) == 0
    told = capsys.readouterr().out
    assert len(told.splitlines()) == 1
    assert "\x1b" not in told


def test_receipts_are_verified_and_keys_renewed(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    keys = tmp_path / "keys.json"
    assert main(["receipts", "rotate", str(keys)]) == 0
    capsys.readouterr()
    monkeypatch.setenv("FRAMEWISE_RECEIPT_KEYS", str(keys))
    folder = tmp_path / "handed-in"
    folder.mkdir()
    token = issue(RECEIPT, read_keys(keys))
    (folder / "ann.txt").write_text(f"Here it is:\n{token[:90]}\n{token[90:]}\n")
    assert main(["receipts", "verify", str(folder), "--csv"]) == 0
    (row,) = csv.DictReader(io.StringIO(capsys.readouterr().out))
    assert (row["student"], row["points"]) == (RECEIPT.name, "52.5")
    (folder / "eve.txt").write_text(token[:-1] + ("A" if token[-1] != "A" else "B"))
    assert main(["receipts", "verify", str(folder)]) == 1
    assert capsys.readouterr().out.count("✓") == 1


@pytest.mark.parametrize(
    "arguments",
    [
        ["receipts", "verify", "{}/nowhere"],
        ["grade", "{}/a.csv", "--exercise", "twolink", "--jobs", "1", "--output", "{}/no/marks.csv"],
        ["receipts", "rotate", "{}/no/keys.json"],
    ],
)
def test_a_file_that_cannot_be_used_is_named(
    arguments: list[str], tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """By the name that was typed, not by that of a file beside it."""
    (tmp_path / "a.csv").write_text(RIGHT)
    typed = [argument.replace("{}", str(tmp_path)) for argument in arguments]
    assert main(typed) == 2
    told = capsys.readouterr().err
    assert "file_unusable" in told
    assert any(f": {word} cannot" in told for word in typed)


def test_marks_are_not_written_under_the_name_of_a_spreadsheet(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """Spreadsheet programs refused the file, and a class's own was overwritten."""
    (tmp_path / "class.csv").write_text(RIGHT)
    output = tmp_path / "marks.XLSX"
    output.write_bytes(b"a spreadsheet")
    typed = [
        "grade",
        str(tmp_path / "class.csv"),
        "--exercise",
        "twolink",
        "--jobs",
        "1",
        "--output",
        str(output),
    ]
    assert main(typed) == 2
    assert "marks.XLSX would not be a spreadsheet" in capsys.readouterr().err
    assert output.read_bytes() == b"a spreadsheet"


@pytest.mark.parametrize("text", ["{", "[]x", '[{"id": 1}]', '{"keys": [{}]}', '{"keys": []}', "5"])
def test_a_file_that_holds_no_keys_is_refused(
    text: str, tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    broken = tmp_path / "keys.json"
    broken.write_text(text)
    monkeypatch.setenv("FRAMEWISE_API_KEYS", str(broken))
    assert main(["receipts", "rotate", str(broken)]) == 2
    assert "key_file_unreadable" in capsys.readouterr().err
    assert main(["keys", "list"]) == 2
    assert "key_file_unreadable" in capsys.readouterr().err
    assert broken.read_text() == text


@pytest.mark.parametrize(
    ("name", "command"), [("API_KEYS", "framewise keys add"), ("RECEIPT_KEYS", "framewise receipts rotate")]
)
def test_a_key_file_that_is_not_there_is_said_before_anything_is_served(
    name: str,
    command: str,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    """A wrong path to the keys of programs let everybody in without one."""
    path = tmp_path / "none.json"
    monkeypatch.setenv(f"FRAMEWISE_{name}", str(path))
    monkeypatch.setattr("service.cli.serve.uvicorn.run", None)
    assert main(["serve", "--port", "0"]) == 2
    assert f"FRAMEWISE_{name}: there is no file {path}; {command} makes it" in capsys.readouterr().err


def test_api_keys_that_cannot_be_understood_are_not_served_with(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    path = tmp_path / "broken.json"
    path.write_text("{")
    monkeypatch.setenv("FRAMEWISE_API_KEYS", str(path))
    monkeypatch.setattr("service.cli.serve.uvicorn.run", None)
    assert main(["serve", "--port", "0"]) == 2
    assert "key_file_unreadable" in capsys.readouterr().err


def test_a_key_that_is_not_there_is_said(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    keys = tmp_path / "keys.json"
    monkeypatch.setenv("FRAMEWISE_API_KEYS", str(keys))
    assert main(["keys", "revoke", "fwk_none"]) == 2
    assert "api_key_unknown" in capsys.readouterr().err
    receipts = tmp_path / "receipts.json"
    assert main(["receipts", "rotate", str(receipts)]) == 0
    before = receipts.read_text()
    assert main(["receipts", "rotate", str(receipts), "--retire", "none"]) == 2
    assert "receipt_kid_unknown" in capsys.readouterr().err
    assert receipts.read_text() == before


@pytest.mark.parametrize(
    "arguments",
    [
        ["grade", "x", "--jobs", "0"],
        ["keys", "add", "--days", "-3"],
        ["keys", "add", "--cost-per-minute", "0"],
    ],
)
def test_what_is_counted_is_counted_from_one(
    arguments: list[str], capsys: pytest.CaptureFixture[str]
) -> None:
    with pytest.raises(SystemExit):
        main(arguments)
    assert "a whole number from 1 on" in capsys.readouterr().err


@pytest.mark.parametrize(
    ("arguments", "told"),
    [
        (["lti", "activate", "9" * 30], "nothing here has a number such as 999"),
        (["lti", "disable", "x"], "a whole number from 1 on"),
        (["lti", "deployment", "9" * 30, "1"], "nothing here has a number such as 999"),
        (["lti", "invite", "ftp://lms.example.edu"], "an address is needed"),
        (["lti", "administer", "framewise.example.edu"], "an address is needed"),
        (["keys", "add", "--scope", "write"], "invalid choice: 'write'"),
        (["keys", "add", "--days", "9" * 12], "at most 36500 days"),
    ],
)
def test_a_slip_is_told_before_anything_is_done(
    arguments: list[str], told: str, capsys: pytest.CaptureFixture[str]
) -> None:
    with pytest.raises(SystemExit):
        main(arguments)
    err = capsys.readouterr().err
    assert told in err
    assert "KeyScope." not in err


def test_no_more_variants_are_prepared_than_are_shared_out(capsys: pytest.CaptureFixture[str]) -> None:
    with pytest.raises(SystemExit):
        main(["warm", "twolink", "--variants", "1001"])
    assert "at most 1000 variants" in capsys.readouterr().err


def test_the_list_of_exercises_has_columns(capsys: pytest.CaptureFixture[str]) -> None:
    """Ids and titles longer than foreseen moved what stood behind them."""
    main(["exercises", "list"])
    begins = set()
    for line in capsys.readouterr().out.splitlines():
        found = exercise(line.split()[0])
        parts = ", ".join(part.kind for part in found.parts)
        assert line.endswith(f" {parts}")
        begins.add((line.index(found.title("en"), len(found.id)), len(line) - len(parts)))
    assert len(begins) == 1


def test_a_reader_that_has_had_enough_is_no_error() -> None:
    """As in `framewise exercises list | head -1`."""
    with subprocess.Popen(
        [sys.executable, "-m", "service", "exercises", "list"], stdout=subprocess.PIPE, stderr=subprocess.PIPE
    ) as listing:
        assert listing.stdout is not None
        assert listing.stderr is not None
        listing.stdout.close()
        assert listing.stderr.read() == b""


def test_a_process_that_says_nothing_is_waited_for_and_keeps_nothing_else_waiting(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """With a sixteenth of a processor none of two ever came to serve: each was killed after five seconds.

    While one was waited for, nobody replaced another that had died, and nobody heard the signal to end.
    """
    from service.cli import serve

    class Begun(Process):
        def start(self) -> None:
            """Nothing is started here."""
            self.process = SimpleNamespace(pid=1, exitcode=None, is_alive=lambda: True)  # type: ignore[assignment]

        def kill(self) -> None:
            """There is nothing to be killed."""

        def join(self) -> None:
            """There is nothing to be waited for."""

    clock = SimpleNamespace(now=0.0, monotonic=lambda: clock.now)

    def watched(supervisor: serve._Supervisor) -> None:
        supervisor.init_processes()
        slow, other = supervisor.processes

        def looked() -> list[Process]:
            supervisor.keep_subprocess_alive()
            return supervisor.processes

        assert looked() == looked() == [slow, other]
        other.process.is_alive = lambda: False  # type: ignore[method-assign]
        first, second = looked()
        assert (first is slow, second is other) == (True, False)
        clock.now = serve.SILENT_SECONDS - 1.0
        assert looked()[0] is slow
        slow.child_conn.recv()
        slow.child_conn.send(True)
        assert looked()[0] is slow
        clock.now += serve.SILENT_SECONDS - 1.0
        assert looked()[0] is slow
        clock.now += 2.0
        assert looked()[0] is not slow
        for each in supervisor.sockets:
            each.close()

    for place in ("uvicorn.supervisors.multiprocess.Process", "service.cli.serve.Process"):
        monkeypatch.setattr(place, Begun)
    monkeypatch.setattr(serve, "time", clock)
    monkeypatch.setattr(serve._Supervisor, "run", watched)
    monkeypatch.setattr("signal.signal", lambda *_: None)
    for shared in ("share_secret", "share_metrics"):
        monkeypatch.setattr(serve, shared, lambda: "nothing is shared here")
    assert main(["serve", "--workers", "2", "--port", "0"]) == 0
    assert serve.SILENT_SECONDS >= 16 * 2


def test_what_looks_after_several_servers_does_not_load_what_they_need() -> None:
    """A server with two workers would import everything twice, one after the other, before it answers."""
    code = "import sys, service.cli.serve; print(*{name.partition('.')[0] for name in sys.modules})"
    run = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert not {"fastapi", "sqlalchemy", "babel", "lark"} & set(run.stdout.split())


def test_a_service_on_sqlite_does_not_load_what_it_may_never_need(tmp_path: Path) -> None:
    """The calendars of all languages take 30 ms of each start, what PostgreSQL needs 35 ms and 2 MB.

    The first start migrates, and needs more.
    """
    open_store("", tmp_path).close()
    code = (
        "import sys; from service.app import create_app; from service.settings import Settings; "
        f"create_app(Settings(storage='on', data_folder={str(tmp_path)!r})); "
        "print(*(name for name in sys.modules if 'dialects' in name or name == 'babel'))"
    )
    run = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    loaded = run.stdout.split()
    assert "sqlalchemy.dialects.sqlite" in loaded
    assert not {"babel", "sqlalchemy.dialects.postgresql"} & set(loaded)


def test_every_command_is_listed_with_the_module_that_declares_it(
    capsys: pytest.CaptureFixture[str],
) -> None:
    with pytest.raises(SystemExit):
        main(["--help"])
    told = re.findall(r"^ {4}(\w+) ", capsys.readouterr().out, re.MULTILINE)
    assert set(told) == set(COMMANDS)


@pytest.mark.parametrize(
    "arguments",
    [
        ["backup", "backup.gz"],
        ["people", "export", "key"],
        ["people", "erase", "key"],
        ["people", "purge"],
        ["lti", "platforms"],
        ["lti", "activate", "1"],
        ["lti", "deployment", "1", "2"],
        ["lti", "remove", "1", "--yes"],
        ["courses", "list"],
        ["courses", "erase", "1", "--yes"],
    ],
)
def test_what_needs_a_database_makes_none(
    arguments: list[str], monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], tmp_path: Path
) -> None:
    """A forgotten `cd` before a nightly backup put one without rows in the place of the last good one."""
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("FRAMEWISE_STORAGE", "on")
    monkeypatch.delenv("FRAMEWISE_DATA_FOLDER", raising=False)
    (tmp_path / "backup.gz").write_bytes(b"the last good one")
    assert main(arguments) == 2
    told = capsys.readouterr().err
    assert "storage_missing" in told
    assert str(tmp_path / "data" / "framewise.sqlite") in told
    assert [file.name for file in tmp_path.iterdir()] == ["backup.gz"]
    assert (tmp_path / "backup.gz").read_bytes() == b"the last good one"


@pytest.mark.parametrize("action", ["export", "erase"])
def test_who_is_stored_in_no_course_is_sought_in_none(
    action: str, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], tmp_path: Path
) -> None:
    monkeypatch.setenv("FRAMEWISE_STORAGE", "on")
    monkeypatch.setenv("FRAMEWISE_DATA_FOLDER", str(tmp_path))
    assert main(["migrate"]) == 0
    assert main(["people", action, "nobody"]) == 2
    assert capsys.readouterr().err == "framewise: There is no such person here. [record_unknown]\n"


def test_without_storage_there_is_nothing_to_back_up(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], tmp_path: Path
) -> None:
    monkeypatch.setenv("FRAMEWISE_STORAGE", "off")
    monkeypatch.setenv("FRAMEWISE_DATA_FOLDER", str(tmp_path / "data"))
    assert main(["backup", str(tmp_path / "backup.gz")]) == 2
    assert "storage is switched off" in capsys.readouterr().err
    assert not list(tmp_path.iterdir())


@pytest.mark.parametrize("package", ["framewise", "service"])
def test_the_packages_are_the_command(package: str) -> None:
    asked = [sys.executable, "-m", package, "--version"]
    told = subprocess.run(asked, capture_output=True, text=True, check=True, timeout=120)
    assert told.stdout == f"framewise {__version__}\n"


def test_values_to_choose_from_are_listed_as_they_are_typed(capsys: pytest.CaptureFixture[str]) -> None:
    """They were `<AngleUnit.RAD: 'rad'>`."""
    for option in ("--tell", "--convention", "--angle-unit", "--length-unit", "--format"):
        with pytest.raises(SystemExit):
            main(["grade", "class.csv", option, "none"])
        assert "<" not in capsys.readouterr().err.rpartition("invalid choice")[2]
