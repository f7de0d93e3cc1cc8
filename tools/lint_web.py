"""Check the pages' scripts and styles: eslint, prettier, and tsc over the JSDoc types.

Runs with the Node that `tools/vendor.py` found or brought, on the development packages that it installed.

    python tools/lint_web.py [--fix]      --fix lets prettier and eslint write
"""

import argparse
import subprocess
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))

import vendor

PRETTIER = ("static/js/**/*.js", "static/css/*.css", "tests/web/js/*.mjs", "types/*.d.ts", "eslint.config.js")


def commands(*, fix: bool) -> list[list[str]]:
    """Return the three programs with their arguments, each to be run by Node."""
    modules = vendor.MODULES
    return [
        [str(modules / "eslint" / "bin" / "eslint.js"), *(["--fix"] if fix else []), "."],
        [
            str(modules / "prettier" / "bin" / "prettier.cjs"),
            "--write" if fix else "--check",
            *("--log-level", "warn"),
            *PRETTIER,
        ],
        [str(modules / "typescript" / "bin" / "tsc"), "--project", "."],
    ]


def main() -> int:
    """Run all three and return 1 if one of them found something."""
    parser = argparse.ArgumentParser(description="Check static/ with eslint, prettier and tsc.")
    parser.add_argument("--fix", action="store_true", help="let prettier and eslint write")
    node = vendor.system_node() or vendor.wheel_node()
    found = [
        subprocess.run([node, *command], cwd=vendor.ROOT, check=False).returncode
        for command in commands(fix=parser.parse_args().fix)
    ]
    return int(any(found))


if __name__ == "__main__":
    sys.exit(main())
