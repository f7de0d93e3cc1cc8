"""OpenAPI Generator's Python client makes every call; its TypeScript client compiles.

The generator is a program in Java that its package on the index brings along; it and what its client needs
are in an environment of their own, which runs `generated_calls.py`.
"""

import json
import subprocess
import sys
import tempfile
from pathlib import Path

from service.settings import Settings
from tests.clients.calls import calls
from tests.document import DOCUMENT
from tests.live_service import running

HERE = Path(__file__).parent
COMPILER = HERE / "typescript" / "node_modules" / "typescript" / "bin" / "tsc"
PACKAGE = "generated_framewise"
UNWRITTEN = "all parts"
"""An example with link matrices, of which each may be null: the generated `to_dict` fails on lists in such a
list. The same call is made with its other example."""


def generate(program: Path, language: str, into: Path, *options: str) -> None:
    """Write a client."""
    document = into.parent / "openapi.json"
    document.write_text(json.dumps(DOCUMENT))
    command = [program, "generate", "-i", document, "-g", language, "-o", into, *options]
    subprocess.run(list(map(str, command)), check=True, stdout=subprocess.DEVNULL)


def make_calls(python: Path, folder: Path) -> list[str]:
    """Make every call of the document with the Python client; return what went wrong."""
    todo = [
        {
            "name": f"{call.method} {call.path}: {call.title}",
            "tag": call.operation["tags"][0],
            "operation": call.operation["operationId"],
            "values": call.values,
            "body": call.body,
        }
        for call in calls()
        if not call.title.startswith(UNWRITTEN)
    ]
    with running(Settings()) as origin:
        made = subprocess.run(
            [python, HERE / "generated_calls.py", PACKAGE, origin, folder],
            input=json.dumps(todo),
            stdout=subprocess.PIPE,
            text=True,
            check=True,
        )
    answers = [json.loads(line) for line in made.stdout.splitlines()]
    assert len(answers) == len(todo)
    faults = [f"{name}: {fault}" for name, fault in answers if fault]
    print(len(todo) - len(faults), "of", len(todo), "calls made with OpenAPI Generator's Python client")
    return faults


def compile_types(folder: Path) -> list[str]:
    """Compile the TypeScript client with strict types; return what the compiler finds."""
    options = ["--noEmit", "--strict", "--target", "es2020", "--module", "es2020"]
    options += ["--moduleResolution", "bundler", "--lib", "es2020,dom"]
    found = subprocess.run(
        ["node", COMPILER, *options, folder / "index.ts"], stdout=subprocess.PIPE, text=True, check=False
    )
    print("OpenAPI Generator's TypeScript client", "does not compile" if found.returncode else "compiles")
    return found.stdout.splitlines() or ["the compiler did not run"] * bool(found.returncode)


def main(environment: Path) -> int:
    """Generate both clients and use them."""
    program, python = environment / "openapi-generator-cli", environment / "python"
    with tempfile.TemporaryDirectory() as temporary:
        folder = Path(temporary)
        generate(program, "python", folder / "python", "--package-name", PACKAGE)
        generate(program, "typescript-fetch", folder / "typescript")
        faults = make_calls(python, folder / "python") + compile_types(folder / "typescript")
    print(*faults, sep="\n")
    return bool(faults)


if __name__ == "__main__":
    sys.exit(main(Path(sys.argv[1])))
