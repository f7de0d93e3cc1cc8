"""Mistakes in frames: exactly one is made, and whatever gives the rows of a table mends it."""

import pytest

from kinematics.frames.assignment import assign_frames
from kinematics.frames.wrong_frames import (
    FRAME_MISTAKES,
    LEFT_HANDED,
    DrawnFrame,
    frame_mistakes,
    plantable_in_frames,
    right_handed,
)
from kinematics.table import Convention
from tests.kinematics.frames.test_assignment import PUMA


@pytest.mark.parametrize("convention", list(Convention))
def test_one_thing_is_wrong_with_one_frame(convention: Convention) -> None:
    assigned = assign_frames(PUMA, convention)
    frames = [right_handed(frame.origin, frame.x, frame.z) for frame in assigned.frames]
    assert not any(frame_mistakes(PUMA, convention, frames))
    ways = plantable_in_frames(PUMA, convention, frames)
    assert len(ways) > 6
    assert set(ways) <= set(FRAME_MISTAKES)
    for code, found in ways.items():
        for way in found:
            wrong = {i: w for i, w in enumerate(frame_mistakes(PUMA, convention, way.shown)) if w}
            assert wrong == {way.index: {code}}
            assert way.right == frames[way.index]


def test_a_y_that_is_no_direction_is_wrong() -> None:
    assigned = assign_frames(PUMA, Convention.STANDARD)
    frames = [right_handed(frame.origin, frame.x, frame.z) for frame in assigned.frames]
    first = frames[0]
    for y in ((0.0, 0.0, 0.0), first.x, (-first.y[0], -first.y[1], -first.y[2])):
        shown = [DrawnFrame(first.origin, first.x, y, first.z), *frames[1:]]
        assert frame_mistakes(PUMA, Convention.STANDARD, shown)[0] == {LEFT_HANDED}
