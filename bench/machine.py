"""What the figures were taken on: facts that matter to speed, and none that name the machine."""

import os
import platform
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path

ONE_THREAD = (
    "OMP_NUM_THREADS",
    "OPENBLAS_NUM_THREADS",
    "MKL_NUM_THREADS",
    "NUMEXPR_NUM_THREADS",
    "VECLIB_MAXIMUM_THREADS",
)
PEERS = {
    "roboticstoolbox-python": "roboticstoolbox-python",
    "pin": "pin",
    "EAIK": "eaik",
    "AutoDH": "AutoDH",
    "sympy": "sympy",
}


def use_one_thread() -> None:
    """Keep numerical libraries to one thread; takes effect only before they are imported."""
    for name in ONE_THREAD:
        os.environ[name] = "1"


def describe() -> str:
    """One line: processor, cores, Python, numpy and the peers' versions."""
    facts = [_processor(), f"{os.cpu_count()} cores, one used", f"CPython {platform.python_version()}"]
    facts += [f"{name} {found}" for name in ("numpy", *PEERS) if (found := _version(PEERS.get(name, name)))]
    return ", ".join(facts)


def _version(distribution: str) -> str | None:
    try:
        return version(distribution)
    except PackageNotFoundError:
        return None


def _processor() -> str:
    cpuinfo = Path("/proc/cpuinfo")
    if cpuinfo.exists():
        for line in cpuinfo.read_text(encoding="utf-8").splitlines():
            if line.startswith("model name"):
                return line.partition(":")[2].strip()
    return platform.machine()
