"""A TypeScript client: types by openapi-typescript, every example checked by tsc and sent by openapi-fetch.

The tools have a lock of their own (tests/clients/typescript): the generator works with version 5 of the
compiler, and the pages are checked with a later one.
"""

import json
import os
import shutil
import subprocess
from pathlib import Path

import pytest

from tests.clients.calls import calls
from tests.document import DOCUMENT

TOOLS = Path(__file__).parent / "typescript"
MISSING = "node and npm cannot be had, or the tools of tests/clients/typescript cannot be installed"


def run(*command: str | Path, folder: Path, seconds: int = 300) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        [str(part) for part in command],
        cwd=folder,
        capture_output=True,
        text=True,
        timeout=seconds,
        check=False,
    )


@pytest.fixture(scope="module")
def tools() -> Path:
    """The folder with the tools of the lock, installed."""
    node, npm = shutil.which("node"), shutil.which("npm")
    installed = TOOLS / "node_modules" / ".package-lock.json"
    wanted = TOOLS / "package-lock.json"
    if node and npm and not (installed.exists() and installed.stat().st_mtime >= wanted.stat().st_mtime):
        run(npm, "ci", "--ignore-scripts", "--no-progress", "--loglevel=error", folder=TOOLS)
        if installed.exists():
            installed.touch()
    if not installed.exists():
        if os.environ.get("CI"):
            pytest.fail(MISSING)
        pytest.skip(MISSING)
    return TOOLS / "node_modules"


@pytest.fixture(scope="module")
def project(tools: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder for programs, with the types of the document in `schema.d.ts`."""
    folder = tmp_path_factory.mktemp("client")
    (folder / "openapi.json").write_text(json.dumps(DOCUMENT))
    (folder / "node_modules").symlink_to(tools)
    (folder / "package.json").write_text('{"type": "module"}')
    (folder / "tsconfig.json").write_text((TOOLS / "tsconfig.json").read_text())
    made = run(tools / ".bin/openapi-typescript", "openapi.json", "-o", "schema.d.ts", folder=folder)
    assert made.returncode == 0, made.stdout + made.stderr
    return folder


def program(address: str) -> str:
    """A program that makes every call of the document with its examples, and tells the statuses."""
    lines = [
        'import createClient from "openapi-fetch";',
        'import type { paths } from "./schema.js";',
        "declare const console: { log(text: string): void };",
        f"const client = createClient<paths>({{ baseUrl: {json.dumps(address)} }});",
        "const statuses: [string, number][] = [];",
    ]
    for i, call in enumerate(calls()):
        options = []
        if call.values:
            options.append(f"params: {{ path: {json.dumps(call.values)} }}")
        if call.body is not None:
            options.append(f"body: {json.dumps(call.body)}")
        given = f", {{ {', '.join(options)} }}" if options else ""
        lines += [
            f"const a{i} = await client.{call.method.upper()}({json.dumps(call.path)}{given});",
            f"if (a{i}.data === undefined) throw new Error(JSON.stringify(a{i}.error));",
            f"statuses.push([{json.dumps(f'{call.method} {call.path}')}, a{i}.response.status]);",
        ]
    return "\n".join([*lines, "console.log(JSON.stringify(statuses));", ""])


def test_every_call_is_typed_compiled_and_made(tools: Path, project: Path, base_url: str) -> None:
    (project / "program.ts").write_text(program(base_url))
    compiled = run(tools / ".bin/tsc", "-p", ".", folder=project)
    assert compiled.returncode == 0, compiled.stdout
    ran = run("node", "program.js", folder=project)
    assert ran.returncode == 0, ran.stderr
    statuses = json.loads(ran.stdout)
    assert len(statuses) == len(calls())
    assert {status for _, status in statuses} == {200}


def test_a_wrong_body_does_not_compile(tools: Path, project: Path) -> None:
    (project / "program.ts").write_text(
        'import createClient from "openapi-fetch";\nimport type { paths } from "./schema.js";\n'
        'const client = createClient<paths>({ baseUrl: "" });\n'
        'await client.POST("/api/v1/forward-kinematics", { body: { robot: 560, joints: [0] } });\n'
    )
    compiled = run(tools / ".bin/tsc", "-p", ".", "--noEmit", folder=project)
    assert compiled.returncode != 0
    assert "number" in compiled.stdout
    assert "string" in compiled.stdout
