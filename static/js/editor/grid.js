/** The table's DOM: a real table with a field in each cell, its meaning and its fault beneath it. */

import { el, fill, iconButton } from "../dom.js";
import { t } from "../i18n.js";
import { showMathml } from "../typeset.js";
import { COLUMNS, jointNumbers, variableCell, variableName } from "./model.js";

/**
 * @typedef {import("./model.js").Table} Table
 * @typedef {import("./model.js").CellName} CellName
 * @typedef {{input: HTMLInputElement, meaning: HTMLElement, fault: HTMLElement}} Cell
 * @typedef {{edit: (row: number, cell: CellName, text: string) => void, joint: (row: number, joint: string) => void,
 *   move: (row: number, to: number) => void, remove: (row: number) => void, settle: () => void,
 *   paste: (event: ClipboardEvent, row: number, cell: CellName) => void, key: (event: KeyboardEvent, row: number, cell: CellName) => void,
 *   focus: (input: HTMLInputElement) => void}} Handlers
 */

const SIGNS = { alpha: "α", a: "a", d: "d", theta: "θ" };
const JOINTS = ["revolute", "prismatic", "fixed"];

/** A column's name in its convention, as text. @param {CellName} cell @param {string} convention */
export function columnText(cell, convention) {
  const before = convention === "modified" && (cell === "alpha" || cell === "a");
  return SIGNS[cell] + (before ? "ᵢ₋₁" : "ᵢ");
}

/** The same as markup. @param {CellName} cell @param {string} convention */
export function columnName(cell, convention) {
  const before = convention === "modified" && (cell === "alpha" || cell === "a");
  return [el("i", { text: SIGNS[cell] }), el("sub", {}, el("i", { text: "i" }), before ? "−1" : "")];
}

/** The unit of a column. @param {CellName} cell @param {Table} table */
export function unitOf(cell, table) {
  if (cell === "alpha" || cell === "theta") return table.angleUnit === "deg" ? "°" : "rad";
  return table.lengthUnit;
}

export class Grid {
  /** @param {string} id stem of the ids of its cells @param {Handlers} handlers */
  constructor(id, handlers) {
    this.id = id;
    this.handlers = handlers;
    this.head = el("thead", { role: "rowgroup" });
    this.body = el("tbody", { role: "rowgroup" });
    this.caption = el("caption", { class: "visually-hidden" });
    this.element = el("table", { class: "dh", role: "table" }, this.caption, this.head, this.body);
    /** @type {Map<string, Cell>} */
    this.cells = new Map();
  }

  /** Builds the table anew. @param {Table} table */
  show(table) {
    const columns = COLUMNS[table.convention];
    this.caption.textContent = t("form-table-caption", { convention: t(`form-convention-${table.convention}`) });
    fill(this.head, this.#headings(table, columns));
    this.cells.clear();
    const numbers = jointNumbers(table.rows);
    fill(
      this.body,
      table.rows.map((row, i) => this.#row(table, row, i, columns, numbers[i])),
    );
  }

  /** @param {number} row @param {CellName} cell */
  at(row, cell) {
    return this.cells.get(`${row}/${cell}`);
  }

  /** Shows what a cell was understood as. @param {number} row @param {CellName} cell @param {string} mathml */
  showMeaning(row, cell, mathml) {
    const found = this.at(row, cell);
    if (found) showMathml(found.meaning, mathml);
  }

  /** Shows a cell's fault, or none. @param {number} row @param {CellName | "joint"} cell @param {string} text */
  showFault(row, cell, text) {
    const found = this.at(row, /** @type {CellName} */ (cell));
    if (!found || found.fault.textContent === text) return;
    found.fault.textContent = text;
    found.fault.hidden = !text;
    if (text) found.input.setAttribute("aria-invalid", "true");
    else found.input.removeAttribute("aria-invalid");
  }

  #headings(table, columns) {
    const heading = (content, more = {}) => el("th", { scope: "col", role: "columnheader", ...more }, content);
    return el(
      "tr",
      { role: "row" },
      heading(el("i", { text: "i" }), { class: "dh-index" }),
      heading(t("form-joint"), { class: "dh-joint" }),
      columns.map((cell) =>
        heading([columnName(cell, table.convention), el("span", { class: "unit", text: ` [${unitOf(cell, table)}]` })]),
      ),
      heading(el("span", { class: "visually-hidden", text: t("form-row-actions") }), { class: "dh-actions" }),
    );
  }

  #row(table, row, i, columns, number) {
    const { handlers } = this;
    const last = table.rows.length - 1;
    const name = String(i + 1);
    return el(
      "tr",
      { role: "row", dataset: { key: String(row.key) } },
      el("th", { scope: "row", role: "rowheader", class: "dh-index", text: name }),
      el("td", { role: "cell", class: "dh-joint" }, this.#jointSelect(row, i)),
      columns.map((cell) => this.#cell(table, row, i, cell, number)),
      el(
        "td",
        { role: "cell", class: "dh-actions" },
        iconButton("up", t("form-row-up", { row: name }), () => handlers.move(i, i - 1), {
          "aria-disabled": i === 0 ? "true" : null,
        }),
        iconButton("down", t("form-row-down", { row: name }), () => handlers.move(i, i + 1), {
          "aria-disabled": i === last ? "true" : null,
        }),
        iconButton("remove", t("form-row-remove", { row: name }), () => handlers.remove(i), {
          "aria-disabled": last === 0 ? "true" : null,
        }),
      ),
    );
  }

  #jointSelect(row, i) {
    const fault = el("div", { class: "fault", id: `${this.id}-${i}-joint-fault`, hidden: true });
    const input = el(
      "select",
      {
        "aria-label": t("form-joint-of-row", { row: i + 1 }),
        "aria-describedby": fault.id,
        onchange: (event) => this.handlers.joint(i, event.target.value),
      },
      JOINTS.map((joint) =>
        el("option", { value: joint, selected: joint === row.joint, text: t(`form-joint-${joint}`) }),
      ),
    );
    this.cells.set(`${i}/joint`, /** @type {any} */ ({ input, fault, meaning: el("span") }));
    return [input, fault];
  }

  #cell(table, row, i, cell, number) {
    const { handlers } = this;
    const id = `${this.id}-${i}-${cell}`;
    const meaning = el("div", { class: "meaning", id: `${id}-meaning` });
    const name = columnText(cell, table.convention);
    const fault = el("div", { class: "fault", id: `${id}-fault`, hidden: true, "data-label": name });
    const holdsVariable = variableCell(row.joint) === cell;
    const input = /** @type {HTMLInputElement} */ (
      el("input", {
        id,
        type: "text",
        value: row[cell],
        placeholder: holdsVariable ? variableName(row.joint, number) : null,
        maxlength: 400,
        autocomplete: "off",
        autocapitalize: "off",
        autocorrect: "off",
        spellcheck: "false",
        "aria-label": t("form-cell-label", { row: i + 1, name, unit: unitOf(cell, table) }),
        "aria-describedby": `${meaning.id} ${fault.id}`,
        oninput: () => handlers.edit(i, cell, input.value),
        onblur: () => handlers.settle(),
        onfocus: () => handlers.focus(input),
        onpaste: (event) => handlers.paste(event, i, cell),
        onkeydown: (event) => handlers.key(event, i, cell),
      })
    );
    this.cells.set(`${i}/${cell}`, { input, meaning, fault });
    return el(
      "td",
      { role: "cell", class: `dh-cell${holdsVariable ? " holds-variable" : ""}`, "data-label": name },
      input,
      meaning,
      fault,
    );
  }
}
