/** Draws a scene as SVG: at once, everywhere, also on paper. Nearer things are drawn over farther ones. */

import { svg } from "../dom.js";
import { project } from "./camera.js";
import { direction, emptyModel, placesOf, position } from "./model.js";
import { plus, times, unit } from "./matrix.js";

/** @typedef {import("./model.js").Item} Item */
/** @typedef {import("./matrix.js").Matrix} Matrix */
/** @typedef {import("./matrix.js").Vector} Vector */

export class SvgRenderer {
  model = emptyModel();

  constructor() {
    this.element = svg("svg", { class: "scene-svg", "aria-hidden": "true", focusable: "false" });
  }

  /** @param {import("./model.js").Model} model */
  setModel(model) {
    this.model = model;
  }

  /** @param {import("./matrix.js").Matrix[]} found @param {import("./camera.js").Camera} camera */
  draw(found, camera) {
    const { width, height } = camera;
    this.element.setAttribute("viewBox", `0 0 ${width} ${height}`);
    const shapes = this.model.items
      .filter((item) => item.kind !== "label")
      .map((item) => ({ near: nearness(item, found, camera), item }))
      .sort((a, b) => a.near - b.near);
    this.element.replaceChildren(...shapes.flatMap(({ item }) => shapesOf(item, found, camera)));
  }

  dispose() {
    this.element.remove();
  }
}

/** @param {any} item @param {Matrix[]} found @param {import("./camera.js").Camera} camera */
function nearness(item, found, camera) {
  const depths = placesOf(item).map((place) => project(camera, position(found, place)).near);
  const lift = item.kind === "arrow" ? 0.001 / camera.scale : 0;
  return depths.reduce((sum, depth) => sum + depth, 0) / depths.length + lift;
}

/** @param {Item} item @returns {Element[]} @param {Matrix[]} found @param {import("./camera.js").Camera} camera */
function shapesOf(item, found, camera) {
  const ends = placesOf(item).map((place) => position(found, place));
  switch (item.kind) {
    case "tube":
      return [stroke(camera, ends[0], ends[1], item.radius * 2, item.tone)];
    case "line":
      return [stroke(camera, ends[0], ends[1], 0, item.tone, item.dashed ? "dashed" : "")];
    case "arrow":
      return arrow(camera, ends[0], ends[1], item);
    case "ball": {
      const { x, y } = project(camera, ends[0]);
      const r = Math.max(2, item.radius * camera.scale);
      return [svg("circle", { cx: x.toFixed(1), cy: y.toFixed(1), r: r.toFixed(1), class: `fill-${item.tone}` })];
    }
    case "points":
      return [cloud(item, found, camera)];
    case "label":
      return [];
    default: {
      const half = times(unit(direction(found, item.at.node, item.axis)), item.length / 2);
      const wide = item.kind === "block" ? item.width : item.radius * 2;
      const [a, b] = [plus(ends[0], times(half, -1)), plus(ends[0], half)];
      return [stroke(camera, a, b, wide * 1.12, "edge", item.kind), stroke(camera, a, b, wide, item.tone, item.kind)];
    }
  }
}

/** Every point as a stroke without length: its round cap is a dot. @param {any} item @param {Matrix[]} found @param {import("./camera.js").Camera} camera */
function cloud(item, found, camera) {
  const dots = item.points.map((/** @type {Vector} */ at) => {
    const { x, y } = project(camera, position(found, { node: item.at.node, at }));
    return `M${x.toFixed(1)} ${y.toFixed(1)}h0`;
  });
  return svg("path", { d: dots.join(""), class: `stroke-${item.tone} cloud`, "stroke-width": 2 });
}

/** @param {import("./camera.js").Camera} camera @param {Vector} from @param {Vector} to @param {number} width @param {string} tone */
function stroke(camera, from, to, width, tone, more = "") {
  const a = project(camera, from);
  const b = project(camera, to);
  // A stroke seen from its end has no length; a trace of one lets its cap be drawn.
  const dx = Math.abs(a.x - b.x) + Math.abs(a.y - b.y) < 0.05 ? 0.05 : 0;
  return svg("line", {
    x1: a.x.toFixed(2),
    y1: a.y.toFixed(2),
    x2: (b.x + dx).toFixed(2),
    y2: b.y.toFixed(2),
    class: `stroke-${tone} ${more}`,
    "stroke-width": width ? Math.max(1.5, width * camera.scale).toFixed(2) : 1.4,
  });
}

/** @param {import("./camera.js").Camera} camera @param {Vector} from @param {Vector} to @param {any} item */
function arrow(camera, from, to, item) {
  const a = project(camera, from);
  const b = project(camera, to);
  const length = Math.hypot(b.x - a.x, b.y - a.y);
  const shaft = svg("line", {
    x1: a.x.toFixed(2),
    y1: a.y.toFixed(2),
    x2: b.x.toFixed(2),
    y2: b.y.toFixed(2),
    class: `stroke-${item.tone}`,
    "stroke-width": Math.max(1.6, item.radius * 2 * camera.scale).toFixed(2),
  });
  if (length < 3) return [shaft];
  const head = Math.min(length * 0.5, Math.max(6, item.radius * 6 * camera.scale));
  const ux = (b.x - a.x) / length;
  const uy = (b.y - a.y) / length;
  /** @param {number} side */
  const corner = (side) => `${b.x - ux * head - uy * side * head * 0.4},${b.y - uy * head + ux * side * head * 0.4}`;
  const tip = `${b.x + ux * 2},${b.y + uy * 2}`;
  return [shaft, svg("polygon", { points: `${tip} ${corner(1)} ${corner(-1)}`, class: `fill-${item.tone}` })];
}
