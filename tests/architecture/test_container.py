"""The container without a container engine: the steps of the Dockerfile, done one after the other in folders.

Each stage gets a folder for its root; absolute paths of the Dockerfile are moved below it; COPY sees only
what .dockerignore lets through; RUN runs in a shell whose `python` is this machine's. What only an engine can
do, making the user, the stage `system` and installing the system's tools, is checked on paper; `make image`
does it with one. Stages that depend on locks alone are kept under build/, named by what they were made from.
"""

import fnmatch
import hashlib
import json
import os
import re
import shlex
import shutil
import subprocess
import sys
import tempfile
from collections.abc import Iterator
from dataclasses import dataclass, field
from pathlib import Path

import pytest
from babel.core import get_global

from service.messages import REGIONS, languages
from tests.architecture.serving import fetched, reserved_port, serving
from tests.architecture.sources import ROOT

pytestmark = pytest.mark.timeout(900)

DOCKERFILE = ROOT / "Dockerfile"
KEPT = ROOT / "build" / "container"
LARGEST_PACKAGES = 155_000_000
"""Bytes of all installed packages: what they weigh now, and a little more."""


@dataclass
class Stage:
    name: str
    steps: list[tuple[str, str]] = field(default_factory=list)

    def last(self, keyword: str) -> str:
        return [rest for key, rest in self.steps if key == keyword][-1]


def stages() -> dict[str, Stage]:
    text = re.sub(r"^#.*\n", "", DOCKERFILE.read_text(encoding="utf-8"), flags=re.MULTILINE)
    found: dict[str, Stage] = {}
    current = Stage("")
    for line in re.sub(r"\\\n\s*", "", text).splitlines():
        keyword, _, rest = line.strip().partition(" ")
        if keyword == "FROM":
            current = found.setdefault(rest.split(" AS ")[1], Stage(rest.split(" AS ")[1]))
        elif keyword:
            current.steps.append((keyword, rest.strip()))
    return found


def in_context(path: Path) -> bool:
    """Whether .dockerignore lets a file of the checkout into the build."""
    name = path.relative_to(ROOT).as_posix()
    kept = True
    for line in (ROOT / ".dockerignore").read_text(encoding="utf-8").splitlines():
        pattern = line.strip()
        if not pattern or pattern.startswith("#"):
            continue
        bare = pattern.removeprefix("!").removeprefix("**/")
        parents = [name, *(parent.as_posix() for parent in path.relative_to(ROOT).parents)]
        anywhere = [name, *path.relative_to(ROOT).parts] if "**/" in pattern else parents
        if any(fnmatch.fnmatchcase(candidate, bare) for candidate in anywhere if candidate != "."):
            kept = pattern.startswith("!")
    return kept


class Builder:
    """Carries out the steps of stages."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder
        self.shims = folder / "bin"
        self.shims.mkdir(parents=True)
        (self.shims / "python").write_text(f'#!/bin/sh\nexec {shlex.quote(sys.executable)} "$@"\n')
        (self.shims / "python").chmod(0o755)

    def root(self, stage: str) -> Path:
        return self.folder / stage

    def build(self, stage: Stage) -> None:
        root = self.root(stage.name)
        root.mkdir()
        work = root
        for keyword, rest in stage.steps:
            if keyword == "WORKDIR":
                work = root / rest.lstrip("/")
                work.mkdir(parents=True, exist_ok=True)
            elif keyword == "COPY":
                self.copy(rest, root, work)
            elif keyword == "RUN" and not rest.startswith(("useradd", "apt-get")):
                self.run(rest, root, work)

    def copy(self, rest: str, root: Path, work: Path) -> None:
        words = shlex.split(rest)
        origin = ROOT
        if words[0] == "--from=system":  # this machine's system stands for it
            return
        if words[0].startswith("--from="):
            origin = self.root(words.pop(0).removeprefix("--from="))
        *sources, target = words
        destination = root / target.lstrip("/") if target.startswith("/") else work / target
        for source in sources:
            path = origin / source.lstrip("/")
            assert path.exists(), f"COPY {rest}: there is no {source}"
            if path.is_dir():
                ignore = self.ignored if origin == ROOT else None
                copy = shutil.copy2 if origin == ROOT else linked_or_copied
                shutil.copytree(
                    path, destination, symlinks=True, dirs_exist_ok=True, ignore=ignore, copy_function=copy
                )
            else:
                assert origin != ROOT or in_context(path), f"COPY {rest}: .dockerignore leaves out {source}"
                into = destination / path.name if target.endswith("/") else destination
                into.parent.mkdir(parents=True, exist_ok=True)
                shutil.copy2(path, into)

    @staticmethod
    def ignored(folder: str, names: list[str]) -> set[str]:
        return {name for name in names if not in_context(Path(folder) / name)}

    def run(self, command: str, root: Path, work: Path) -> None:
        moved = re.sub(r"(?<![\w.])/opt/", f"{shlex.quote(str(root))}/opt/", command)
        subprocess.run(
            ["bash", "-ec", moved],
            cwd=work,
            env={**os.environ, "PATH": f"{self.shims}:{os.environ['PATH']}"},
            check=True,
        )


def linked_or_copied(source: str, target: str) -> None:
    """Layers share their files."""
    try:
        os.link(source, target)
    except OSError:
        shutil.copy2(source, target)


def fingerprint() -> str:
    digest = hashlib.sha256(sys.version.encode())
    for name in ("requirements.lock", "requirements-node.lock", "package-lock.json", "tools/vendor.py"):
        digest.update((ROOT / name).read_bytes())
    for name in ("vendor", "packages"):
        digest.update(repr(stages()[name]).encode())
    return digest.hexdigest()[:16]


@pytest.fixture(scope="module")
def image() -> Iterator[Path]:
    """The root of the last stage."""
    parsed = stages()
    kept = KEPT / fingerprint()
    if not kept.exists():
        for old in KEPT.glob("[0-9a-f]*"):
            shutil.rmtree(old, ignore_errors=True)
        partial = KEPT / f"partial-{os.getpid()}"
        builder = Builder(partial)
        builder.build(parsed["vendor"])
        builder.build(parsed["packages"])
        shutil.rmtree(partial / "vendor" / "opt")
        shutil.rmtree(partial / "vendor" / "build" / "node_modules")
        if kept.exists():  # somebody else has built the same meanwhile
            shutil.rmtree(partial)
        else:
            partial.rename(kept)
    with tempfile.TemporaryDirectory() as folder:
        Path(folder).chmod(0o755)
        builder = Builder(Path(folder) / "image")
        for name in ("vendor", "packages"):
            builder.root(name).symlink_to(kept / name)
        builder.build(parsed["service"])
        yield builder.root("service")


def environment(image: Path) -> dict[str, str]:
    settings = [rest for key, rest in stages()["service"].steps if key == "ENV"]
    variables = dict(word.split("=", 1) for rest in settings for word in shlex.split(rest))
    variables["FRAMEWISE_DATA_FOLDER"] = str(image / "data")
    variables["PATH"] = variables["PATH"].replace("/opt/", f"{image}/opt/") + f":{os.environ['PATH']}"
    return variables


def test_hadolint_finds_nothing() -> None:
    result = subprocess.run(
        [Path(sys.executable).parent / "hadolint", str(DOCKERFILE)],
        capture_output=True,
        text=True,
        check=False,
    )
    assert result.returncode == 0, result.stdout


def test_the_base_image_can_be_pinned_to_a_digest() -> None:
    text = DOCKERFILE.read_text(encoding="utf-8")
    assert re.search(r"^ARG PYTHON_IMAGE=python:3\.\d+-", text, re.MULTILINE)
    assert set(re.findall(r"^FROM (\S+)", text, re.MULTILINE)) == {"${PYTHON_IMAGE}", "scratch"}


def test_it_does_not_run_as_root() -> None:
    service, system = stages()["service"], stages()["system"]
    user = service.last("USER").split(":")[0]
    assert user.isdigit()
    assert int(user) > 0
    assert f"--uid {user} " in next(rest for key, rest in system.steps if key == "RUN")
    assert [key for key, _ in service.steps].index("USER") > max(
        i for i, (key, _) in enumerate(service.steps) if key in {"RUN", "COPY"}
    )


def installs(stage: Stage) -> list[str]:
    """The steps of a stage that install packages of Python."""
    return [rest for key, rest in stage.steps if key == "RUN" and re.search(r"\bpip\b.* install ", rest)]


def test_everything_is_installed_from_hash_locks() -> None:
    found = [install for stage in stages().values() for install in installs(stage)]
    assert len(found) == 2
    assert all("--require-hashes" in install for install in found)


def test_an_image_can_be_built_that_sends_traces() -> None:
    """By its own lock: the service's packages as they are, and those of the extra beside them."""

    def locked(name: str) -> set[str]:
        return set(re.findall(r"^\S+==\S+", (ROOT / name).read_text(encoding="utf-8"), flags=re.MULTILINE))

    added = locked("requirements-telemetry.lock") - locked("requirements.lock")
    assert locked("requirements.lock") <= locked("requirements-telemetry.lock")
    named = {line.partition("==")[0] for line in added}
    assert {"opentelemetry-sdk", "opentelemetry-exporter-otlp-proto-http"} <= named
    (install,) = installs(stages()["packages"])
    assert '-r "${LOCK:-requirements.lock}"' in install


def locales(name: str) -> Iterator[str]:
    """A locale and those whose data it inherits."""
    while name != "root":
        yield name
        name = get_global("parent_exceptions").get(name) or name.rpartition("_")[0] or "root"


def test_the_image_counts_and_dates_in_every_language() -> None:
    (install,) = installs(stages()["packages"])
    regions = {name for region in REGIONS.values() for name in locales(region)}
    assert set(re.findall(r"! -name (\w+)\.dat", install)) == {"root", *languages(), *regions}


def test_the_image_holds_what_it_serves_and_nothing_more(image: Path) -> None:
    app = image / "app"
    assert {path.name for path in app.iterdir()} == {
        "LICENSE", "README.md", "kinematics", "exercises", "courses", "service", "static",
    }  # fmt: skip
    assert (app / "static" / "vendor" / "three").is_dir()
    assert not list((app / "static").rglob("axe.*")), "what only tests need is left out"
    assert not (image / "opt" / "framewise" / "bin" / "pip").exists()


def test_the_command_serves_and_the_health_check_agrees(image: Path) -> None:
    service = stages()["service"]
    command = json.loads(service.last("CMD"))
    check = json.loads(service.last("HEALTHCHECK").split(" CMD ")[1])
    user = unprivileged(image, service)
    command[0] = check[0] = str(image / "opt" / "framewise" / "bin" / command[0])

    with reserved_port() as port:
        variables = {**environment(image), "FRAMEWISE_PORT": str(port)}

        def healthy() -> bool:
            done = subprocess.run(check, cwd=image / "app", env=variables, user=user, check=False)
            return done.returncode == 0

        assert not healthy()
        with serving(command, cwd=image / "app", environment=variables, user=user) as address:
            assert fetched(address, "/api/v1/openapi.json")[0] == 200
            assert fetched(address, "/")[0] == 200
            assert any(healthy() for _ in range(20))  # each waits for seconds: too few on a busy machine
    assert not list((image / "app").rglob("*.log"))


def unprivileged(image: Path, service: Stage) -> int | None:
    """The image's user, where this process may become it and that user can run this Python."""
    if os.geteuid() != 0:
        return None
    user = int(service.last("USER").split(":")[0])
    python = image / "opt" / "framewise" / "bin" / "python"
    try:
        subprocess.run([python, "-c", ""], user=user, check=True, cwd="/", capture_output=True)
    except (OSError, subprocess.CalledProcessError):
        return None
    return user


def test_the_packages_hold_nothing_that_is_not_run(image: Path) -> None:
    packages = next((image / "opt" / "framewise" / "lib").glob("python3*/site-packages"))
    assert not [path for path in packages.rglob("tests") if path.is_dir()]
    assert not list(packages.rglob("*.pyi"))
    assert not list(packages.rglob("*.py")), "of what is compiled, the sources are left out"
    weight = sum(path.stat().st_size for path in packages.rglob("*") if path.is_file())
    assert weight < LARGEST_PACKAGES, f"{weight / 1e6:.0f} MB"
