"""Joint values on the wire, one configuration or a batch, and joint limits."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Annotated, Any, TypeAlias

from pydantic import Discriminator, Field, Tag, WithJsonSchema

from service.http.validation import CHOICE
from service.schemas.base import LONGEST_LIST, Real

_ONE = {"type": "array", "items": {"type": "number"}, "maxItems": LONGEST_LIST}


def _shape_of(joints: Any) -> str:
    batch = isinstance(joints, list) and joints and isinstance(joints[0], list)
    return CHOICE + ("batch" if batch else "one")


Configuration: TypeAlias = Annotated[list[Real], Field(max_length=LONGEST_LIST, fail_fast=True)]
"""One value a joint. A batch may have millions: the first that is no number is named, and no more."""

Configurations: TypeAlias = Annotated[list[Configuration], Field(fail_fast=True)]

Joints: TypeAlias = Annotated[
    Annotated[list[Real], Field(max_length=LONGEST_LIST), Tag(CHOICE + "one")]
    | Annotated[Configurations, Tag(CHOICE + "batch")],
    Discriminator(_shape_of),
    WithJsonSchema(
        {
            "anyOf": [
                _ONE,
                {"type": "array", "minItems": 1, "items": _ONE},
            ],
            "description": "q_1 … q_n in joint order (fixed rows not counted), or a list of such lists",
        }
    ),
]


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
