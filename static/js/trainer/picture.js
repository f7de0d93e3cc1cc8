/** The robot's axes in space with the coordinate system, the frames as far as chosen, and what can be clicked. */

import { together, triad } from "../scene/model.js";
import { figureRobot } from "../scene/robots.js";
import { cross, identity, plus, times, unit } from "../scene/matrix.js";
import { same } from "./steps.js";

/** @typedef {import("../scene/model.js").Model} Model */
/** @typedef {import("../scene/model.js").Item} Item */

const SIZE = { triad: 0.16, pick: 0.018, direction: 0.24, coordinates: 0.26, z: 0.2 };

/**
 * @param {Wire.Figure} figure
 * @param {import("./steps.js").State} state
 * @param {Wire.Candidate[]} candidates of the current frame's part, to be clicked by their index
 * @param {import("./steps.js").Part | null} part @param {Wire.Vector[][]} normals ends of each common normal
 * @returns {Model}
 */
export function picture(figure, state, candidates, part, normals) {
  const robot = figureRobot(figure, { dimensions: false });
  const frames = state.frames.map((frame, i) => frameModel(figure, frame, i)).filter((model) => model !== null);
  return together([
    robot,
    coordinates(figure),
    ...frames,
    normalsModel(normals, figure.size),
    choicesModel(figure, state, candidates, part),
  ]);
}

/** From where the figure's coordinates count, which is not always where the robot is fixed. @param {Wire.Figure} figure @returns {Model} */
export function coordinates({ size }) {
  /** @param {Item} item @returns {Item} */
  const drawn = (item) => {
    if (item.kind === "arrow") return { ...item, radius: item.radius * 0.6 };
    return item.kind === "label" ? { ...item, text: item.text.toUpperCase() } : item;
  };
  const items = triad(0, size * SIZE.coordinates, "").map(drawn);
  return { nodes: [{ parent: -1, constant: identity() }], items, joints: 0 };
}

/** @param {number[]} o @param {number[]} x @param {number[]} y @param {number[]} z */
function poseAt(o, x, y, z) {
  return [...[0, 1, 2].map((k) => [x[k], y[k], z[k], o[k]]), [0, 0, 0, 1]];
}

/** A frame as far as it is chosen; a z without an origin stands on the joint's axis. @param {Wire.Figure} figure @param {import("./steps.js").Chosen} frame @param {number} index @returns {Model | null} */
function frameModel(figure, frame, index) {
  const { z, x } = frame;
  const origin = frame.origin ?? (z ? placeOf(figure, index) : null);
  if (!origin) return null;
  const y = z && x ? cross(z, x) : null;
  const axes = [x && "x", y && "y", z && "z"].filter(Boolean).join("");
  const none = [0, 0, 0];
  /** @type {Item[]} */
  const ball = frame.origin
    ? [{ kind: "ball", at: { node: 0, at: [0, 0, 0] }, radius: figure.size * 0.012, tone: "own-joint" }]
    : [];
  const items = [...ball, ...triad(0, figure.size * (x ? SIZE.triad : SIZE.z), String(index), { axes })];
  return { nodes: [{ parent: -1, constant: poseAt(origin, x ?? none, y ?? none, z ?? none) }], items, joints: 0 };
}

/** Where a frame's arrows stand while its origin is open. @param {Wire.Figure} figure @param {number} frame @returns {Wire.Vector} */
export function placeOf(figure, frame) {
  const axis = figure.axes[Math.min(frame, figure.axes.length - 1)];
  return frame < figure.axes.length ? axis.point : plus(axis.point, times(unit(axis.direction), figure.size * 0.18));
}

/** @param {Wire.Vector[][]} normals @param {number} size @returns {Model} */
function normalsModel(normals, size) {
  const items = normals.map(
    ([from, to]) =>
      /** @type {Item} */ (
        to
          ? { kind: "tube", from: { node: 0, at: from }, to: { node: 0, at: to }, radius: size * 0.007, tone: "lit" }
          : { kind: "ball", at: { node: 0, at: from }, radius: size * 0.02, tone: "lit" }
      ),
  );
  return { nodes: [{ parent: -1, constant: identity() }], items, joints: 0 };
}

/**
 * One candidate, lit: while its option is pointed at, or while something is dragged to it.
 * @param {Wire.Figure} figure @param {import("./steps.js").State} state @param {Wire.Candidate} candidate
 * @param {import("./steps.js").Part} part @returns {Model}
 */
export function litModel(figure, state, candidate, part) {
  const { nodes, items } = choicesModel(figure, state, [candidate], part);
  const larger = items.map((item) => ({
    ...item,
    ...("radius" in item ? { radius: item.radius * 1.5 } : {}),
    tone: "lit",
    pick: undefined,
  }));
  return { nodes, items: /** @type {Item[]} */ (larger), joints: 0 };
}

/** @param {Wire.Figure} figure @param {import("./steps.js").State} state @param {Wire.Candidate[]} candidates @param {import("./steps.js").Part | null} part @returns {Model} */
function choicesModel(figure, state, candidates, part) {
  /** @type {Item[]} */
  const items = [];
  if (part) {
    const chosen = state.frames[state.frame];
    const root = chosen.origin ?? placeOf(figure, state.frame);
    const { size } = figure;
    candidates.forEach((candidate, i) => {
      const tone = same(chosen[part], candidate.vector) ? "own-joint" : "pick";
      const pick = String(i);
      if (part === "origin")
        return items.push({
          kind: "ball",
          at: { node: 0, at: candidate.vector },
          radius: size * SIZE.pick,
          tone,
          pick,
        });
      const end = plus(root, times(unit(candidate.vector), size * SIZE.direction));
      return items.push({
        kind: "arrow",
        from: { node: 0, at: root },
        to: { node: 0, at: end },
        radius: size * 0.008,
        tone,
        pick,
      });
    });
  }
  return { nodes: [{ parent: -1, constant: identity() }], items, joints: 0 };
}
