"""The arms that roboticstoolbox describes by DH tables, where it is installed, as for the benchmarks."""

import inspect
from typing import Any

from kinematics.inverse.solve import MAX_JOINTS
from kinematics.table import Convention, DHTable
from tests.kinematics.robots import numeric


def toolbox_models() -> dict[str, DHTable]:
    """Its models by name, without their bases and tools."""
    import roboticstoolbox.models.DH as models

    made = (made() for made in vars(models).values() if inspect.isclass(made))
    return {f"toolbox {arm.name}": _table(arm) for arm in made if arm.n <= MAX_JOINTS}


def _table(arm: Any) -> DHTable:
    convention = Convention.MODIFIED if arm.mdh else Convention.STANDARD
    rows = (
        (
            "prismatic" if link.isprismatic else "revolute",
            float(link.alpha),
            float(link.a),
            0.0 if link.isprismatic else float(link.d),
            float(link.theta) if link.isprismatic else 0.0,
        )
        for link in arm.links
    )
    return numeric(convention, *rows)
