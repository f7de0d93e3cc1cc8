/**
 * `<matrix-panel>`: the matrices of a table, as numbers and in symbols.
 *
 * `api` must be set before use. `showNumbers({links, transform})` takes what /forward-kinematics answered;
 * `table` (as it goes to the API) is what /symbolic is asked about when symbols are shown.
 */

import { Latest } from "./api.js";
import { el, fill, segmented, uniqueId } from "./dom.js";
import { t } from "./i18n.js";
import { copyButtons, matrixSource } from "./clipboard.js";
import { problemNotice } from "./problem.js";
import { numericMatrix, transformName, typeset } from "./typeset.js";

const SOURCES = ["latex", "python", "c", "matlab"];

export class MatrixPanel extends HTMLElement {
  /** @type {import("./api.js").Api | null} */
  api = null;
  #mode = "numbers";
  #notation = "short";
  #table = /** @type {any} */ (null);
  #numbers = /** @type {{links: number[][][], transform: number[][]} | null} */ (null);
  #shown = /** @type {ReturnType<typeof numericMatrix>[]} */ ([]);
  #symbolic = /** @type {any} */ (null);
  #latest = new Latest();
  #body = el("div", { class: "matrices" });

  connectedCallback() {
    if (this.firstChild) return;
    const name = uniqueId("matrix-mode");
    const notation = segmented({
      name: uniqueId("matrix-notation"),
      label: t("form-matrix-notation"),
      value: this.#notation,
      options: [
        { value: "short", label: t("form-matrix-short") },
        { value: "full", label: t("form-matrix-full") },
      ],
      onchange: (value) => {
        this.#notation = value;
        this.#askSymbols();
      },
    });
    notation.hidden = true;
    const mode = segmented({
      name,
      label: t("form-matrix-mode"),
      value: this.#mode,
      options: [
        { value: "numbers", label: t("form-matrix-numbers") },
        { value: "symbols", label: t("form-matrix-symbols") },
      ],
      onchange: (value) => {
        this.#mode = value;
        notation.hidden = value !== "symbols";
        this.#show();
      },
    });
    fill(this, el("div", { class: "row" }, mode, notation), this.#body);
    this.#show();
  }

  /** The table in question, as it goes to the API; null while it cannot be read. */
  get table() {
    return this.#table;
  }

  set table(table) {
    if (JSON.stringify(table) === JSON.stringify(this.#table)) return;
    this.#table = table;
    this.#latest.cancel();
    this.#symbolic = null;
    if (!table) this.#numbers = null;
    this.#show();
  }

  /** @param {{links: number[][][], transform: number[][]}} numbers */
  showNumbers(numbers) {
    const sameShape = this.#numbers?.links.length === numbers.links.length && this.#shown.length > 0;
    this.#numbers = numbers;
    if (this.#mode !== "numbers") return;
    if (!sameShape) return this.#show();
    [numbers.transform, ...numbers.links].forEach((values, i) => this.#shown[i].update(values));
  }

  #show() {
    if (!this.isConnected) return;
    this.#shown = [];
    this.#wait(false);
    if (!this.#table || (this.#mode === "numbers" && !this.#numbers)) {
      fill(this.#body, el("p", { class: "hint", text: t("form-matrix-none") }));
    } else if (this.#mode === "numbers") this.#showNumbers();
    else this.#askSymbols();
  }

  #showNumbers() {
    const numbers = this.#numbers;
    if (!numbers) return;
    const { links, transform } = numbers;
    const blocks = [transform, ...links].map((values, i) => {
      const matrix = numericMatrix(values);
      this.#shown.push(matrix);
      const ends = i === 0 ? [0, links.length] : [i - 1, i];
      /** @param {import("./clipboard.js").Format} format */
      const source = (format) => {
        const present = this.#numbers ?? numbers;
        const current = i === 0 ? present.transform : present.links[i - 1];
        return matrixSource(current, format, i === 0 ? "T" : `A${i}`);
      };
      return block(ends, matrix.element, source);
    });
    fill(this.#body, blocks);
  }

  async #askSymbols() {
    this.#latest.cancel();
    const { api } = this;
    if (!this.#table || !api) return;
    const asked = JSON.stringify([this.#table, this.#notation]);
    if (this.#symbolic?.asked !== asked) {
      this.#wait(true);
      try {
        const request = { table: this.#table, formats: SOURCES, notation: this.#notation };
        const answer = await this.#latest.run((signal) => api.post("symbolic", request, { signal }));
        if (!answer) return;
        this.#symbolic = { asked, ...answer.value };
      } catch (error) {
        this.#wait(false);
        if (this.#mode === "symbols") fill(this.#body, problemNotice(error));
        return;
      }
    }
    this.#wait(false);
    if (this.#mode === "symbols") this.#showSymbols();
  }

  /** @param {any} waiting */
  #wait(waiting) {
    this.#body.classList.toggle("busy", waiting);
    if (waiting) this.#body.setAttribute("aria-busy", "true");
    else this.#body.removeAttribute("aria-busy");
  }

  #showSymbols() {
    const { links, transform } = this.#symbolic;
    const blocks = [transform, ...links].map((formats, i) => {
      const ends = i === 0 ? [0, links.length] : [i - 1, i];
      const formula = el("div", { class: "formula" });
      typeset(formula, formats.latex, { display: true }).catch(() => (formula.textContent = formats.latex));
      return block(ends, formula, (/** @type {string} */ format) => formats[format]);
    });
    fill(this.#body, blocks);
  }
}

/** @param {any} options @param {any} content @param {any} source */
function block([from, to], content, source) {
  const name = t("form-matrix-name", { from, to });
  return el(
    "div",
    { class: "matrix-block" },
    el(
      "div",
      { class: "matrix-head" },
      el("h3", { "aria-label": name }, transformName(from, to)),
      copyButtons(name, source),
    ),
    el("div", { class: "scroller", tabindex: "0", role: "group", "aria-label": name }, content),
  );
}

customElements.define("matrix-panel", MatrixPanel);
