"""What must not be in the repository: hosts in locks, paths of a machine, notes to oneself."""

import json
import re

import pytest

from tests.architecture.sources import ROOT, modules, shown, tracked

LOCKS = [path for path in tracked() if path.name.endswith((".lock", "-lock.json"))]
PRIVATE = re.compile(
    r"(?<!\w)/work/|/root/|/home/[a-z]|/opt/(wheels|pypi)|/tmp/[a-zA-Z]"
    r"|\bissues? #?\d+\b|\bissues show\b|\bseeds/\d{3}_"
)
TEXT = {".py", ".md", ".toml", ".ftl", ".js", ".css", ".html", ".json", ".yaml", ".yml", ".txt", ".lock", ""}


@pytest.mark.parametrize("path", LOCKS, ids=shown)
def test_locks_name_no_host(path) -> None:
    text = path.read_text(encoding="utf-8")
    if path.suffix == ".json":
        packages = json.loads(text)["packages"].values()
        assert not [package["resolved"] for package in packages if "resolved" in package]
    else:
        assert "://" not in text
        assert "--index-url" not in text
        assert "--find-links" not in text


def test_locks_hash_every_package() -> None:
    for path in LOCKS:
        if path.suffix == ".json":
            packages = json.loads(path.read_text(encoding="utf-8"))["packages"]
            assert not [name for name, entry in packages.items() if name and "integrity" not in entry]
            continue
        for requirement in re.split(r"\n(?=[A-Za-z0-9])", path.read_text(encoding="utf-8")):
            if re.match(r"[A-Za-z0-9_.-]+==", requirement):
                assert "--hash=sha256:" in requirement, requirement[:60]


def test_no_file_speaks_of_the_machine_it_was_written_on() -> None:
    found = []
    for path in tracked():
        if path.suffix not in TEXT or path.name.endswith(".lock") or path == ROOT / "LICENSE":
            continue
        if path.name in {"test_tracked_files.py", "package-lock.json"}:
            continue
        for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
            if PRIVATE.search(line):
                found.append(f"{shown(path)}:{number}: {line.strip()[:100]}")
    assert not found


def test_no_code_waits_to_be_written() -> None:
    marks = re.compile(r"\b(TODO|FIXME|XXX|HACK)\b|raise NotImplementedError")
    found = [
        f"{shown(path)}:{number}"
        for path in modules()
        for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1)
        if marks.search(line)
    ]
    assert not found


def test_what_make_builds_is_not_tracked() -> None:
    built = [
        shown(path)
        for path in tracked()
        if path.relative_to(ROOT).parts[0] in {".venv", "node_modules", "build", "dist"}
        or "vendor" in path.relative_to(ROOT).parts[:2]
    ]
    assert not built
