"""What a policy fixes, each rule by itself and in company."""

import math
from dataclasses import replace

import numpy as np
import pytest

from kinematics.equivalence import (
    BaseRule,
    DirectionRule,
    Kind,
    Policy,
    Tolerance,
    ToolRule,
    ZeroRule,
    decide,
)
from kinematics.table import Convention, DHTable, NumericTable
from tests.kinematics.equivalence.tables import (
    HALF,
    PUMA,
    PUMA_CRAIG,
    SCARA,
    F,
    P,
    R,
    changed,
    modified,
    standard,
)

EXACT = Tolerance(length=1e-9, angle=1e-9)
FREE = Policy(tool=ToolRule.FREE, tolerance=EXACT)

TWO_LINKS = standard((R, 0, 1.0, 0, 0), (R, 0, 0.5, 0, 0))


def broken(reference: NumericTable, submission: NumericTable, **rules: object) -> list[Kind]:
    """The rules that a submission of the right robot breaks."""
    decision = decide(reference, submission, replace(FREE, **rules))
    assert decision.same_robot
    return [mismatch.kind for mismatch in decision.mismatches]


def with_base(table: NumericTable, *rows: tuple[object, ...]) -> NumericTable:
    before = standard(*rows) if table.convention is Convention.STANDARD else modified(*rows)  # type: ignore[arg-type]
    return DHTable(convention=table.convention, rows=(*before.rows, *table.rows))


def test_base_axis() -> None:
    turned = changed(PUMA, 1, theta=1.0)
    assert broken(PUMA, turned, base=BaseRule.AXIS) == []
    raised = changed(PUMA, 1, d=0.7)
    assert broken(PUMA, raised, base=BaseRule.AXIS) == []
    upside_down = changed(PUMA, 1, alpha=-HALF)
    upside_down = replace(upside_down, rows=(replace(upside_down.rows[0], sign=-1), *upside_down.rows[1:]))
    assert broken(PUMA, with_base(upside_down, (F, math.pi, 0, 0, 0)), base=BaseRule.AXIS) == []
    assert broken(PUMA, with_base(PUMA, (F, 0, 0.2, 0, 0)), base=BaseRule.AXIS) == [Kind.BASE]
    assert broken(PUMA, with_base(PUMA, (F, 0.2, 0, 0, 0)), base=BaseRule.AXIS) == [Kind.BASE]


def test_base_axis_is_the_first_joints_or_the_references_own() -> None:
    worldly = with_base(PUMA_CRAIG, (F, 0.3, 0.5, 0, 0))
    assert broken(worldly, worldly, base=BaseRule.AXIS) == []
    assert broken(worldly, PUMA_CRAIG, base=BaseRule.AXIS) == []
    assert broken(worldly, with_base(PUMA_CRAIG, (F, 0.3, 0.4, 0, 0)), base=BaseRule.AXIS) == [Kind.BASE]


def test_base_origin() -> None:
    tall = changed(PUMA, 1, d=0.7)
    assert broken(tall, changed(tall, 1, theta=1.0), base=BaseRule.ORIGIN) == []
    tilted = with_base(PUMA, (F, HALF, 0, 0, 0.3), (F, -HALF, 0, 0.7, 0))
    assert broken(tilted, tilted, base=BaseRule.ORIGIN) == []
    assert broken(tall, PUMA, base=BaseRule.ORIGIN) == [Kind.BASE]
    assert broken(tall, with_base(tall, (F, 0.4, 0, 0, 0)), base=BaseRule.ORIGIN) == []
    assert broken(tall, with_base(tall, (F, 0, 0.1, 0, 0)), base=BaseRule.ORIGIN) == [Kind.BASE]


def test_base_frame() -> None:
    assert broken(PUMA, PUMA, base=BaseRule.FRAME) == []
    # q_1 may still be zero elsewhere: only frame 0 is fixed
    assert broken(PUMA, changed(PUMA, 1, theta=1.0), base=BaseRule.FRAME) == []
    assert broken(PUMA, changed(PUMA, 1, d=0.1), base=BaseRule.FRAME) == [Kind.BASE]
    assert broken(PUMA, with_base(PUMA, (F, 0.4, 0, 0, 0)), base=BaseRule.FRAME) == [Kind.BASE]


def test_tool_point() -> None:
    assert broken(TWO_LINKS, TWO_LINKS, tool=ToolRule.POINT) == []
    # the same point, z_2 tilted any way
    assert broken(TWO_LINKS, changed(TWO_LINKS, 2, alpha=0.4), tool=ToolRule.POINT) == []
    assert broken(TWO_LINKS, changed(TWO_LINKS, 2, a=-0.5), tool=ToolRule.POINT) == []
    tip = modified((R, 0, 0, 0, 0), (R, 0, 1.0, 0, 0), (F, 0.7, 0.5, 0, 1.0))
    assert broken(TWO_LINKS, tip, tool=ToolRule.POINT) == []
    assert broken(TWO_LINKS, changed(TWO_LINKS, 2, a=0.4), tool=ToolRule.POINT) == [Kind.TOOL]
    # the height of frame 0 is free, so a shift along the parallel axes is one of frame 0
    assert broken(TWO_LINKS, changed(TWO_LINKS, 2, d=0.1), tool=ToolRule.POINT) == []
    both = {"tool": ToolRule.POINT, "base": BaseRule.ORIGIN}
    assert broken(TWO_LINKS, changed(TWO_LINKS, 2, d=0.1), **both) == [Kind.TOOL]


def test_a_table_without_joints_is_where_its_tool_is() -> None:
    """Turned about a fixed origin, a point is anywhere at its distance; at the origin it is there alone."""
    key = standard((F, 0.3, 0.3, 0.4, 0.2))
    centred = {"base": BaseRule.ORIGIN, "tool": ToolRule.POINT}
    assert broken(key, key, base=BaseRule.FRAME, tool=ToolRule.FRAME) == []
    assert broken(key, standard((F, 1.0, 0.5, 0, 2.0)), **centred) == []
    assert broken(key, standard((F, 1.0, 0.5, 0.01, 2.0)), **centred) == [Kind.TOOL]
    assert broken(key, standard((F, 1.0, 0, 0, 2.0)), **centred) == [Kind.TOOL]
    assert broken(key, standard((F, 0.3, 0.3, 0.4, 0.25)), base=BaseRule.FRAME, tool=ToolRule.FRAME)


def test_tool_axis() -> None:
    assert broken(PUMA, changed(PUMA, 6, d=0.3), tool=ToolRule.AXIS) == []
    assert broken(PUMA, changed(PUMA, 6, alpha=math.pi), tool=ToolRule.AXIS) == []
    assert broken(PUMA, changed(PUMA, 6, alpha=0.1), tool=ToolRule.AXIS) == [Kind.TOOL]
    assert broken(PUMA, changed(PUMA, 6, a=0.1), tool=ToolRule.AXIS) == [Kind.TOOL]
    # of a standard table with a tool off the last axis, both lines will do
    assert broken(TWO_LINKS, TWO_LINKS, tool=ToolRule.AXIS) == []
    assert broken(TWO_LINKS, modified((R, 0, 0, 0, 0), (R, 0, 1.0, 0, 0)), tool=ToolRule.AXIS) == []
    assert broken(TWO_LINKS, changed(TWO_LINKS, 2, a=0.3), tool=ToolRule.AXIS) == [Kind.TOOL]


def test_tool_axis_of_a_slider_is_a_direction() -> None:
    slider = standard((R, HALF, 0, 0, 0), (P, 0, 0, 0, 0))
    assert broken(slider, changed(slider, 2, a=0.3), tool=ToolRule.AXIS) == []
    assert broken(slider, changed(slider, 2, alpha=0.3), tool=ToolRule.AXIS) == [Kind.TOOL]


def test_tool_frame() -> None:
    assert broken(PUMA, PUMA, tool=ToolRule.FRAME) == []
    assert broken(PUMA, changed(PUMA, 6, theta=0.4), tool=ToolRule.FRAME) == []
    for cells in ({"d": 0.1}, {"a": 0.1}, {"alpha": 0.3}):
        assert broken(PUMA, changed(PUMA, 6, **cells), tool=ToolRule.FRAME) == [Kind.TOOL]
    turned = DHTable(convention=PUMA.convention, rows=(*PUMA.rows, standard((F, 0, 0, 0, 1.0)).rows[0]))
    assert broken(PUMA, turned, tool=ToolRule.FRAME) == []  # q_6 is zero elsewhere, the frame is the same
    # each rule can be kept, but not both
    assert broken(PUMA, turned, tool=ToolRule.FRAME, zero=ZeroRule.FIGURE) == [Kind.ZERO]


def test_zero() -> None:
    assert broken(PUMA, PUMA, zero=ZeroRule.FIGURE) == []
    # x_0 and x_6 are free, so the first and the last variable's zeros are as well
    assert broken(PUMA, changed(PUMA, 1, theta=0.4), zero=ZeroRule.FIGURE) == []
    assert broken(PUMA, changed(PUMA, 6, theta=0.4), zero=ZeroRule.FIGURE) == []
    assert broken(PUMA, changed(PUMA, 2, theta=0.4), zero=ZeroRule.FIGURE) == [Kind.ZERO]
    assert broken(PUMA, changed(PUMA, 2, theta=2 * math.pi), zero=ZeroRule.FIGURE) == []
    assert broken(SCARA, changed(SCARA, 3, d=0.2), zero=ZeroRule.FIGURE) == []  # along parallel axes
    sliding = standard((R, HALF, 0, 0, 0), (P, HALF, 0, 0, 0), (R, 0, 0.4, 0, 0))
    assert broken(sliding, changed(sliding, 2, d=0.2), zero=ZeroRule.FIGURE) == [Kind.ZERO]


def test_zero_with_frames_drawn_otherwise() -> None:
    """x_2 turned by 180°: θ_2 and θ_3 get constants, and the variables are zero where they were."""
    rows = list(PUMA.rows)
    rows[1] = replace(rows[1], theta=math.pi, a=-rows[1].a)
    rows[2] = replace(rows[2], theta=-math.pi)
    turned = DHTable(convention=PUMA.convention, rows=tuple(rows))
    assert broken(PUMA, turned, zero=ZeroRule.FIGURE, direction=DirectionRule.FIGURE) == []
    rows[1] = replace(rows[1], theta=0.0)
    rows[2] = replace(rows[2], theta=0.0)
    unmarked = DHTable(convention=PUMA.convention, rows=tuple(rows))
    assert broken(PUMA, unmarked) == []
    assert broken(PUMA, unmarked, zero=ZeroRule.FIGURE) == [Kind.ZERO]


def test_direction() -> None:
    against = replace(PUMA, rows=(PUMA.rows[0], replace(PUMA.rows[1], sign=-1), *PUMA.rows[2:]))
    assert broken(PUMA, against) == []
    assert broken(PUMA, against, direction=DirectionRule.FIGURE) == [Kind.DIRECTION]


def test_several_broken_rules_are_all_named() -> None:
    table = changed(with_base(changed(PUMA, 6, a=0.1), (F, 0.3, 0, 0, 0)), 3, theta=0.5)
    rules = {"base": BaseRule.AXIS, "tool": ToolRule.AXIS, "zero": ZeroRule.FIGURE}
    assert broken(PUMA, table, **rules) == [Kind.BASE, Kind.TOOL, Kind.ZERO]


@pytest.mark.parametrize("rule", list(ToolRule))
@pytest.mark.parametrize("base", list(BaseRule))
def test_certificates_keep_the_rules_to_the_letter(rule: ToolRule, base: BaseRule) -> None:
    policy = Policy(base=base, tool=rule, tolerance=EXACT)
    certificate = decide(PUMA, changed(PUMA, 3, d=0.15005, theta=0.2), policy).certificate
    assert certificate is not None
    B, E = certificate.base, certificate.tool
    if base is BaseRule.FRAME:
        assert np.allclose(B, np.eye(4))
    if base is BaseRule.ORIGIN:
        assert np.allclose(B[:3, 3], 0.0)
    if rule is ToolRule.FRAME:
        assert np.array_equal(E, np.eye(4))
    if rule is ToolRule.POINT:
        assert np.array_equal(E[:3, 3], np.zeros(3))
    if rule is ToolRule.AXIS:
        assert np.allclose(np.abs(E[:3, 2]), (0, 0, 1))
        assert np.allclose(E[:2, 3], 0.0)
