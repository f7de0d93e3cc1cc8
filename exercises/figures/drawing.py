"""A scene as SVG."""

from collections.abc import Mapping, Sequence
from itertools import pairwise
from typing import Any

import numpy as np

from exercises.figures import dimensioning
from exercises.figures.bodies import Body, body_of, corners, outline
from exercises.figures.camera import Camera, camera_for, fitted
from exercises.figures.dimensioning import DimensionLine, halo
from exercises.figures.geometry import Scene, scene_points
from exercises.figures.labels import DISC, NAME_SIZE, Written, name_places, number_places
from exercises.figures.placement import PaperMap, Placer, Places
from exercises.figures.shapes import (
    Arrow,
    arrows,
    axis_ends,
    draw_arrow,
    gripper_lines,
    ground_lines,
    sense_arrow,
    trimmed,
)
from exercises.figures.specification import View
from exercises.figures.strokes import in_front
from exercises.figures.svg import Canvas, SvgDrawing, line, text_width
from kinematics.frames.wrong_frames import DrawnFrame
from kinematics.se3 import Floats
from kinematics.table import JointType

HEIGHT = 450.0
MARGIN = 62.0
EDGE = 8.0
NARROWEST = 420.0
MOST_SCALE = 2000.0
LINK_WIDTH = 7.5
LINK_CORE = 4.7
NUMBER_SIZE = 14.0
NOTE_SIZE = 13.0
"""Sizes of the drawing in its own units, of which a page of text is 700 wide: chosen by eye, so that
numbers are as large as the text beside them."""

_TUBE = np.array(((-2.5, 0.0), (2.5, 0.0), (0.0, -2.5), (0.0, 2.5), (0.0, 0.0)))
"""Shifts of a link's line under which its tube covers the map."""

Style = dict[str, Any]


def draw_figure(
    scene: Scene, view: View, width: float, note: str, frames: Mapping[int, DrawnFrame]
) -> SvgDrawing:
    """Return the figure of a scene, frames drawn over the robot by their numbers, and a note below it."""
    drawing = drawn(scene, view, width, note, frames)
    return SvgDrawing(box=drawing.box(), elements="".join(drawing.canvas.parts))


def drawn(scene: Scene, view: View, width: float, note: str, frames: Mapping[int, DrawnFrame]) -> "Drawing":
    """Return a finished drawing; arguments as in `draw_figure`."""
    unscaled = camera_for(view)
    bodies = [body_of(axis, scene.size, unscaled) for axis in scene.axes]
    extent = _extent(scene, bodies)
    camera = fitted(unscaled, extent, width=width - 2 * MARGIN, height=HEIGHT - 2 * MARGIN, most=MOST_SCALE)
    drawing = Drawing(scene, bodies, camera, extent, width, arrows(frames, scene.size, camera))
    drawing.draw()
    if note:
        drawing.draw_note(note)
    return drawing


class Drawing:
    """One figure in the making."""

    def __init__(
        self,
        scene: Scene,
        bodies: Sequence[Body],
        camera: Camera,
        extent: Floats,
        width: float,
        frames: Sequence[Arrow],
    ) -> None:
        self.scene, self.bodies, self.camera, self.frames = scene, bodies, camera, frames
        self.canvas = Canvas()
        self.links = [trimmed(np.array(chain), scene) for chain in scene.links]
        points = camera.project(extent)
        low = points.min(axis=0)
        high = points.max(axis=0)
        top = float(low[1]) - 110.0
        self.paper = PaperMap(4.0 - MARGIN, top, width - 8.0, float(high[1]) + 110.0 - top)
        self.seen: list[Floats] = [points]
        self.dimensions: list[DimensionLine] = []

    def draw(self) -> None:
        """Draw everything, from the back to the front."""
        scene, camera = self.scene, self.camera
        axes = [
            axis_ends(axis, body, scene.size) for axis, body in zip(self.scene.axes, self.bodies, strict=True)
        ]
        senses = [
            sense_arrow(axis, body, scene.size, camera)
            for axis, body in zip(self.scene.axes, self.bodies, strict=True)
        ]
        gripper, ground = gripper_lines(scene, camera), ground_lines(scene, camera)
        self.take(axes, senses, gripper, ground)
        dimensions, labels = self.place(axes, senses)
        self.dimensions = dimensions
        for run, width in ground:
            self.canvas.path(line(run), "ground", stroke="currentColor", stroke_width=width)
        for dimension in dimensions:
            dimensioning.draw_extensions(self.canvas, dimension)
        self.strokes(axes)
        for run in gripper:
            self.canvas.path(line(run), "gripper", stroke="currentColor", stroke_width=3.2)
        for sense in senses:
            self.draw_sense(sense)
        for dimension in dimensions:
            dimensioning.draw(self.canvas, dimension)
        for arrow in self.frames:
            draw_arrow(self.canvas, arrow)
        self.draw_labels(labels)
        for dimension in dimensions:
            dimensioning.draw_name(self.canvas, dimension)
            half = np.array([text_width(dimension.name, dimensioning.FONT_SIZE), dimensioning.FONT_SIZE]) / 2
            self.seen.append(np.array([dimension.label - half, dimension.label + half]))
            self.seen.append(np.array(dimension.drawn_line()))

    def box(self) -> tuple[float, float, float, float]:
        """Return left, top, width and height of the paper: as wide as all figures, as high as needed."""
        points = np.concatenate(self.seen)
        low, high = points.min(axis=0) - EDGE, points.max(axis=0) + EDGE
        missing = max(0.0, NARROWEST - float(high[0] - low[0])) / 2
        return (
            float(low[0]) - missing,
            float(low[1]),
            float(high[0] - low[0]) + 2 * missing,
            float(high[1] - low[1]),
        )

    # what is taken, and where the rest goes

    def take(
        self,
        axes: Sequence[tuple[Floats, Floats]],
        senses: Sequence[tuple[Floats, ...]],
        gripper: Sequence[Floats],
        ground: Sequence[tuple[Floats, float]],
    ) -> None:
        """Mark on the map what is drawn before anything is placed."""
        paper, camera = self.paper, self.camera
        for body in self.bodies:
            paper.mark(paper.inside(corners(body, camera)), 3.0)
        for chain in self.links:
            for cells in paper.along(camera.project(chain), _TUBE):
                paper.mark(cells, 2.0)
        for ends in axes:
            paper.mark(paper.along(camera.project(np.array(ends))), 0.8)
        for run in (*gripper, *(run for run, _ in ground), *(s[0] for s in senses if len(s))):
            paper.mark(paper.along(run), 2.0)
            self.seen.append(np.asarray(run))
        for point in self.scene.points:
            paper.mark_square(camera.project(point.at), 10.0, 4.0)
        for arrow in self.frames:
            paper.mark(paper.along(arrow.ends), 1.5)
            self.seen.append(arrow.ends)

    def place(
        self, axes: Sequence[tuple[Floats, Floats]], senses: Sequence[tuple[Floats, ...]]
    ) -> tuple[list[DimensionLine], list[Written]]:
        """Return the places of joints' numbers, points' names, variables' names and dimensions."""
        scene, camera, paper = self.scene, self.camera, self.paper
        labels = [
            number_places(axis, body, camera.project(np.array(ends)), camera, paper)
            for axis, body, ends in zip(scene.axes, self.bodies, axes, strict=True)
        ]
        labels += [name_places(point.name, camera.project(point.at), paper) for point in scene.points]
        labels += [
            name_places(f"q{axis.joint}", sense[2], paper)
            for axis, sense in zip(scene.axes, senses, strict=True)
            if sense
        ]
        labels += [name_places(arrow.name, arrow.ends[1], paper) for arrow in self.frames]
        lines = [dimensioning.dimension_places(dimension, camera, paper) for dimension in scene.dimensions]
        things: list[Places[DimensionLine | Written]] = [*labels, *lines]  # type: ignore[list-item]
        placed = Placer[DimensionLine | Written](paper).place(things)
        return (
            [found for found in placed if isinstance(found, DimensionLine)],
            [found for found in placed if isinstance(found, Written)],
        )

    # drawing

    def strokes(self, axes: Sequence[tuple[Floats, Floats]]) -> None:
        """Draw axes and links, the bodies over them, and whatever passes before a body once more."""
        dash: Style = {"stroke": "currentColor", "stroke_width": 1.3, "stroke_dasharray": "11 3.5 1 3.5"}
        self.draw_links([line(self.camera.project(chain)) for chain in self.links], "round")
        for ends in axes:
            self.canvas.path(line(self.camera.project(np.array(ends))), "axis", **dash)
        for body in sorted(self.bodies, key=lambda body: float(body.centre @ self.camera.eye)):
            self.draw_body(body)
        links = [pair for chain in self.links for pair in pairwise(chain)]
        shown = in_front([*links, *axes], self.bodies, self.camera)
        self.draw_links([line(run) for runs in shown[: len(links)] for run in runs], "butt")
        for runs in shown[len(links) :]:
            for run in runs:
                self.canvas.path(line(run), "axis", **dash)

    def draw_links(self, runs: Sequence[str], cap: str) -> None:
        """Draw links as tubes: all rims first, so that they run into one another."""
        for role, colour, width in (("rim", "currentColor", LINK_WIDTH), ("core", "#fff", LINK_CORE)):
            for run in runs:
                self.canvas.path(run, role, stroke=colour, stroke_width=width, stroke_linecap=cap)

    def draw_body(self, body: Body) -> None:
        """Draw a cylinder or a block, white in front of what is behind it."""
        for role, data in outline(body, self.camera):
            edge: Style = {"stroke": "currentColor", "stroke_width": 1.6}
            self.canvas.path(data, "body", fill="#fff", **edge)
            if role == "side":
                self.canvas.path(data, "shade", fill="currentColor", fill_opacity=0.13)
        if body.type is JointType.REVOLUTE:
            tip = self.camera.project(body.centre + body.axis * body.half)
            self.canvas.circle(tip, 1.6, "tip", fill="currentColor")

    def draw_labels(self, labels: Sequence[Written]) -> None:
        """Write the numbers of joints, names, and the points that are named."""
        for label in labels:
            self.seen.append(np.array([label.at - 12.0, label.at + 12.0]))
            if label.text.isdecimal():
                self.canvas.circle(
                    label.at, DISC, "disc", fill="#fff", stroke="currentColor", stroke_width=1.3
                )
                self.canvas.text(
                    label.at, label.text, "number", NUMBER_SIZE, fill="currentColor", font_weight="bold"
                )
            else:
                halo(self.canvas, label.at, label.text, NAME_SIZE, font_style="italic")
        for point in self.scene.points:
            self.canvas.circle(self.camera.project(point.at), 4.2, "point", fill="currentColor")

    def draw_note(self, note: str) -> None:
        """Write a few words below everything, at the right."""
        points = np.concatenate(self.seen)
        at = np.array(
            [float(points[:, 0].max()) - 0.25 * NOTE_SIZE * len(note), points[:, 1].max() + NOTE_SIZE]
        )
        self.seen.append(np.array([at, at + NOTE_SIZE / 2]))
        self.canvas.text(at, note, "note", NOTE_SIZE, fill="currentColor", fill_opacity=0.75)

    def draw_sense(self, sense: tuple[Floats, ...]) -> None:
        """Draw the arrow of a variable, if it has one."""
        if sense:
            run, head, _ = sense
            self.canvas.path(line(run), "sense", stroke="currentColor", stroke_width=1.6)
            self.canvas.path(line(head), "sense", stroke="currentColor", stroke_width=1.6)


def _extent(scene: Scene, bodies: Sequence[Body]) -> Floats:
    """(n, 3) points in space that must be on the paper: links, points, bodies and their axes."""
    points = list(scene_points(scene))
    for axis, body in zip(scene.axes, bodies, strict=True):
        points += [tuple(end) for end in axis_ends(axis, body, scene.size)]
    return np.array(points)
