/**
 * After a right answer: the exercise's robot and the student's moving together under the certificate
 * F_s(σ∘q + δ) = B · F_r(q) · E. The student's frame 0 stands at B⁻¹ as seen from the key's.
 */

import { el, icon } from "../dom.js";
import { t } from "../i18n.js";
import { inverse, multiply } from "../scene/matrix.js";
import { placed, together } from "../scene/model.js";
import { figureRobot } from "../scene/robots.js";
import { Player } from "../scene/player.js";

/**
 * @param {{figure: any, own: import("../scene/model.js").Model, certificate: any, world: number[][], posture: number[],
 *   degrees: boolean, types: string[]}} given
 *   `world` is the key's frame 0 in the figure, `posture` the key's joint values in the figure [rad or length]
 */
export function bothRobots({ figure, own, certificate, world, posture, degrees, types }) {
  const reference = figureRobot(figure, { dimensions: false });
  const base = multiply(world, inverse(certificate.base));
  const scene = /** @type {any} */ (el("robot-scene", { label: t("form-both-label") }));
  const offsets = certificate.joint_offsets.map((value, i) =>
    degrees && types[i] === "revolute" ? (value * Math.PI) / 180 : value,
  );
  const size = figure.size;
  const pose = (phase) => {
    const q = posture.map((value, i) => value + wave(phase, i) * (types[i] === "prismatic" ? size * 0.12 : 0.9));
    const ownJoints = q.map((value, i) => certificate.joint_signs[i] * value + offsets[i]);
    scene.joints = [...q.map((value, i) => value - posture[i]), ...ownJoints];
  };
  scene.model = together([reference, placed(own, base)]);
  pose(0);
  const player = new Player(pose);
  const slider = /** @type {HTMLInputElement} */ (
    el("input", { type: "range", min: 0, max: 1, step: 0.002, value: "0", "aria-label": t("form-both-position"), oninput: () => (player.pause(), pose(Number(slider.value)), show()) })
  );
  const button = el("button", { type: "button", onclick: () => (player.playing ? player.pause() : player.play(), show()) });
  const show = () => {
    button.replaceChildren(icon(player.playing ? "pause" : "play"), t(player.playing ? "form-pause" : "form-play"));
  };
  show();
  if (!matchMedia("(prefers-reduced-motion: reduce)").matches) {
    player.play();
    show();
  }
  return {
    element: el("div", { class: "both" }, el("p", { class: "hint", text: t("form-both-text") }), scene, el("div", { class: "row no-print" }, button, slider)),
    describe: () => scene.describe(t("form-both-description")),
    stop: () => player.pause(),
  };
}

/** A motion that starts at rest and takes each joint its own way. @param {number} phase 0 … 1 @param {number} i */
function wave(phase, i) {
  const turn = 2 * Math.PI * phase;
  return (Math.sin(turn * (1 + (i % 3)) + i * 0.9) - Math.sin(i * 0.9)) / 1.6;
}
