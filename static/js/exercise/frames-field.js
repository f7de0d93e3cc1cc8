/**
 * Frames on the robot of the figure: for each its origin and the directions of z and x, chosen from what the figure
 * shows or typed, and drawn on the robot at once. The same interface as the fields of `part-fields.js`.
 */

import { el, faultLine, setFault, uniqueId, VERBATIM } from "../dom.js";
import { t } from "../i18n.js";
import { numberIn, plain } from "../numbers.js";
import { cross, dot, norm, unit } from "../scene/matrix.js";
import { together, triad } from "../scene/model.js";
import { figureRobot } from "../scene/robots.js";
import { METRES } from "../units.js";
import { typed } from "./typed.js";

/** @typedef {import("../scene/matrix.js").Vector} Vector */
/** @typedef {"origin" | "z" | "x"} Piece */

/** In the order of the lecture: all z, then where, then x. @type {Piece[]} */
const PIECES = ["z", "origin", "x"];
const TYPED = "typed";
const AXES = ["X", "Y", "Z"];
/** Length of a frame's arrows, relative to the robot. */
const ARROWS = 0.16;
/** Two choices this close [relative to what they measure] are one. */
const SAME = 1e-6;

export class FramesField {
  onchange = () => {};

  /** @param {Wire.Exercise} exercise */
  constructor(exercise) {
    this.figure = exercise.figure;
    this.metres = METRES[exercise.length_unit];
    this.conventions = exercise.conventions;
    const places = placesOf(exercise.figure, this.metres);
    const directions = directionsOf(exercise.figure);
    const changed = () => (this.#draw(), this.onchange());
    this.frames = Array.from({ length: exercise.joints.length + 1 }, (_, i) =>
      Object.fromEntries(
        PIECES.map((piece) => [piece, new TripleField(i, piece, piece === "origin" ? places : directions, changed)]),
      ),
    );
    const id = uniqueId("frames");
    this.convention = el(
      "select",
      { id, onchange: changed },
      this.conventions.map((value) => el("option", { value, text: t(`form-convention-${value}`) })),
    );
    this.scene = /** @type {any} */ (el("robot-scene", { label: t("form-frames-scene") }));
    this.element = el(
      "div",
      { class: "frames" },
      el("div", { class: "field" }, el("label", { for: id, text: t("form-convention") }), this.convention),
      el("p", { class: "hint", text: t("form-frames-hint", { unit: exercise.length_unit }) }),
      this.scene,
      this.frames.map((frame, i) =>
        el(
          "fieldset",
          { class: "frame" },
          el("legend", { text: t("form-frames-frame", { frame: i }) }),
          PIECES.map((piece) => frame[piece].element),
        ),
      ),
    );
    this.#draw();
  }

  get touched() {
    return this.frames.some((frame) => PIECES.some((piece) => frame[piece].touched));
  }

  get value() {
    if (!this.touched) return null;
    const frames = this.frames.map((frame) =>
      PIECES.some((piece) => frame[piece].touched)
        ? Object.fromEntries(PIECES.map((piece) => [piece, frame[piece].value]))
        : null,
    );
    return { convention: this.convention.value, frames };
  }

  /** Pieces of a frame that was begun and is not whole, as faults. */
  get missing() {
    return this.frames.flatMap((frame, i) => {
      const begun = PIECES.some((piece) => frame[piece].touched);
      const open = PIECES.filter((piece) => begun && !frame[piece].whole);
      return open.map((piece) => ({ where: ["frames", i, piece], text: t("form-choose-missing") }));
    });
  }

  get state() {
    const frames = this.frames.map((frame) => PIECES.map((piece) => frame[piece].state));
    return { convention: this.convention.value, frames };
  }

  set state({ convention, frames }) {
    if (this.conventions.includes(/** @type {any} */ (convention))) this.convention.value = convention;
    frames.forEach((states, i) =>
      PIECES.forEach((piece, k) => this.frames[i] && states[k] && (this.frames[i][piece].state = states[k])),
    );
    this.#draw();
  }

  /** @param {{where: (string | number)[], text: string}[]} faults */
  showFaults(faults) {
    for (const frame of this.frames) for (const piece of PIECES) frame[piece].fault = "";
    for (const { where, text } of faults) this.#at(where).fault = text;
  }

  /** @param {(string | number)[]} [where] */
  focus(where = []) {
    this.#at(where).focus();
  }

  /** @param {(string | number)[]} where such as ["frames", 2, "origin", 0] @returns {TripleField} */
  #at([, frame, piece]) {
    return (this.frames[Number(frame)] ?? this.frames[0])[PIECES.includes(/** @type {any} */ (piece)) ? piece : "z"];
  }

  /** The robot with every frame that can be drawn. */
  #draw() {
    const size = this.figure.size * ARROWS;
    /** @type {import("../scene/model.js").Model} */
    const frames = { nodes: [], items: [], joints: 0 };
    this.frames.forEach((frame, i) => {
      const pose = poseOf(frame, this.metres);
      if (!pose) return;
      const node = frames.nodes.push({ parent: -1, constant: pose }) - 1;
      frames.items.push(...triad(node, size * (1 - 0.1 * (i % 3)), String(i)));
    });
    this.scene.model = together([figureRobot(this.figure), frames]);
    const drawn = frames.nodes.length;
    this.scene.describe(`${this.figure.description} ${t("form-frames-drawn", { drawn, all: this.frames.length })}`);
  }
}

/** How a place of such an answer is called. @param {(string | number)[]} where */
export function framePlace([, frame, piece]) {
  if (frame === undefined) return t("form-frames-ends");
  return piece ? t(`form-frames-${piece}-of`, { frame }) : t("form-frames-frame", { frame });
}

/** Three numbers: chosen by what they mean in the figure, or typed. */
class TripleField {
  /** @param {number} frame @param {Piece} piece @param {{text: string, vector: Vector}[]} choices @param {() => void} changed */
  constructor(frame, piece, choices, changed) {
    this.choices = choices;
    const name = t(`form-frames-${piece}-of`, { frame });
    this.line = faultLine(uniqueId("fault"));
    const id = uniqueId("frame");
    this.select = /** @type {HTMLSelectElement} */ (
      el(
        "select",
        { id, "aria-describedby": this.line.id, onchange: () => (this.#show(), changed()) },
        el("option", { value: "", text: t("form-choose") }),
        choices.map(({ text }, i) => el("option", { value: String(i), text })),
        el("option", { value: TYPED, text: t("form-frames-typed") }),
      )
    );
    this.inputs = AXES.map(
      (axis) =>
        /** @type {HTMLInputElement} */ (
          el("input", {
            type: "text",
            size: 6,
            ...VERBATIM,
            "aria-label": `${name}, ${axis}`,
            oninput: () => ((this.fault = ""), changed()),
          })
        ),
    );
    this.row = el(
      "span",
      { class: "triple" },
      this.inputs.map((input, k) => el("span", {}, el("span", { "aria-hidden": "true", text: AXES[k] }), input)),
    );
    this.element = el(
      "div",
      { class: "field" },
      el("label", { for: id, text: t(`form-frames-${piece}`) }, el("span", { class: "visually-hidden" }, `: ${name}`)),
      this.select,
      this.row,
      this.line,
    );
    this.#show();
  }

  get touched() {
    return this.select.value !== "";
  }

  get whole() {
    return this.touched && this.value.every((cell) => cell !== "");
  }

  /** Three cells as they go to the API. @returns {string[]} */
  get value() {
    const choice = this.choices[Number(this.select.value)];
    if (this.select.value === TYPED) return this.inputs.map(typed);
    return this.touched && choice ? choice.vector.map((number) => plain(number, 9)) : ["", "", ""];
  }

  get state() {
    return { chosen: this.select.value, typed: this.inputs.map(({ value }) => value) };
  }

  set state({ chosen, typed: texts }) {
    this.select.value = chosen;
    texts.forEach((text, k) => (this.inputs[k].value = text));
    this.#show();
  }

  /** @param {string} text */
  set fault(text) {
    setFault(this.select, this.line, text);
  }

  focus() {
    this.select.focus();
  }

  #show() {
    const choice = this.choices[Number(this.select.value)];
    this.fault = "";
    if (this.select.value === TYPED && !this.row.hidden) return;
    this.row.hidden = this.select.value !== TYPED;
    if (choice && this.select.value !== "" && this.select.value !== TYPED)
      choice.vector.forEach((number, k) => (this.inputs[k].value = plain(number, 6)));
  }
}

/** The pose of a frame [m] if it is whole and its axes are perpendicular. @param {any} frame @param {number} metres */
function poseOf(frame, metres) {
  const [z, origin, x] = PIECES.map((piece) => numbersOf(frame[piece].value));
  if (!z || !origin || !x || norm(z) < SAME || norm(x) < SAME) return null;
  const [along, across] = [unit(z), unit(x)];
  if (Math.abs(dot(along, across)) > SAME) return null;
  const y = cross(along, across);
  return [0, 1, 2].map((r) => [across[r], y[r], along[r], origin[r] * metres]).concat([[0, 0, 0, 1]]);
}

/** @param {string[]} cells @returns {Vector | null} */
function numbersOf(cells) {
  const numbers = cells.map(numberIn);
  return numbers.includes(null) ? null : /** @type {Vector} */ (numbers);
}

/** Points that the figure shows, in the exercise's unit of length. @param {Wire.Figure} figure @param {number} metres */
function placesOf({ axes, points = [], ground }, metres) {
  const found = [
    ...axes.map(({ joint, point }) => ({ text: t("form-frames-at-joint", { joint }), vector: point })),
    ...points.map(({ name, at }) => ({ text: t("form-frames-at-point", { name }), vector: at })),
    ...(ground ? [{ text: t("form-frames-at-ground"), vector: ground.at }] : []),
  ];
  return found.map(({ text, vector }) => ({ text, vector: /** @type {Vector} */ (vector.map((v) => v / metres)) }));
}

/** Along and against the axes of the figure's coordinates, and those of joints that lie otherwise. @param {Wire.Figure} figure */
function directionsOf({ axes }) {
  /** @type {{text: string, vector: Vector}[]} */
  const found = AXES.flatMap((axis, k) =>
    [1, -1].map((sign) => ({
      text: `${sign > 0 ? "+" : "−"}${axis}`,
      vector: /** @type {Vector} */ ([0, 1, 2].map((i) => (i === k ? sign : 0))),
    })),
  );
  for (const { joint, direction } of axes) {
    if (found.some(({ vector }) => Math.abs(dot(vector, direction)) > 1 - SAME)) continue;
    const against = /** @type {Vector} */ (direction.map((v) => -v));
    found.push({ text: t("form-frames-along", { joint }), vector: direction });
    found.push({ text: t("form-frames-against", { joint }), vector: against });
  }
  return found;
}
