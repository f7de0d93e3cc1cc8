/**
 * What a scene shows, as plain data: a tree of nodes and things drawn at them. Renderers turn it into WebGL
 * or SVG; builders make it from what the API returns.
 *
 * @typedef {import("./matrix.js").Matrix} Matrix
 * @typedef {import("./matrix.js").Vector} Vector
 *
 * @typedef {{index: number, type: "revolute" | "prismatic", sign: number}} Motion
 *   joint `index` (from 0) turns the node about its own z by sign·q, or slides it along it
 * @typedef {{parent: number, constant: Matrix, motion?: Motion | null}} Node
 *   pose in the parent is constant · motion(q); parent -1 is the scene itself
 *
 * @typedef {{node: number, at: Vector}} Place a point that moves with a node
 * @typedef {"body" | "joint" | "own" | "own-joint" | "line" | "x" | "y" | "z" | "pick" | "plate" | "muted"
 *   | "lit" | "ghost" | "ghost-joint" | "shade" | "shade-joint"} Tone
 *   the colours of the design; the style sheet says what they look like
 *
 * @typedef {{kind: "tube", from: Place, to: Place, radius: number, tone: Tone, pick?: string}
 *   | {kind: "cylinder", at: Place, axis: Vector, length: number, radius: number, tone: Tone, pick?: string}
 *   | {kind: "block", at: Place, axis: Vector, length: number, width: number, tone: Tone, pick?: string}
 *   | {kind: "ball", at: Place, radius: number, tone: Tone, pick?: string}
 *   | {kind: "line", from: Place, to: Place, tone: Tone, dashed?: boolean, pick?: string}
 *   | {kind: "arrow", from: Place, to: Place, radius: number, tone: Tone, pick?: string}
 *   | {kind: "points", at: Place, points: Vector[], tone: Tone}
 *   | {kind: "label", at: Place, text: string, tone: Tone, sub?: string}} Item
 *   lengths are in the scene's unit, a cloud's points in the coordinates of its node; `pick` names what a click on
 *   the item means
 *
 * @typedef {{nodes: Node[], items: Item[], joints: number}} Model
 */

import { apply, jointMotion, minus, multiply } from "./matrix.js";

/** A model without anything in it. @returns {Model} */
export function emptyModel() {
  return { nodes: [], items: [], joints: 0 };
}

/**
 * Poses of all nodes at joint values, parents first.
 * @param {Model} model @param {number[]} joints [rad or length] @returns {Matrix[]}
 */
export function poses(model, joints) {
  /** @type {Matrix[]} */
  const found = [];
  for (const node of model.nodes) {
    let local = node.constant;
    if (node.motion) {
      const q = (joints[node.motion.index] ?? 0) * node.motion.sign;
      local = multiply(local, jointMotion(node.motion.type, q));
    }
    found.push(node.parent < 0 ? local : multiply(found[node.parent], local));
  }
  return found;
}

/** Where a place is in the scene. @param {Matrix[]} found @param {Place} place @returns {Vector} */
export function position(found, place) {
  return place.node < 0 ? place.at : apply(found[place.node], place.at);
}

/** A direction that moves with a node, in the scene. @param {Matrix[]} found @param {number} node @param {Vector} v @returns {Vector} */
export function direction(found, node, v) {
  return node < 0 ? v : minus(apply(found[node], v), apply(found[node], [0, 0, 0]));
}

/** Every point that an item spans. @param {Item} item @returns {Place[]} */
export function placesOf(item) {
  return "from" in item ? [item.from, item.to] : [item.at];
}

/** Every point that is drawn, in the scene. @param {Model} model @param {number[]} joints @returns {Vector[]} */
export function drawnPoints(model, joints) {
  const found = poses(model, joints);
  return model.items.flatMap((item) =>
    item.kind === "points"
      ? item.points.map((at) => position(found, { node: item.at.node, at }))
      : placesOf(item).map((place) => position(found, place)),
  );
}

/** A model moved as a whole. @param {Model} model @param {Matrix} by @returns {Model} */
export function placed(model, by) {
  return {
    ...model,
    nodes: [{ parent: -1, constant: by }, ...model.nodes.map((node) => ({ ...node, parent: node.parent + 1 }))],
    items: model.items.map((item) => shifted(item, 1, 0)),
  };
}

const SIZES = ["radius", "length", "width"];

/** A model that stands still at joint values. @param {Model} model @param {number[]} joints [rad or length] @returns {Model} */
export function frozen(model, joints) {
  const found = poses(model, joints);
  return { ...model, nodes: found.map((constant) => ({ parent: -1, constant })), joints: 0 };
}

/** A model in another unit of length. @param {Model} model @param {number} factor @returns {Model} */
export function scaled(model, factor) {
  /** @param {any} value */
  const length = (value) => value * factor;
  /** @param {any} place */
  const point = (place) => ({ ...place, at: /** @type {Vector} */ (place.at.map(length)) });
  return {
    ...model,
    nodes: model.nodes.map((node) => ({ ...node, constant: scaledPose(node.constant, factor) })),
    items: model.items.map((item) => {
      const sizes = Object.fromEntries(
        Object.entries(item).flatMap(([name, value]) => (SIZES.includes(name) ? [[name, length(value)]] : [])),
      );
      const places = "from" in item ? { from: point(item.from), to: point(item.to) } : { at: point(item.at) };
      const cloud = item.kind === "points" ? { points: item.points.map((each) => each.map(length)) } : {};
      return /** @type {Item} */ ({ ...item, ...sizes, ...places, ...cloud });
    }),
  };
}

/** A pose in another unit of length. @param {Matrix} pose @param {number} factor @returns {Matrix} */
export function scaledPose(pose, factor) {
  return pose.map((row, i) => (i < 3 ? [row[0], row[1], row[2], row[3] * factor] : row));
}

/** Several models in one tree, joints side by side. @param {Model[]} models @returns {Model} */
export function together(models) {
  const all = emptyModel();
  for (const model of models) {
    const offset = all.nodes.length;
    for (const node of model.nodes) {
      all.nodes.push({
        ...node,
        parent: node.parent < 0 ? -1 : node.parent + offset,
        motion: node.motion ? { ...node.motion, index: node.motion.index + all.joints } : null,
      });
    }
    for (const item of model.items) all.items.push(shifted(item, offset, -1));
    all.joints += model.joints;
  }
  return all;
}

/** @param {Item} item @param {number} offset @param {number} root @returns {Item} */
function shifted(item, offset, root) {
  /** @param {any} place */
  const move = (place) => ({ ...place, node: place.node < 0 ? root : place.node + offset });
  return "from" in item ? { ...item, from: move(item.from), to: move(item.to) } : { ...item, at: move(item.at) };
}

/**
 * The triad of a frame: three arrows with their names.
 * @param {number} node @param {number} size @param {string} index what stands below x, y, z
 * @param {{axes?: string, prime?: string}} [options]
 * @returns {Item[]}
 */
export function triad(node, size, index, { axes = "xyz", prime = "" } = {}) {
  /** @type {Record<string, Vector>} */
  const ends = { x: [size, 0, 0], y: [0, size, 0], z: [0, 0, size] };
  return [...axes].flatMap((axis) => {
    const end = ends[axis];
    const tone = /** @type {Tone} */ (axis);
    const beyond = /** @type {Vector} */ (end.map((value) => value * 1.18));
    return /** @type {Item[]} */ ([
      { kind: "arrow", from: { node, at: [0, 0, 0] }, to: { node, at: end }, radius: size * 0.04, tone },
      { kind: "label", at: { node, at: beyond }, text: axis + prime, sub: index, tone },
    ]);
  });
}
