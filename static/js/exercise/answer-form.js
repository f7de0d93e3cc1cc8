/**
 * The form of a part that describes its answer itself: cells, rows, matrices, lists of rows, choices.
 * The same interface as the fields of `part-fields.js`.
 */

import { columnHeads } from "../data-table.js";
import { el, faultLine, fill, setFault, uniqueId, VERBATIM } from "../dom.js";
import { named, t } from "../i18n.js";
import { typed as read } from "./typed.js";
import { plain } from "../numbers.js";

/** @typedef {{input: HTMLInputElement | HTMLSelectElement, line: HTMLElement}} Slot */
/** @typedef {{name: string, label: string, shape: string, labels: string[], rows: number, options: {value: string, label: string}[]}} Field */

export class AnswerForm {
  onchange = () => {};

  /** @param {{form: Field[], numbers: any[]}} part */
  constructor({ form, numbers }) {
    this.fields = form.map((field) => new FormField(field, () => this.onchange()));
    this.element = el(
      "div",
      { class: "stack" },
      numbers.map(givenNumbers),
      this.fields.map(({ element }) => element),
    );
  }

  get touched() {
    return this.fields.some(({ touched }) => touched);
  }

  get value() {
    if (!this.touched) return null;
    const typed = this.fields.filter(({ touched }) => touched);
    return Object.fromEntries(typed.map((field) => [field.name, field.value]));
  }

  get state() {
    return Object.fromEntries(this.fields.map((field) => [field.name, field.state]));
  }

  set state(values) {
    for (const field of this.fields) if (values?.[field.name]) field.state = values[field.name];
  }

  /** @param {{where: (string | number)[], text: string}[]} faults */
  showFaults(faults) {
    for (const field of this.fields) field.clear();
    for (const { where, text } of faults) {
      const field = this.fields.find(({ name }) => name === where[0]) ?? this.fields[0];
      field?.show(where.slice(1), text);
    }
  }

  /** @param {any} [where] */
  focus([name, ...where] = []) {
    (this.fields.find((field) => field.name === name) ?? this.fields[0])?.focus(where);
  }
}

/**
 * How a place of such an answer is called; null of what has no field.
 * @param {Field[]} form @param {(string | number)[]} where
 */
export function formPlace(form, [name, ...where]) {
  const field = form.find((found) => found.name === name);
  return field ? { name: field.label, at: where.map((step) => Number(step) + 1).join(", ") } : null;
}

class FormField {
  /** @param {Field} field @param {() => void} changed */
  constructor(field, changed) {
    this.name = field.name;
    this.field = field;
    this.changed = changed;
    /** @type {Slot[][]} */
    this.rows = [];
    this.body = el("tbody");
    this.more = el("button", {
      type: "button",
      class: "quiet small",
      text: t("form-row-add"),
      onclick: () => (this.#grow(this.rows.length + 1), this.rows.at(-1)?.[0].input.focus()),
    });
    const { shape, labels, label } = field;
    if (shape === "choice" || shape === "cell") {
      const slot = this.#slot(0, 0);
      this.rows = [[slot]];
      const unit = shape === "cell" && labels[0] ? ` ${labels[0]}` : "";
      this.element = el(
        "div",
        { class: "field" },
        el("label", { for: slot.input.id, text: `${label}${unit}` }),
        slot.input,
        slot.line,
      );
      return;
    }
    const head = labels.some(Boolean) ? columnHeads(labels) : null;
    this.element = el(
      "fieldset",
      { class: "matrix-field" },
      el("legend", { text: label }),
      el(
        "div",
        { class: "scroller", tabindex: "0", role: "group", "aria-label": label },
        el("table", { class: "matrix-cells", role: "presentation" }, head, this.body),
      ),
      shape === "list" ? el("div", { class: "row" }, this.more) : null,
    );
    this.#grow(shape === "matrix" ? field.rows : 1);
  }

  get touched() {
    return this.rows.some((row) => row.some(({ input }) => input.value.trim() !== ""));
  }

  get value() {
    const { shape } = this.field;
    const typed = this.rows.map((row) => row.map(({ input }) => read(input)));
    if (shape === "choice" || shape === "cell") return typed[0][0];
    if (shape === "vector") return typed[0];
    return shape === "list" ? typed.filter((row) => row.some(Boolean)) : typed;
  }

  get state() {
    return this.rows.map((row) => row.map(({ input }) => input.value));
  }

  set state(values) {
    if (!Array.isArray(values)) return;
    if (this.field.shape === "list") this.#cut(Math.max(1, values.length));
    this.#grow(values.length);
    values.forEach((row, i) =>
      row.forEach((/** @type {string} */ text, /** @type {number} */ k) => {
        const slot = this.rows[i]?.[k];
        if (slot) slot.input.value = text;
      }),
    );
  }

  clear() {
    for (const row of this.rows) for (const { input, line } of row) setFault(input, line, "");
  }

  /** @param {(string | number)[]} where @param {string} text */
  show(where, text) {
    const slot = this.#at(where);
    setFault(slot.input, slot.line, text);
  }

  /** @param {(string | number)[]} where */
  focus(where) {
    this.#at(where).input.focus();
  }

  /** @param {(string | number)[]} where */
  #at(where) {
    const [row, column] = this.field.shape === "vector" ? [0, where[0]] : where;
    return this.rows[Number(row ?? 0)]?.[Number(column ?? 0)] ?? this.rows[0][0];
  }

  /** Takes away the rows after so many: an earlier answer had fewer. @param {number} count */
  #cut(count) {
    for (const _ of this.rows.splice(count)) this.body.lastElementChild?.remove();
  }

  /** @param {number} count */
  #grow(count) {
    const { shape, rows, labels } = this.field;
    const most = shape === "matrix" || shape === "list" ? rows : 1;
    if (shape === "choice" || shape === "cell") return;
    while (this.rows.length < Math.min(count, most)) {
      const i = this.rows.length;
      const row = labels.map((_, k) => this.#slot(i, k));
      this.rows.push(row);
      this.body.append(
        el(
          "tr",
          {},
          row.map(({ input, line }) => el("td", {}, input, line)),
        ),
      );
    }
    this.more.hidden = this.rows.length >= most;
  }

  /** @param {number} row @param {number} column @returns {Slot} */
  #slot(row, column) {
    const { shape, label, labels, options } = this.field;
    const line = faultLine(uniqueId("fault"));
    const changed = () => (setFault(input, line, ""), this.changed());
    const single = shape === "choice" || shape === "cell";
    const shared = { id: uniqueId("form"), "aria-describedby": line.id };
    const name = named(label, `${row + 1}, ${labels[column] || column + 1}`);
    /** @type {HTMLInputElement | HTMLSelectElement} */
    const input =
      shape === "choice"
        ? el(
            "select",
            { ...shared, onchange: changed },
            el("option", { value: "", text: t("form-choose") }),
            options.map((option) => el("option", { value: option.value, text: option.label })),
          )
        : el("input", {
            ...shared,
            type: "text",
            ...VERBATIM,
            "aria-label": single ? null : name,
            oninput: changed,
          });
    return { input, line };
  }
}

/** Numbers that a task is about. @param {{label: string, labels: string[], rows: (string | number)[][]}} given */
function givenNumbers({ label, labels, rows }) {
  const table = el("table", { class: labels.length ? "data given-data" : "matrix-cells given-matrix" });
  const body = rows.map((row) =>
    el(
      "tr",
      {},
      row.map((cell) => el("td", { text: typeof cell === "number" ? plain(cell, 4) : cell })),
    ),
  );
  const head = labels.length ? columnHeads(labels) : null;
  fill(table, el("caption", { text: label }), head, el("tbody", {}, body));
  return el("div", { class: "scroller", tabindex: "0", role: "group", "aria-label": label }, table);
}
