"""Figures: every robot drawn from its geometry, nothing given away, nothing covered."""

import math
import re
from dataclasses import replace
from itertools import pairwise
from pathlib import Path
from xml.etree import ElementTree

import numpy as np
import pytest

from exercises.definition import Exercise
from exercises.drawings import (
    figure_drawing,
    figure_geometry,
    figure_sentences,
    key_pose,
    prescribed_frames,
    true_scene,
)
from exercises.figures.camera import camera_for
from exercises.figures.svg import document, split_name
from exercises.grading import DirectionRule
from exercises.instance import Instance, generate
from exercises.loader import load_exercise
from exercises.parts.registry import part_type
from kinematics.table import JointType
from tests.exercises.folders import TWO_LINKS, folder
from tests.exercises.packaged import exercise, exercise_ids


def what_is_drawn(found: Exercise) -> str:
    return repr((found.reference.table, found.parameters, found.figure, found.length_unit, found.policy))


ALL = tuple({what_is_drawn(exercise(name)): name for name in reversed(exercise_ids)}.values())
"""One exercise of each figure: half of them ask something else about the robot of another, drawn alike."""
SVG = "{http://www.w3.org/2000/svg}"


def drawn(exercise_id: str, seed: str | None = None) -> ElementTree.Element:
    return root_of(generate(exercise(exercise_id), seed))


def root_of(instance: Instance) -> ElementTree.Element:
    drawing = figure_drawing(instance)
    return ElementTree.fromstring(document(drawing, title="A <robot>", description='"d" & e', language="en"))


def texts(root: ElementTree.Element) -> list[str]:
    return ["".join(node.itertext()) for node in root.iter(f"{SVG}text")]


@pytest.mark.parametrize("exercise_id", ALL)
def test_a_figure_is_sound_and_says_what_it_is(exercise_id: str) -> None:
    root = drawn(exercise_id)
    assert root.get("role") == "img"
    named = root.get("aria-labelledby")
    assert named is not None
    ids = {node.get("id"): node for node in root.iter() if node.get("id")}
    assert [ids[name].tag for name in named.split()] == [f"{SVG}title", f"{SVG}desc"]
    assert ids["figure-title"].text == "A <robot>"
    tags = {node.tag.removeprefix(SVG) for node in root.iter()}
    assert tags <= {"svg", "title", "desc", "style", "path", "circle", "text", "tspan"}
    source = ElementTree.tostring(root, encoding="unicode")
    assert not re.search(r"url\(|@import|<script|\son[a-z]+=", source)
    assert set(re.findall(r'href|https?://[^"]*', source)) <= {"http://www.w3.org/2000/svg"}


@pytest.mark.parametrize("exercise_id", ALL)
def test_every_joint_dimension_and_point_is_named_once_for_each_time_it_is_drawn(exercise_id: str) -> None:
    found = exercise(exercise_id)
    numbers = [str(joint) for joint in range(1, found.reference.table.n_joints + 1)]
    dimensions = ["".join(split_name(mark.name)) for mark in found.figure.dimensions]
    instance = generate(found)
    frames = [f"{axis}{i}" for i in prescribed_frames(instance, instance.values) for axis in "xyz"]
    assert sorted(texts(drawn(exercise_id))) == sorted([*numbers, *dimensions, *found.figure.marks, *frames])


def boxes(root: ElementTree.Element) -> list[tuple[str, float, float, float, float]]:
    """Names with the boxes that their letters take at least."""
    found = []
    for node in root.iter(f"{SVG}text"):
        text, size = "".join(node.itertext()), float(node.get("font-size", 0))
        x, y = float(node.get("x", 0)), float(node.get("y", 0)) - 0.34 * size
        width = 0.5 * size * len(text)
        found.append((text, x - width / 2, y - size / 3, x + width / 2, y + size / 3))
    return found


@pytest.mark.parametrize("exercise_id", ALL)
@pytest.mark.parametrize("seed", [None, "1", "2"])
def test_names_do_not_cover_each_other_and_stay_on_the_paper(exercise_id: str, seed: str | None) -> None:
    root = drawn(exercise_id, seed)
    left, top, width, height = map(float, str(root.get("viewBox")).split())
    placed = boxes(root)
    for i, (text, x0, y0, x1, y1) in enumerate(placed):
        assert left <= x0
        assert x1 <= left + width
        assert top <= y0
        assert y1 <= top + height
        for other, u0, v0, u1, v1 in placed[:i]:
            apart = x1 < u0 or u1 < x0 or y1 < v0 or v1 < y0
            assert apart, f"{text} covers {other}"


@pytest.mark.parametrize("exercise_id", ALL)
def test_a_figure_fits_a_phone(exercise_id: str) -> None:
    """At 320 pixels, names of dimensions are still 8 pixels high, and the figure no taller than a screen."""
    _, _, width, height = map(float, str(drawn(exercise_id).get("viewBox")).split())
    assert 18 * 320 / width >= 8
    assert 320 * height / width < 480


@pytest.mark.parametrize("exercise_id", ALL)
def test_directions_of_axes_tell_nothing_of_the_frames(exercise_id: str) -> None:
    for axis in true_scene(generate(exercise(exercise_id))).axes:
        assert not axis.signed
        largest = max(axis.direction, key=abs)
        assert largest > 0
    root = drawn(exercise_id)
    assert not [node for node in root.iter() if node.get("class") == "sense"]


@pytest.mark.parametrize("exercise_id", ALL)
def test_geometry_is_true_and_in_metres(exercise_id: str) -> None:
    instance = generate(exercise(exercise_id), "5")
    geometry = figure_geometry(instance)
    metres = float(instance.exercise.length_unit.metres_per_unit)
    for dimension in geometry["dimensions"]:  # type: ignore[attr-defined]
        length = np.linalg.norm(np.array(dimension["to"]) - np.array(dimension["from"]))
        assert length == pytest.approx(instance.parameters[dimension["name"]] * metres)


@pytest.mark.parametrize("exercise_id", ALL)
def test_axes_are_those_of_the_reference(exercise_id: str) -> None:
    """The figure's axes, turned back by the key's base, are the axes of the key at the figure's posture."""
    from kinematics.chain import chain_of_table, joint_motions
    from kinematics.table import bind

    instance = generate(exercise(exercise_id), "5")
    found = instance.exercise
    scene, key = true_scene(instance), key_pose(instance)
    chain = chain_of_table(bind(found.reference.table, instance.values))
    posture = np.array(found.figure.posture or [0.0] * len(chain.axes))
    motions = joint_motions(chain, posture[:, None])[:, 0]
    pose = np.array(key.base)
    for drawn_axis, direction, axis, motion in zip(
        scene.axes, key.directions, chain.axes, motions, strict=True
    ):
        assert pose[:3, :3] @ np.array(axis.direction) == pytest.approx(np.array(direction), abs=1e-9)
        if not axis.prismatic:
            away = np.array(drawn_axis.point) - (pose[:3, :3] @ np.array(axis.point) + pose[:3, 3])
            assert np.cross(away, np.array(direction)) == pytest.approx(np.zeros(3), abs=1e-6 * scene.size)
        pose = pose @ motion


@pytest.mark.parametrize("exercise_id", ALL)
def test_the_description_speaks_of_every_joint_and_dimension(exercise_id: str) -> None:
    found = exercise(exercise_id)
    sentences = figure_sentences(generate(found))
    joints = [entry.params["joint"] for entry in sentences if entry.code.startswith("joint-")]
    assert joints == list(range(1, found.reference.table.n_joints + 1))
    assert [entry.params["name"] for entry in sentences if entry.code == "dimension"] == [
        mark.name for mark in found.figure.dimensions
    ]
    assert bool(found.figure.lengths) is any(entry.code == "not-to-scale" for entry in sentences)


@pytest.mark.parametrize("exercise_id", ["scara-frame-mistake", "twolink-frames"])
def test_description_task_and_geometry_count_in_the_same_coordinates(exercise_id: str) -> None:
    """The words counted from where the robot is fixed, what was asked and drawn from the key's frame 0."""
    found = generate(exercise(exercise_id))
    (kind,) = (part for part in found.exercise.parts if part.kind in {"frames", "frame_mistake"})
    told = part_type(kind.kind).task(kind, found).values
    scene = true_scene(found)
    assert scene.ground is not None
    first, *others = figure_sentences(found)
    assert [told[name] for name in ("x", "fixed", "at")] == ["right", "ground", first.params["at"]]
    assert numbers_in(first.params["at"]) == pytest.approx(scene.ground.at)
    places = [numbers_in(entry.params["place"]) for entry in others if "place" in entry.params]
    points = [axis.point for axis in scene.axes] + [point.at for point in scene.points]
    assert np.array(places) == pytest.approx(np.array(points), abs=1e-3)


def numbers_in(triple: str | int) -> list[float]:
    return [float(text) for text in str(triple).strip("()").split("; ")]


@pytest.mark.parametrize("azimuth", [-60, -10, 60, 140, 215])
def test_the_words_say_where_x_points_on_paper(azimuth: float) -> None:
    found = generate(exercise("scara"))
    view = replace(found.exercise.figure.view, azimuth=math.radians(azimuth))
    figure = replace(found.exercise.figure, view=view)
    (first, *_) = figure_sentences(replace(found, exercise=replace(found.exercise, figure=figure)))
    x, towards = camera_for(view).right[0], camera_for(view).eye[0]
    sideways, away = ("right" if x > 0 else "left"), ("front" if towards > 0 else "back")
    assert first.params["x"] == (sideways if abs(x) > abs(towards) else away)


def with_signs(exercise_id: str) -> Instance:
    found = exercise(exercise_id)
    signed: Exercise = replace(found, policy=replace(found.policy, direction=DirectionRule.FIGURE))
    return generate(signed)


@pytest.mark.parametrize("exercise_id", ["puma560", "scara", "stanford", "kr125", "ssrms"])
def test_a_policy_that_fixes_directions_shows_them(exercise_id: str) -> None:
    instance = with_signs(exercise_id)
    root = root_of(instance)
    names = [f"q{joint}" for joint in range(1, instance.exercise.reference.table.n_joints + 1)]
    assert set(names) <= set(texts(root))
    arrows = [node for node in root.iter() if node.get("class") == "sense"]
    assert len(arrows) == 2 * len(names)
    assert [axis.direction for axis in true_scene(instance).axes] == list(key_pose(instance).directions)


def test_arrows_turn_by_the_right_hand_rule() -> None:
    """Joint 1 of the PUMA turns about the vertical: seen from above, the arrow runs counterclockwise."""
    root = root_of(with_signs("puma560"))
    arrow = next(node for node in root.iter() if node.get("class") == "sense")
    points = np.array([[float(v) for v in pair.split()] for pair in str(arrow.get("d"))[1:].split("L")])
    centred = points - points.mean(axis=0)
    area = np.sum(centred[:-1, 0] * centred[1:, 1] - centred[1:, 0] * centred[:-1, 1])
    assert area < 0  # y points down on paper


def test_a_table_alone_gives_a_figure(tmp_path: Path) -> None:
    found = load_exercise(folder(tmp_path))
    root = root_of(generate(found))
    assert sorted(texts(root)) == ["1", "2", "L1", "L2"]


def test_the_last_link_begins_at_the_last_body_alone(tmp_path: Path) -> None:
    """A slider at zero and the joint on it stood apart, and a bar led from each to the end of the arm."""
    rows = """
  { joint = "revolute", theta = "q1", d = "L1", a = 0, alpha = -90 },
  { joint = "prismatic", theta = 0, d = "q2", a = 0, alpha = 90 },
  { joint = "revolute", theta = "q3", d = 0, a = "L2", alpha = 0 },
]"""
    text = re.sub(r"rows = \[(\n.*)*?\n\]", f"rows = [{rows}", TWO_LINKS, count=1)
    scene = true_scene(generate(load_exercise(folder(tmp_path, text))))
    (chain,) = scene.links
    end = max(chain, key=lambda point: math.hypot(point[0], point[1]))
    beside = {
        tuple(np.round(other, 9))
        for one, two in pairwise(chain)
        for point, other in ((one, two), (two, one))
        if point == end
    }
    assert beside == {tuple(np.round(scene.axes[2].point, 9))}


@pytest.mark.parametrize("exercise_id", ALL)
def test_the_automatic_figure_of_every_robot_is_sound(exercise_id: str) -> None:
    from exercises.figures.specification import FigureSpecification

    bare = replace(exercise(exercise_id), figure=FigureSpecification())
    scene = true_scene(generate(bare))
    assert len(scene.axes) == bare.reference.table.n_joints
    assert len(scene.dimensions) >= 1
    assert scene.ground is not None
    root_of(generate(bare))


def test_prismatic_joints_are_blocks_and_revolute_ones_cylinders() -> None:
    scene = true_scene(generate(exercise("stanford")))
    assert [axis.type for axis in scene.axes] == [
        JointType.PRISMATIC if joint == 3 else JointType.REVOLUTE for joint in range(1, 7)
    ]
    bodies = [node for node in drawn("stanford").iter() if node.get("class") == "body"]
    curved = [node for node in bodies if "A" in str(node.get("d"))]
    assert len(curved) == 2 * 5  # a side and a cap each
    assert len(bodies) - len(curved) == 3  # the faces of the block that can be seen


def test_the_camera_keeps_directions() -> None:
    camera = camera_for(exercise("puma560").figure.view)
    frame = np.array([camera.right, camera.up, camera.eye])
    assert frame @ frame.T == pytest.approx(np.eye(3))
    assert np.linalg.det(frame) == pytest.approx(1.0)
    assert camera.project([camera.right, camera.up, camera.eye]) == pytest.approx(
        np.array([[1.0, 0.0], [0.0, -1.0], [0.0, 0.0]])
    )
