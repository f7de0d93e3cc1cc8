"""Files and functions are named for what they are about, and documented."""

import ast
import re
from collections.abc import Iterator

from tests.architecture.sources import PACKAGES, ROOT, modules, shown, tracked

NAMELESS = {"util", "utils", "helper", "helpers", "common", "core", "misc"}
LONGEST_BODY = 60
LONGEST_FILE = 400


def test_no_file_is_a_drawer_for_everything() -> None:
    drawers = [
        shown(path)
        for path in tracked()
        if path.relative_to(ROOT).parts[0] in {*PACKAGES, "static", "tests", "bench"}
        and {path.stem.lower(), *(part.lower() for part in path.relative_to(ROOT).parts[:-1])} & NAMELESS
    ]
    assert not drawers


def _public(tree: ast.Module) -> Iterator[ast.FunctionDef | ast.AsyncFunctionDef | ast.ClassDef]:
    pending: list[ast.AST] = list(tree.body)
    while pending:
        node = pending.pop()
        if isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef | ast.ClassDef):
            if node.name.startswith("_"):
                continue
            yield node
            if isinstance(node, ast.ClassDef):
                pending.extend(node.body)


def test_everything_public_is_documented() -> None:
    silent = [
        f"{shown(path)}:{node.lineno} {node.name}"
        for path, tree in modules().items()
        for node in _public(tree)
        if not ast.get_docstring(node)
    ]
    silent += [
        f"{shown(path)}: the module" for path, tree in modules().items() if not ast.get_docstring(tree)
    ]
    assert not silent


ALIKE = {
    "service",
    "service/adapters",
    "service/cli",
    "service/lti",
    "service/routes/courses",
    "service/routes/exercises",
    "service/routes/kinematics",
    "service/schemas/exercises",
    "service/schemas/kinematics",
}
"""Packages of modules with one shape, each named after what it serves."""


def test_a_large_package_says_what_is_where() -> None:
    """Its first lines name every module and no other, so that the list of files reads as the theory."""
    unread = []
    for package, tree in modules().items():
        folder = package.parent
        names = {path.stem for path in folder.glob("*.py")} - {"__init__"}
        if package.name != "__init__.py" or len(names) < 7 or shown(folder) in ALIKE:
            continue
        text = ast.get_docstring(tree) or ""
        unread += [
            f"{shown(folder)}: {name} is not named" for name in names if not re.search(rf"\b{name}\b", text)
        ]
        listed = re.findall(r"^ *((?:\w+, )*\w+)  +\S", text, re.MULTILINE)
        rooms = {path.name for path in folder.iterdir() if path.is_dir()}
        named = {name for line in listed for name in line.split(", ")}
        unread += [f"{shown(folder)}: there is no {name}" for name in named - names - rooms]
    assert not unread


def test_functions_and_files_stay_small() -> None:
    large = []
    for path, tree in modules().items():
        length = len(path.read_text(encoding="utf-8").splitlines())
        if length > LONGEST_FILE:
            large.append(f"{shown(path)}: {length} lines")
        for node in ast.walk(tree):
            if isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef) and node.end_lineno:
                first = node.body[1] if ast.get_docstring(node) and len(node.body) > 1 else node.body[0]
                body = node.end_lineno - first.lineno + 1
                if body > LONGEST_BODY:
                    large.append(f"{shown(path)}:{node.lineno} {node.name}: {body} lines")
    assert not large
