/** Mistakes planted in the robot that is shown: in its table, and in frames drawn on it. */

import "../scene/robot-scene.js";
import { el, fill } from "../dom.js";
import { rowsTable } from "../editor/rows-table.js";
import { t } from "../i18n.js";
import { framesModel } from "../scene/figures.js";
import { column, identity } from "../scene/matrix.js";
import { frozen, together } from "../scene/model.js";
import { shown } from "../numbers.js";
import { asked } from "./tool.js";
import { scroller } from "./values.js";

/** @typedef {import("./more.js").Context} Context */

/** What a frame is told by. */
const PIECES = /** @type {const} */ (["origin", "x", "y", "z"]);

/** @type {import("./more.js").Entry[]} */
export const MISTAKES = [
  {
    id: "mistake",
    fields: anotherOne,
    call: async (subject, seed) => ["plant-mistake", { ...asked(subject), seed }],
    show: plantedTable,
  },
  {
    id: "frame",
    fields: anotherOne,
    call: async (subject, seed, api) => {
      const question = { ...asked(subject), joints: subject.joints, parts: ["frames"] };
      const { frames } = await api.post("forward-kinematics", question);
      const { convention } = subject.table;
      return ["plant-frame-mistake", { axes: axesOf(subject.table, frames), convention, seed }];
    },
    show: plantedFrames,
  },
];

/** @param {Context} context @returns {import("./more.js").Fields} */
function anotherOne({ again }) {
  let number = 1;
  const next = () => {
    number += 1;
    again();
  };
  const button = el("button", { type: "button", onclick: next }, t("playground-mistake-next"));
  return { controls: [el("div", {}, button)], value: () => String(number) };
}

/** @param {any} answer */
function plantedTable({ table, row, label, mended }) {
  const { buttons, verdict } = choice({
    names: table.rows.map((/** @type {any} */ _, /** @type {number} */ i) => t("playground-row", { row: i + 1 })),
    wrong: row - 1,
    found: () => [el("p", { text: t("playground-mistake-found", { row, label }) }), rowsTable(mended)],
    elsewhere: (i) => t("playground-mistake-elsewhere", { row: i + 1 }),
  });
  return [rowsTable(table), el("p", { text: t("playground-mistake-which") }), buttons, verdict];
}

/**
 * The z of a joint's frame lies along its axis: of the frame before it by the standard convention, of its own by the
 * modified one.
 * @param {any} table @param {number[][][]} frames 1 … N
 */
function axesOf({ convention, rows }, frames) {
  const all = [identity(), ...frames];
  const first = convention === "standard" ? 0 : 1;
  return rows.flatMap((/** @type {any} */ { joint = "revolute" }, /** @type {number} */ i) => {
    const frame = all[i + first];
    return joint === "fixed" ? [] : [{ joint, point: column(frame, 3), direction: column(frame, 2) }];
  });
}

/** @param {any} answer @param {Context} context */
function plantedFrames({ frames, frame, label, mended }, { robot, joints }) {
  const names = frames.map((/** @type {any} */ _, /** @type {number} */ i) => t("form-frames-frame", { frame: i }));
  const { buttons, verdict } = choice({
    names,
    wrong: frame,
    found: () => [
      el("p", { text: t("playground-frame-found", { frame, label }) }),
      frameTable([[frame, mended]], t("playground-frame-mended")),
    ],
    elsewhere: (i) => t("playground-frame-elsewhere", { frame: i }),
  });
  const coordinates = frameTable(
    frames.map((/** @type {any} */ drawn, /** @type {number} */ i) => [i, drawn]),
    t("playground-frame-coordinates"),
  );
  const scene = /** @type {any} */ (el("robot-scene", { label: t("playground-frame-scene") }));
  scene.describe(t("form-scene-keys"));
  const drawn = robot();
  const bare = drawn ? [frozen(withoutFrames(drawn.model), joints())] : [];
  const numbered = frames.map((/** @type {any} */ frame, /** @type {number} */ number) => ({ ...frame, number }));
  scene.model = together([...bare, framesModel(numbered, drawn?.size ?? 1)]);
  return [scene, el("p", { text: t("playground-frame-which") }), buttons, verdict, coordinates];
}

/** The body of a robot. @param {import("../scene/model.js").Model} model @returns {import("../scene/model.js").Model} */
function withoutFrames(model) {
  return { ...model, items: model.items.filter(({ kind }) => kind !== "arrow" && kind !== "label") };
}

/** @param {[number, any][]} frames by their numbers @param {string} caption */
function frameTable(frames, caption) {
  const head = el(
    "tr",
    {},
    ["i", "O", "x", "y", "z"].map((text) => el("th", { scope: "col", text })),
  );
  const lines = frames.map(([number, frame]) =>
    el(
      "tr",
      {},
      el("th", { scope: "row", text: String(number) }),
      PIECES.map((piece) => el("td", { text: `(${frame[piece].map(shown).join(", ")})` })),
    ),
  );
  const table = el("table", { class: "solutions vectors" }, el("caption", { text: caption }), el("thead", {}, head));
  table.append(el("tbody", {}, lines));
  return scroller(caption, table);
}

/**
 * Buttons one of which is the right one, and what is said when one is pressed.
 * @param {{names: string[], wrong: number, found: () => Node[], elsewhere: (i: number) => string}} options
 */
function choice({ names, wrong, found, elsewhere }) {
  const verdict = el("div", { class: "tool-answer", role: "status" });
  const judge = (/** @type {number} */ i) =>
    fill(verdict, ...(i === wrong ? found() : [el("p", { text: elsewhere(i) })]));
  const buttons = names.map((name, i) =>
    el("button", { type: "button", class: "small", onclick: () => judge(i) }, name),
  );
  return { buttons: el("div", { class: "row" }, buttons), verdict };
}
