/**
 * What is wrong with a table, from two sides: what the service says while it is typed, and what it said when the
 * table was handed in. The second has a summary that leads to each cell. A fault goes when its cell is typed into,
 * whichever side it came from; an answer to the one never touches the other, in whatever order they arrive.
 */

import { el, fill } from "../dom.js";
import { named, t } from "../i18n.js";
import { columnText } from "./grid.js";

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
  /** @type {Map<PlacedFault, HTMLElement>} */
  #lines = new Map();

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

  /** What a table was refused for, listed in the summary. @param {PlacedFault[]} faults @param {string} convention */
  refuse(faults, convention) {
    this.#refused = faults;
    this.#lines = new Map(faults.map((fault) => [fault, this.#line(fault, convention)]));
    fill(this.list, [...this.#lines.values()]);
    this.#count();
  }

  /** A cell was typed into. @param {number} row @param {string} cell */
  forget(row, cell) {
    /** @param {any} fault */
    const elsewhere = (fault) => fault.row !== row || fault.cell !== cell;
    this.#read = this.#read.filter(elsewhere);
    for (const fault of this.#refused) if (!elsewhere(fault)) this.#lines.get(fault)?.remove();
    this.#refused = this.#refused.filter(elsewhere);
    this.#count();
  }

  /** The table is another one. */
  clear() {
    this.#read = [];
    this.refuse([], "");
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

  #count() {
    this.summary.hidden = this.#refused.length === 0;
    const count = this.#refused.filter(({ row }) => row >= 0).length;
    if (this.#refused.length) this.title.textContent = count ? t("form-faults", { count }) : t("form-refused");
  }

  /** @param {any} options @param {string} convention */
  #line({ row, cell, text }, convention) {
    if (row < 0) return el("li", { text });
    const name = cell === "joint" ? t("form-joint") : columnText(/** @type {any} */ (cell), convention);
    /** @param {any} event */
    const follow = (event) => {
      event.preventDefault();
      this.go(row, cell);
    };
    const place = t("form-row-cell", { row: row + 1, name });
    return el("li", {}, el("a", { href: `#${this.id}-${row}-${cell}`, onclick: follow, text: named(place, text) }));
  }
}
