/**
 * `<joint-sliders>`: a slider and a number for each joint.
 *
 * Property `joints`: `[{name, type: "revolute" | "prismatic", min, max, value?}]`, angles in radians.
 * Property `values`: the joint values, angles in radians. Property `units`: `{angle: "rad" | "deg", length: "m"}`
 * says what the fields show. Event `joints-change` with `detail.values`, on every movement.
 */

import { el, fill, iconButton, uniqueId, VERBATIM } from "./dom.js";
import { t } from "./i18n.js";
import { clamped } from "./joint-ranges.js";
import { degrees, numberIn, plain, radians } from "./numbers.js";

const STEPS = 360;

/** @typedef {import("./joint-ranges.js").JointRange} JointRange */

export class JointSliders extends HTMLElement {
  /** @type {JointRange[]} */
  #joints = [];
  /** @type {number[]} */
  #values = [];
  #units = { angle: "deg", length: "m" };
  /** @type {{range: HTMLInputElement, number: HTMLInputElement}[]} */
  #inputs = [];

  get joints() {
    return this.#joints;
  }

  set joints(joints) {
    const same =
      joints.length === this.#joints.length && joints.every((joint, i) => joint.type === this.#joints[i].type);
    const called = same && joints.every((joint, i) => joint.name === this.#joints[i].name);
    this.#values = joints.map((joint, i) => clamped(joint, same ? this.#values[i] : (joint.value ?? 0)));
    this.#joints = joints;
    if (called) this.#range();
    else this.#build();
  }

  get values() {
    return [...this.#values];
  }

  set values(values) {
    this.#values = this.#joints.map((joint, i) => values[i] ?? joint.value ?? 0);
    this.#show();
  }

  get units() {
    return this.#units;
  }

  set units(units) {
    const { angle, length } = this.#units;
    this.#units = { ...this.#units, ...units };
    if (angle !== this.#units.angle || length !== this.#units.length) this.#build();
  }

  /** Back to the values that the joints came with. */
  reset() {
    this.#values = this.#joints.map((joint) => clamped(joint, joint.value ?? 0));
    this.#show();
    this.#tell();
  }

  #build() {
    this.#inputs = [];
    fill(
      this,
      this.#joints.map((joint, i) => this.#line(joint, i)),
    );
    this.#range();
  }

  /** How far the sliders go; the elements stay, so that one that is being dragged goes on being dragged. */
  #range() {
    this.#inputs.forEach(({ range }, i) => {
      const joint = this.#joints[i];
      const [min, max] = [this.#outward(joint, joint.min), this.#outward(joint, joint.max)];
      Object.assign(range, { min, max, step: niceStep((max - min) / STEPS) });
    });
    this.#show();
  }

  /** @param {any} joint @param {number} i */
  #line(joint, i) {
    const id = uniqueId("joint");
    const label = t(joint.type === "prismatic" ? "form-joint-slide" : "form-joint-turn", { name: joint.name });
    /** @type {HTMLInputElement} */
    const range = el("input", {
      id,
      type: "range",
      "aria-label": `${label} [${this.#unit(joint)}]`,
      oninput: () => this.#take(i, Number(range.value), range),
    });
    /** @type {HTMLInputElement} */
    const number = el("input", {
      type: "text",
      ...VERBATIM,
      "aria-label": t("form-joint-value", { name: joint.name, unit: this.#unit(joint) }),
      oninput: () => this.#take(i, numberIn(number.value), number),
      onchange: () => this.#show(),
      onkeydown: (event) => {
        const way = { ArrowUp: 1, ArrowDown: -1 }[event.key];
        if (!way) return;
        event.preventDefault();
        this.#take(i, this.#outward(joint, this.#values[i]) + way * Number(range.step));
      },
    });
    this.#inputs.push({ range, number });
    return el(
      "div",
      { class: "joint-line" },
      el("label", { for: id, class: "joint-name" }, nameOf(joint.name)),
      range,
      el("span", { class: "joint-number" }, number, el("span", { class: "hint", text: this.#unit(joint) })),
    );
  }

  /** @param {number} i @param {number | null} shown @param {HTMLInputElement} [source] the field that is being used */
  #take(i, shown, source) {
    if (shown === null) return;
    this.#values[i] = this.#inward(this.#joints[i], shown);
    this.#show(source);
    this.#tell();
  }

  /** @param {HTMLInputElement} [except] the field that is being used */
  #show(except) {
    this.#inputs.forEach(({ range, number }, i) => {
      const value = this.#outward(this.#joints[i], this.#values[i]);
      if (range !== except) range.value = String(value);
      const text = plain(value, this.#units.angle === "deg" ? 2 : 4);
      const typing = number === document.activeElement && numberIn(number.value) === Number(text);
      if (number !== except && !typing) number.value = text;
      range.setAttribute("aria-valuetext", `${plain(value, 2)} ${this.#unit(this.#joints[i])}`);
    });
  }

  #tell() {
    this.dispatchEvent(new CustomEvent("joints-change", { detail: { values: this.values }, bubbles: true }));
  }

  /** @param {any} joint @param {any} value */
  #outward(joint, value) {
    return joint.type === "revolute" && this.#units.angle === "deg" ? degrees(value) : value;
  }

  /** @param {any} joint @param {any} value */
  #inward(joint, value) {
    return joint.type === "revolute" && this.#units.angle === "deg" ? radians(value) : value;
  }

  /** @param {any} joint */
  #unit(joint) {
    if (joint.type === "prismatic") return this.#units.length;
    return this.#units.angle === "deg" ? "°" : "rad";
  }
}

/** @param {string} name */
function nameOf(name) {
  const match = /^([^\d_]+)_?(\d+)$/.exec(name);
  return match ? [el("i", { text: match[1] }), el("sub", { text: match[2] })] : name;
}

/** @param {any} step */
function niceStep(step) {
  const power = 10 ** Math.floor(Math.log10(step || 1));
  const lead = step / power;
  return Number(((lead < 1.5 ? 1 : lead < 3.5 ? 2 : lead < 7.5 ? 5 : 10) * power).toPrecision(3));
}

/** A bar with a reset button for sliders. @param {JointSliders} sliders */
export function resetButton(sliders) {
  return iconButton("home", t("form-joints-reset"), () => sliders.reset());
}

customElements.define("joint-sliders", JointSliders);
