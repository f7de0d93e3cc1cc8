/** Formulas: LaTeX from the API through KaTeX (loaded when first needed), numbers as plain MathML. */

import { el, math } from "./dom.js";
import { loadedOnce } from "./page.js";
import { shown } from "./numbers.js";

const katex = loadedOnce(() => import("../vendor/katex/katex.js"), "vendor/katex/katex.css");

/**
 * Writes a formula into an element, with MathML inside for screen readers. Built node by node, so that no
 * inline style has to be allowed.
 * @param {HTMLElement} element @param {string} latex @param {{display?: boolean}} [options]
 */
export async function typeset(element, latex, { display = false } = {}) {
  element.dataset.latex = latex;
  const { render } = await katex();
  if (element.dataset.latex !== latex) return;
  render(latex, element, { displayMode: display, throwOnError: false, strict: "ignore", trust: false });
}

/**
 * Shows a small formula that the API wrote as MathML; browsers draw it themselves, without anything loaded.
 * @param {HTMLElement} element @param {string} mathml one math element, or nothing
 */
export function showMathml(element, mathml) {
  if (element.dataset.mathml === mathml) return;
  element.dataset.mathml = mathml;
  element.replaceChildren();
  if (!mathml) return;
  const parsed = new DOMParser().parseFromString(mathml, "application/xml").documentElement;
  if (parsed.localName === "math") element.append(document.importNode(parsed, true));
}

/**
 * A matrix of numbers as MathML, and a way to change its numbers. Its brackets are drawn by the style sheet,
 * because few systems have a font whose brackets stretch.
 * @param {number[][]} values
 */
export function numericMatrix(values) {
  const cells = values.map((row) => row.map((value) => math("mn", {}, shown(value))));
  const table = math(
    "mtable",
    {},
    cells.map((row) =>
      math(
        "mtr",
        {},
        row.map((cell) => math("mtd", {}, cell)),
      ),
    ),
  );
  const element = el("span", { class: "bracketed" }, math("math", { display: "block" }, table));
  return {
    element,
    /** @param {number[][]} next */
    update(next) {
      next.forEach((row, i) => row.forEach((value, k) => (cells[i][k].textContent = shown(value))));
    },
  };
}

/** ⁱ⁻¹Tᵢ or the like. @param {string | number} from @param {string | number} to */
export function transformName(from, to) {
  return math(
    "math",
    {},
    math(
      "mmultiscripts",
      {},
      math("mi", {}, "T"),
      math("mn", {}, to),
      math("none"),
      math("mprescripts"),
      math("none"),
      math("mn", {}, from),
    ),
  );
}
