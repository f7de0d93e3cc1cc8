/**
 * Robots as models: the exercise's from its figure's geometry, the student's from the API's link matrices.
 * No DH formula stands here. A joint turns or slides about its own z between constant transforms:
 * standard T_i(q) = motion(q) · A_i(0), modified A_i(q) = A_i(0) · motion(q).
 *
 * @typedef {import("./model.js").Model} Model
 * @typedef {import("./model.js").Item} Item
 * @typedef {import("./matrix.js").Matrix} Matrix
 * @typedef {import("./matrix.js").Vector} Vector
 * @typedef {import("./model.js").Motion} Motion
 * @typedef {import("./model.js").Place} Place
 * @typedef {import("./model.js").Tone} Tone
 */

import { directions, VIEWS } from "./camera.js";
import { triad } from "./model.js";
import { piecesOf } from "./bodies.js";
import {
  apply,
  column,
  dot,
  identity,
  inverse,
  minus,
  multiply,
  norm,
  plus,
  poseAlong,
  times,
  unit,
} from "./matrix.js";

/** How large things are drawn, relative to the robot. */
const SIZE = {
  joint: 0.042,
  jointLength: 0.13,
  tube: 0.014,
  triad: 0.15,
  axis: 0.2,
  point: 0.018,
  plate: 0.14,
  dimension: 0.1,
  name: 0.085,
};

/** How the student's robot is drawn. @type {{body: Tone, joint: Tone}} */
const OWN = { body: "own", joint: "own-joint" };

/** Size of a robot from its constant transforms: the sum of its link lengths. @param {Matrix[]} links */
export function reach(links) {
  return links.reduce((sum, link) => sum + norm(column(link, 3)), 0) || 1;
}

/**
 * @typedef {Model & {frames: number[], convention: string}} TableModel `frames` are the nodes of frame 0 … N
 * @typedef {{model: TableModel, row: number, size: number, tones: {body: Tone, joint: Tone}}} Drawing
 *   what a row's pieces are added to, and how they look
 */

/**
 * The robot of a DH table, or of its first rows. What a cell is drawn as can be picked as "row/cell".
 * @param {{convention: "standard" | "modified", rows: {joint: string, sign: number}[], links: Matrix[],
 *   size?: number, prime?: string, tones?: {body: Tone, joint: Tone}}} table
 *   `links` are the API's link matrices with all joints at zero; `size` sets how large symbols are drawn
 * @returns {TableModel}
 */
export function tableRobot({ convention, rows, links, size = reach(links), prime = "", tones = OWN }) {
  /** @type {TableModel} */
  const model = { nodes: [{ parent: -1, constant: identity() }], items: [], joints: 0, frames: [0], convention };
  let frame = 0;
  model.items.push(...triad(0, size * SIZE.triad, "0", { prime }));
  rows.forEach((row, i) => {
    const drawing = { model, row: i, size, tones };
    const before = frame;
    const motion = row.joint === "fixed" ? null : { index: model.joints, type: row.joint, sign: row.sign };
    if (motion) model.joints += 1;
    const add = convention === "standard" ? addStandard : addModified;
    frame = add(drawing, before, /** @type {Motion | null} */ (motion), links[i]);
    model.frames.push(frame);
    const stagger = 1 - 0.12 * ((i + 1) % 3);
    const axes = triad(frame, size * SIZE.triad * stagger, String(i + 1), { prime });
    model.items.push(
      ...axes.map((item) => (item.kind === "arrow" && item.tone === "z" ? { ...item, pick: `${i}/alpha` } : item)),
    );
  });
  return model;
}

/** @param {Drawing} drawing @param {number} before @param {Motion | null} motion @param {Matrix} link */
function addStandard(drawing, before, motion, link) {
  const { model } = drawing;
  const origin = column(link, 3);
  const corner = /** @type {Vector} */ ([0, 0, origin[2]]);
  const joint = model.nodes.push({ parent: before, constant: identity(), motion }) - 1;
  const frame = model.nodes.push({ parent: joint, constant: link }) - 1;
  addTube(drawing, { node: before, at: [0, 0, 0] }, { node: joint, at: corner }, "d");
  addTube(drawing, { node: joint, at: corner }, { node: frame, at: [0, 0, 0] }, "a");
  addJoint(drawing, motion, before, joint);
  return frame;
}

/** @param {Drawing} drawing @param {number} before @param {Motion | null} motion @param {Matrix} link */
function addModified(drawing, before, motion, link) {
  const { model } = drawing;
  const origin = column(link, 3);
  const axis = column(link, 2);
  const corner = minus(origin, times(axis, dot(origin, axis)));
  const frame = model.nodes.push({ parent: before, constant: link, motion }) - 1;
  addTube(drawing, { node: before, at: [0, 0, 0] }, { node: before, at: corner }, "a");
  addTube(drawing, { node: before, at: corner }, { node: frame, at: [0, 0, 0] }, "d");
  addJoint(drawing, motion, frame, frame);
  return frame;
}

/** @param {Drawing} drawing @param {Place} from @param {Place} to @param {string} cell that its length stands in */
function addTube({ model, row, size, tones }, from, to, cell) {
  const still = from.node === to.node && norm(minus(from.at, to.at)) < size * 1e-6;
  if (still) return;
  model.items.push({ kind: "tube", from, to, radius: size * SIZE.tube, tone: tones.body, pick: `${row}/${cell}` });
}

/** @param {Drawing} drawing @param {Motion | null} motion @param {number} turning @param {number} sliding nodes */
function addJoint({ model, row, size, tones }, motion, turning, sliding) {
  if (!motion) return;
  const axis = /** @type {Vector} */ ([0, 0, 1]);
  const length = size * SIZE.jointLength;
  const tone = tones.joint;
  if (motion.type === "prismatic") {
    const at = { node: sliding, at: /** @type {Vector} */ ([0, 0, 0]) };
    model.items.push({ kind: "block", at, axis, length, width: size * SIZE.joint * 1.6, tone, pick: `${row}/d` });
  } else {
    const at = { node: turning, at: /** @type {Vector} */ ([0, 0, 0]) };
    model.items.push({ kind: "cylinder", at, axis, length, radius: size * SIZE.joint, tone, pick: `${row}/theta` });
  }
}

/**
 * The robot of an exercise, from the geometry that its figure is drawn from. Each joint is a node with its z
 * along the axis, and one that moves in it, so that the robot can be moved from the posture of its figure.
 * @param {Omit<Wire.Figure, "description" | "size"> & {size?: number}} figure
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
    const motion = pieces ? /** @type {Motion} */ ({ index: i, type: axis.type, sign: 1 }) : null;
    model.nodes.push({ parent: 2 * i - 1, constant }, { parent: 2 * i, constant: identity(), motion });
  });
  model.joints = pieces ? figure.axes.length : 0;
  for (const { from, to, body } of pieces ?? unmoved(figure.links)) {
    const ends = { from: bodyPlace(world, body, from), to: bodyPlace(world, body, to) };
    model.items.push({ kind: "tube", ...ends, radius: size * SIZE.tube * 1.4, tone: "body" });
  }
  const names = namePlaces(
    world,
    size,
    (figure.points ?? []).map(({ at }) => at),
  );
  figure.axes.forEach((axis, i) => model.items.push(...axisItems(axis, 2 * i, size, names[i])));
  if (figure.ground) {
    const at = { node: -1, at: figure.ground.at };
    model.items.push({
      kind: "cylinder",
      at,
      axis: figure.ground.normal,
      length: size * 0.008,
      radius: size * SIZE.plate,
      tone: "plate",
    });
  }
  for (const point of figure.points ?? []) {
    const place = bodyPlace(world, pieces ? bodyOf(point.at, pieces, size) : 0, point.at);
    model.items.push({ kind: "ball", at: place, radius: size * SIZE.point, tone: "pick" });
    model.items.push({ kind: "label", at: place, ...named(point.name), tone: "pick" });
  }
  /** @param {any} point */
  const bodyAt = (point) => (pieces ? bodyOf(point, pieces, size) : 0);
  if (dimensions)
    for (const mark of figure.dimensions ?? []) model.items.push(...dimensionItems(mark, bodyAt, world, size));
  return model;
}

/** @param {any} links */
function unmoved(links) {
  return links.flatMap((/** @type {any} */ chain) =>
    chain.slice(1).map((/** @type {any} */ to, /** @type {number} */ k) => ({ from: chain[k], to, body: 0 })),
  );
}

/** The body on which a marked point lies: the last that reaches it. @param {any} point @param {any} pieces @param {number} size */
function bodyOf(point, pieces, size) {
  const ends = pieces.filter((/** @type {any} */ { from, to }) =>
    [from, to].some((end) => norm(minus(end, point)) < size * 1e-6),
  );
  return ends.at(-1)?.body ?? 0;
}

/** @param {any} world @param {any} body @param {any} point */
function bodyPlace(world, body, point) {
  return body === 0 ? { node: -1, at: point } : { node: 2 * body - 1, at: apply(inverse(world[body - 1]), point) };
}

/**
 * Where the number of each joint stands, in its node's coordinates: at the end of its axis, unless it would be seen on
 * another joint's body, another number or a marked point from the usual corner; then at the other end or beside the
 * joint, wherever there is most room.
 * @param {Matrix[]} world poses of the axes, z along them @param {number} size @param {Vector[]} [marks] points with names
 * @returns {Vector[]}
 */
export function namePlaces(world, size, marks = []) {
  const end = size * SIZE.axis * 1.12;
  const beside = size * SIZE.joint * 3;
  /** @type {Vector[]} */
  const candidates = [
    [0, 0, end],
    [0, 0, -end],
    [beside, 0, 0],
    [-beside, 0, 0],
    [0, beside, 0],
    [0, -beside, 0],
  ];
  const taken = marks.map(seen);
  return world.map((pose, i) => {
    const others = world.filter((_, k) => k !== i);
    const room = (/** @type {Vector} */ at) => {
      const place = seen(apply(pose, at));
      const bodies = others.map((other) => distanceToBody(place, other, size));
      return Math.min(...bodies, ...taken.map((name) => norm(minus(name, place))), Infinity);
    };
    const rooms = candidates.map(room);
    const free = rooms.findIndex((found) => found > size * SIZE.name);
    const best = candidates[free >= 0 ? free : rooms.indexOf(Math.max(...rooms))];
    taken.push(seen(apply(pose, best)));
    return best;
  });
}

const CORNER = directions({ ...VIEWS.corner, scale: 1, target: [0, 0, 0], width: 0, height: 0 });

/** A point as it is seen from the usual corner: to the right and up. @param {Vector} point @returns {Vector} */
const seen = (point) => [dot(point, CORNER.right), dot(point, CORNER.up), 0];

/** How far a place in the picture is from the middle line of a joint's body. @param {Vector} place @param {Matrix} pose @param {number} size */
function distanceToBody(place, pose, size) {
  const half = (size * SIZE.jointLength) / 2;
  const [low, high] = [-half, half].map((z) => seen(apply(pose, [0, 0, z])));
  const way = minus(high, low);
  const length = dot(way, way);
  const share = length > 0 ? Math.max(0, Math.min(1, dot(minus(place, low), way) / length)) : 0;
  return norm(minus(place, plus(low, times(way, share))));
}

/** @param {Wire.Figure["axes"][number]} axis @param {number} node @param {number} size @param {Vector} name @returns {Item[]} */
function axisItems(axis, node, size, name) {
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
    { kind: "label", at: { node, at: name }, text: String(axis.joint), tone: "line" },
  ]);
}

/** To the right as one looks from the usual corner; where dimensions of upright lengths stand. */
const ASIDE = /** @type {Vector} */ ([0.867, 0.498, 0]);

/**
 * A dimension beside its length; its ends move with the pieces that they lie on.
 * @returns {Item[]}
 * @param {any} mark @param {any} bodyAt @param {any} world @param {number} size
 */
function dimensionItems(mark, bodyAt, world, size) {
  const along = unit(minus(mark.to, mark.from));
  const away = Math.abs(along[2]) > 0.9 ? ASIDE : /** @type {Vector} */ ([0, 0, 1]);
  const side = times(unit(minus(away, times(along, dot(away, along)))), size * SIZE.dimension);
  const [start, end] = [mark.from, mark.to].map((point) => {
    const body = bodyAt(point);
    return (/** @type {number} */ forward, /** @type {number} */ aside) =>
      bodyPlace(world, body, plus(plus(point, times(along, forward * size)), times(side, aside)));
  });
  /** @param {any} from @param {any} to */
  const line = (from, to) => ({ kind: "line", from, to, tone: "muted" });
  /** @param {any} place @param {any} sense */
  const head = (place, sense) => ({
    kind: "arrow",
    from: place(sense * 0.03, 1),
    to: place(0, 1),
    radius: size * 0.004,
    tone: "muted",
  });
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

/** @param {Pick<Wire.Figure, "links" | "axes">} figure */
function extent(figure) {
  const points = [...figure.links.flat(), ...figure.axes.map((/** @type {any} */ axis) => axis.point)];
  const spans = [0, 1, 2].map((k) => {
    const values = points.map((p) => p[k]);
    return Math.max(...values) - Math.min(...values);
  });
  return Math.hypot(...spans) || 1;
}
