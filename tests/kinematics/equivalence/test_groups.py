"""The table of groups: stabilisers and their extensions, against brute force on random elements."""

import math
from random import Random

import pytest

from kinematics.chain import Axis
from kinematics.equivalence.groups import (
    EVERYTHING,
    NOTHING,
    Group,
    Nearness,
    Rotations,
    about_direction,
    about_point,
    cylinder,
    departure,
    fixing_direction,
    fixing_line,
    with_rotations_about,
    with_translations_along,
)
from kinematics.se3 import (
    IDENTITY,
    ORIGIN,
    Z_AXIS,
    Motion,
    Vector,
    compose,
    inverse,
    move,
    norm,
    plus,
    rejection,
    rotate,
    rotation_about,
    scale,
    subtract,
    translation,
    unit,
)

NEAR = Nearness(1e-9, 1e-9, 1e-9)
X_AXIS: Vector = (1.0, 0.0, 0.0)
SKEW: Vector = unit((1.0, 2.0, -0.5))
ASIDE: Vector = (0.3, -0.2, 0.1)

GROUPS = {
    "everything": EVERYTHING,
    "about a point": about_point(ASIDE),
    "about a direction": about_direction(Z_AXIS),
    "cylinder": cylinder(ASIDE, Z_AXIS),
    "about a line": Group(Rotations.ABOUT_LINE, point=ASIDE, axis=Z_AXIS),
    "along a line": Group(Rotations.NONE, translations=(Z_AXIS,)),
    "in a plane": Group(Rotations.NONE, translations=(Z_AXIS, X_AXIS)),
    "all translations": Group(Rotations.NONE, translations=EVERYTHING.translations),
    "nothing": NOTHING,
}
AXES = {
    "the line itself": (ASIDE, Z_AXIS),
    "the line reversed": (plus(ASIDE, (0, 0, 2.0)), (0.0, 0.0, -1.0)),
    "a parallel": ((1.0, 0.0, 0.0), Z_AXIS),
    "crossing": (ASIDE, X_AXIS),
    "skew": ((0.5, 0.5, 0.5), SKEW),
}


def element(group: Group, rng: Random) -> Motion:
    """A random element of a group."""
    g = IDENTITY
    if group.rotations is not Rotations.NONE:
        axis = group.axis
        if group.rotations is Rotations.ABOUT_POINT:
            axis = unit((rng.gauss(0, 1), rng.gauss(0, 1), rng.gauss(0, 1)))
        angle = rng.uniform(-math.pi, math.pi)
        g = rotation_about(group.point, axis, math.cos(angle), math.sin(angle))
    for direction in group.translations:
        g = compose(translation(scale(direction, rng.uniform(-2, 2))), g)
    return g


def dimension(group: Group) -> int:
    turns = {Rotations.NONE: 0, Rotations.ABOUT_LINE: 1, Rotations.ABOUT_POINT: 3}[group.rotations]
    return turns + len(group.translations)


def keeps_line(g: Motion, point: Vector, direction: Vector) -> bool:
    moved = rejection(subtract(move(g, point), point), direction)
    return norm(subtract(rotate(g, direction), direction)) < 1e-9 and norm(moved) < 1e-9


@pytest.mark.parametrize("group", GROUPS.values(), ids=GROUPS.keys())
def test_groups_are_closed_and_know_their_members(group: Group) -> None:
    rng = Random(1)
    for _ in range(20):
        g, h = element(group, rng), element(group, rng)
        for member in (compose(g, h), inverse(g)):
            assert max(departure(group, member)) < 1e-9
    stranger = rotation_about((0.1, 0.7, 0.2), SKEW, math.cos(1.0), math.sin(1.0))
    assert group is EVERYTHING or max(departure(group, stranger)) > 1e-3


@pytest.mark.parametrize("group", GROUPS.values(), ids=GROUPS.keys())
@pytest.mark.parametrize("axis", AXES.values(), ids=AXES.keys())
def test_stabilisers_of_lines(group: Group, axis: tuple[Vector, Vector]) -> None:
    point, direction = axis
    stabiliser = fixing_line(group, point, direction, NEAR)
    rng = Random(2)
    for _ in range(10):
        g = element(stabiliser, rng)
        assert max(departure(group, g)) < 1e-9
        assert keeps_line(g, point, direction)
    # and nothing is forgotten: the line's own motions that lie in the group are there
    turn = rotation_about(point, direction, math.cos(0.7), math.sin(0.7))
    slide = translation(scale(direction, 0.4))
    for own in (turn, slide):
        if max(departure(group, own)) < 1e-9:
            assert max(departure(stabiliser, own)) < 1e-9


@pytest.mark.parametrize("group", GROUPS.values(), ids=GROUPS.keys())
@pytest.mark.parametrize("axis", AXES.values(), ids=AXES.keys())
def test_stabilisers_of_directions(group: Group, axis: tuple[Vector, Vector]) -> None:
    _, direction = axis
    stabiliser = fixing_direction(group, direction, NEAR)
    rng = Random(3)
    for _ in range(10):
        g = element(stabiliser, rng)
        assert max(departure(group, g)) < 1e-9
        assert norm(subtract(rotate(g, direction), direction)) < 1e-9
    assert stabiliser.translations == group.translations


@pytest.mark.parametrize("group", GROUPS.values(), ids=GROUPS.keys())
@pytest.mark.parametrize("prismatic", [False, True])
@pytest.mark.parametrize("axis", AXES.values(), ids=AXES.keys())
def test_a_joints_motions_and_its_stabiliser_make_a_group(
    group: Group, axis: tuple[Vector, Vector], prismatic: bool
) -> None:
    joint = Axis(prismatic, axis[1], axis[0])
    if prismatic:
        stabiliser = fixing_direction(group, joint.direction, NEAR)
        product = with_translations_along(stabiliser, joint.direction, NEAR)
        own = translation(scale(joint.direction, 0.8))
    else:
        stabiliser = fixing_line(group, joint.point, joint.direction, NEAR)
        product = with_rotations_about(stabiliser, joint.point, joint.direction)
        own = rotation_about(joint.point, joint.direction, math.cos(0.8), math.sin(0.8))
    rng = Random(4)
    assert max(departure(product, own)) < 1e-9
    assert dimension(product) <= dimension(stabiliser) + 1
    for _ in range(10):
        k = element(stabiliser, rng)
        assert max(departure(product, compose(own, k))) < 1e-9
        # the stabiliser commutes with the joint
        apart = compose(inverse(compose(own, k)), compose(k, own))
        assert max(abs(a - b) for a, b in zip(apart, IDENTITY, strict=True)) < 1e-9


def test_the_chain_of_groups_of_a_planar_arm() -> None:
    """SE(3) → cylinder → cylinder → …: parallel axes keep a translation along themselves."""
    group = EVERYTHING
    for x in (0.0, 1.0, 2.0):
        stabiliser = fixing_line(group, (x, 0.0, 0.0), Z_AXIS, NEAR)
        group = with_rotations_about(stabiliser, (x, 0.0, 0.0), Z_AXIS)
        assert (group.rotations, len(group.translations)) == (Rotations.ABOUT_LINE, 1)
    assert stabiliser.rotations is Rotations.NONE


def test_the_chain_of_groups_of_three_sliders() -> None:
    """SE(3) → all about a direction → all translations: sliders can be drawn anywhere."""
    group = fixing_direction(EVERYTHING, Z_AXIS, NEAR)
    assert (group.rotations, len(group.translations)) == (Rotations.ABOUT_LINE, 3)
    group = fixing_direction(group, X_AXIS, NEAR)
    assert (group.rotations, len(group.translations)) == (Rotations.NONE, 3)


def test_fixing_a_line_through_a_point() -> None:
    assert fixing_line(about_point(ORIGIN), ORIGIN, Z_AXIS, NEAR).rotations is Rotations.ABOUT_LINE
    assert fixing_line(about_point(ORIGIN), ASIDE, Z_AXIS, NEAR) == NOTHING
