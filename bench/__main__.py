"""`python -m bench [module …]`: measure, print, and write docs/performance.md.

Without arguments every `bench_*.py` runs, each in a process of its own; the peers' environment must be the
one that runs it (`make bench` sees to that). `--quiet-page` prints without touching the page.
"""

from bench.machine import use_one_thread

use_one_thread()

import argparse  # noqa: E402  (threads are counted when numpy is imported, so its variables come first)
import importlib  # noqa: E402
import subprocess  # noqa: E402
import sys  # noqa: E402
from pathlib import Path  # noqa: E402

from bench.report import section, terminal, write  # noqa: E402

HERE = Path(__file__).resolve().parent


def modules() -> list[str]:
    """Names of all benchmark modules, `forward` for bench_forward.py."""
    return sorted(path.stem.removeprefix("bench_") for path in HERE.glob("bench_*.py"))


def run(name: str, *, page: bool) -> None:
    """Run one module and report."""
    module = importlib.import_module(f"bench.bench_{name}")
    outcomes = module.rows()
    print(f"\n{module.TITLE}\n{terminal(outcomes)}", flush=True)
    if page:
        write(name, section(name, module.TITLE, module.ABOUT, outcomes))


def main() -> int:
    """Run the modules that were asked for."""
    known = modules()
    parser = argparse.ArgumentParser(prog="python -m bench", description=__doc__)
    parser.add_argument("modules", nargs="*", metavar="module", help=f"any of: {', '.join(known)}")
    parser.add_argument("--quiet-page", action="store_true", help="leave docs/performance.md as it is")
    arguments = parser.parse_args()
    unknown = sorted(set(arguments.modules) - set(known))
    if unknown:
        parser.error(f"no such module: {', '.join(unknown)}; there are {', '.join(known)}")
    chosen = arguments.modules or known
    if len(chosen) == 1:
        run(chosen[0], page=not arguments.quiet_page)
        return 0
    flags = ["--quiet-page"] if arguments.quiet_page else []
    codes = [
        subprocess.run([sys.executable, "-m", "bench", name, *flags], cwd=HERE.parent, check=False).returncode
        for name in chosen
    ]
    return max(codes)


if __name__ == "__main__":
    sys.exit(main())
