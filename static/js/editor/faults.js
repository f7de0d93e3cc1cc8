/**
 * What is wrong with a table, from two sides: what the service says while it is typed, and what it said when the
 * table was handed in. The second has a summary that leads to each cell, or to the first of a whole row or column. A fault goes when its cell is typed into,
 * whichever side it came from; an answer to the one never touches the other, in whatever order they arrive.
 */

import { el, fill } from "../dom.js";
import { named, t } from "../i18n.js";
import { columnText } from "./grid.js";
import { COLUMNS } from "./model.js";

/** @typedef {{row: number, cell: string, text: string}} PlacedFault row -1 is the table as a whole */

/** @param {import("../api.js").Fault[]} faults @returns {PlacedFault[]} */
export function placedFaults(faults) {
  return faults.map((fault) => {
    const match = /\/rows\/(\d+)(?:\/(\w+))?$/.exec(fault.pointer ?? "");
    return { row: match ? Number(match[1]) : -1, cell: match?.[2] ?? "joint", text: fault.detail };
  });
}

export class Faults {
  /** @type {PlacedFault[]} */
  #read = [];
  /** @type {PlacedFault[]} */
  #refused = [];
  /** @type {Pick<import("./model.js").Table, "convention" | "rows"> | null} */
  #table = null;

  /** @param {string} id of the editor @param {(row: number, cell: any) => void} go leads to a cell */
  constructor(id, go) {
    this.id = id;
    this.go = go;
    this.title = el("strong", { id: `${id}-faults` });
    this.list = el("ul");
    this.summary = el(
      "div",
      {
        class: "editor-summary notice notice-problem",
        role: "group",
        tabindex: "-1",
        "aria-labelledby": this.title.id,
        hidden: true,
      },
      el("p", {}, this.title),
      this.list,
    );
    this.general = el("div", { class: "notice notice-problem", role: "status", hidden: true });
  }

  /** What the service says of the table as it stands. @param {PlacedFault[]} faults */
  read(faults) {
    this.#read = faults;
  }

  /** What the service said last of the table as it stands. */
  get known() {
    return this.#read;
  }

  /** What a table was refused for, listed in the summary. @param {PlacedFault[]} faults @param {import("./model.js").Table} table */
  refuse(faults, table) {
    this.#refused = faults;
    this.#table = table;
    this.#showSummary();
  }

  /** A cell was typed into. @param {number} row @param {string} cell */
  forget(row, cell) {
    /** @param {any} fault */
    const elsewhere = (fault) => fault.row !== row || fault.cell !== cell;
    this.#read = this.#read.filter(elsewhere);
    this.#refused = this.#refused.filter(elsewhere);
    this.#showSummary();
  }

  /** The table is another one. */
  clear() {
    this.#read = [];
    this.#refused = [];
    this.#showSummary();
  }

  /** What is wrong with a cell. @param {number} row @param {string} cell */
  at(row, cell) {
    return [...this.#refused, ...this.#read].find((fault) => fault.row === row && fault.cell === cell)?.text ?? "";
  }

  /** Whether a table was refused for this cell. @param {number} row @param {string} cell */
  isRefused(row, cell) {
    return this.#refused.some((fault) => fault.row === row && fault.cell === cell);
  }

  /** Shows what belongs to no cell. @param {(row: number, cell: string) => boolean} isCell */
  showGeneral(isCell) {
    const listed = new Set(this.#refused.map(({ text }) => text));
    const texts = this.#read
      .filter(({ row, cell, text }) => !isCell(row, cell) && !listed.has(text))
      .map(({ text }) => text);
    if (texts.join("\n") === this.generalText) return;
    this.generalText = texts.join("\n");
    this.general.hidden = texts.length === 0;
    fill(
      this.general,
      texts.map((text) => el("p", { text })),
    );
  }

  #showSummary() {
    this.summary.hidden = this.#refused.length === 0;
    fill(this.list, this.#lines());
    const count = this.#refused.filter(({ row }) => row >= 0).length;
    if (this.#refused.length) this.title.textContent = count ? t("form-faults", { count }) : t("form-refused");
  }

  /** A line for each fault; one for a column or a row in which every cell has the same. */
  #lines() {
    if (!this.#table) return [];
    const { convention, rows } = this.#table;
    const columns = COLUMNS[convention];
    /** @param {number} row @param {string} cell */
    const textAt = (row, cell) => this.#refused.find((fault) => fault.row === row && fault.cell === cell)?.text ?? "";
    const isSame = (/** @type {string[]} */ texts) => texts.length > 1 && new Set(texts).size === 1 && texts[0] !== "";
    const wholeColumns = columns.filter((cell) => isSame(rows.map((_, row) => textAt(row, cell))));
    const others = columns.filter((cell) => !wholeColumns.includes(cell));
    const isWholeRow = (/** @type {number} */ row) =>
      others.length > 1 && row >= 0 && isSame(columns.map((cell) => textAt(row, cell)));
    /** @type {Map<string, HTMLElement>} */
    const lines = new Map();
    for (const [i, fault] of this.#refused.entries()) {
      const { row, cell, text } = fault;
      const name = cell === "joint" ? t("form-joint") : columnText(/** @type {any} */ (cell), convention);
      const [key, place] = wholeColumns.includes(/** @type {any} */ (cell))
        ? [cell, t("form-column", { name })]
        : isWholeRow(row) && cell !== "joint"
          ? [`row ${row}`, t("form-row", { row: row + 1 })]
          : [`fault ${i}`, t("form-row-cell", { row: row + 1, name })];
      if (!lines.has(key)) lines.set(key, row < 0 ? el("li", { text }) : this.#line(fault, place));
    }
    return [...lines.values()];
  }

  /** @param {PlacedFault} fault @param {string} place */
  #line({ row, cell, text }, place) {
    /** @param {any} event */
    const follow = (event) => {
      event.preventDefault();
      this.go(row, cell);
    };
    return el("li", {}, el("a", { href: `#${this.id}-${row}-${cell}`, onclick: follow, text: named(place, text) }));
  }
}
