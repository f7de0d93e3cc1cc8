"""The table of settings in docs/operations.md is that of the code. `python … --update` writes it."""

import os
import socket
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

import pytest

from service.__main__ import main
from service.settings import Settings
from tests.architecture.sources import ROOT
from tests.exercises.folders import folder

PAGE = ROOT / "docs" / "operations.md"
BEGIN = "<!-- settings: written by tests/architecture/test_settings.py --update -->\n"
END = "<!-- end of settings -->"


def table() -> str:
    lines = ["| variable | default | meaning |", "|---|---|---|"]
    for name, field in Settings.model_fields.items():
        default = field.default
        if isinstance(default, tuple):
            default = " ".join(default)
        if isinstance(default, bool):
            default = str(default).lower()
        shown = f"`{default}`" if default not in ("", None) else "none"
        lines.append(f"| `FRAMEWISE_{name.upper()}` | {shown} | {field.description} |")
    return "\n".join(lines) + "\n"


def test_the_page_lists_every_setting() -> None:
    text = PAGE.read_text(encoding="utf-8")
    assert text[text.index(BEGIN) + len(BEGIN) : text.index(END)] == table()


@pytest.fixture
def refusal(capsys: pytest.CaptureFixture[str]) -> Callable[..., str]:
    """What a command says that cannot be carried out, which ends with 2 as all such do; it ended with 1."""

    def told(*arguments: str) -> str:
        with pytest.raises(SystemExit, match=r"^2$"):
            main(arguments)
        return capsys.readouterr().err

    return told


def test_every_setting_is_explained() -> None:
    assert all(field.description for field in Settings.model_fields.values())


@pytest.mark.parametrize(
    ("name", "value"),
    [
        ("PORT", "many"),
        ("BODY_LIMIT", "-1"),
        ("PROT", "8000"),
        ("WORKERS", "0"),
        ("WORKERS", "100000"),
        ("SYMBOLIC_WORKERS", "100000"),
        ("BATCH_THREADS", "100000"),
        ("GRADING_THREADS", "100000"),
        ("PREFIX", "/dh/.."),
        ("PREFIX", "./dh"),
        ("PUBLIC_URL", "https://a b"),
        ("PUBLIC_URL", "ftp://a.example"),
        ("PUBLIC_URL", "a.example"),
        ("LTI_TRUSTED_ORIGINS", "lms.example"),
        ("LTI_TRUSTED_ORIGINS", "https://lms.example/lti"),
        ("CALLBACK_HOSTS", "https://lms.example"),
        ("CALLBACK_HOSTS", "*"),
        ("PEOPLE_DAYS", "99999999999"),
        ("ACCESS_DAYS", "99999999999"),
        ("READ_SECONDS", "inf"),
        ("SYMBOLIC_SECONDS", "inf"),
        ("SYMBOLIC_SECONDS", "1e300"),
        ("QUEUE_SECONDS", "inf"),
        ("SHUTDOWN_SECONDS", "99999999999"),
        ("SYMBOLIC_MEMORY", "1048576"),
        ("SYMBOLIC_MEMORY", "999999999999999999999"),
        ("NUMBER_DIGITS", "1001"),
        ("NUMBER_LARGEST", "inf"),
        ("HOST", ""),
        ("SECRET", ""),
        ("HOST", "not a host"),
        ("FRAME_ANCESTORS", "none"),
        ("FRAME_ANCESTORS", "self https://a.example"),
        ("FRAME_ANCESTORS", "https://a.example:65536"),
        ("CORS_ORIGINS", "https://a.example:99999"),
        ("DATA_FOLDER", ""),
        ("DATABASE_URL", "mysql://a/b"),
        ("TRACES", "collector:4318"),
    ],
)
def test_a_setting_that_is_wrong_stops_the_service_and_is_named(
    monkeypatch: pytest.MonkeyPatch, refusal: Callable[..., str], name: str, value: str
) -> None:
    monkeypatch.setenv(f"FRAMEWISE_{name}", value)
    assert f"FRAMEWISE_{name}" in refusal("--port", "0")


@pytest.mark.parametrize(
    ("name", "value", "wanted"),
    [
        ("SECRET", "x", "at least 32 characters are needed; openssl rand -hex 32 makes enough"),
        ("PORT", "many", "a whole number is needed, such as 8"),
        ("PORT", "99999", "a number of 65535 or less is needed"),
        ("WORKERS", "0", "a number above 0 is needed"),
        ("WORKERS", "1025", "a number of 1024 or less is needed"),
        ("ACCESS_LOG", "maybe", "true or false is needed"),
        ("STORAGE", "yes", "'on' or 'off' is needed"),
        ("READ_SECONDS", "x", "a number is needed, such as 0.5"),
        ("TRUSTED_PROXIES", "10.0.0.1/8", "10.0.0.1/8 has host bits set"),
        ("HOST", "{x}", "'{x}' is not an address or a name, such as 127.0.0.1; 0.0.0.0 for all"),
    ],
)
def test_a_setting_that_is_wrong_is_told_what_would_be_right(
    monkeypatch: pytest.MonkeyPatch, refusal: Callable[..., str], name: str, value: str, wanted: str
) -> None:
    monkeypatch.setenv(f"FRAMEWISE_{name}", value)
    assert refusal("config").endswith(f"FRAMEWISE_{name}: {wanted}\n")


def test_settings_with_which_the_service_would_not_start_are_told_by_their_check(
    monkeypatch: pytest.MonkeyPatch, refusal: Callable[..., str]
) -> None:
    monkeypatch.setenv("FRAMEWISE_EXERCISE_FOLDERS", "/none/here")
    assert "FRAMEWISE_EXERCISE_FOLDERS: there is no folder /none/here" in refusal("config")
    monkeypatch.setenv("FRAMEWISE_API_KEYS", "/none/keys.json")
    assert "FRAMEWISE_API_KEYS: there is no file /none/keys" in refusal("config")


def test_an_exercise_that_is_named_instead_of_its_folder_is_told(
    monkeypatch: pytest.MonkeyPatch, refusal: Callable[..., str], tmp_path: Path
) -> None:
    """The service started without it, and without a word."""
    monkeypatch.setenv("FRAMEWISE_EXERCISE_FOLDERS", str(folder(tmp_path, name="crane")))
    wanted = (
        f"FRAMEWISE_EXERCISE_FOLDERS: {tmp_path}/crane is an exercise; the folder that holds it is needed"
    )
    assert f"{wanted}: {tmp_path}" in refusal("config")


def test_a_receipt_key_file_that_is_none_is_told_by_the_check(
    monkeypatch: pytest.MonkeyPatch, refusal: Callable[..., str], tmp_path: Path
) -> None:
    """All was well, and then the service did not start."""
    (tmp_path / "keys.json").write_text("none")
    monkeypatch.setenv("FRAMEWISE_RECEIPT_KEYS", str(tmp_path / "keys.json"))
    assert "[key_file_unreadable]" in refusal("config")


def test_traces_that_cannot_be_sent_are_told_by_the_check(
    monkeypatch: pytest.MonkeyPatch, refusal: Callable[..., str]
) -> None:
    monkeypatch.setattr("service.cli.environment.find_spec", lambda _: None)
    monkeypatch.setenv("FRAMEWISE_TRACES", "http://collector:4318/v1/traces")
    assert "FRAMEWISE_TRACES: this needs the extra telemetry" in refusal("config")


@pytest.mark.parametrize(
    ("name", "value"),
    [
        ("PREFIX", "/dh/v1.2"),
        ("PUBLIC_URL", "https://a.example:8443/dh/"),
        ("PUBLIC_URL", "http://[::1]:8000"),
        ("LTI_TRUSTED_ORIGINS", "http://127.0.0.1:8080, http://lms_web:8000/"),
        ("CALLBACK_HOSTS", "lms.example 127.0.0.1:80 [::1]:65535"),
        ("HOST", "::1"),
        ("HOST", "fe80::1%eth0"),
        ("HOST", "localhost"),
        ("FRAME_ANCESTORS", "'none'"),
        ("FRAME_ANCESTORS", "https: *.a.example:* selfish.example none.example"),
        ("DATABASE_URL", "postgresql:///framewise?host=/var/run/postgresql"),
        ("DATABASE_URL", "postgresql+psycopg://u:p@[::1]:5432/d"),
        ("SYMBOLIC_MEMORY", str(1 << 60)),
        ("NUMBER_DIGITS", "1000"),
        ("NUMBER_LARGEST", "1e308"),
    ],
)
def test_a_setting_that_is_right_is_taken(monkeypatch: pytest.MonkeyPatch, name: str, value: str) -> None:
    monkeypatch.setenv(f"FRAMEWISE_{name}", value)
    assert main(["config"]) in (0, None)


def test_the_address_of_a_collector_is_taken() -> None:
    assert Settings(traces="http://u:p@collector:4318/v1/traces?x=1").traces


def test_what_is_printed_can_be_read_again(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    main(["config"])
    printed = capsys.readouterr().out
    for line in printed.splitlines():
        if not line.startswith("# "):
            monkeypatch.setenv(*line.split("=", 1))
    main(["config"])
    assert capsys.readouterr().out == printed


@pytest.mark.parametrize(
    "address",
    [
        "postgresql://ada:lovelace@host/database",
        "postgresql://ada:love@lovelace@host/database",
        "postgresql://ada:/lovelace@host/database",
        "postgresql://host/database?user=ada&password=lovelace&sslmode=require",
        "postgresql://host/database?sslpassword=lovelace",
    ],
)
def test_no_password_is_printed(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], address: str
) -> None:
    monkeypatch.setenv("FRAMEWISE_DATABASE_URL", address)
    main(["config"])
    printed = capsys.readouterr().out
    assert "lovelace" not in printed
    assert "FRAMEWISE_DATABASE_URL=postgresql://" in printed
    assert "host/database" in printed


def test_no_token_of_a_collector_is_printed(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr("service.cli.config.require_what_is_named", lambda _: None)
    monkeypatch.setenv("FRAMEWISE_TRACES", "https://u:lovelace@host/v1/traces?Api-Key=lovelace&region=eu")
    main(["config"])
    printed = capsys.readouterr().out
    assert "lovelace" not in printed
    assert "region=eu" in printed


@pytest.mark.parametrize("name", ["DATABASE_URL", "TRACES"])
def test_no_password_is_repeated_in_a_refusal(
    monkeypatch: pytest.MonkeyPatch, refusal: Callable[..., str], name: str
) -> None:
    monkeypatch.setenv(f"FRAMEWISE_{name}", "ftp://ada:lovelace@host/x")
    told = refusal("config")
    assert f"FRAMEWISE_{name}" in told
    assert "lovelace" not in told


def test_a_port_that_is_taken_ends_the_program() -> None:
    with socket.create_server(("127.0.0.1", 0)) as taken:
        port = str(taken.getsockname()[1])
        command = [sys.executable, "-m", "service", "--port", port]
        result = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=False)
    assert result.returncode != 0
    assert "address already in use" in result.stderr


@pytest.mark.parametrize("port", ["65536", "-1", "http"])
def test_a_port_that_is_none_is_refused(port: str) -> None:
    with pytest.raises(SystemExit):
        main([f"--port={port}"])


def test_lists_are_separated_by_spaces_or_commas(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("FRAMEWISE_FRAME_ANCESTORS", "'self', https://a.example https://b.example")
    monkeypatch.setenv("FRAMEWISE_PREFIX", "dh/")
    assert Settings().frame_ancestors == ("'self'", "https://a.example", "https://b.example")
    assert Settings().prefix == "/dh"


if __name__ == "__main__" and "--update" in sys.argv:
    text = PAGE.read_text(encoding="utf-8")
    head, tail = text[: text.index(BEGIN) + len(BEGIN)], text[text.index(END) :]
    PAGE.write_text(head + table() + tail, encoding="utf-8")


def test_a_setting_misspelt_is_answered_with_the_one_meant(
    monkeypatch: pytest.MonkeyPatch, refusal: Callable[..., str]
) -> None:
    monkeypatch.setenv("FRAMEWISE_DATA_DIR", "x")
    assert "did you mean FRAMEWISE_DATA_FOLDER" in refusal("config")
    monkeypatch.delenv("FRAMEWISE_DATA_DIR")
    monkeypatch.setenv("FRAMEWISE_QQ", "x")
    assert refusal("config").endswith("FRAMEWISE_QQ: there is no such setting\n")


@pytest.mark.parametrize("workers", ["1", "2"])
def test_a_start_that_lacks_something_ends_with_a_sentence(tmp_path: Path, workers: str) -> None:
    """Several processes were started again for ever, each with a stack trace, and nobody was answered.

    Nor is a dead process given the time in which one that loads has to answer.
    """
    (tmp_path / "file").write_text("")
    patient = "from service.cli import serve; serve.SILENT_SECONDS = 3600"
    command = [sys.executable, "-c", f"{patient}; from service.__main__ import main; main()"]
    lacking = {"FRAMEWISE_STORAGE": "on", "FRAMEWISE_DATA_FOLDER": str(tmp_path / "file")}
    result = subprocess.run(
        [*command, "--port", "0", "--workers", workers],
        cwd=ROOT,
        env={**os.environ, **lacking},
        capture_output=True,
        text=True,
        check=False,
        timeout=300,
    )
    assert result.returncode == 2
    assert "[storage_folder]" in result.stderr
    assert "Traceback" not in result.stderr
