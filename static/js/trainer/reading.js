/** A row of the trainer's table as a film over its frames, in the posture of the figure. */

import { cross } from "../scene/matrix.js";
import { still, stepsOf } from "../scene/film.js";
import { variableIn } from "./table.js";

/** How long the film of a row takes. */
export const ROWS_SECONDS = 5;

/**
 * @param {string} convention @param {any} row of /check-frames, angles in radians
 * @param {import("./steps.js").Chosen} before the frame that the row starts from
 * @param {number} phase 0 … 4 @param {number} index of the row, from 0 @param {number} size of the robot
 */
export function stillOf(convention, row, before, phase, index, size) {
  const number = (/** @type {string | number} */ value) =>
    typeof value === "number" ? value : variableIn(value).offset;
  const values = { alpha: number(row.alpha), a: number(row.a), d: number(row.d), theta: number(row.theta) };
  const steps = stepsOf(convention, /** @type {any} */ ({ joint: row.joint, sign: 1, values }), 0);
  return still(steps, phase, poseOf(before), { size, index });
}

/** A chosen frame's pose. @param {import("./steps.js").Chosen} frame */
export function poseOf({ origin = [0, 0, 0], x = [1, 0, 0], z = [0, 0, 1] }) {
  const y = cross(z, x);
  return [...[0, 1, 2].map((k) => [x[k], y[k], z[k], origin[k]]), [0, 0, 0, 1]];
}
