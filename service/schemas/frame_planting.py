"""POST /plant-frame-mistake on the wire."""

from __future__ import annotations

from typing import Annotated

from pydantic import Field

from kinematics.table import Convention
from service.schemas.base import Wire
from service.schemas.exercises import FigureFrame, Seed
from service.schemas.frame_assignment_models import AxisModel


class PlantFrameMistakeRequest(Wire):
    """A robot by its joint axes, in one of whose frames a mistake is wanted."""

    axes: list[AxisModel] = Field(min_length=1, max_length=64, description="the joint axes, base first")
    convention: Annotated[Convention, Field(strict=False)]
    seed: Seed = Field(None, description="names a student or a try: the same seed plants the same mistake")


class PlantFrameMistakeAnswer(Wire):
    """Frames on a robot, one of them with a mistake."""

    frame: int = Field(description="which one is wrong, from 0")
    mistake: str = Field(description="what was planted: the rule that is broken, or y_left_handed")
    label: str = Field(description="what it is called, in the caller's language")
    frames: list[FigureFrame] = Field(description="frame 0 … N, in the coordinates of the axes")
    mended: FigureFrame = Field(description="the wrong frame as it should be")
