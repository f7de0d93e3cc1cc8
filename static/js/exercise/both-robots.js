/**
 * After a right answer: the exercise's robot and the student's moving together under the certificate
 * F_s(σ∘q + δ) = B · F_r(q) · E. The student's frame 0 stands at B⁻¹ as seen from the key's.
 */

import { t } from "../i18n.js";
import { dot, inverse, multiply } from "../scene/matrix.js";
import { placed, scaled, scaledPose, together } from "../scene/model.js";
import { figureRobot } from "../scene/robots.js";
import { METRES } from "../units.js";
import { movingScene } from "./moving-scene.js";

/**
 * The scene and its joint values as functions of a motion of the exercise's robot away from its figure.
 * @param {{figure: any, own: import("../scene/model.js").Model, certificate: any, units: {angle: string, length: string},
 *   key: {base: number[][], posture: number[], directions: number[][]}}} given
 *   `key` says how the key lies in the figure: pose of its frame 0 [m], joint values [rad or m], senses of its axes
 */
function bothModel({ figure, own, certificate, units, key }) {
  const metres = METRES[units.length];
  const radians = units.angle === "deg" ? Math.PI / 180 : 1;
  const types = figure.axes.map((/** @type {any} */ axis) => axis.type);
  const base = multiply(key.base, inverse(scaledPose(certificate.base, metres)));
  const offsets = certificate.joint_offsets.map(
    (/** @type {any} */ value, /** @type {number} */ i) => value * (types[i] === "prismatic" ? metres : radians),
  );
  const senses = figure.axes.map((/** @type {any} */ axis, /** @type {number} */ i) =>
    Math.sign(dot(axis.direction, /** @type {any} */ (key.directions[i]))),
  );
  const reference = figureRobot(figure, { dimensions: false });
  const model = together([reference, placed(scaled(own, metres), base)]);
  /** @param {any} change */
  const joints = (change) => [
    ...change.slice(0, reference.joints).map((/** @type {any} */ value, /** @type {number} */ i) => senses[i] * value),
    ...change.map(
      (/** @type {any} */ value, /** @type {number} */ i) =>
        certificate.joint_signs[i] * (key.posture[i] + value) + offsets[i],
    ),
  ];
  return { model, joints, types };
}

/** @param {Parameters<typeof bothModel>[0]} given */
export function bothRobots(given) {
  return movingScene({
    ...bothModel(given),
    reach: given.figure.size,
    label: t("form-both-label"),
    text: t("form-both-text"),
    description: t("form-both-description"),
  });
}
