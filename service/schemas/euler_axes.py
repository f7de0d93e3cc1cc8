"""The axes of three angles on the wire."""

from __future__ import annotations

from typing import Annotated, TypeAlias

from pydantic import AfterValidator, Field
from pydantic_core import PydanticCustomError

from kinematics.errors import PoseError
from kinematics.rotations.sequences import EulerSequence


def _known(axes: str) -> str:
    try:
        return EulerSequence(axes=axes).axes
    except PoseError as error:
        fault = error.faults[0]
        raise PydanticCustomError(fault.code, "not a sequence of axes", dict(fault.params)) from None


EulerAxes: TypeAlias = Annotated[
    str,
    Field(
        description="three of X, Y, Z in the order of the angles; neighbours differ",
        json_schema_extra={"pattern": "^(XY[XZ]|XZ[XY]|YX[YZ]|YZ[XY]|ZX[YZ]|ZY[XZ])$"},
    ),
    AfterValidator(_known),
]
