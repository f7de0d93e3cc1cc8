"""`make fuzz MINUTES=10`: all targets, for so long in total; guided by coverage where atheris is installed.

What is found is written to build/fuzz/ and told; put it into tests/fuzz/corpus/ with the mend.
"""

import argparse
import contextlib
import hashlib
import os
import subprocess
import sys
import time
import traceback
from pathlib import Path

from tests.fuzz.mutating import CORPUS, mutations

FOUND = Path("build") / "fuzz"
SECONDS = 60.0
LONGEST = 16384
"""Bytes of an input; a reader that has a fault at more has it at less."""


def main() -> int:
    """Run each target in a process of its own; return 1 if anything was found."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--minutes", type=float, default=1.0, help="in total")
    parser.add_argument("--only", nargs="*", help="targets; all, if left out")
    parser.add_argument("--target", help=argparse.SUPPRESS)
    parser.add_argument("--seconds", type=float, default=SECONDS, help=argparse.SUPPRESS)
    parser.add_argument("--seed", type=int, default=time.time_ns() % 1_000_000)
    options, rest = parser.parse_known_args()
    if options.target:
        return _fuzz(options.target, options.seconds, options.seed, rest)
    names = options.only or sorted(path.name for path in CORPUS.iterdir())
    share = options.minutes * SECONDS / len(names)
    failed = []
    for name in names:
        command = [sys.executable, "-m", "tests.fuzz", "--target", name]
        told = ["--seconds", f"{share:.1f}", "--seed", str(options.seed)]
        failed += [name] if subprocess.run([*command, *told]).returncode else []
    sys.stdout.write(f"{', '.join(failed)}: see {FOUND}\n" if failed else "nothing was found\n")
    return int(bool(failed))


def _fuzz(name: str, seconds: float, seed: int, rest: list[str]) -> int:
    FOUND.mkdir(parents=True, exist_ok=True)
    with contextlib.suppress(ImportError):
        import atheris

        with atheris.instrument_imports(include=["kinematics", "exercises", "service"]):
            from tests.fuzz.targets import run
        kept = FOUND / f"corpus-{name}"
        kept.mkdir(exist_ok=True)
        limits = [f"-max_total_time={max(1, round(seconds))}", f"-max_len={LONGEST}", f"-seed={seed}"]
        quiet = ["-verbosity=0", f"-artifact_prefix={FOUND}/{name}-", "-timeout=10", "-rss_limit_mb=4096"]
        atheris.Setup(
            [sys.argv[0], *limits, *quiet, *rest, str(kept), str(CORPUS / name)], lambda data: run(name, data)
        )
        sys.stdout.write(f"{name}: {seconds:.0f} s, guided by coverage\n")
        sys.stdout.flush()
        atheris.Fuzz()
        os._exit(0)
    from tests.fuzz.targets import run

    until, count = time.monotonic() + seconds, 0
    for data in mutations(name, seed):
        if time.monotonic() > until:
            break
        count += 1
        try:
            run(name, data)
        except Exception:
            file = FOUND / f"{name}-{hashlib.sha256(data).hexdigest()[:12]}"
            file.write_bytes(data)
            sys.stdout.write(f"{name}: {file}\n{traceback.format_exc()}\n")
            return 1
    sys.stdout.write(f"{name}: {count} inputs in {seconds:.0f} s, not guided: atheris is not installed\n")
    return 0


if __name__ == "__main__":
    sys.exit(main())
