"""Joint limits on the wire."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Annotated, TypeAlias

from pydantic import Field

from service.schemas.base import Real

Range: TypeAlias = Annotated[list[Real | None], Field(min_length=2, max_length=2)]
JointRanges: TypeAlias = Annotated[
    list[Range | None],
    Field(
        max_length=64,
        description="[least, greatest] of each joint in the table's units; null where there is no limit",
    ),
]

DomainLimits: TypeAlias = list[tuple[float | None, float | None] | None]


def domain_limits(
    limits: Sequence[Sequence[float | None] | None] | None, units: Sequence[float]
) -> DomainLimits | None:
    """Return the limits in [rad] and in the table's length unit.

    Args:
        limits: as they were sent.
        units: for joint 1 … n what one unit of the request is; further limits are left to be refused.
    """
    if limits is None:
        return None
    factors = [*units, *([1.0] * (len(limits) - len(units)))]
    return [
        None if pair is None else (_scaled(pair[0], factor), _scaled(pair[1], factor))
        for pair, factor in zip(limits, factors, strict=False)
    ]


def _scaled(bound: float | None, factor: float) -> float | None:
    return None if bound is None else bound * factor
