/** How far each joint may go: shown, changed, and used by the sliders and by every answer. */

import { el, fill, setValid, uniqueId, VERBATIM } from "../dom.js";
import { named, t } from "../i18n.js";
import { numberIn, plain } from "../numbers.js";

/** @typedef {import("../joint-ranges.js").Limits} Limits */

export class JointLimits {
  /** @type {Limits} */
  #limits = null;
  #shown = "";
  #source = "";

  /** @param {(limits: Limits) => void} changed by hand, in the table's units */
  constructor(changed) {
    this.changed = changed;
    this.body = el("div", { class: "limits" });
    this.fault = el("div", { role: "status", id: uniqueId("limits-fault") });
    this.element = el("details", { class: "tool" }, el("summary", {}, t("playground-limits")), this.body, this.fault);
  }

  /** In the table's units; null where nothing is known. */
  get limits() {
    return this.#limits;
  }

  /**
   * Takes the limits of another robot.
   * @param {Limits} limits @param {string} [source] where they come from
   */
  take(limits, source = "") {
    this.#limits = limits;
    this.#source = source;
    this.#shown = "";
  }

  /**
   * Shows a field for either end of every joint of the robot that is drawn now.
   * @param {{types: string[], ranges: import("../joint-ranges.js").JointRange[], units: {angle: string, length: string}}} subject
   */
  show({ types, ranges, units }) {
    const shown = JSON.stringify([ranges.map(({ name, type }) => [name, type]), units, this.#limits]);
    if (shown === this.#shown) return;
    const fields = [...this.body.querySelectorAll("input")];
    const focused = fields.findIndex((field) => field === document.activeElement);
    this.#shown = shown;
    if (focused >= 0 && fields.length === 2 * types.length) return;
    fill(this.fault);
    fill(
      this.body,
      el("p", { class: "hint", text: types.length ? t("playground-limits-hint") : t("playground-no-joints") }),
      types.length ? this.#table(ranges, units) : null,
      this.#source ? el("p", { class: "hint", text: t("playground-limits-source", { source: this.#source }) }) : null,
    );
  }

  /** @param {import("../joint-ranges.js").JointRange[]} ranges @param {{angle: string, length: string}} units */
  #table(ranges, units) {
    const heads = ["playground-joint", "playground-least", "playground-greatest"];
    return el(
      "table",
      { class: "cells limits-table" },
      el("caption", { class: "visually-hidden", text: t("playground-limits") }),
      el(
        "thead",
        {},
        el(
          "tr",
          {},
          heads.map((id) => el("th", { scope: "col", text: t(id) })),
          el("td"),
        ),
      ),
      el(
        "tbody",
        {},
        ranges.map((range, i) => this.#line(range, i, units)),
      ),
    );
  }

  /** @param {import("../joint-ranges.js").JointRange} range @param {number} i @param {{angle: string, length: string}} units */
  #line({ name, type }, i, units) {
    const unit = type === "prismatic" ? units.length : units.angle === "deg" ? "°" : "rad";
    const field = (/** @type {0 | 1} */ end, /** @type {string} */ label) => {
      const value = this.#limits?.[i]?.[end] ?? null;
      return el("input", {
        id: uniqueId("limit"),
        type: "text",
        ...VERBATIM,
        value: value === null ? "" : plain(value, 4),
        "aria-label": t(label, { name, unit }),
        oninput: (event) => this.#typed(i, end, event.target),
      });
    };
    return el(
      "tr",
      {},
      el("th", { scope: "row", text: name }),
      el("td", {}, field(0, "playground-slide-least")),
      el("td", {}, field(1, "playground-slide-greatest")),
      el("td", { class: "hint", text: unit }),
    );
  }

  /** @param {number} i @param {0 | 1} end @param {HTMLInputElement} input */
  #typed(i, end, input) {
    const value = input.value.trim() === "" ? null : numberIn(input.value);
    const wrong = value === null && input.value.trim() !== "";
    setValid(input, !wrong);
    this.#say(wrong ? t("playground-number-needed") : "", input);
    if (wrong) return;
    const count = this.body.querySelectorAll("input").length / 2;
    const limits = Array.from({ length: count }, (_, k) => this.#limits?.[k] ?? null);
    const pair = /** @type {[number | null, number | null]} */ ([...(limits[i] ?? [null, null])]);
    pair[end] = value;
    const reversed = pair[0] !== null && pair[1] !== null && pair[0] > pair[1];
    for (const each of input.closest("tr")?.querySelectorAll("input") ?? []) setValid(each, !reversed);
    if (reversed) return this.#say(t("playground-limits-reversed"), input);
    limits[i] = pair[0] === null && pair[1] === null ? null : pair;
    this.#limits = limits.every((each) => each === null) ? null : limits;
    this.changed(this.#limits);
  }

  /** Says below the table why a limit that is being typed does not hold. @param {string} text @param {HTMLInputElement} input */
  #say(text, input) {
    const joint = input.closest("tr")?.querySelector("th")?.textContent ?? "";
    fill(this.fault, text ? el("p", { class: "notice notice-problem", text: named(joint, text) }) : null);
    if (text) input.setAttribute("aria-describedby", this.fault.id);
    else input.removeAttribute("aria-describedby");
  }
}
