"""`python -m tests.kinematics.equivalence [--valid N] [--rounded N] [--wrong N] [--mended N] … [--jobs J]`.

Runs the campaigns at length and prints what came of them; the exit code is 1 if one missed its bar.
"""

import argparse
import os
import sys
import time
from collections.abc import Callable
from concurrent.futures import ProcessPoolExecutor

for variable in ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS"):
    os.environ.setdefault(variable, "1")

from tests.exercises.grading.answers_campaign import (  # noqa: E402
    accused_rows,
    hostile_answers,
    rounded_answers,
    wrong_names,
)
from tests.exercises.grading.campaign import mended_tables, repeated_entries, score_chains  # noqa: E402
from tests.kinematics.equivalence.campaign import (  # noqa: E402
    TABLES_PER_BLOCK,
    Outcome,
    rounded_tables,
    strict_tables,
    valid_tables,
    wrong_tables,
)

CAMPAIGNS: dict[str, tuple[Callable[[int], Outcome], int]] = {
    "valid": (valid_tables, 1_000_000),
    "strict": (strict_tables, 100_000),
    "rounded": (rounded_tables, 100_000),
    "wrong": (wrong_tables, 1_000_000),
    "mended": (mended_tables, 5_000),
    "answers": (rounded_answers, 100_000),
    "names": (wrong_names, 100_000),
    "hostile": (hostile_answers, 20_000),
    "chains": (score_chains, 10_000),
    "repeated": (repeated_entries, 10_000),
    "accused": (accused_rows, 5_000),
}
LARGEST_RESIDUAL = 1e-9
LEAST_SHARE = 0.99
LEAST_ACCUSED = 0.98
SHOWN = 20
SECONDS_BETWEEN_LINES = 60.0


def run(name: str, tables: int, jobs: int, first: int) -> bool:
    """Run one campaign and print what came of it; whether it kept its bar."""
    campaign, _ = CAMPAIGNS[name]
    blocks = -(-tables // TABLES_PER_BLOCK)
    total, shown = Outcome(), 0
    start = said = time.monotonic()
    with ProcessPoolExecutor(jobs) as pool:
        for outcome in pool.map(campaign, range(first, first + blocks), chunksize=4):
            total += outcome
            for failure in outcome.failures[: max(SHOWN - shown, 0)]:
                print("   " + failure, flush=True)
            shown += len(outcome.failures)
            now = time.monotonic()
            if now - said >= SECONDS_BETWEEN_LINES:
                said = now
                print(
                    f"   {name}: {total.tables} of {tables} tables in {now - start:.0f} s, "
                    f"{len(total.failures)} failures",
                    flush=True,
                )
    seconds = time.monotonic() - start
    kept = keeps_its_bar(name, total)
    print(f"{name}: {summary(name, total)}")
    rate = total.tables / seconds / jobs
    print(
        f"   {'passed' if kept else 'FAILED'} in {seconds:.0f} s, {rate:.0f} tables/s in each of {jobs} "
        f"processes; blocks {first} to {first + blocks - 1}"
    )
    print("   " + ", ".join(f"{kind} {count}" for kind, count in sorted(total.kinds.items())))
    sys.stdout.flush()
    return kept


def keeps_its_bar(name: str, total: Outcome) -> bool:
    """Whether a campaign came out as it must."""
    if not total.tables:
        return False
    if name == "mended":
        return min(total.mended, total.right_row) >= LEAST_SHARE * total.tables
    if name == "accused":
        return total.right_row >= LEAST_ACCUSED * total.tables
    return not total.failures and (name not in ("valid", "strict") or total.residual <= LARGEST_RESIDUAL)


def summary(name: str, total: Outcome) -> str:
    """What came of a campaign, in a line."""
    rejected, contradicted = (
        sum(failure.startswith(what) for failure in total.failures) for what in ("rejected", "certificate")
    )
    if name == "mended":
        tried = max(total.tables, 1)
        return (
            f"{total.tables} wrong tables with one mistake, {total.mended} mended by one edit "
            f"({total.mended / tried:.2%}), {total.right_row} in the right row "
            f"({total.right_row / tried:.2%}); {total.accepted} more were right in spite of it"
        )
    if name == "names":
        return (
            f"{total.tables} tables with a wrong name, {len(total.failures)} failures; {total.accepted} more "
            f"were right in spite of it, of whose certificates {total.confirmed} stand"
        )
    if name in ("chains", "repeated", "accused"):
        return f"{total.tables} tables, {total.right_row} in the right row, {len(total.failures)} failures"
    if name == "hostile":
        return f"{total.tables} tables, at most {total.residual:.2f} s, {len(total.failures)} failures"
    told = f"{total.tables} tables, {total.accepted} accepted"
    if name != "wrong":
        told += f", {rejected} rejected"
    if total.left_out:
        told += f", {total.left_out} left out ({total.left_out / (total.tables + total.left_out):.3%})"
    return (
        f"{told}; largest residual {total.residual:.1e}; of the certificates evaluated afresh "
        f"{total.confirmed} stand, {contradicted} do not"
    )


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
    results = [run(name, n, arguments["jobs"], arguments["first_block"]) for name, n in counts.items() if n]
    return 0 if all(results) else 1


if __name__ == "__main__":
    sys.exit(main())
