/** The table's DOM: a real table with a field in each cell, its meaning and its fault beneath it. */

import { arrange, el, faultLine, fill, iconButton, setAble, setFault, VERBATIM } from "../dom.js";
import { t } from "../i18n.js";
import { pageAddress } from "../page.js";
import { showMathml } from "../typeset.js";
import { COLUMNS, LETTERS, jointNumbers, variableCell, variableName } from "./model.js";

/**
 * @typedef {import("./model.js").Table} Table
 * @typedef {import("./model.js").CellName} CellName
 * @typedef {{input: HTMLInputElement, meaning: HTMLElement, fault: HTMLElement}} Cell
 * @typedef {{edit: (row: number, cell: CellName, text: string) => void, joint: (row: number, joint: string) => void,
 *   move: (row: number, to: number) => void, remove: (row: number) => void, settle: () => void,
 *   paste: (event: ClipboardEvent, row: number, cell: CellName) => void, key: (event: KeyboardEvent, row: number, cell: CellName) => void,
 *   focus: (input: HTMLInputElement, row: number, cell: CellName) => void, play: (row: number) => void}} Handlers
 * @typedef {{element: HTMLElement, row: import("./model.js").Row, index: number, play: HTMLElement, joint: HTMLSelectElement,
 *   cells: Map<string, Cell>, actions: HTMLElement[]}} Line one row of the table as it stands in the page
 */

const JOINTS = ["revolute", "prismatic", "fixed"];

/** A column's name in its convention, as text. @param {CellName} cell @param {string} convention */
export function columnText(cell, convention) {
  const before = convention === "modified" && (cell === "alpha" || cell === "a");
  return LETTERS[cell] + (before ? "ᵢ₋₁" : "ᵢ");
}

/** The same as markup. @param {CellName} cell @param {string} convention */
export function columnName(cell, convention) {
  const before = convention === "modified" && (cell === "alpha" || cell === "a");
  return [el("i", { text: LETTERS[cell] }), el("sub", {}, el("i", { text: "i" }), before ? "−1" : "")];
}

/** A term that leads to its place in the first lesson. @param {string} place @param {string} name @param {import("../dom.js").Child} content */
export function term(place, name, content) {
  const label = t("form-term", { term: name });
  return el(
    "a",
    { class: "term", href: `${pageAddress("lesson")}#${place}`, "aria-label": label, title: label },
    content,
  );
}

/** The unit of a column. @param {CellName} cell @param {Table} table */
function unitOf(cell, table) {
  if (cell === "alpha" || cell === "theta") return table.angleUnit === "deg" ? "°" : "rad";
  return table.lengthUnit;
}

export class Grid {
  /** @type {Map<number, Line>} */
  #lines = new Map();
  #convention = "";

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

  /** Shows a table. Rows that were there stay the same elements, so that the focus stays where it is. @param {Table} table */
  show(table) {
    const columns = COLUMNS[table.convention];
    this.caption.textContent = t("form-table-caption", { convention: t(`form-convention-${table.convention}`) });
    fill(this.head, this.#headings(table, columns));
    if (table.convention !== this.#convention) this.#lines.clear();
    this.#convention = table.convention;
    const numbers = jointNumbers(table.rows);
    this.cells.clear();
    const lines = table.rows.map((row, i) => {
      const line = this.#lines.get(row.key) ?? this.#line(row, columns);
      this.#patch(line, table, row, i, numbers[i]);
      return line;
    });
    this.#lines = new Map(lines.map((line) => [line.row.key, line]));
    arrange(
      this.body,
      lines.map(({ element }) => element),
    );
  }

  /** @param {number} row @param {CellName} cell */
  at(row, cell) {
    return this.cells.get(`${row}/${cell}`);
  }

  /** Marks the cell that is being shown in the picture; none, if there is no row. @param {number} row @param {string} cell */
  light(row, cell) {
    for (const [place, { input }] of this.cells) input.classList.toggle("lit", place === `${row}/${cell}`);
  }

  /** Shows what a cell was understood as. @param {number} row @param {CellName} cell @param {string} mathml */
  showMeaning(row, cell, mathml) {
    const found = this.at(row, cell);
    if (found) showMathml(found.meaning, mathml);
  }

  /** Shows a cell's fault, or none. @param {number} row @param {CellName | "joint"} cell @param {string} text */
  showFault(row, cell, text) {
    const found = this.at(row, /** @type {CellName} */ (cell));
    if (found && found.fault.textContent !== text) setFault(found.input, found.fault, text);
  }

  /** @param {Table} table @param {CellName[]} columns */
  #headings(table, columns) {
    const heading = (/** @type {import("../dom.js").Child} */ content, more = {}) =>
      el("th", { scope: "col", role: "columnheader", ...more }, content);
    return el(
      "tr",
      { role: "row" },
      heading(el("i", { text: "i" }), { class: "dh-index" }),
      heading(term("variable", t("form-joint"), t("form-joint")), { class: "dh-joint" }),
      columns.map((cell) =>
        heading([
          term(cell, columnText(cell, table.convention), columnName(cell, table.convention)),
          el("span", { class: "unit", text: ` [${unitOf(cell, table)}]` }),
        ]),
      ),
      heading(el("span", { class: "visually-hidden", text: t("form-row-actions") }), { class: "dh-actions" }),
    );
  }

  /** A new row of elements. @param {import("./model.js").Row} row @param {CellName[]} columns @returns {Line} */
  #line(row, columns) {
    const { handlers } = this;
    const play = el("button", { type: "button", class: "quiet dh-play", onclick: () => handlers.play(line.index) });
    const actions = [
      iconButton("up", "", () => handlers.move(line.index, line.index - 1)),
      iconButton("down", "", () => handlers.move(line.index, line.index + 1)),
      iconButton("remove", "", () => handlers.remove(line.index)),
    ];
    const joint = el(
      "select",
      { onchange: (event) => handlers.joint(line.index, event.target.value) },
      JOINTS.map((value) => el("option", { value, text: t(`form-joint-${value}`) })),
    );
    const jointFault = faultLine();
    /** @type {Map<string, Cell>} */
    const cells = new Map(columns.map((cell) => [cell, this.#cell(cell, () => line.index)]));
    cells.set("joint", { input: /** @type {any} */ (joint), fault: jointFault, meaning: el("span") });
    const boxes = columns.map((cell) => {
      const { input, meaning, fault } = /** @type {Cell} */ (cells.get(cell));
      return el("td", { role: "cell", class: "dh-cell" }, input, meaning, fault);
    });
    const element = el(
      "tr",
      { role: "row", dataset: { key: String(row.key) } },
      el("th", { scope: "row", role: "rowheader", class: "dh-index" }, play),
      el("td", { role: "cell", class: "dh-joint" }, joint, jointFault),
      boxes,
      el("td", { role: "cell", class: "dh-actions" }, actions),
    );
    /** @type {Line} */
    const line = { element, row, index: 0, play, joint, cells, actions };
    return line;
  }

  /** @param {CellName} cell @param {() => number} row @returns {Cell} */
  #cell(cell, row) {
    const { handlers } = this;
    /** @type {HTMLInputElement} */
    const input = el("input", {
      type: "text",
      maxlength: 400,
      ...VERBATIM,
      oninput: () => handlers.edit(row(), cell, input.value),
      onblur: () => handlers.settle(),
      onfocus: () => handlers.focus(input, row(), cell),
      onpaste: (event) => handlers.paste(event, row(), cell),
      onkeydown: (event) => handlers.key(event, row(), cell),
    });
    return { input, meaning: el("div", { class: "meaning" }), fault: faultLine() };
  }

  /** Brings a row of elements up to date. @param {Line} line @param {Table} table @param {import("./model.js").Row} row @param {number} i @param {number} number */
  #patch(line, table, row, i, number) {
    Object.assign(line, { row, index: i });
    line.play.textContent = String(i + 1);
    line.play.setAttribute("aria-label", t("form-row-play", { row: i + 1 }));
    line.play.title = t("form-row-play", { row: i + 1 });
    line.joint.setAttribute("aria-label", t("form-joint-of-row", { row: i + 1 }));
    if (line.joint.value !== row.joint) line.joint.value = row.joint;
    for (const [cell, parts] of line.cells) {
      this.cells.set(`${i}/${cell}`, parts);
      if (cell === "joint") {
        parts.fault.id = `${this.id}-${i}-joint-fault`;
        line.joint.setAttribute("aria-describedby", parts.fault.id);
      } else this.#patchCell(parts, table, row, i, /** @type {CellName} */ (cell), number);
    }
    const last = table.rows.length - 1;
    const names = ["form-row-up", "form-row-down", "form-row-remove"];
    const useless = [i === 0, i === last, last === 0];
    line.actions.forEach((button, k) => {
      const label = t(names[k], { row: String(i + 1) });
      button.setAttribute("aria-label", label);
      button.title = label;
      setAble(button, !useless[k]);
    });
  }

  /** @param {Cell} parts @param {Table} table @param {import("./model.js").Row} row @param {number} i @param {CellName} cell @param {number} number */
  #patchCell({ input, meaning, fault }, table, row, i, cell, number) {
    const id = `${this.id}-${i}-${cell}`;
    const name = columnText(cell, table.convention);
    const holdsVariable = variableCell(row.joint) === cell;
    input.id = id;
    meaning.id = `${id}-meaning`;
    fault.id = `${id}-fault`;
    fault.dataset.label = name;
    if (input.value !== row[cell]) input.value = row[cell];
    input.placeholder = holdsVariable ? variableName(row.joint, number) : "";
    input.setAttribute("aria-label", t("form-cell-label", { row: i + 1, name, unit: unitOf(cell, table) }));
    input.setAttribute("aria-describedby", `${meaning.id} ${fault.id}`);
    const box = input.parentElement;
    if (!box) return;
    box.dataset.label = name;
    box.classList.toggle("holds-variable", holdsVariable);
  }
}
