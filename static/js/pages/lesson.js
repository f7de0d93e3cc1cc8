/** The first lesson: four numbers that move a frame in both conventions, and two axes with their common normal. */

import "../scene/robot-scene.js";
import { el, fill, uniqueId } from "../dom.js";
import { LETTERS } from "../editor/model.js";
import { t } from "../i18n.js";
import { inSentence, radians } from "../numbers.js";
import { robotOf } from "../live-robot.js";
import { api, startPage } from "../page.js";
import { problemNotice } from "../problem.js";
import { ORDER, still, stepsOf } from "../scene/film.js";
import { identity } from "../scene/matrix.js";
import { triad } from "../scene/model.js";

/** @typedef {import("../scene/model.js").Model} Model */
/** @typedef {import("../scene/model.js").Item} Item */

const SIZE = 1;

const place = (/** @type {string} */ id) => /** @type {HTMLElement} */ (document.getElementById(id));

/**
 * A slider with its name and value.
 * @param {string} label @param {{min: number, max: number, step: number, value: number, unit: string}} range
 * @param {(value: number) => void} changed
 */
function slider(label, { min, max, step, value, unit }, changed) {
  const id = uniqueId("slider");
  const text = el("output", { for: id, text: `${inSentence(value, 2)}${unit}` });
  /** @type {HTMLInputElement} */
  const input = el("input", {
    id,
    type: "range",
    min,
    max,
    step,
    value: String(value),
    oninput: () => {
      text.textContent = `${inSentence(Number(input.value), 2)}${unit}`;
      changed(Number(input.value));
    },
  });
  return el("div", { class: "lesson-slider" }, el("label", { for: id, text: label }), input, text);
}

/** The same four numbers in both conventions, motion by motion. */
function fourNumbers() {
  /** @type {Record<string, number>} */
  const values = { theta: radians(40), d: 0.5, a: 0.7, alpha: radians(60) };
  let phase = 4;
  const scenes = ["standard", "modified"].map((convention) => {
    const scene = el("robot-scene", { label: t(`lesson-demo-${convention}`) });
    scene.model = base();
    const letters = ORDER[convention].map((cell) => el("span", { text: LETTERS[cell] }));
    scene.describe(`${t(`lesson-${convention}`)} ${t("form-scene-keys")}`);
    return {
      convention,
      scene,
      letters,
      element: el(
        "figure",
        {},
        el(
          "figcaption",
          {},
          el("strong", { text: t(`lesson-demo-${convention}`) }),
          el(
            "span",
            { class: "lesson-order" },
            letters.flatMap((letter, k) => (k ? [" → ", letter] : [letter])),
          ),
        ),
        scene,
      ),
    };
  });
  const show = () => {
    for (const { convention, scene, letters } of scenes) {
      letters.forEach((letter, k) => letter.classList.toggle("lit", k === Math.ceil(phase) - 1));
      const row = /** @type {any} */ ({ joint: "fixed", sign: 1, values });
      scene.overlay = still(stepsOf(convention, row, 0), phase, identity(), { size: SIZE, index: 0 });
    }
  };
  const set = (/** @type {string} */ name, /** @type {number} */ factor) => (/** @type {number} */ value) => {
    values[name] = value * factor;
    show();
  };
  const turn = { min: -180, max: 180, step: 5, unit: "°" };
  const slide = { min: -1, max: 1, step: 0.05, unit: "" };
  const motion = slider(t("lesson-step"), { min: 0, max: 4, step: 0.05, value: 4, unit: "" }, (value) => {
    phase = value;
    show();
  });
  fill(
    place("four-numbers"),
    el(
      "div",
      { class: "two-columns" },
      scenes.map(({ element }) => element),
    ),
    slider("θ", { ...turn, value: 40 }, set("theta", Math.PI / 180)),
    slider("d", { ...slide, value: 0.5 }, set("d", 1)),
    slider("a", { ...slide, value: 0.7 }, set("a", 1)),
    slider("α", { ...turn, value: 60 }, set("alpha", Math.PI / 180)),
    motion,
  );
  show();
}

/** Frame i−1, and room for where the other one may go. @returns {Model} */
function base() {
  /** @type {Item[]} */
  const items = [
    ...triad(0, 0.28, "0"),
    { kind: "line", from: { node: 0, at: [-0.6, 0, 0] }, to: { node: 0, at: [1, 0, 0] }, tone: "muted", dashed: true },
    { kind: "line", from: { node: 0, at: [0, 0, -0.5] }, to: { node: 0, at: [0, 0, 1] }, tone: "muted", dashed: true },
  ];
  return { nodes: [{ parent: -1, constant: identity() }], items, joints: 0 };
}

/** Two neighbouring axes, their distance and their angle, with the common normal. */
function twoAxes() {
  let distance = 0.6;
  let twist = radians(50);
  const scene = el("robot-scene", { label: t("lesson-axes") });
  scene.describe(`${t("lesson-axes-text")} ${t("form-scene-keys")}`);
  const show = () => (scene.model = axesModel(distance, twist));
  fill(
    place("two-axes"),
    scene,
    slider(
      t("lesson-distance"),
      { min: 0, max: 1, step: 0.05, value: distance, unit: "" },
      (value) => ((distance = value), show()),
    ),
    slider(
      t("lesson-twist"),
      { min: -180, max: 180, step: 5, value: 50, unit: "°" },
      (value) => ((twist = radians(value)), show()),
    ),
  );
  show();
}

/** @param {number} distance @param {number} twist @returns {Model} */
function axesModel(distance, twist) {
  const along = (/** @type {number} */ s) => ({
    node: 0,
    at: /** @type {[number, number, number]} */ ([distance, -s * Math.sin(twist), s * Math.cos(twist)]),
  });
  const at = (/** @type {number} */ x, /** @type {number} */ z) => ({
    node: 0,
    at: /** @type {[number, number, number]} */ ([x, 0, z]),
  });
  /** @type {Item[]} */
  const items = [
    { kind: "line", from: at(0, -0.6), to: at(0, 0.6), tone: "line", dashed: true },
    { kind: "line", from: along(-0.6), to: along(0.6), tone: "line", dashed: true },
    { kind: "arrow", from: at(0, 0), to: at(0, 0.45), radius: 0.012, tone: "z" },
    { kind: "arrow", from: along(0), to: along(0.45), radius: 0.012, tone: "z" },
    { kind: "label", at: at(0, 0.54), text: "z", sub: "1", tone: "z" },
    { kind: "label", at: along(0.54), text: "z", sub: "2", tone: "z" },
    { kind: "tube", from: at(0, 0), to: at(distance, 0), radius: 0.012, tone: "lit" },
    { kind: "label", at: at(distance / 2, 0.08), text: "a", tone: "line" },
  ];
  if (distance > 0) items.push({ kind: "arrow", from: at(0, 0), to: at(0.3, 0), radius: 0.01, tone: "x" });
  return { nodes: [{ parent: -1, constant: identity() }], items, joints: 0 };
}

/** The same arm twice, with and without something added to its second variable: zero is elsewhere, the robot the same. */
async function zeroPosition() {
  const arms = await Promise.all(
    ["q2", "q2 + 90"].map(async (theta) => {
      const rows = ["q1", theta].map((cell) => ({ joint: "revolute", alpha: "0", a: "1", d: "0", theta: cell }));
      const table = { convention: "standard", angle_unit: "deg", length_unit: "m", rows };
      const label = t("lesson-zero-demo", { theta: theta.replace("q2", "θ₂") });
      const scene = el("robot-scene", { label });
      scene.describe(`${t("lesson-zero-text")} ${t("form-scene-keys")}`);
      const robot = await robotOf(api, table, {});
      if (robot) scene.model = robot.model;
      scene.joints = [0, 0];
      scene.reset("top");
      return { scene, element: el("figure", {}, el("figcaption", {}, el("strong", { text: label })), scene) };
    }),
  );
  const turn = slider("θ₂", { min: -180, max: 180, step: 5, value: 0, unit: "°" }, (value) => {
    for (const { scene } of arms) {
      scene.joints = [0, radians(value)];
      scene.settle();
    }
  });
  fill(
    place("two-zeros"),
    el("p", { text: t("lesson-zero-try") }),
    el(
      "div",
      { class: "two-columns" },
      arms.map(({ element }) => element),
    ),
    turn,
  );
}

startPage(async () => {
  fourNumbers();
  twoAxes();
  await zeroPosition().catch((error) => fill(place("two-zeros"), problemNotice(error)));
});
