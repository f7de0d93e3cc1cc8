/**
 * Which piece of a drawn robot follows which joint. A figure draws links as chains of points from the base on;
 * a chain passes the joints in order, and what comes after a joint moves with it.
 */

import { dot, minus, norm, plus, times } from "./matrix.js";

/** @typedef {import("./matrix.js").Vector} Vector */

const CLOSE = 1e-6;

/**
 * @param {Vector[][]} links @param {{joint: number, point: Vector}[]} axes in joint order @param {number} size of the robot
 * @returns {{from: Vector, to: Vector, body: number}[] | null} pieces with the joint they follow (0: the base),
 *   or null if the joints do not all stand on the chains, in order
 */
export function piecesOf(links, axes, size) {
  const pieces = [];
  /** @type {Set<number>} */
  const met = new Set();
  for (const chain of links) {
    let body = bodyAt(chain, pieces, axes, size);
    if (body > 0) met.add(body);
    for (let k = 1; k < chain.length; k += 1) {
      let from = chain[k - 1];
      for (const { joint, point } of passed(from, chain[k], axes, met, size)) {
        if (joint !== body + 1) return null;
        if (norm(minus(point, from)) > CLOSE * size) pieces.push({ from, to: point, body });
        met.add(joint);
        body = joint;
        from = point;
      }
      if (norm(minus(chain[k], from)) > CLOSE * size) pieces.push({ from, to: chain[k], body });
    }
  }
  return met.size === axes.length ? pieces : null;
}

/**
 * The body that a chain starts with: the base for the first, else that of the piece on which it starts. A rod
 * that starts in the open slides through the first joint that it meets, and belongs to it on both sides.
 * @param {Vector[]} chain @param {any[]} pieces @param {any[]} axes @param {number} size
 */
function bodyAt(chain, pieces, axes, size) {
  if (pieces.length === 0) return 0;
  const piece = [...pieces].reverse().find(({ from, to }) => distance(chain[0], from, to).away < CLOSE * size);
  if (piece) return piece.body;
  for (let k = 1; k < chain.length; k += 1) {
    const [first] = passed(chain[k - 1], chain[k], axes, new Set(), size);
    if (first) return first.joint;
  }
  return 0;
}

/** Joints on a stretch, in the order in which they are met. @param {Vector} from @param {Vector} to @param {any[]} axes @param {Set<number>} met @param {number} size */
function passed(from, to, axes, met, size) {
  return axes
    .filter((/** @type {any} */ { joint }) => !met.has(joint))
    .map((/** @type {any} */ axis) => ({ ...axis, ...distance(axis.point, from, to) }))
    .filter((/** @type {any} */ { away }) => away < CLOSE * size)
    .sort((/** @type {any} */ a, /** @type {any} */ b) => a.along - b.along || a.joint - b.joint);
}

/** @param {Vector} point @param {Vector} from @param {Vector} to */
function distance(point, from, to) {
  const way = minus(to, from);
  const length = dot(way, way);
  const along = length > 0 ? Math.max(0, Math.min(1, dot(minus(point, from), way) / length)) : 0;
  return { along, away: norm(minus(point, plus(from, times(way, along)))) };
}
