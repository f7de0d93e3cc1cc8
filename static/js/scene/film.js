/**
 * The film of a row: frame i−1 carried into frame i by four elementary motions, in the order of the convention.
 * What moves is a triad; what it has moved along stays as an arc or a ruler, lit while it is that cell's turn.
 *
 * @typedef {import("./matrix.js").Matrix} Matrix
 * @typedef {import("./matrix.js").Vector} Vector
 * @typedef {import("./model.js").Item} Item
 * @typedef {"alpha" | "a" | "d" | "theta"} CellName
 * @typedef {{cell: CellName, axis: "x" | "z", turns: boolean, amount: number}} Step
 *   about or along which axis of the moving frame, by how much [rad or length]
 */

import { apply, identity, multiply } from "./matrix.js";
import { triad } from "./model.js";

/** Motions in the order in which each convention multiplies them. @type {Record<string, CellName[]>} */
export const ORDER = { standard: ["theta", "d", "a", "alpha"], modified: ["alpha", "a", "theta", "d"] };

const SIZE = { triad: 0.19, arc: 0.13, width: 0.019 };
/** Chords of an arc, one for about every 9°. */
const CHORD = Math.PI / 20;

/**
 * The steps of a row at a joint value.
 * @param {string} convention @param {import("../understanding.js").ReadRow} row whose four cells have numbers
 * @param {number} q its joint's value [rad or length]; of no account in a fixed row
 * @returns {Step[]}
 */
export function stepsOf(convention, row, q) {
  const moved = { revolute: "theta", prismatic: "d", fixed: "" }[row.joint];
  return ORDER[convention].map((cell) => ({
    cell,
    axis: cell === "theta" || cell === "d" ? "z" : "x",
    turns: cell === "theta" || cell === "alpha",
    amount: (row.values[cell] ?? 0) + (cell === moved ? row.sign * q : 0),
  }));
}

/** A turn about or a slide along an axis. @param {Step} step @param {number} share of it @returns {Matrix} */
export function motion({ axis, turns, amount }, share = 1) {
  const by = amount * share;
  const matrix = identity();
  if (!turns) matrix[axis === "x" ? 0 : 2][3] = by;
  else {
    const [i, k] = axis === "x" ? [1, 2] : [0, 1];
    const [c, s] = [Math.cos(by), Math.sin(by)];
    matrix[i][i] = matrix[k][k] = c;
    matrix[k][i] = s;
    matrix[i][k] = -s;
  }
  return matrix;
}

/** Pose of the moving frame in frame i−1. @param {Step[]} steps @param {number} phase 0 … the number of steps @returns {Matrix} */
export function poseAt(steps, phase) {
  return steps.reduce((pose, step, k) => multiply(pose, motion(step, Math.max(0, Math.min(1, phase - k)))), identity());
}

/**
 * What is drawn over the robot at a point of the film.
 * @param {Step[]} steps @param {number} phase @param {Matrix} start pose of frame i−1 in the scene
 * @param {{size: number, index: number, cell?: CellName | null}} options
 *   size of the robot, number of the row from 0, and the cell that is lit; left out, the one whose turn it is
 * @returns {import("./model.js").Model} without joints
 */
export function still(steps, phase, start, { size, index, cell = null }) {
  const lit = cell ?? steps[Math.max(0, Math.ceil(phase) - 1)].cell;
  /** @type {Item[]} */
  const items = [];
  steps.forEach((step, k) => {
    const share = Math.max(0, Math.min(1, phase - k));
    if (share === 0 || step.amount === 0) return;
    const before = multiply(start, poseAt(steps, k));
    items.push(...trace(step, share, before, size, step.cell === lit));
  });
  const node = { parent: -1, constant: multiply(start, poseAt(steps, phase)) };
  const name = phase === 0 ? String(index) : phase === steps.length ? String(index + 1) : "";
  items.push(...triad(0, size * SIZE.triad, name));
  return { nodes: [node], items, joints: 0 };
}

/** The arc or the ruler of a step. @param {Step} step @param {number} share @param {Matrix} before @param {number} size @param {boolean} lit @returns {Item[]} */
function trace(step, share, before, size, lit) {
  const tone = lit ? "lit" : "muted";
  const at = (/** @type {Vector} */ point) => ({ node: -1, at: apply(before, point) });
  const radius = size * SIZE.width * (lit ? 1 : 0.5);
  const by = step.amount * share;
  if (!step.turns) {
    const point = (/** @type {number} */ s) => at(step.axis === "x" ? [s, 0, 0] : [0, 0, s]);
    return [{ kind: "arrow", from: point(0), to: point(by), radius, tone, pick: step.cell }];
  }
  const r = size * SIZE.arc;
  const point = (/** @type {number} */ angle) => {
    const [c, s] = [r * Math.cos(angle), r * Math.sin(angle)];
    return at(step.axis === "z" ? [c, s, 0] : [0, -s, c]);
  };
  const chords = Math.max(2, Math.ceil(Math.abs(by) / CHORD));
  const points = Array.from({ length: chords + 1 }, (_, k) => point((by * k) / chords));
  const tip = /** @type {Item} */ ({
    kind: "arrow",
    from: points[chords - 1],
    to: points[chords],
    radius,
    tone,
    pick: step.cell,
  });
  const bend = points
    .slice(1, -1)
    .map(
      (to, k) =>
        /** @type {Item} */ ({ kind: "tube", from: points[k], to, radius: radius * 0.8, tone, pick: step.cell }),
    );
  return [...bend, tip];
}
