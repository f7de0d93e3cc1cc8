/**
 * Axes placed in space: by clicks in the scene, or by fields alone. What is built here is only said, never computed:
 * the service answers with the axes in space and the table that follows.
 *
 * @typedef {{on: number, at: string | number}} OnAxis
 * @typedef {{from: number, by: (string | number)[]}} FromAxis
 * @typedef {(string | number)[] | OnAxis | FromAxis} Point
 * @typedef {(string | number)[] | Record<string, any>} Direction
 * @typedef {{joint: string, point: Point, direction: Direction}} Axis
 * @typedef {{length_unit: string, lengths: Record<string, number>, axes: Axis[]}} Drawing
 */

import { announce, el, iconButton, segmented, VERBATIM } from "../dom.js";
import { t } from "../i18n.js";
import { field, numberOf, refill } from "./fields.js";

const FIXED = {
  "+x": [1, 0, 0],
  "-x": [-1, 0, 0],
  "+y": [0, 1, 0],
  "-y": [0, -1, 0],
  "+z": [0, 0, 1],
  "-z": [0, 0, -1],
};
const NEW_LENGTH = 0.3;
const NAME = /[A-Za-z][A-Za-z_]*\d*/g;
const FUNCTIONS = new Set(["sqrt", "sin", "cos", "pi"]);

/** @returns {Drawing} */
function newDrawing() {
  return { length_unit: "m", lengths: {}, axes: [{ joint: "revolute", point: [0, 0, 0], direction: [0, 0, 1] }] };
}

export class AxesForm {
  /** @param {(drawing: Drawing) => void} changed */
  constructor(changed) {
    this.changed = changed;
    this.drawing = newDrawing();
    this.selected = 0;
    this.list = el("div", { class: "row author-axes", role: "group", "aria-label": t("author-axes") });
    this.axis = el("div", { class: "stack" });
    this.lengths = el("div", { class: "row" });
    this.element = el(
      "div",
      { class: "stack" },
      this.list,
      this.axis,
      el("h3", { text: t("author-lengths-named") }),
      el("p", { class: "hint", text: t("author-lengths-named-hint") }),
      this.lengths,
    );
    this.build();
  }

  /** @param {Drawing} drawing */
  take(drawing) {
    this.drawing = drawing;
    this.selected = Math.min(this.selected, drawing.axes.length - 1);
    this.build();
  }

  /** @param {number} index */
  select(index) {
    this.selected = index;
    this.build();
    this.changed(this.drawing);
  }

  /** One more axis, where the last one is: one click further and it is in place. */
  add() {
    const { axes } = this.drawing;
    const last = axes.length;
    const axis = { joint: "revolute", point: { from: last, by: [0, 0, 0] }, direction: { parallel: last } };
    this.selected = last;
    this.#become({ ...this.drawing, axes: [...axes, axis] }, true);
    announce(t("author-axis-added", { number: last + 1 }));
  }

  remove() {
    const axes = this.drawing.axes.slice(0, -1);
    if (!axes.length) return;
    this.selected = Math.min(this.selected, axes.length - 1);
    this.#become({ ...this.drawing, axes }, true);
    announce(t("author-axis-removed", { number: axes.length + 1 }));
  }

  /** @param {Partial<Axis>} change of the selected axis @param {boolean} [anew] whether fields have to be built anew */
  change(change, anew = true) {
    const axes = this.drawing.axes.map((axis, i) => (i === this.selected ? { ...axis, ...change } : axis));
    this.#become({ ...this.drawing, axes }, anew);
  }

  /** @param {Drawing} drawing @param {boolean} anew */
  #become(drawing, anew) {
    const used = namesIn(drawing.axes);
    const lengths = Object.fromEntries(used.map((name) => [name, drawing.lengths[name] ?? NEW_LENGTH]));
    this.drawing = { ...drawing, lengths };
    if (anew) this.build();
    else this.#buildLengths();
    this.changed(this.drawing);
  }

  build() {
    const { axes } = this.drawing;
    refill(
      this.list,
      axes.map((axis, i) =>
        el("button", {
          type: "button",
          class: "small",
          "aria-pressed": String(i === this.selected),
          onclick: () => this.select(i),
          text: t("author-axis", { number: i + 1, joint: t(`form-joint-${axis.joint}`) }),
        }),
      ),
      iconButton("add", t("author-axis-add"), () => this.add()),
      axes.length > 1
        ? iconButton("less", t("author-axis-remove", { number: axes.length }), () => this.remove())
        : null,
    );
    refill(this.axis, this.#fields(axes[this.selected]));
    this.#buildLengths();
  }

  /** @param {Axis} axis */
  #fields(axis) {
    const number = this.selected + 1;
    return [
      segmented({
        name: "author-joint",
        label: t("author-axis-joint", { number }),
        value: axis.joint,
        options: ["revolute", "prismatic"].map((value) => ({ value, label: t(`form-joint-${value}`) })),
        onchange: (joint) => this.change({ joint }),
      }),
      this.#pointFields(axis.point),
      this.#directionFields(axis.direction),
    ];
  }

  /** @param {Point} point */
  #pointFields(point) {
    const how = Array.isArray(point) ? "at" : "on" in point ? "on" : "from";
    const earlier = this.#earlier();
    const options = earlier.length ? ["at", "on", "from"] : ["at"];
    /** @param {string} chosen */
    const become = (chosen) => {
      const last = this.selected;
      this.change({
        point: chosen === "at" ? [0, 0, 0] : chosen === "on" ? { on: last, at: 0 } : { from: last, by: [0, 0, 0] },
      });
    };
    const choose = select(
      "point",
      options.map((value) => ({ value, label: t(`author-point-${value}`) })),
      how,
      become,
    );
    /** @type {any[]} */
    let more;
    if (Array.isArray(point)) more = this.#three("point", point, (value) => this.change({ point: value }, false));
    else if ("on" in point)
      more = [
        field(
          t("author-point-axis"),
          this.#axisChoice("on", point.on, (on) => this.change({ point: { ...point, on } })),
        ),
        field(
          t("author-point-distance"),
          this.#cell("at", point.at, (at) => this.change({ point: { ...point, at } }, false)),
        ),
      ];
    else
      more = [
        field(
          t("author-point-axis"),
          this.#axisChoice("from", point.from, (from) => this.change({ point: { ...point, from } })),
        ),
        ...this.#three("by", point.by, (by) => this.change({ point: { ...point, by } }, false)),
      ];
    return el(
      "fieldset",
      {},
      el("legend", { text: t("author-point") }),
      el("div", { class: "row" }, field(t("author-how"), choose), more),
    );
  }

  /** @param {Direction} direction */
  #directionFields(direction) {
    const earlier = this.#earlier();
    const how = howOf(direction);
    const fixed = Object.keys(FIXED).map((value) => ({
      value,
      label: t("author-along", { axis: value.replace("-", "−") }),
    }));
    const others = earlier.flatMap((axis) =>
      ["parallel", "opposite"].map((kind) => ({ value: `${kind} ${axis}`, label: t(`author-${kind}`, { axis }) })),
    );
    const across = earlier.map((axis) => ({
      value: `perpendicular ${axis}`,
      label: t("author-perpendicular", { axis }),
    }));
    const both = earlier.flatMap((axis, i) =>
      earlier
        .slice(i + 1)
        .map((other) => ({ value: `across ${axis} ${other}`, label: t("author-across", { axis, other }) })),
    );
    const own = ["vector", "through"].map((value) => ({ value, label: t(`author-direction-${value}`) }));
    const choose = select("direction", [...fixed, ...others, ...across, ...both, ...own], how, (chosen) =>
      this.change({ direction: directionOf(chosen) }),
    );
    /** @type {any} */
    let more = null;
    if (how === "vector")
      more = this.#three("vector", /** @type {any} */ (direction), (value) => this.change({ direction: value }, false));
    else if (how === "through")
      more = this.#three("through", /** @type {any} */ (direction).through, (through) =>
        this.change({ direction: { through } }, false),
      );
    else if (how.startsWith("perpendicular"))
      more = this.#three("towards", /** @type {any} */ (direction).towards, (towards) =>
        this.change({ direction: { .../** @type {any} */ (direction), towards } }, false),
      );
    return el(
      "fieldset",
      {},
      el("legend", { text: t("author-direction") }),
      el("div", { class: "row" }, field(t("author-how"), choose), more),
    );
  }

  #earlier() {
    return Array.from({ length: this.selected }, (_, i) => i + 1);
  }

  /** @param {string} name @param {(string | number)[]} values @param {(values: (string | number)[]) => void} onchange */
  #three(name, values, onchange) {
    let now = values;
    return ["x", "y", "z"].map((axis, k) =>
      field(
        axis,
        this.#cell(`${name}-${axis}`, values[k], (value) => {
          now = now.map((entry, i) => (i === k ? value : entry));
          onchange(now);
        }),
      ),
    );
  }

  /** A length: a number, or an expression in names. @param {string} name @param {string | number} value @param {(value: string | number) => void} onchange */
  #cell(name, value, onchange) {
    return el("input", {
      type: "text",
      size: "6",
      value,
      ...VERBATIM,
      dataset: { field: name },
      oninput: (event) => onchange(numberOf(event.target.value) ?? 0),
    });
  }

  /** @param {string} name @param {number} value @param {(axis: number) => void} onchange */
  #axisChoice(name, value, onchange) {
    const options = this.#earlier().map((axis) => ({ value: String(axis), label: String(axis) }));
    return select(`${name}-axis`, options, String(value), (text) => onchange(Number(text)));
  }

  #buildLengths() {
    const names = Object.keys(this.drawing.lengths);
    const shown = [...this.lengths.querySelectorAll("input")].map((input) => input.dataset.name);
    if (shown.length && shown.join() === names.join()) return;
    refill(
      this.lengths,
      names.length ? null : el("p", { class: "hint", text: t("author-lengths-none") }),
      names.map((name) =>
        field(
          name,
          el("input", {
            type: "text",
            inputmode: "decimal",
            size: "7",
            value: this.drawing.lengths[name],
            dataset: { name, field: `length-${name}` },
            oninput: (event) => {
              const value = numberOf(event.target.value);
              if (typeof value !== "number") return;
              this.drawing = { ...this.drawing, lengths: { ...this.drawing.lengths, [name]: value } };
              this.changed(this.drawing);
            },
          }),
        ),
      ),
    );
  }
}

/** @param {string} name @param {{value: string, label: string}[]} options @param {string} value @param {(value: string) => void} onchange */
function select(name, options, value, onchange) {
  return el(
    "select",
    { dataset: { field: name }, onchange: (event) => onchange(event.target.value) },
    options.map((option) =>
      el("option", { value: option.value, selected: option.value === value, text: option.label }),
    ),
  );
}

/** @param {Direction} direction */
function howOf(direction) {
  if (Array.isArray(direction)) {
    const found = Object.entries(FIXED).find(([, vector]) => vector.every((entry, k) => entry === direction[k]));
    return found ? found[0] : "vector";
  }
  if ("through" in direction) return "through";
  if ("parallel" in direction) return `parallel ${direction.parallel}`;
  if ("opposite" in direction) return `opposite ${direction.opposite}`;
  return "and" in direction
    ? `across ${direction.perpendicular} ${direction.and}`
    : `perpendicular ${direction.perpendicular}`;
}

/** @param {string} how @returns {Direction} */
function directionOf(how) {
  const [kind, axis, other] = how.split(" ");
  if (kind in FIXED) return FIXED[/** @type {keyof typeof FIXED} */ (kind)];
  if (kind === "parallel" || kind === "opposite") return { [kind]: Number(axis) };
  if (kind === "perpendicular") return { perpendicular: Number(axis), towards: [0, -1, 0] };
  if (kind === "across") return { perpendicular: Number(axis), and: Number(other) };
  return kind === "through" ? { through: [0, 0, 1] } : [1, 1, 0];
}

/** The names that stand in a drawing, in the order in which they do. @param {Axis[]} axes */
export function namesIn(axes) {
  /** @param {any} node @returns {string[]} */
  const texts = (node) => {
    if (typeof node === "string") return node.match(NAME) ?? [];
    return typeof node === "object" && node !== null ? Object.values(node).flatMap(texts) : [];
  };
  const found = axes.flatMap(({ point, direction }) => [...texts(point), ...texts(direction)]);
  return [...new Set(found)].filter((name) => !FUNCTIONS.has(name));
}
