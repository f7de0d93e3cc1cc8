/** The drawn axes in space, with what can be clicked: points of a grid and of other axes, and directions. */

import { identity, norm, minus, plus, times, unit, dot } from "../scene/matrix.js";

/** @typedef {import("../scene/model.js").Item} Item */
/** @typedef {import("../scene/matrix.js").Vector} Vector */
/** @typedef {{joint: string, point: Vector, direction: Vector}} PlacedAxis as the service places it */

const SIZE = { half: 0.16, joint: 0.03, pick: 0.02, arrow: 0.16, grid: 8 };

/**
 * @param {PlacedAxis[]} axes @param {number} selected
 * @returns {{model: import("../scene/model.js").Model, picks: Record<string, any>}} what a click on each thing means: `point` or
 *   `direction` of the selected axis, or `select`
 */
export function drawnAxes(axes, selected) {
  const size = extent(axes);
  /** @type {Item[]} */
  const items = [];
  /** @type {Record<string, any>} */
  const picks = {};
  const at = (/** @type {Vector} */ point) => ({ node: 0, at: point });
  /** @param {any} item @param {string} id @param {any} meaning */
  const pickable = (item, id, meaning) => {
    picks[id] = meaning;
    items.push({ ...item, pick: id });
  };
  axes.forEach(({ joint, point, direction }, i) => {
    const tone = i === selected ? "own-joint" : "joint";
    const along = times(unit(direction), size * SIZE.half);
    const body =
      joint === "prismatic"
        ? { kind: "block", at: at(point), axis: direction, length: size * 0.1, width: size * SIZE.joint * 1.8, tone }
        : { kind: "cylinder", at: at(point), axis: direction, length: size * 0.1, radius: size * SIZE.joint, tone };
    pickable(body, `select ${i}`, { select: i });
    items.push({ kind: "line", from: at(minus(point, along)), to: at(plus(point, along)), tone: "line", dashed: true });
    items.push({ kind: "label", at: at(plus(point, times(along, 1.15))), text: String(i + 1), tone: "line" });
    if (i > 0 && norm(minus(point, axes[i - 1].point)) > 1e-9)
      items.push({ kind: "tube", from: at(axes[i - 1].point), to: at(point), radius: size * 0.008, tone: "body" });
  });
  const own = axes[selected];
  if (own) {
    addGrid(own, size, pickable);
    axes.slice(0, selected).forEach((axis, i) => addPointsOn(axis, i + 1, size, pickable));
    addDirections(own, axes.slice(0, selected), size, pickable);
  }
  return { model: { nodes: [{ parent: -1, constant: identity() }], items, joints: 0 }, picks };
}

/** Points of a grid on the ground. @param {PlacedAxis} own @param {number} size @param {any} pickable */
function addGrid(own, size, pickable) {
  const step = niceStep(size / SIZE.grid);
  for (let i = -2; i <= 2; i += 1)
    for (let k = -2; k <= 2; k += 1) {
      const point = [round(i * step), round(k * step), round(own.point[2])];
      const ball = { kind: "ball", at: { node: 0, at: point }, radius: size * SIZE.pick, tone: "muted" };
      pickable(ball, `grid ${i} ${k}`, { point });
    }
}

/** Points along another axis. @param {PlacedAxis} axis @param {number} number @param {number} size @param {any} pickable */
function addPointsOn({ point, direction }, number, size, pickable) {
  const step = niceStep(size / SIZE.grid);
  for (let k = -2; k <= 2; k += 1) {
    const place = plus(point, times(unit(direction), k * step));
    const ball = { kind: "ball", at: { node: 0, at: place }, radius: size * SIZE.pick, tone: "pick" };
    pickable(ball, `on ${number} ${k}`, { point: { on: number, at: round(k * step) } });
  }
}

/** Arrows along x, y, z and along the other axes. @param {PlacedAxis} own @param {PlacedAxis[]} others @param {number} size @param {any} pickable */
function addDirections(own, others, size, pickable) {
  /** @type {[Vector, any][]} */
  const ways = [];
  others.forEach(({ direction }, i) => {
    ways.push([direction, { parallel: i + 1 }], [times(direction, -1), { opposite: i + 1 }]);
  });
  for (const vector of /** @type {Vector[]} */ ([
    [1, 0, 0],
    [-1, 0, 0],
    [0, 1, 0],
    [0, -1, 0],
    [0, 0, 1],
    [0, 0, -1],
  ]))
    ways.push([vector, vector]);
  /** @type {Vector[]} */
  const shown = [];
  for (const [vector, direction] of ways) {
    if (shown.some((other) => dot(unit(other), unit(vector)) > 1 - 1e-9)) continue;
    shown.push(vector);
    const current = dot(unit(own.direction), unit(vector)) > 1 - 1e-9;
    const end = plus(own.point, times(unit(vector), size * SIZE.arrow));
    const arrow = {
      kind: "arrow",
      from: { node: 0, at: own.point },
      to: { node: 0, at: end },
      radius: size * 0.007,
      tone: current ? "own-joint" : "pick",
    };
    pickable(arrow, `along ${shown.length}`, { direction });
  }
}

/** @param {PlacedAxis[]} axes */
function extent(axes) {
  const spans = [0, 1, 2].map((k) => {
    const along = axes.map(({ point }) => point[k]);
    return Math.max(0, ...along) - Math.min(0, ...along);
  });
  return Math.hypot(...spans) || 1;
}

/** @param {number} length */
function niceStep(length) {
  const power = 10 ** Math.floor(Math.log10(length));
  return power * ([1, 2, 5, 10].find((factor) => factor * power >= length) ?? 10);
}

/** @param {number} value */
function round(value) {
  return Number(value.toPrecision(9));
}
