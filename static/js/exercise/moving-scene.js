/** A scene whose robots move by themselves, or as a slider is dragged: to see that they stay together, or where they part. */

import { el, icon } from "../dom.js";
import { t } from "../i18n.js";
import { Player } from "../scene/player.js";

/** How many poses of the motion the picture is fitted to. */
const SAMPLES = 60;

/**
 * @param {{model: import("../scene/model.js").Model, joints: (change: number[]) => number[], types: string[],
 *   reach: number, label: string, text: string, description: string}} given
 *   `joints` are the scene's joint values when each joint has moved so far [rad or m]; `reach` is the robot's size [m]
 */
export function movingScene({ model, joints, types, reach, label, text, description }) {
  const scene = /** @type {any} */ (el("robot-scene", { label }));
  const range = (/** @type {string} */ type) => (type === "prismatic" ? reach * 0.12 : 0.9);
  const at = (/** @type {number} */ phase) => joints(types.map((type, i) => wave(phase, i) * range(type)));
  const pose = (/** @type {number} */ phase) => (scene.joints = at(phase));
  scene.motion = Array.from({ length: SAMPLES }, (_, k) => at(k / SAMPLES));
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
      el("p", { class: "hint", text }),
      scene,
      el("div", { class: "row no-print" }, button, slider),
    ),
    describe: () => scene.describe(description),
    stop: () => player.pause(),
  };
}

/** A motion that starts at rest and takes each joint its own way. @param {number} phase 0 … 1 @param {number} i */
function wave(phase, i) {
  const turn = 2 * Math.PI * phase;
  return (Math.sin(turn * (1 + (i % 3)) + i * 0.9) - Math.sin(i * 0.9)) / 1.6;
}
