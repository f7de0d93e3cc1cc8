"""The project's own files, as the guards see them."""

import ast
import subprocess
from functools import cache
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent.parent
PACKAGES = ("kinematics", "exercises", "courses", "service", "framewise")


@cache
def tracked() -> tuple[Path, ...]:
    """Every file under version control, and every new one that is not ignored."""
    listing = subprocess.run(
        ["git", "ls-files", "-z", "--cached", "--others", "--exclude-standard"],
        cwd=ROOT,
        capture_output=True,
        check=True,
    )
    paths = (ROOT / name.decode() for name in listing.stdout.split(b"\0") if name)
    return tuple(path for path in paths if path.is_file())


@cache
def modules() -> dict[Path, ast.Module]:
    """The syntax tree of every module of the three packages."""
    found: dict[Path, ast.Module] = {}
    for package in PACKAGES:
        for path in sorted((ROOT / package).rglob("*.py")):
            found[path] = ast.parse(path.read_text(encoding="utf-8"), str(path))
    return found


def shown(path: Path) -> str:
    """The path as it is written in a message."""
    return str(path.relative_to(ROOT))
