/**
 * Robots as models: the exercise's from its figure's geometry, the student's from the API's link matrices.
 * No DH formula stands here. A joint turns or slides about its own z between constant transforms:
 * standard T_i(q) = motion(q) · A_i(0), modified A_i(q) = A_i(0) · motion(q).
 *
 * @typedef {import("./model.js").Model} Model
 * @typedef {import("./model.js").Item} Item
 * @typedef {import("./matrix.js").Matrix} Matrix
 * @typedef {import("./matrix.js").Vector} Vector
 */

import { triad } from "./model.js";
import { piecesOf } from "./bodies.js";
import { apply, column, dot, identity, inverse, minus, multiply, norm, plus, poseAlong, times, unit } from "./matrix.js";

/** How large things are drawn, relative to the robot. */
const SIZE = { joint: 0.042, jointLength: 0.13, tube: 0.014, triad: 0.15, axis: 0.2, point: 0.018, plate: 0.14, dimension: 0.1 };

/** Size of a robot from its constant transforms: the sum of its link lengths. @param {Matrix[]} links */
export function reach(links) {
  return links.reduce((sum, link) => sum + norm(column(link, 3)), 0) || 1;
}

/**
 * The robot of a DH table.
 * @param {{convention: "standard" | "modified", rows: {joint: string, sign: number}[], links: Matrix[],
 *   size?: number, prime?: string}} table
 *   `links` are the API's link matrices with all joints at zero; `size` sets how large symbols are drawn
 * @returns {Model}
 */
export function tableRobot({ convention, rows, links, size = reach(links), prime = "" }) {
  /** @type {Model} */
  const model = { nodes: [{ parent: -1, constant: identity() }], items: [], joints: 0 };
  let frame = 0;
  model.items.push(...triad(0, size * SIZE.triad, "0", { prime }));
  rows.forEach((row, i) => {
    const before = frame;
    const motion = row.joint === "fixed" ? null : { index: model.joints, type: row.joint, sign: row.sign };
    if (motion) model.joints += 1;
    frame = convention === "standard" ? addStandard(model, before, motion, links[i], size) : addModified(model, before, motion, links[i], size);
    const stagger = 1 - 0.12 * ((i + 1) % 3);
    model.items.push(...triad(frame, size * SIZE.triad * stagger, String(i + 1), { prime }));
  });
  return model;
}

function addStandard(model, before, motion, link, size) {
  const origin = column(link, 3);
  const corner = /** @type {Vector} */ ([0, 0, origin[2]]);
  const joint = model.nodes.push({ parent: before, constant: identity(), motion }) - 1;
  const frame = model.nodes.push({ parent: joint, constant: link }) - 1;
  addTube(model, before, [0, 0, 0], joint, corner, size);
  addTube(model, joint, corner, frame, [0, 0, 0], size);
  addJoint(model, motion, before, joint, size);
  return frame;
}

function addModified(model, before, motion, link, size) {
  const origin = column(link, 3);
  const axis = column(link, 2);
  const corner = minus(origin, times(axis, dot(origin, axis)));
  const frame = model.nodes.push({ parent: before, constant: link, motion }) - 1;
  addTube(model, before, [0, 0, 0], before, corner, size);
  addTube(model, before, corner, frame, [0, 0, 0], size);
  addJoint(model, motion, frame, frame, size);
  return frame;
}

function addTube(model, fromNode, from, toNode, to, size) {
  const still = fromNode === toNode && norm(minus(from, to)) < size * 1e-6;
  if (still) return;
  const tube = { kind: "tube", from: { node: fromNode, at: from }, to: { node: toNode, at: to } };
  model.items.push({ ...tube, radius: size * SIZE.tube, tone: "own" });
}

function addJoint(model, motion, turning, sliding, size) {
  if (!motion) return;
  const axis = /** @type {Vector} */ ([0, 0, 1]);
  const length = size * SIZE.jointLength;
  if (motion.type === "prismatic") {
    const width = size * SIZE.joint * 1.6;
    model.items.push({ kind: "block", at: { node: sliding, at: [0, 0, 0] }, axis, length, width, tone: "own-joint" });
  } else {
    const radius = size * SIZE.joint;
    model.items.push({ kind: "cylinder", at: { node: turning, at: [0, 0, 0] }, axis, length, radius, tone: "own-joint" });
  }
}

/**
 * The robot of an exercise, from the geometry that its figure is drawn from. Each joint is a node with its z
 * along the axis, and one that moves in it, so that the robot can be moved from the posture of its figure.
 * @param {{axes: {joint: number, type: string, point: Vector, direction: Vector}[], links: Vector[][],
 *   dimensions?: {name: string, from: Vector, to: Vector}[], points?: {name: string, at: Vector}[],
 *   ground?: {at: Vector, normal: Vector} | null, size?: number}} figure
 * @param {{dimensions?: boolean}} [options]
 * @returns {Model} a model without joints if the figure does not say which piece moves with which joint
 */
export function figureRobot(figure, { dimensions = true } = {}) {
  const size = figure.size || extent(figure);
  /** @type {Model} */
  const model = { nodes: [], items: [], joints: 0 };
  /** @type {Matrix[]} */
  const world = [];
  const pieces = piecesOf(figure.links, figure.axes, size);
  figure.axes.forEach((axis, i) => {
    const pose = poseAlong(axis.point, axis.direction);
    const constant = i === 0 ? pose : multiply(inverse(world[i - 1]), pose);
    world.push(pose);
    const motion = pieces ? { index: i, type: axis.type, sign: 1 } : null;
    model.nodes.push({ parent: 2 * i - 1, constant }, { parent: 2 * i, constant: identity(), motion });
  });
  model.joints = pieces ? figure.axes.length : 0;
  for (const { from, to, body } of pieces ?? unmoved(figure.links)) {
    const ends = { from: bodyPlace(world, body, from), to: bodyPlace(world, body, to) };
    model.items.push({ kind: "tube", ...ends, radius: size * SIZE.tube * 1.4, tone: "body" });
  }
  figure.axes.forEach((axis, i) => model.items.push(...axisItems(axis, 2 * i, size)));
  if (figure.ground) {
    const at = { node: -1, at: figure.ground.at };
    model.items.push({ kind: "cylinder", at, axis: figure.ground.normal, length: size * 0.008, radius: size * SIZE.plate, tone: "plate" });
  }
  for (const point of figure.points ?? []) {
    const place = bodyPlace(world, pieces ? bodyOf(point.at, pieces, size) : 0, point.at);
    model.items.push({ kind: "ball", at: place, radius: size * SIZE.point, tone: "pick" });
    model.items.push({ kind: "label", at: place, ...named(point.name), tone: "pick" });
  }
  const bodyAt = (point) => (pieces ? bodyOf(point, pieces, size) : 0);
  if (dimensions) for (const mark of figure.dimensions ?? []) model.items.push(...dimensionItems(mark, bodyAt, world, size));
  return model;
}

function unmoved(links) {
  return links.flatMap((chain) => chain.slice(1).map((to, k) => ({ from: chain[k], to, body: 0 })));
}

/** The body on which a marked point lies: the last that reaches it. */
function bodyOf(point, pieces, size) {
  const ends = pieces.filter(({ from, to }) => [from, to].some((end) => norm(minus(end, point)) < size * 1e-6));
  return ends.at(-1)?.body ?? 0;
}

function bodyPlace(world, body, point) {
  return body === 0 ? { node: -1, at: point } : { node: 2 * body - 1, at: apply(inverse(world[body - 1]), point) };
}

/** @returns {Item[]} */
function axisItems(axis, node, size) {
  const half = size * SIZE.axis;
  const length = size * SIZE.jointLength;
  const z = /** @type {Vector} */ ([0, 0, 1]);
  const middle = { node, at: /** @type {Vector} */ ([0, 0, 0]) };
  const body =
    axis.type === "prismatic"
      ? { kind: "block", at: middle, axis: z, length, width: size * SIZE.joint * 2, tone: "joint" }
      : { kind: "cylinder", at: middle, axis: z, length, radius: size * SIZE.joint * 1.15, tone: "joint" };
  return /** @type {Item[]} */ ([
    body,
    { kind: "line", from: { node, at: [0, 0, -half] }, to: { node, at: [0, 0, half] }, tone: "line", dashed: true },
    { kind: "label", at: { node, at: [0, 0, half * 1.12] }, text: String(axis.joint), tone: "line" },
  ]);
}

/** To the right as one looks from the usual corner; where dimensions of upright lengths stand. */
const ASIDE = /** @type {Vector} */ ([0.867, 0.498, 0]);

/**
 * A dimension beside its length; its ends move with the pieces that they lie on.
 * @returns {Item[]}
 */
function dimensionItems(mark, bodyAt, world, size) {
  const along = unit(minus(mark.to, mark.from));
  const away = Math.abs(along[2]) > 0.9 ? ASIDE : /** @type {Vector} */ ([0, 0, 1]);
  const side = times(unit(minus(away, times(along, dot(away, along)))), size * SIZE.dimension);
  const [start, end] = [mark.from, mark.to].map((point) => {
    const body = bodyAt(point);
    return (forward, aside) => bodyPlace(world, body, plus(plus(point, times(along, forward * size)), times(side, aside)));
  });
  const line = (from, to) => ({ kind: "line", from, to, tone: "muted" });
  const head = (place, sense) => ({ kind: "arrow", from: place(sense * 0.03, 1), to: place(0, 1), radius: size * 0.004, tone: "muted" });
  const half = norm(minus(mark.to, mark.from)) / 2 / size;
  return /** @type {Item[]} */ ([
    line(start(0, 1), end(0, 1)),
    line(start(0, 0), start(0, 1.15)),
    line(end(0, 0), end(0, 1.15)),
    head(start, 1),
    head(end, -1),
    { kind: "label", at: start(half, 1.35), ...named(mark.name), tone: "muted" },
  ]);
}

/** A name with its digits as an index. @param {string} name */
function named(name) {
  const match = /^([A-Za-z]+)_?(\d+)$/.exec(name);
  return match ? { text: match[1], sub: match[2] } : { text: name };
}

function extent(figure) {
  const points = [...figure.links.flat(), ...figure.axes.map((axis) => axis.point)];
  const spans = [0, 1, 2].map((k) => {
    const values = points.map((p) => p[k]);
    return Math.max(...values) - Math.min(...values);
  });
  return Math.hypot(...spans) || 1;
}
