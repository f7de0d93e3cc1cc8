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
        value: value === null ? "" : shortened(value),
        "aria-label": t(label, { name, unit }),
        oninput: (event) => this.#typed(i, event.target.closest("tr")),
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

  /** Reads both limits of joint i + 1, whichever was typed. @param {number} i @param {HTMLElement} row */
  #typed(i, row) {
    const fields = [...row.querySelectorAll("input")];
    const [least, greatest] = fields.map((field, end) => {
      const known = this.#limits?.[i]?.[end] ?? null; // shown with fewer digits than it has
      return known !== null && field.value === shortened(known) ? known : numberIn(field.value);
    });
    const unread = fields.filter((field) => field.value.trim() !== "" && numberIn(field.value) === null);
    const reversed = least !== null && greatest !== null && least > greatest;
    this.#mark(row, reversed ? fields : unread, reversed ? "playground-limits-reversed" : "playground-number-needed");
    if (unread.length || reversed) return;
    const count = this.body.querySelectorAll("input").length / 2;
    const limits = Array.from({ length: count }, (_, k) => this.#limits?.[k] ?? null);
    limits[i] = least === null && greatest === null ? null : [least, greatest];
    this.#limits = limits.every((each) => each === null) ? null : limits;
    this.changed(this.#limits);
  }

  /** Marks the limits of a joint that do not hold, and says why below the table. @param {HTMLElement} row @param {Element[]} wrong @param {string} why */
  #mark(row, wrong, why) {
    for (const field of row.querySelectorAll("input")) {
      setValid(field, !wrong.includes(field));
      if (wrong.includes(field)) field.setAttribute("aria-describedby", this.fault.id);
      else field.removeAttribute("aria-describedby");
    }
    const joint = row.querySelector("th")?.textContent ?? "";
    fill(this.fault, wrong.length ? el("p", { class: "notice notice-problem", text: named(joint, t(why)) }) : null);
  }
}

/** A limit as it is shown. @param {number} limit */
const shortened = (limit) => plain(limit, 4);
