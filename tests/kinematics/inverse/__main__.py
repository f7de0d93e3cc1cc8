"""Inverse kinematics near singularities, of every model: python -m tests.kinematics.inverse --poses 10000."""

import argparse
import statistics
from collections.abc import Sequence

from tests.kinematics.inverse.campaign import run, run_arms
from tests.kinematics.inverse.models import MODELS
from tests.kinematics.inverse.toolbox import toolbox_models


def main(arguments: Sequence[str] | None = None) -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--poses", type=int, default=10_000, help="of every model")
    parser.add_argument(
        "--tried", type=int, default=1_000, help="complete answers tried by brute force, of every model"
    )
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--only", nargs="+", metavar="MODEL", default=[], help="names of models")
    parser.add_argument(
        "--toolbox",
        action="store_true",
        help="the models of roboticstoolbox instead, which is to be installed",
    )
    parser.add_argument(
        "--arms", type=int, default=0, help="one pose each of so many random arms beside a search, instead"
    )
    asked = parser.parse_args(arguments)
    if asked.arms:
        raise SystemExit(_searched(asked.arms, asked.seed))
    models = toolbox_models() if asked.toolbox else MODELS
    unknown = [name for name in asked.only if name not in models]
    if unknown:
        parser.error(f"no model is called {', '.join(unknown)}; there are {', '.join(models)}")
    faults = 0
    for name in asked.only or models:
        tally = run(name, models[name], asked.poses, asked.tried, asked.seed)
        faults += len(tally.faults)
        counts = (
            f"{tally.poses} poses, {tally.complete} complete, {tally.tried} tried, {tally.rough} too rough"
        )
        print(f"{name}: {counts}, {len(tally.faults)} faults {tally.faults[:6]}", flush=True)
    raise SystemExit(faults > 0)


def _searched(arms: int, seed: int) -> bool:
    tally, times = run_arms(arms, seed)
    print(
        f"{tally.poses} random arms, {tally.complete} answers complete, median processor time "
        f"{1e3 * statistics.median(times):.1f} ms, {len(tally.faults)} faults {tally.faults[:6]}"
    )
    return bool(tally.faults)


if __name__ == "__main__":
    main()
