/** Numbers with their names, and matrices with theirs, as they stand under an answer. */

import { copyButtons, matrixSource } from "../clipboard.js";
import { el } from "../dom.js";
import { shown } from "../numbers.js";
import { numericMatrix, typeset } from "../typeset.js";

/** What closed forms are asked for in, and copied as. */
export const FORMATS = ["latex", "python", "c", "matlab"];

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

/** Something under its name, with copying. @param {string} name @param {Element} content @param {(format: import("../clipboard.js").Format) => string} source */
function block(name, content, source) {
  return el(
    "div",
    { class: "matrix-block" },
    el("div", { class: "matrix-head" }, el("h3", { text: name }), copyButtons(name, source)),
    el("div", { class: "scroller", tabindex: "0", role: "group", "aria-label": name }, content),
  );
}

/** A matrix under its name, with copying. @param {string} name @param {number[][]} values @param {string} [variable] */
export function matrix(name, values, variable = "M") {
  return block(name, numericMatrix(values).element, (format) => matrixSource(values, format, variable));
}

/** A formula. @param {string} latex @param {{display?: boolean}} [options] */
export function formula(latex, { display = true } = {}) {
  const element = el(display ? "div" : "span", { class: "formula" });
  typeset(element, latex, { display }).catch(() => (element.textContent = latex));
  return element;
}

/** A closed form under its name, with copying. @param {string} name @param {any} formats its text in each of FORMATS */
export function closedForm(name, formats) {
  return block(name, formula(formats.latex), (format) => formats[format]);
}

/** @param {string} unit "deg" or "rad" */
export const angleSign = (unit) => (unit === "deg" ? "°" : "rad");

/** What may be wider than the page, under a name. @param {string} label @param {Node} content */
export function scroller(label, content) {
  return el("div", { class: "scroller", tabindex: "0", role: "region", "aria-label": label }, content);
}
