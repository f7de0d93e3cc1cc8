/**
 * After a right answer: the exercise's robot and the student's moving together under the certificate
 * F_s(σ∘q + δ) = B · F_r(q) · E. The student's frame 0 stands at B⁻¹ as seen from the key's.
 */

import { el, icon } from "../dom.js";
import { t } from "../i18n.js";
import { dot, inverse, multiply } from "../scene/matrix.js";
import { placed, scaled, scaledPose, together } from "../scene/model.js";
import { Player } from "../scene/player.js";
import { figureRobot } from "../scene/robots.js";
import { METRES } from "../units.js";

/**
 * The scene and its joint values as functions of a motion of the exercise's robot away from its figure.
 * @param {{figure: any, own: import("../scene/model.js").Model, certificate: any, units: {angle: string, length: string},
 *   key: {base: number[][], posture: number[], directions: number[][]}}} given
 *   `key` says how the key lies in the figure: pose of its frame 0 [m], joint values [rad or m], senses of its axes
 */
export function bothModel({ figure, own, certificate, units, key }) {
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
  const { model, joints, types } = bothModel(given);
  const scene = /** @type {any} */ (el("robot-scene", { label: t("form-both-label") }));
  const reach = given.figure.size;
  /** @param {number} phase */
  const pose = (phase) => {
    scene.joints = joints(
      types.map(
        (/** @type {any} */ type, /** @type {number} */ i) =>
          wave(phase, i) * (type === "prismatic" ? reach * 0.12 : 0.9),
      ),
    );
  };
  scene.model = model;
  pose(0);
  const player = new Player(pose);
  const slider = /** @type {HTMLInputElement} */ (
    el("input", {
      type: "range",
      min: 0,
      max: 1,
      step: 0.002,
      value: "0",
      "aria-label": t("form-both-position"),
      oninput: () => (player.pause(), pose(Number(slider.value)), show()),
    })
  );
  const button = el("button", {
    type: "button",
    onclick: () => (player.playing ? player.pause() : player.play(), show()),
  });
  const show = () => {
    button.replaceChildren(icon(player.playing ? "pause" : "play"), t(player.playing ? "form-pause" : "form-play"));
  };
  show();
  if (!matchMedia("(prefers-reduced-motion: reduce)").matches) {
    player.play();
    show();
  }
  return {
    element: el(
      "div",
      { class: "both" },
      el("p", { class: "hint", text: t("form-both-text") }),
      scene,
      el("div", { class: "row no-print" }, button, slider),
    ),
    describe: () => scene.describe(t("form-both-description")),
    stop: () => player.pause(),
  };
}

/** A motion that starts at rest and takes each joint its own way. @param {number} phase 0 … 1 @param {number} i */
function wave(phase, i) {
  const turn = 2 * Math.PI * phase;
  return (Math.sin(turn * (1 + (i % 3)) + i * 0.9) - Math.sin(i * 0.9)) / 1.6;
}
