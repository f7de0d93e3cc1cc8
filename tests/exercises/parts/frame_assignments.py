"""Frame assignments made at random: valid ones in every freedom, and ones with a single broken rule.

`python -m tests.exercises.parts.frame_assignments 100000` tries as many of each. Nothing here uses the rules
or the procedure: a frame is built from the two axes that it belongs to by plain vector algebra.
"""

import random
import sys
from dataclasses import dataclass

import numpy as np

from kinematics.frames.axes import JointAxis
from kinematics.frames.chosen_frames import ChosenFrame
from kinematics.frames.rules import Severity
from kinematics.frames.trainer import check_frames
from kinematics.table import Convention, JointType

Array = np.ndarray


@dataclass(frozen=True)
class Assignment:
    """Axes, a convention, frames; and the rule that is broken with the frame that breaks it, if one is."""

    axes: tuple[JointAxis, ...]
    convention: Convention
    frames: tuple[ChosenFrame, ...]
    broken: tuple[int, frozenset[str]] | None = None


def unit(v: Array) -> Array:
    return v / np.linalg.norm(v)


def some_direction(rng: random.Random) -> Array:
    return unit(np.array([rng.gauss(0, 1) for _ in range(3)]))


def some_axes(rng: random.Random) -> list[tuple[JointType, Array, Array]]:
    """A chain whose neighbouring axes are parallel, coincident, intersecting or skew."""
    axes = [(JointType.REVOLUTE, np.array([rng.uniform(-1, 1) for _ in range(3)]), some_direction(rng))]
    for _ in range(rng.randint(1, 6)):
        _, point, direction = axes[-1]
        kind = rng.choice(("parallel", "coincident", "intersecting", "skew", "prismatic"))
        along = point + rng.uniform(-1, 1) * direction
        across = unit(np.cross(direction, some_direction(rng)))
        tilt = rng.uniform(0.4, 2.7)
        turned = np.cos(tilt) * direction + np.sin(tilt) * np.cross(across, direction)
        sign = rng.choice((1.0, -1.0))
        if kind == "parallel":
            axes.append((JointType.REVOLUTE, along + rng.uniform(0.2, 1) * across, sign * direction))
        elif kind == "coincident":
            axes.append((JointType.REVOLUTE, along, sign * direction))
        elif kind == "intersecting":
            axes.append((JointType.REVOLUTE, along, turned))
        elif kind == "skew":
            axes.append((JointType.REVOLUTE, along + rng.uniform(0.2, 1) * across, turned))
        else:
            axes.append((JointType.PRISMATIC, along, turned))
    return axes


def valid(rng: random.Random) -> Assignment:
    """A valid assignment that uses every freedom that the convention leaves."""
    axes = some_axes(rng)
    convention = rng.choice(list(Convention))
    n = len(axes)
    frames: list[ChosenFrame] = []
    for i in range(n + 1):
        own = i if convention is Convention.MODIFIED else i + 1
        partner = i + 1 if convention is Convention.MODIFIED else i
        frames.append(
            _frame(
                axes[own - 1] if 1 <= own <= n else None,
                axes[partner - 1] if 1 <= partner <= n else None,
                rng,
            )
        )
    joints = tuple(JointAxis(joint=kind, point=point, direction=z) for kind, point, z in axes)
    return Assignment(joints, convention, tuple(frames))


def _frame(own: tuple | None, partner: tuple | None, rng: random.Random) -> ChosenFrame:
    free = rng.uniform(-2, 2)
    if own is None and partner is not None:
        # z is free: x crosses the neighbouring axis at right angles somewhere, z lies anywhere across x
        _, point, direction = partner
        x = unit(np.cross(direction, some_direction(rng)))
        origin = point + free * direction + rng.uniform(-1, 1) * x
        return ChosenFrame(origin=origin, x=x, z=unit(np.cross(x, some_direction(rng))))
    assert own is not None
    _, p, z = own
    z = z * rng.choice((1.0, -1.0))
    if partner is None:
        return ChosenFrame(origin=p + free * z, x=unit(np.cross(z, some_direction(rng))), z=z)
    _, q, w = partner
    across = np.cross(z, w)
    if np.linalg.norm(across) > 1e-6:
        # the lines of sliding axes were drawn through points where they belong
        t = np.linalg.solve(np.stack([z, -w, across], axis=1), q - p)
        return ChosenFrame(origin=p + t[0] * z, x=unit(across) * rng.choice((1.0, -1.0)), z=z)
    apart = (q - p) - ((q - p) @ z) * z
    x = unit(apart) if np.linalg.norm(apart) > 1e-6 else unit(np.cross(z, some_direction(rng)))
    return ChosenFrame(origin=p + free * z, x=x * rng.choice((1.0, -1.0)), z=z)


def with_one_broken_rule(rng: random.Random) -> Assignment:
    """A valid assignment of turning joints in which one frame breaks one rule."""
    made = valid(rng)
    while any(axis.joint is JointType.PRISMATIC for axis in made.axes):
        made = valid(rng)
    n = len(made.axes)
    modified = made.convention is Convention.MODIFIED
    i = rng.randrange(1, n + 1) if modified else rng.randrange(n)
    frame = made.frames[i]
    x, z, origin = (np.array(vector) for vector in (frame.x, frame.z, frame.origin))
    how = rng.choice(("z", "origin", "x"))
    if how == "z":
        tilted = unit(z + rng.uniform(0.05, 0.5) * np.cross(z, x))
        changed = ChosenFrame(origin=origin, x=x, z=tilted)
        rules = {"z_not_along_axis"}
    elif how == "origin":
        changed = ChosenFrame(origin=origin + rng.uniform(0.05, 0.5) * np.cross(z, x), x=x, z=z)
        rules = {"origin_not_on_axis"}
    else:
        changed = ChosenFrame(origin=origin, x=unit(x + rng.uniform(0.05, 0.5) * z), z=z)
        rules = {"x_not_across_z"}
    frames = (*made.frames[:i], changed, *made.frames[i + 1 :])
    return Assignment(made.axes, made.convention, frames, (i, frozenset(rules)))


def rounded(made: Assignment, digits: int) -> Assignment:
    """The assignment with every number rounded."""
    frames = tuple(
        ChosenFrame(
            **{name: [round(float(c), digits) for c in getattr(f, name)] for name in ("origin", "x", "z")}
        )
        for f in made.frames
    )
    return Assignment(made.axes, made.convention, frames, made.broken)


def broken_rules(made: Assignment, rounding: float = 0.0) -> dict[int, set[str]]:
    """The rules that the checker finds broken, by frame."""
    found = check_frames(made.axes, made.convention, made.frames, rounding=rounding)
    return {
        frame.index: rules
        for frame in found.frames
        if (rules := {f.rule.value for f in frame.findings if f.severity is Severity.BROKEN})
    }


def campaign(count: int, seed: int = 0) -> tuple[int, int]:
    """How many of `count` valid assignments were refused, and how many broken ones not told as they are."""
    rng = random.Random(seed)
    refused = unnamed = 0
    for _ in range(count):
        made = valid(rng)
        refused += bool(broken_rules(made))
        wrong = with_one_broken_rule(rng)
        assert wrong.broken is not None
        index, rules = wrong.broken
        unnamed += not rules <= broken_rules(wrong).get(index, set())
    return refused, unnamed


if __name__ == "__main__":
    print(campaign(int(sys.argv[1]) if len(sys.argv) > 1 else 1000))
