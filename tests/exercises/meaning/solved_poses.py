"""Configurations that reach a pose, by triangles, for arms of parallel links with a spherical wrist or none.

Every configuration is evaluated by the product of the printed matrices; none is missing, for each of the
equations below has exactly the roots that are taken.
"""

import math
import random
from collections.abc import Iterator
from dataclasses import replace
from typing import Any

import numpy as np

from exercises.answers import RawAnswer, parse
from exercises.grader import grade
from exercises.instance import Instance
from exercises.parts.inverse.joint_cells import JointAnswerCells
from exercises.parts.inverse.pose_question import DrawnPose, InverseKinematicsPart
from exercises.parts.joint_draws import PoseCase, key_numbers
from exercises.written_table import written_table
from kinematics.answers.joint_verdicts import JointClaim
from tests.exercises.meaning.answers_known import KnownAnswer, other_than, typed, typed_angle
from tests.exercises.meaning.own_tables import PlainTable, plain
from tests.exercises.meaning.posed_answers import asking, in_units, student

EXERCISES = ("puma560-inverse", "rx90-inverse", "scara-inverse", "scara-own-inverse", "twolink-inverse")
CLEAR = 0.05
Rows = list[list[float]]


def joint_values(rng: random.Random) -> Iterator[KnownAnswer]:
    """One solution, all, infinitely many with their condition, or none, as it is asked."""
    found = student(rng.choice(EXERCISES), rng.randrange(60))
    part = found.exercise.part("inverse_kinematics")
    assert isinstance(part, InverseKinematicsPart)
    every = rng.random() < 0.7
    drawn: DrawnPose = found.drawn["inverse_kinematics"]
    turning = len(drawn.joints) == 6
    if turning and rng.random() < 0.2:
        drawn = replace(drawn, joints=(*drawn.joints[:4], type(drawn.joints[0])(0), drawn.joints[5]))
    instance = replace(
        asking(found, replace(part, every=every)), drawn={**found.drawn, "inverse_kinematics": drawn}
    )
    numbers = plain(key_numbers(instance))
    joints = in_units(instance, drawn.joints)
    own = _own(instance, rng)
    if drawn.case is PoseCase.OUT_OF_REACH:
        yield _handed_in(instance, True, own, [], JointClaim.OUT_OF_REACH, rng)
        yield _handed_in(instance, False, own, [joints], JointClaim.FINITE, rng)
        yield _handed_in(instance, False, own, [joints], JointClaim.INFINITE, rng)
        return
    rows, combination = solutions(numbers, joints)
    for row in rows:
        off = np.abs(numbers.pose(row) - numbers.pose(joints))
        assert off[:3, 3 if len(joints) == 2 else slice(4)].max() < 1e-6
    rng.shuffle(rows)
    claim = JointClaim.FINITE if combination is None else JointClaim.INFINITE
    kept = rows if every else rows[:1]
    factor = rng.choice([-2, -1, 1, 3])
    conditions = [] if combination is None else [[factor * c for c in combination]]
    k, joint = rng.randrange(len(kept)), rng.randrange(len(joints))
    step = rng.choice([-1, 1]) * rng.uniform(CLEAR, 3.0)
    if numbers.rows[joint].slides:
        step *= numbers.reach / 3
    if combination is not None and combination[joint]:
        joint = 0
    bad = [*kept[:k], other_than(kept[k], joint, step), *kept[k + 1 :]]
    yield _handed_in(instance, True, own, kept, claim, rng, conditions)
    yield _handed_in(instance, False, own, bad, claim, rng, conditions)
    yield _handed_in(instance, False, own, [], JointClaim.OUT_OF_REACH, rng)
    if every:
        yield _handed_in(instance, True, own, [*kept, kept[k]], claim, rng, conditions)
        yield _handed_in(instance, False, own, [*kept, bad[k]], claim, rng, conditions)
        other = JointClaim.INFINITE if claim is JointClaim.FINITE else JointClaim.FINITE
        yield _handed_in(instance, False, own, kept, other, rng, conditions)
        if len(kept) > 1:
            yield _handed_in(instance, False, own, kept[:k] + kept[k + 1 :], claim, rng, conditions)
        if combination is not None:
            turned = [[-c if i == 3 else c for i, c in enumerate(combination)]]
            yield _handed_in(instance, False, own, kept, claim, rng)
            yield _handed_in(instance, False, own, kept, claim, rng, turned)


Own = tuple[Any, list[int], list[float]]


def _own(instance: Instance, rng: random.Random) -> Own:
    """A table with variables of one's own, if one is asked, their senses and their zeros [rad, length]."""
    types = instance.exercise.reference.table.joint_types
    if instance.exercise.part("table") is None:
        return None, [1] * len(types), [0.0] * len(types)
    degrees = instance.exercise.angle_unit.value == "deg"
    key = written_table(instance.exercise.reference)
    signs, zeros, rows = [], [], []
    for i, row in enumerate(key.rows, 1):
        cell = "d" if types[i - 1].value == "prismatic" else "theta"
        sign, zero = rng.choice([1, -1]), rng.randint(-120, 120)
        if cell == "d":
            zero = 0
        shown = f"{zero}" if degrees else f"{zero}*pi/180"
        text = str(getattr(row, cell)).replace(f"q{i}", f"({'' if sign > 0 else '-'}q{i} + {shown})")
        rows.append(replace(row, **{cell: text, "joint": None}))
        signs.append(sign)
        # q = sign·own + zero
        zeros.append(float(np.radians(zero)))
    return replace(key, rows=tuple(rows)), signs, zeros


def _handed_in(
    instance: Instance,
    right: bool,
    own: Own,
    rows: Rows,
    claim: JointClaim,
    rng: random.Random,
    conditions: Rows | None = None,
) -> KnownAnswer:
    table, signs, zeros = own
    degrees = instance.exercise.angle_unit.value == "deg"
    types = instance.exercise.reference.table.joint_types
    cells = JointAnswerCells(
        claim=claim,
        solutions=tuple(
            tuple(
                typed(s * (q - z), rng, 5)
                if kind.value == "prismatic"
                else typed_angle(s * (q - z), degrees, rng)
                for q, s, z, kind in zip(row, signs, zeros, types, strict=True)
            )
            for row in rows
        ),
        combinations=tuple(tuple(s * c for s, c in zip(signs, row, strict=True)) for row in conditions or []),
    )
    parts: dict[str, Any] = {"inverse_kinematics": cells}
    if table is not None:
        parts["table"] = table

    def judge() -> bool:
        report = grade(instance, parse(instance, RawAnswer(**parts)), drawn=False)
        return next(part for part in report.parts if part.kind == "inverse_kinematics").correct

    return KnownAnswer(
        right, judge, lambda: f"{instance.exercise.id} {instance.seed} {instance.drawn} {parts}"
    )


def solutions(table: PlainTable, joints: list[float]) -> tuple[Rows, list[float] | None]:
    """All configurations with the pose of one, and of infinitely many what stays the same along them."""
    if len(joints) == 6:
        return _with_a_wrist(table, joints)
    lengths = [row.a for row in table.rows if row.a]
    inside = math.atan2(lengths[1] * math.sin(joints[1]), lengths[0] + lengths[1] * math.cos(joints[1]))
    other = [*joints]
    other[0], other[1] = joints[0] + 2 * inside, -joints[1]
    if len(joints) == 4:
        sense = round(float(table.pose([0.0] * 4)[2, 2]))
        other[3] = joints[3] + sense * (joints[0] + joints[1] - other[0] - other[1])
    return [list(joints), other], None


def _with_a_wrist(table: PlainTable, joints: list[float]) -> tuple[Rows, list[float] | None]:
    """Two shoulders, two elbows, two wrists, of arms with parallel axes 2 and 3 and a_1 = d_1 = d_6 = 0."""
    target = table.pose(joints)
    if not table.modified:
        links = [(0.0, 0.0), *((row.alpha, row.a) for row in table.rows[:-1])]
        shifted = [
            replace(row, alpha=link[0], a=link[1]) for row, link in zip(table.rows, links, strict=True)
        ]
        table = PlainTable(modified=True, rows=tuple(shifted))
        assert np.allclose(table.pose(joints), target)
    rows = table.rows
    twist, length = rows[1].alpha, rows[2].a
    ca, sa = math.cos(twist), math.sin(twist)
    end = rows[3]
    wrist = np.array([end.a, -end.d * math.sin(end.alpha), end.d * math.cos(end.alpha)])
    aside = rows[1].d + rows[2].d + wrist[2]
    x, y, z = target[:3, 3]
    across = (ca * z - aside) / sa
    found: Rows = []
    for way in (1, -1):
        along = way * math.sqrt(x * x + y * y - across * across)
        first = math.atan2(y, x) - math.atan2(across, along)
        up = ca * across + sa * z
        rho, reach2 = math.hypot(wrist[0], wrist[1]), along * along + up * up
        bent = math.acos((reach2 - length * length - rho * rho) / (2 * length * rho))
        for elbow in (bent, -bent):
            third = elbow - math.atan2(wrist[1], wrist[0])
            second = math.atan2(up, along) - math.atan2(rho * math.sin(elbow), length + rho * math.cos(elbow))
            heads = [q - row.theta for q, row in zip((first, second, third), rows, strict=False)]
            links = table.links([*heads, 0.0, 0.0, 0.0])
            before = (links[0] @ links[1] @ links[2]).real
            found += _wrists(table, before[:3, :3].T @ target[:3, :3], heads)
    if abs(math.sin(joints[4] + rows[4].theta)) > 1e-9:
        return found, None
    # axes 4 and 6 are one line where θ_5 is 0 or π, so that only one combination of their turns is seen
    level = [abs(math.sin(row[4] + rows[4].theta)) < 1e-6 for row in found]
    kept = [row for k, row in enumerate(found) if k % 2 == 0 or not level[k]]
    frames = table.frames(joints)
    same = float(frames[4][:3, 2].real @ frames[6][:3, 2].real)
    return kept, [0.0, 0.0, 0.0, 1.0, 0.0, float(np.sign(same))]


def _wrists(table: PlainTable, left: np.ndarray, heads: list[float]) -> Rows:
    """Both ways of a wrist at right angles."""
    a4, a5, a6 = (row.alpha for row in table.rows[3:])
    turn = np.array([[1, 0, 0], [0, math.cos(a4), math.sin(a4)], [0, -math.sin(a4), math.cos(a4)]])
    W = turn @ left
    s4, s5 = math.sin(a5), math.sin(a6)
    found = []
    for way in (1, -1):
        fifth = way * math.atan2(math.hypot(W[0, 2], W[1, 2]), -W[2, 2] * s4 * s5)
        flat = way * s5
        fourth = math.atan2(flat * W[1, 2], flat * W[0, 2]) if abs(math.sin(fifth)) > 1e-6 else 0.0
        link = [q - row.theta for q, row in zip((fourth, fifth), table.rows[3:], strict=False)]
        links = table.links([*heads, *link, 0.0])
        rest = (links[3] @ links[4]).real[:3, :3].T @ left
        a = a6
        back = np.array([[1, 0, 0], [0, math.cos(a), math.sin(a)], [0, -math.sin(a), math.cos(a)]]) @ rest
        found.append([*heads, *link, math.atan2(back[1, 0], back[0, 0]) - table.rows[5].theta])
    return found
