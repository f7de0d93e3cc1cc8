"""`python -m tests.kinematics.equivalence [--valid N] [--rounded N] [--wrong N] [--graded N] [--jobs J]`.

Runs the campaigns at length and prints what came of them; the exit code is 1 if anything failed.
"""

from __future__ import annotations

import argparse
import os
import sys
import time
from collections.abc import Callable
from concurrent.futures import ProcessPoolExecutor

for variable in ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS"):
    os.environ.setdefault(variable, "1")

from tests.exercises.grading.campaign import mended_tables  # noqa: E402
from tests.kinematics.equivalence.campaign import (  # noqa: E402
    TABLES_PER_BLOCK,
    Outcome,
    rounded_tables,
    valid_tables,
    wrong_tables,
)

CAMPAIGNS: dict[str, tuple[Callable[[int], Outcome], int]] = {
    "valid": (valid_tables, 1_000_000),
    "rounded": (rounded_tables, 100_000),
    "wrong": (wrong_tables, 1_000_000),
    "mended": (mended_tables, 20_000),
}
SHOWN = 20


def run(name: str, tables: int, jobs: int, first: int) -> bool:
    """Run one campaign; whether nothing failed."""
    campaign, _ = CAMPAIGNS[name]
    blocks = -(-tables // TABLES_PER_BLOCK)
    total = Outcome()
    start = time.monotonic()
    with ProcessPoolExecutor(jobs) as pool:
        for outcome in pool.map(campaign, range(first, first + blocks), chunksize=4):
            total += outcome
    print(
        f"{name}: {total.tables} tables in {time.monotonic() - start:.0f} s, {total.accepted} accepted, "
        f"{len(total.failures)} failures, largest residual {total.residual:.1e}"
    )
    print("   " + ", ".join(f"{kind} {count}" for kind, count in sorted(total.kinds.items())))
    for failure in total.failures[:SHOWN]:
        print("   " + failure)
    return not total.failures or name == "mended"


def main() -> int:
    """Run the campaigns that were asked for, or all of them."""
    parser = argparse.ArgumentParser(prog="python -m tests.kinematics.equivalence", description=__doc__)
    for name, (_, usual) in CAMPAIGNS.items():
        parser.add_argument(f"--{name}", type=int, metavar="N", help=f"tables; {usual} in a full run")
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    parser.add_argument("--first-block", type=int, default=0)
    arguments = vars(parser.parse_args())
    asked = {name: arguments[name] for name in CAMPAIGNS if arguments[name] is not None}
    counts = asked or {name: usual for name, (_, usual) in CAMPAIGNS.items()}
    results = [run(name, n, arguments["jobs"], arguments["first_block"]) for name, n in counts.items()]
    return 0 if all(results) else 1


if __name__ == "__main__":
    sys.exit(main())
