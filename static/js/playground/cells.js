/** A small grid of fields with named columns and as many rows as wanted: axes, SCM chains, target poses. */

import { el, fill, iconButton, VERBATIM } from "../dom.js";
import { t } from "../i18n.js";
import { numberIn } from "../numbers.js";

/**
 * @typedef {{name: string, label: string, options?: {value: string, label: string}[], otherwise: string}} Column
 *   `options` makes a choice of it, `otherwise` is what a new row holds
 */

export class Cells {
  /** @type {HTMLTableSectionElement} */
  #body = /** @type {any} */ (el("tbody"));

  /**
   * @param {string} caption @param {Column[]} columns
   * @param {{rows: Record<string, string>[], fixed?: boolean, onchange?: () => void}} options
   *   `fixed` grids neither grow nor shrink
   */
  constructor(caption, columns, { rows, fixed = false, onchange = () => undefined }) {
    this.columns = columns;
    this.fixed = fixed;
    this.onchange = onchange;
    const head = el(
      "tr",
      {},
      el("th", { scope: "col" }, el("span", { class: "visually-hidden", text: t("playground-number") }), "#"),
      columns.map((column) => el("th", { scope: "col", text: column.label })),
      fixed ? null : el("td"),
    );
    const table = el(
      "table",
      { class: "cells" },
      el("caption", { class: "visually-hidden", text: caption }),
      el("thead", {}, head),
      this.#body,
    );
    const scroller = el("div", { class: "scroller", tabindex: "0", role: "region", "aria-label": caption }, table);
    const add = el("button", { type: "button", class: "small", onclick: () => this.add() }, t("form-row-add"));
    this.element = el("div", { class: "stack" }, scroller, fixed ? null : el("div", {}, add));
    this.rows = rows;
  }

  /** What stands in the grid, row by row. */
  get rows() {
    return Array.from(this.#body.rows, (row) =>
      Object.fromEntries(
        Array.from(/** @type {NodeListOf<HTMLInputElement>} */ (row.querySelectorAll("[data-name]")), (field) => [
          field.dataset.name ?? "",
          field.value.trim(),
        ]),
      ),
    );
  }

  set rows(rows) {
    fill(
      this.#body,
      rows.map((row, i) => this.#row(row, i)),
    );
  }

  /** One more row, with the focus in it. */
  add() {
    this.rows = [...this.rows, Object.fromEntries(this.columns.map((column) => [column.name, column.otherwise]))];
    /** @type {HTMLElement | null | undefined} */ (
      this.#body.lastElementChild?.querySelector("input, select")
    )?.focus();
    this.onchange();
  }

  /** Marks the fields that a refusal speaks of. @param {{row: number, name: string, text: string}[]} faults */
  mark(faults) {
    for (const field of this.#body.querySelectorAll("[data-name]")) field.removeAttribute("aria-invalid");
    for (const { row, name } of faults) {
      this.#body.rows[row]?.querySelector(`[data-name="${name}"]`)?.setAttribute("aria-invalid", "true");
    }
  }

  /** @param {any} values @param {number} i */
  #row(values, i) {
    const remove = () => {
      this.rows = this.rows.filter((_, k) => k !== i);
      const { rows } = this.#body;
      const next = rows[Math.min(i, rows.length - 1)]?.querySelector("button") ?? this.element.querySelector("button");
      next?.focus();
      this.onchange();
    };
    return el(
      "tr",
      {},
      el("th", { scope: "row", text: String(i + 1) }),
      this.columns.map((column) => el("td", {}, this.#field(column, values[column.name] ?? column.otherwise, i))),
      this.fixed ? null : el("td", {}, iconButton("remove", t("form-row-remove", { row: i + 1 }), remove)),
    );
  }

  /** @param {Column} column @param {string} value @param {number} i */
  #field(column, value, i) {
    const shared = {
      "aria-label": t("form-row-cell", { row: i + 1, name: column.label }),
      dataset: { name: column.name },
      oninput: () => this.onchange(),
    };
    if (column.options) {
      const select = el(
        "select",
        shared,
        column.options.map((/** @type {any} */ option) =>
          el("option", { value: option.value, selected: option.value === value, text: option.label }),
        ),
      );
      return select;
    }
    return el("input", {
      ...shared,
      type: "text",
      value,
      ...VERBATIM,
    });
  }
}

/** A field as a number if it is one, as it stands otherwise. @param {string} text @returns {number | string} */
export function cellValue(text) {
  return numberIn(text) ?? text;
}
