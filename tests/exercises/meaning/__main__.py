"""`python -m tests.exercises.meaning [--answers N] [--seconds S] [--only KIND …] …`.

Judges answers whose truth is known, and prints how many were misjudged; the exit code is 1 if one was.
"""

import argparse
import os
import sys
import time
from concurrent.futures import ProcessPoolExecutor
from functools import partial
from itertools import count, islice

for variable in ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS"):
    os.environ.setdefault(variable, "1")

from tests.exercises.meaning.campaign_of_answers import CAMPAIGNS, Tally, judged_answers  # noqa: E402

ANSWERS_PER_BLOCK = 1000
SHOWN = 10


def main() -> int:
    """Run the campaigns that were asked for, or all of them."""
    parser = argparse.ArgumentParser(prog="python -m tests.exercises.meaning", description=__doc__)
    parser.add_argument("--answers", type=int, default=100_000, help="right ones and wrong ones, at least")
    parser.add_argument("--seconds", type=float, default=3600.0, help="of each kind, at most")
    parser.add_argument("--only", nargs="+", choices=CAMPAIGNS, default=list(CAMPAIGNS))
    parser.add_argument("--first-block", type=int, default=0)
    parser.add_argument("--jobs", type=int, default=os.cpu_count() or 1)
    asked = parser.parse_args()
    clean = True
    with ProcessPoolExecutor(asked.jobs) as pool:
        for name in asked.only:
            total, start, blocks = Tally(), time.monotonic(), count(asked.first_block)
            judge = partial(judged_answers, name, count=ANSWERS_PER_BLOCK)
            while min(total.right, total.wrong) < asked.answers and time.monotonic() - start < asked.seconds:
                for found in pool.map(judge, islice(blocks, asked.jobs)):
                    total += found
            print(f"{name}: {total.told}", *total.misjudged[:SHOWN], sep="\n   ", flush=True)
            clean &= not total.misjudged
    return 0 if clean else 1


if __name__ == "__main__":
    sys.exit(main())
