/** The robot's axes in space, the frames as far as chosen, and what can be clicked. */

import { together, triad } from "../scene/model.js";
import { figureRobot } from "../scene/robots.js";
import { cross, identity, plus, times, unit } from "../scene/matrix.js";
import { same } from "./choices.js";

const SIZE = { triad: 0.16, pick: 0.03, direction: 0.22 };

/**
 * @param {any} figure the exercise's geometry
 * @param {import("./choices.js").State} state
 * @param {{z: any[], origin: any[], x: any[]}} candidates of the current frame
 * @returns {import("../scene/model.js").Model}
 */
export function picture(figure, state, candidates) {
  const robot = figureRobot({ ...figure, bodies: undefined }, { dimensions: false });
  const frames = state.frames.map((frame, i) => frameModel(frame, i, figure.size)).filter(Boolean);
  return together([robot, ...frames, choicesModel(state, candidates, figure.size)]);
}

/** A frame as far as it is chosen. */
function frameModel(frame, index, size) {
  const { origin, z, x } = frame;
  if (!origin) return null;
  const y = z && x ? cross(z, x) : null;
  const axes = [x && "x", y && "y", z && "z"].filter(Boolean).join("");
  const column = (v) => v ?? [0, 0, 0];
  const constant = [0, 1, 2].map((k) => [column(x)[k], column(y)[k], column(z)[k], origin[k]]);
  return {
    nodes: [{ parent: -1, constant: [...constant, [0, 0, 0, 1]] }],
    items: [
      { kind: "ball", at: { node: 0, at: [0, 0, 0] }, radius: size * 0.012, tone: "own-joint" },
      ...triad(0, size * SIZE.triad, String(index), { axes }),
    ],
    joints: 0,
  };
}

/** What can be clicked for the part that is to be chosen. */
function choicesModel(state, candidates, size) {
  const { part, current, frames } = state;
  const chosen = frames[current][part];
  const root = frames[current].origin ?? candidates.origin[0]?.vector ?? [0, 0, 0];
  const items = candidates[part].flatMap((candidate, i) => {
    const pick = `${part}:${i}`;
    const tone = same(chosen, candidate.vector) ? "own-joint" : "pick";
    if (part === "origin") {
      const at = { node: 0, at: candidate.vector };
      return [
        { kind: "ball", at, radius: size * SIZE.pick * 0.6, tone, pick },
        { kind: "label", at, text: String(i + 1), tone, pick },
      ];
    }
    const end = plus(root, times(unit(candidate.vector), size * SIZE.direction));
    return [
      { kind: "arrow", from: { node: 0, at: root }, to: { node: 0, at: end }, radius: size * 0.008, tone, pick },
      { kind: "label", at: { node: 0, at: plus(root, times(unit(candidate.vector), size * SIZE.direction * 1.12)) }, text: String(i + 1), tone, pick },
    ];
  });
  return { nodes: [{ parent: -1, constant: identity() }], items, joints: 0 };
}
