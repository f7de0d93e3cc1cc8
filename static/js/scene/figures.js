/** What answers draw over a robot: a velocity ellipsoid, directions that are blocked, a path, ghosts of postures. */

import { identity, plus, times } from "./matrix.js";
import { frozen, triad } from "./model.js";

/**
 * @typedef {import("./matrix.js").Vector} Vector
 * @typedef {import("./model.js").Item} Item
 * @typedef {import("./model.js").Model} Model
 */

/** A unit of joint rates is drawn so long, relative to what it moves. */
const RATE = 0.3;
const CHORDS = 48;
const BLOCKED = 0.3;
/** Length of a frame's arrows, relative to the robot. */
const FRAME = 0.16;

/** @param {Item[]} items @returns {Model} */
const still = (items) => ({ nodes: [{ parent: -1, constant: identity() }], items, joints: 0 });

/**
 * The ellipsoid of translation by its three principal ellipses, and the directions in which the tip cannot move.
 * @param {Vector} at tip @param {{axes: Vector[], radii: number[]}} ellipsoid @param {number} size of the robot
 * @returns {Model}
 */
export function ellipsoidModel(at, { axes, radii }, size) {
  const items = /** @type {Item[]} */ ([]);
  for (const [i, k] of [
    [0, 1],
    [1, 2],
    [2, 0],
  ]) {
    if (radii[i] === 0 && radii[k] === 0) continue;
    const points = Array.from({ length: CHORDS + 1 }, (_, n) => {
      const turn = (2 * Math.PI * n) / CHORDS;
      const first = times(axes[i], RATE * radii[i] * Math.cos(turn));
      return plus(at, plus(first, times(axes[k], RATE * radii[k] * Math.sin(turn))));
    });
    items.push(...polyline(points, "pick", size * 0.004));
  }
  axes.forEach((axis, i) => {
    if (radii[i] > 0) return;
    const [from, to] = [-1, 1].map((way) => ({ node: 0, at: plus(at, times(axis, way * BLOCKED * size)) }));
    items.push({ kind: "line", from, to, tone: "lit", dashed: true });
    items.push({ kind: "label", at: to, text: "v = 0", tone: "lit" });
  });
  return still(items);
}

/**
 * Frames as somebody drew them: y points where it is drawn.
 * @param {{number: number, origin: number[], x: number[], y: number[], z: number[]}[]} frames @param {number} size of the robot
 * @returns {Model}
 */
export function framesModel(frames, size) {
  /** @type {Model} */
  const model = { nodes: [], items: [], joints: 0 };
  frames.forEach(({ number, origin, x, y, z }) => {
    const constant = [...[0, 1, 2].map((k) => [x[k], y[k], z[k], origin[k]]), [0, 0, 0, 1]];
    const node = model.nodes.push({ parent: -1, constant }) - 1;
    model.items.push(...triad(node, size * FRAME * (1 - 0.1 * (number % 3)), String(number)));
  });
  return model;
}

/** A path as a chain of tubes. @param {Vector[]} points @param {number} size of the robot @returns {Model} */
export function pathModel(points, size) {
  return still(polyline(points, "lit", size * 0.006));
}

/** @param {Vector[]} points @param {import("./model.js").Tone} tone @param {number} radius @returns {Item[]} */
function polyline(points, tone, radius) {
  return points.slice(1).map((to, k) => ({
    kind: "tube",
    from: { node: 0, at: points[k] },
    to: { node: 0, at: to },
    radius,
    tone,
  }));
}

/** The bodies of a robot in a posture, without frames and names. @param {Model} model @param {number[]} joints [rad or length] @returns {Model} */
export function shadeModel(model, joints) {
  const bodies = model.items.filter(({ kind }) => kind === "tube" || kind === "cylinder" || kind === "block");
  const items = bodies.map((item) => ({
    ...item,
    tone: item.tone === "own-joint" ? "shade-joint" : "shade",
    pick: undefined,
  }));
  return frozen({ ...model, items: /** @type {Item[]} */ (items) }, joints);
}
