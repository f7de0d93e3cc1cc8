/** Numbers with their names, and matrices with theirs, as they stand under an answer. */

import { copyButtons, matrixSource } from "../clipboard.js";
import { el } from "../dom.js";
import { shown } from "../numbers.js";
import { numericMatrix } from "../typeset.js";

/** @param {[string, string | Node][]} pairs names and values */
export function named(pairs) {
  return el(
    "dl",
    { class: "named" },
    pairs.map(([name, value]) => [el("dt", { text: name }), el("dd", {}, value)]),
  );
}

/** Numbers in a row. @param {number[]} values @param {string} [unit] */
export function numbers(values, unit = "") {
  return `${values.map((value) => shown(value)).join("  ")}${unit ? ` ${unit}` : ""}`;
}

/** A matrix under its name, with copying. @param {string} name @param {number[][]} values @param {string} [variable] */
export function matrix(name, values, variable = "M") {
  return el(
    "div",
    { class: "matrix-block" },
    el(
      "div",
      { class: "matrix-head" },
      el("h3", { text: name }),
      copyButtons(name, (format) => matrixSource(values, format, variable)),
    ),
    el("div", { class: "scroller", tabindex: "0", role: "region", "aria-label": name }, numericMatrix(values).element),
  );
}

/** @param {string} unit "deg" or "rad" */
export const angleSign = (unit) => (unit === "deg" ? "°" : "rad");
