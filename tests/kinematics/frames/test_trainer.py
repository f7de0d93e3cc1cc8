"""A student's frames: right ones pass, each wrong one breaks the rule that it should."""

import dataclasses

import numpy as np
import pytest

from kinematics.errors import DescriptionError
from kinematics.forward import forward_kinematics
from kinematics.frames.assignment import assign_frames
from kinematics.frames.chosen_frames import ChosenFrame
from kinematics.frames.rules import FramePart, RuleCode, Severity
from kinematics.frames.trainer import check_frames, rules_and_table
from kinematics.se3 import cross
from kinematics.table import CELLS, Convention
from tests.conftest import EXPLORE
from tests.kinematics.frames.chains import KINDS, motion, random_chain, random_end
from tests.kinematics.frames.test_assignment import PUMA, P, R, X, Y, Z, axes, both


def chosen_from(result):
    return [ChosenFrame(origin=frame.origin, x=frame.x, z=frame.z) for frame in result.frames]


def rules(judged, i, severity=Severity.BROKEN):
    return [finding.rule for finding in judged.frames[i].findings if finding.severity is severity]


def changed(frames, i, **parts):
    return [dataclasses.replace(f, **parts) if k == i else f for k, f in enumerate(frames)]


@both
@pytest.mark.parametrize("kind", KINDS)
def test_assigned_frames_break_no_rule_and_give_the_same_table(convention, kind):
    rng = np.random.default_rng(KINDS.index(kind))
    for _ in range(30):
        chain = random_chain(rng, kind)
        base = random_end(rng, chain[0]) if rng.random() < 0.3 else None
        tool = random_end(rng, chain[-1]) if rng.random() < 0.3 else None
        result = assign_frames(chain, convention, base=base, tool=tool)
        judged = check_frames(chain, convention, chosen_from(result), base=base, tool=tool)
        assert not [f for frame in judged.frames for f in frame.findings if f.severity is Severity.BROKEN]
        assert judged.table is not None
        for got, want in zip(judged.table.rows, result.table.rows, strict=True):
            assert all(abs(getattr(got, cell) - getattr(want, cell)) < 1e-9 for cell in CELLS)
        assert np.allclose(judged.base, result.base)
        assert np.allclose(judged.tool, result.tool)


@both
def test_what_breaks_no_rule_is_the_same_robot(convention):
    """Random legal frames: z either way, x either way, origins slid along parallels; the table still is"
    " the robot."""
    rng = np.random.default_rng(5)
    for _ in range(60):
        chain = random_chain(rng, "related", prismatic=0.2, most=6)
        frames = chosen_from(assign_frames(chain, convention))
        for i, frame in enumerate(frames):
            if rng.random() < 0.4:
                frames[i] = dataclasses.replace(frame, z=[-v for v in frame.z])
            if rng.random() < 0.4:
                frames[i] = dataclasses.replace(frames[i], x=[-v for v in frame.x])
        judged = check_frames(chain, convention, frames)
        assert judged.table is not None
        end = forward_kinematics(judged.table, np.zeros(len(chain)), base=judged.base).transform
        q = rng.normal(size=len(chain))
        moved = np.eye(4)
        for axis, value in zip(chain, q, strict=True):
            moved = moved @ motion(axis, value)
        got = forward_kinematics(judged.table, q, base=judged.base).transform
        assert np.allclose(got, moved @ end, atol=1e-9)


@both
def test_rules_and_table_alone_are_those_of_the_whole_judgement(convention):
    """Right, wrong, half chosen and missing frames: the short way finds the same rules and the same table."""
    rng = np.random.default_rng(6)
    tables = 0
    for _ in range(60):
        chain = random_chain(rng, "related", prismatic=0.2, most=6)
        frames = chosen_from(assign_frames(chain, convention))
        for i, frame in enumerate(frames):
            wrong = {"x": frame.z, "z": frame.x, "origin": [v + 0.1 for v in frame.origin]}
            part = rng.choice([*wrong, *["right"] * 20])
            if part in wrong:
                value = None if rng.random() < 0.5 else wrong[part]
                frames[i] = dataclasses.replace(frame, **{part: value})
            elif rng.random() < 0.03:
                frames[i] = None
        judged = check_frames(chain, convention, frames)
        broken, table = rules_and_table(chain, convention, frames)
        assert [[rule.rule for rule in found] for found in broken] == [
            rules(judged, i) for i in range(len(judged.frames))
        ]
        assert table == judged.table
        tables += table is not None
    assert 10 <= tables <= 50


MODIFIED = chosen_from(assign_frames(PUMA, Convention.MODIFIED))
STANDARD = chosen_from(assign_frames(PUMA, Convention.STANDARD))


@pytest.mark.parametrize(
    ("convention", "i", "parts", "rule", "part"),
    [
        (Convention.MODIFIED, 2, {"z": Z}, RuleCode.Z_NOT_ALONG_AXIS, FramePart.Z),
        (Convention.STANDARD, 1, {"z": Z}, RuleCode.Z_NOT_ALONG_AXIS, FramePart.Z),
        (Convention.MODIFIED, 2, {"origin": (0.1, 0, 0)}, RuleCode.ORIGIN_NOT_ON_AXIS, FramePart.ORIGIN),
        (
            Convention.MODIFIED,
            4,
            {"origin": (0.4521, -0.15005, 0)},
            RuleCode.ORIGIN_NOT_AT_INTERSECTION,
            FramePart.ORIGIN,
        ),
        (
            Convention.MODIFIED,
            3,
            {"origin": (0.4318, 0, 0)},
            RuleCode.ORIGIN_NOT_ON_COMMON_NORMAL,
            FramePart.ORIGIN,
        ),
        (
            Convention.STANDARD,
            3,
            {"origin": (0.4521, -0.15005, 0.3)},
            RuleCode.ORIGIN_NOT_ON_COMMON_NORMAL,
            FramePart.ORIGIN,
        ),
        (Convention.MODIFIED, 2, {"x": Z}, RuleCode.X_NOT_ALONG_COMMON_NORMAL, FramePart.X),
        (Convention.MODIFIED, 1, {"x": Y}, RuleCode.X_NOT_ACROSS_BOTH_AXES, FramePart.X),
        (Convention.MODIFIED, 2, {"x": Y}, RuleCode.X_NOT_ACROSS_Z, FramePart.X),
        (Convention.MODIFIED, 0, {"x": Z}, RuleCode.FIRST_X_MISSES_AXIS, FramePart.X),
        (Convention.MODIFIED, 0, {"origin": (0, 1, 0)}, RuleCode.FIRST_X_MISSES_AXIS, FramePart.X),
        (Convention.STANDARD, 6, {"x": Z, "z": X}, RuleCode.LAST_X_MISSES_AXIS, FramePart.X),
        (Convention.STANDARD, 0, {"origin": (1, 0, 0)}, RuleCode.ORIGIN_NOT_ON_AXIS, FramePart.ORIGIN),
    ],
)
def test_each_rule_is_named(convention, i, parts, rule, part):
    frames = changed(MODIFIED if convention is Convention.MODIFIED else STANDARD, i, **parts)
    judged = check_frames(PUMA, convention, frames)
    found = [finding for finding in judged.frames[i].findings if finding.rule is rule]
    assert len(found) == 1
    assert found[0].part is part
    assert found[0].severity is Severity.BROKEN
    assert judged.table is None


@pytest.mark.parametrize(
    ("convention", "i", "parts", "rule"),
    [
        (Convention.MODIFIED, 2, {"z": (0, 1, 0)}, RuleCode.Z_REVERSED),
        (Convention.MODIFIED, 2, {"x": (-1, 0, 0)}, RuleCode.X_REVERSED),
        (Convention.MODIFIED, 2, {"origin": (0, 0.2, 0)}, RuleCode.OFFSET_COULD_VANISH),
        (Convention.STANDARD, 2, {"origin": (0.4318, 0.2, 0)}, RuleCode.OFFSET_COULD_VANISH),
        (Convention.MODIFIED, 4, {"x": (-1, 0, 0)}, RuleCode.ANGLE_COULD_VANISH),
        (Convention.MODIFIED, 0, {"origin": (0, 0, -0.6)}, RuleCode.FIRST_NOT_SIMPLEST),
        (Convention.STANDARD, 0, {"x": Y}, RuleCode.FIRST_NOT_SIMPLEST),
        (Convention.MODIFIED, 6, {"origin": (0.4521, -0.15005, 0.5)}, RuleCode.LAST_NOT_SIMPLEST),
        (Convention.STANDARD, 6, {"x": Y}, RuleCode.LAST_NOT_SIMPLEST),
    ],
)
def test_legal_but_not_simplest_is_advice(convention, i, parts, rule):
    frames = changed(MODIFIED if convention is Convention.MODIFIED else STANDARD, i, **parts)
    judged = check_frames(PUMA, convention, frames)
    assert rules(judged, i) == []
    assert rule in rules(judged, i, Severity.ADVICE)
    assert judged.table is not None


def test_a_reversed_z_enters_with_a_minus_sign():
    judged = check_frames(PUMA, Convention.MODIFIED, changed(MODIFIED, 2, z=(0, 1, 0)))
    assert [row.sign for row in judged.table.rows] == [1, -1, 1, 1, 1, 1]


def test_judged_step_by_step():
    judged = check_frames(PUMA, Convention.MODIFIED, [None, ChosenFrame(z=X)])
    assert rules(judged, 1) == [RuleCode.Z_NOT_ALONG_AXIS]
    assert not judged.frames[1].complete
    assert [row is None for row in judged.rows] == [True] * 6
    judged = check_frames(PUMA, Convention.MODIFIED, MODIFIED[:3])
    assert [row is None for row in judged.rows] == [False, False, True, True, True, True]
    assert judged.table is None


@both
@pytest.mark.parametrize("kind", KINDS)
def test_a_right_choice_is_always_among_the_candidates(convention, kind):
    """Whoever always picks a candidate that breaks no rule ends with a whole table."""
    rng = np.random.default_rng(11)
    for _ in range(12 if EXPLORE else 6):
        chain = random_chain(rng, kind, prismatic=0.15, most=5)
        chosen = [None] * (len(chain) + 1)
        for i in range(len(chosen)):
            chosen[i] = first_legal(chain, convention, chosen, i)
        assert check_frames(chain, convention, chosen).table is not None


def first_legal(chain, convention, chosen, i):
    offered = check_frames(chain, convention, chosen).frames[i].candidates
    for z in offered.z:
        for origin in offered.origin:
            for x in offered.x:
                frame = ChosenFrame(origin=origin.vector, x=x.vector, z=z.vector)
                if abs(np.dot(x.vector, z.vector)) > 1e-9:
                    continue
                if not rules(check_frames(chain, convention, [*chosen[:i], frame]), i):
                    return frame
    raise AssertionError(f"frame {i} cannot be chosen")


def test_a_sliding_axis_is_where_it_is_drawn():
    chain = axes((R, (0, 0, 0), Z), (P, (0, 0, 0), X), (R, (1, 0.5, 0), Z))
    frames = [
        ChosenFrame(origin=(0, 0, 0), x=(0, -1, 0), z=Z),
        ChosenFrame(origin=(0, 0, 0), x=(0, -1, 0), z=Z),
        ChosenFrame(origin=(1, 0.5, 0), x=(0, -1, 0), z=X),
        ChosenFrame(origin=(1, 0.5, 0), x=(0, -1, 0), z=Z),
    ]
    judged = check_frames(chain, Convention.MODIFIED, frames)
    assert judged.table is not None
    assert judged.table.rows[1].a == -0.5
    crooked = changed(frames, 2, origin=(1, 0.5, 0.3))
    judged = check_frames(chain, Convention.MODIFIED, crooked)
    assert rules(judged, 1) == [RuleCode.ORIGIN_NOT_ON_COMMON_NORMAL]
    assert rules(judged, 2) == []


def test_candidates_are_distinct_and_unit():
    judged = check_frames(PUMA, Convention.STANDARD, [])
    for frame in judged.frames:
        for offered in (frame.candidates.z, frame.candidates.x):
            assert all(abs(np.linalg.norm(c.vector) - 1) < 1e-12 for c in offered)
            assert len({tuple(np.round(c.vector, 9) + 0.0) for c in offered}) == len(offered)


def test_too_many_frames_are_refused():
    with pytest.raises(DescriptionError) as refusal:
        check_frames(PUMA, Convention.MODIFIED, [None] * 8)
    assert refusal.value.code == "frames_too_many"
    with pytest.raises(DescriptionError) as refusal:
        check_frames(PUMA, Convention.MODIFIED, [ChosenFrame(x=(0, 0, 0)), ChosenFrame(origin=(1, 2))])
    assert [fault.code for fault in refusal.value.faults] == ["direction_zero", "vector_malformed"]


def test_y_completes_the_frame():
    result = assign_frames(PUMA, Convention.MODIFIED)
    assert all(np.allclose(frame.y, cross(frame.z, frame.x)) for frame in result.frames)
