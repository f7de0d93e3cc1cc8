"""Poses in numbers, matrices in closed form, and chains of frames, about tables of the students' own."""

import math
import random
from collections.abc import Iterator
from dataclasses import replace
from functools import cache
from itertools import pairwise

import numpy as np

from exercises.definition import Part
from exercises.instance import Instance, generate
from exercises.parts.joint_draws import key_numbers
from exercises.parts.rotations.frame_chain import FrameChainPart, path_between
from kinematics.cells import RawTable
from kinematics.table import JointType
from tests.exercises.meaning.answers_known import KnownAnswer, known, typed, typed_rows
from tests.exercises.meaning.own_tables import PlainTable, own_table, plain
from tests.exercises.packaged import exercise, table_ids

POSES = tuple(name for name in table_ids if exercise(name).part("pose") is not None)
Strings = list[list[str]]


@cache
def student(name: str, seed: int) -> Instance:
    """A student of an exercise."""
    return generate(exercise(name), seed)


def in_units(instance: Instance, joints: tuple[float, ...]) -> list[float]:
    """Joint values of the task, turns in [rad]."""
    degrees = instance.exercise.angle_unit.value == "deg"
    types = instance.exercise.reference.table.joint_types
    return [
        math.radians(q) if degrees and kind is JointType.REVOLUTE else float(q)
        for q, kind in zip(joints, types, strict=True)
    ]


def poses(rng: random.Random) -> Iterator[KnownAnswer]:
    """⁰T_N in numbers: it follows from the table, or one entry does not, or it is turned round."""
    instance = student(rng.choice(POSES), rng.randrange(30))
    raw, numbers = own_table(instance, rng)
    pose = numbers.pose(in_units(instance, instance.drawn["pose"]))
    yield known(True, instance, "pose", table=raw, pose=typed_rows(pose, rng, 5))
    for wrong in _spoilt(pose, numbers.reach, rng):
        yield known(False, instance, "pose", table=raw, pose=typed_rows(wrong, rng, 5))


def _spoilt(pose: np.ndarray, reach: float, rng: random.Random) -> Iterator[np.ndarray]:
    r, c = rng.randrange(3), rng.randrange(4)
    wrong = pose.copy()
    wrong[r, c] += rng.choice([-1, 1]) * rng.uniform(0.1, 0.7) * (reach if c == 3 else 1.0)
    yield wrong
    turned = pose.copy()
    turned[:3, :3] = pose[:3, :3].T
    if np.abs(turned - pose).max() > 0.1:
        yield turned
    if np.abs(np.linalg.inv(pose) - pose)[:3, :3].max() > 0.1:
        yield np.linalg.inv(pose)


def frame_chains(rng: random.Random) -> Iterator[KnownAnswer]:
    """The pose of one frame in another, from poses of any pairs of frames that lead there."""
    instance = student("stanford-frame-chain", rng.randrange(30))
    part = instance.exercise.part("frame_chain")
    assert isinstance(part, FrameChainPart)
    stops = rng.sample(range(7), rng.randint(2, 4))
    pairs = [(a, b) if rng.random() < 0.5 else (b, a) for a, b in pairwise(stops)]
    rng.shuffle(pairs)
    asked = stops[0], stops[-1]
    path = path_between(pairs, asked)
    assert path is not None
    instance = asking(instance, replace(part, known=tuple(pairs), asked=asked, path=path))
    numbers = plain(key_numbers(instance))
    frames = [frame.real for frame in numbers.frames(in_units(instance, instance.drawn["frame_chain"]))]
    pose = np.linalg.inv(frames[asked[0]]) @ frames[asked[1]]
    yield known(True, instance, "frame_chain", frame_chain=_cells(typed_rows(pose, rng)))
    for wrong in _spoilt(pose, numbers.reach, rng):
        yield known(False, instance, "frame_chain", frame_chain=_cells(typed_rows(wrong, rng)))


def _cells(rows: list[list[float | str]]) -> object:
    from exercises.parts.rotations.frame_chain import FrameChainCells

    return FrameChainCells(pose=rows)


def asking(instance: Instance, *parts: Part) -> Instance:
    """The same student, asked for something else of the same kind."""
    kinds = {part.kind: part for part in parts}
    asked = tuple(kinds.get(part.kind, part) for part in instance.exercise.parts)
    return replace(instance, exercise=replace(instance.exercise, parts=asked))


def closed_forms(rng: random.Random) -> Iterator[KnownAnswer]:
    """Matrices of the rows and, of short arms, their product, written out in names."""
    instance = student(rng.choice(POSES), rng.randrange(30))
    raw, numbers = own_table(instance, rng)
    links = [_link(raw, numbers, i) for i in range(len(raw.rows))]
    right = [_rewritten(link, rng) for link in links]
    yield known(True, instance, "link_matrices", table=raw, link_matrices=right)
    k = rng.randrange(len(links))
    wrong = [*right[:k], _with_wrong_entry(right[k], numbers.reach, rng), *right[k + 1 :]]
    yield known(False, instance, "link_matrices", table=raw, link_matrices=wrong)
    if len(links) < 5:
        whole = links[0]
        for link in links[1:]:
            whole = _product(whole, link)
        if max(len(cell) for row in whole for cell in row) < 1000:
            yield known(True, instance, "transform", table=raw, transform=_rewritten(whole, rng))
            spoilt = _with_wrong_entry(whole, numbers.reach, rng)
            yield known(False, instance, "transform", table=raw, transform=spoilt)


def _link(raw: RawTable, numbers: PlainTable, i: int) -> Strings:
    """The matrix of a row, by the formula that stands in every textbook, in the row's own cells."""
    row = raw.rows[i]
    t, w, d, a = (f"({row.theta})", f"({row.alpha})", f"({row.d})", f"({row.a})")
    c, s, ca, sa = f"cos{t}", f"sin{t}", f"cos{w}", f"sin{w}"
    last = ["0", "0", "0", "1"]
    if numbers.modified:
        return [
            [c, f"-{s}", "0", a],
            [f"{s}*{ca}", f"{c}*{ca}", f"-{sa}", f"-{d}*{sa}"],
            [f"{s}*{sa}", f"{c}*{sa}", ca, f"{d}*{ca}"],
            last,
        ]
    return [
        [c, f"-{s}*{ca}", f"{s}*{sa}", f"{a}*{c}"],
        [s, f"{c}*{ca}", f"-{c}*{sa}", f"{a}*{s}"],
        ["0", sa, ca, d],
        last,
    ]


def _product(first: Strings, second: Strings) -> Strings:
    return [
        [
            "+".join(
                f"({first[i][k]})*({second[k][j]})"
                for k in range(4)
                if "0" not in (first[i][k], second[k][j])
            )
            or "0"
            for j in range(4)
        ]
        for i in range(4)
    ]


def _rewritten(rows: Strings, rng: random.Random) -> Strings:
    found = [list(row) for row in rows]
    for _ in range(3):
        r, c = rng.randrange(3), rng.randrange(4)
        cell = found[r][c]
        found[r][c] = rng.choice(
            [
                f"({cell})*(sin(0.3)^2 + cos(0.3)^2)",
                f"2*({cell}) - ({cell})",
                f"0 + {cell}",
                cell.replace("*", "·") if "*" in cell else cell,
                cell.replace("cos(", "C("),
            ]
        )
    return found


def _with_wrong_entry(rows: Strings, reach: float, rng: random.Random) -> Strings:
    found = [list(row) for row in rows]
    r, c = rng.randrange(3), rng.randrange(4)
    step = typed(rng.choice([-1, 1]) * rng.uniform(0.1, 0.7) * (reach if c == 3 else 1.0), rng)
    # twice an angle stands in no pose of a chain, so that no other frames can make this right
    ways = [f"{found[r][c]} + ({step})*cos(q1)^2", f"({step})*cos(2*q1) + {found[r][c]}"]
    found[r][c] = rng.choice(ways if c == 3 else [*ways, f"{found[r][c]} + ({step})"])
    return found
