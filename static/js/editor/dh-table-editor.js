/**
 * `<dh-table-editor>`: a DH table to type, paste, reorder, undo.
 *
 * Properties: `table` (as it goes to the API), `state` (as it is typed; JSON), `allowed` (conventions).
 * Methods: `showMeaning(rows)`, `showFaults(faults)`, `focusCell(row, cell)`.
 * Event: `table-change` with `detail: {table, complete}` whenever something was typed.
 */

import { announce, el, fill, uniqueId } from "../dom.js";
import { t } from "../i18n.js";
import { Bar, editorFoot } from "./bar.js";
import { faultSummary, placedFaults } from "./faults.js";
import { Grid } from "./grid.js";
import {
  CELLS,
  COLUMNS,
  convertedAngles,
  emptyCells,
  fromWire,
  History,
  insertRow,
  isBareVariable,
  moveRow,
  newRow,
  newTable,
  removeRow,
  setCell,
  setJoint,
  toWire,
} from "./model.js";
import { isTable, readPasted, withBlock, withPasted } from "./paste.js";
import { askForTable } from "./paste-dialog.js";

/** @typedef {import("./model.js").CellName} CellName */
/** @typedef {import("./model.js").Table} Table */

export class DhTableEditor extends HTMLElement {
  #history = new History(newTable("modified", 1));
  #grid = /** @type {Grid} */ (/** @type {unknown} */ (null));
  #bar = /** @type {Bar} */ (/** @type {unknown} */ (null));
  #faults = /** @type {{row: number, cell: string, text: string}[]} */ ([]);
  #lastInput = /** @type {HTMLInputElement | null} */ (null);
  /** @type {("standard" | "modified")[]} */
  #allowed = ["standard", "modified"];

  connectedCallback() {
    if (this.#grid) return;
    this.id ||= uniqueId("table");
    this.#bar = new Bar(this.id, {
      undo: () => this.#step("undo"),
      redo: () => this.#step("redo"),
      paste: () => this.#openPaste(),
    });
    this.notice = el("div", { class: "editor-notice" });
    this.summary = el("div", { class: "editor-summary", tabindex: "-1" });
    this.#grid = new Grid(this.id, {
      edit: (row, cell, text) => this.#edit(row, cell, text),
      joint: (row, joint) => this.#change(setJoint(this.#table, row, /** @type {any} */ (joint)), { focus: [row, "joint"] }),
      move: (row, to) => this.#move(row, to, null),
      remove: (row) => this.#remove(row),
      settle: () => this.#settle(),
      paste: (event, row, cell) => this.#paste(event, row, cell),
      key: (event, row, cell) => this.#key(event, row, cell),
      focus: (input) => (this.#lastInput = input),
    });
    this.addEventListener("keydown", (event) => this.#undoKeys(event));
    const frame = el("div", { class: "dh-frame" }, this.#grid.element);
    const foot = editorFoot(() => this.#add(this.#table.rows.length), () => this.#lastInput);
    fill(this, this.#bar.element, this.notice, this.summary, frame, foot);
    this.#show();
  }

  get #table() {
    return this.#history.table;
  }

  /** The table as it goes to the API. */
  get table() {
    return toWire(this.#table);
  }

  set table(wire) {
    this.#change(fromWire(wire), { quietly: true });
  }

  /** Everything that was typed, as plain data. */
  get state() {
    return structuredClone(this.#table);
  }

  set state(state) {
    const rows = state.rows.map((row) => ({ ...row, key: newRow(0, "fixed").key }));
    this.#history = new History({ ...state, rows });
    if (this.#grid) this.#show();
  }

  /** Conventions that may be chosen. */
  get allowed() {
    return this.#allowed;
  }

  set allowed(allowed) {
    this.#allowed = allowed;
    if (!allowed.includes(this.#table.convention)) this.#history = new History({ ...this.#table, convention: allowed[0] });
    if (this.#grid) this.#show();
  }

  /** Whether something stands in every cell. */
  get complete() {
    return emptyCells(this.#table).length === 0;
  }

  /** Whether nothing stands in the table but the variables that a new one holds. */
  get untouched() {
    const texts = this.#table.rows.flatMap((row) => CELLS.map((cell) => row[cell]));
    return texts.every((text) => text.trim() === "" || isBareVariable(text));
  }

  /** Cells in which nothing stands. */
  get missing() {
    return emptyCells(this.#table);
  }

  /** Shows what cells were understood as. @param {(import("../understanding.js").ReadRow | undefined)[]} rows */
  showMeaning(rows) {
    this.#table.rows.forEach((_, i) => {
      for (const cell of CELLS) this.#grid.showMeaning(i, cell, rows[i]?.meanings[cell] ?? "");
    });
  }

  /**
   * Shows faults at their cells.
   * @param {import("../api.js").Fault[]} faults with pointers such as /table/rows/2/alpha
   * @param {{summary?: boolean}} [options] with a summary that links to each, and takes the focus
   */
  showFaults(faults, { summary = false } = {}) {
    this.#faults = placedFaults(faults);
    this.#placeFaults();
    if (summary && faults.length) this.#summarize();
    else fill(this.summary);
  }

  /** @param {number} row @param {CellName | "joint"} cell */
  focusCell(row, cell) {
    const input = this.#grid.at(row, /** @type {CellName} */ (cell))?.input;
    input?.focus();
    if (input instanceof HTMLInputElement) input.select();
  }

  #show(focus) {
    const kept = focus ?? this.#focused();
    this.#grid.show(this.#table);
    this.#showBar();
    this.#placeFaults();
    if (kept) this.#grid.at(kept[0], kept[1])?.input.focus({ preventScroll: false });
  }

  #focused() {
    const active = document.activeElement;
    for (const [key, { input }] of this.#grid.cells) {
      if (input === active) return /** @type {[number, any]} */ ([Number(key.split("/")[0]), key.split("/")[1]]);
    }
    return null;
  }

  #change(table, { tag = "", focus = null, quietly = false } = {}) {
    if (table === this.#table) return;
    this.#history.change(table, tag);
    this.#faults = [];
    if (this.#grid) this.#show(focus);
    if (!quietly) fill(this.notice);
    this.#tell();
  }

  #edit(row, cell, text) {
    this.#history.change(setCell(this.#table, row, cell, text), `${row}/${cell}`);
    this.#faults = this.#faults.filter((fault) => fault.row !== row || fault.cell !== cell);
    this.#grid.showFault(row, cell, "");
    this.#showUndo();
    this.#tell();
  }

  #tell() {
    this.dispatchEvent(new CustomEvent("table-change", { detail: { table: this.table, complete: this.complete }, bubbles: true }));
  }

  #settle() {
    this.#history.settle();
    setTimeout(() => this.#placeFaults());
  }

  /** A fault in the cell that is being typed into waits until the cell is left. */
  #placeFaults() {
    if (!this.#grid) return;
    for (const [key, { input }] of this.#grid.cells) {
      const [row, cell] = key.split("/");
      const text = this.#faults.find((fault) => fault.row === Number(row) && fault.cell === cell)?.text ?? "";
      if (text && input === document.activeElement && input.tagName === "INPUT") continue;
      this.#grid.showFault(Number(row), /** @type {any} */ (cell), text);
    }
    const general = this.#faults.filter((fault) => fault.row < 0 || !this.#grid.at(fault.row, /** @type {any} */ (fault.cell)));
    this.general?.remove();
    if (general.length) {
      this.general = el("div", { class: "notice notice-problem" }, general.map((fault) => el("p", { text: fault.text })));
      this.summary.after(this.general);
    }
  }

  #summarize() {
    const go = (row, cell) => this.focusCell(row, cell);
    fill(this.summary, faultSummary(this.#faults, this.id, this.#table.convention, go));
    this.#placeFaults();
    this.summary.focus();
  }

  /** Says that cells are empty, with links to them. */
  showMissing() {
    this.showFaults(
      this.missing.map(({ row, cell }) => ({ code: "cell_empty", pointer: `/rows/${row}/${cell}`, detail: t("form-cell-empty"), params: {} })),
      { summary: true },
    );
  }

  #showBar() {
    const table = this.#table;
    this.#bar.show(table, this.#allowed, {
      convention: (value) => this.#setConvention(value),
      angleUnit: (value) => this.#setAngleUnit(value),
      lengthUnit: (value) => this.#change({ ...table, lengthUnit: value }),
    });
    this.#showUndo();
  }

  #showUndo() {
    this.#bar.enable(this.#history.past.length > 0, this.#history.future.length > 0);
  }

  #add(at) {
    this.#change(insertRow(this.#table, at), { focus: [at, COLUMNS[this.#table.convention][0]] });
    announce(t("form-row-added", { row: at + 1 }));
  }

  #remove(row) {
    if (this.#table.rows.length <= 1) return;
    const next = Math.min(row, this.#table.rows.length - 2);
    this.#change(removeRow(this.#table, row), { focus: [next, COLUMNS[this.#table.convention][0]] });
    announce(t("form-row-removed", { row: row + 1 }));
  }

  #move(row, to, cell) {
    if (to < 0 || to >= this.#table.rows.length) return;
    this.#change(moveRow(this.#table, row, to), cell ? { focus: [to, cell] } : {});
    if (!cell) {
      const label = to < row ? t("form-row-up", { row: to + 1 }) : t("form-row-down", { row: to + 1 });
      /** @type {HTMLElement} */ (this.querySelector(`[aria-label="${CSS.escape(label)}"]`))?.focus();
    }
    announce(t("form-row-moved", { row: row + 1, to: to + 1 }));
  }

  #step(direction) {
    if (!this.#history[direction]()) return;
    this.#faults = [];
    this.#show();
    fill(this.notice);
    announce(t(direction === "undo" ? "form-undone" : "form-redone"));
    this.#tell();
  }

  #setConvention(convention) {
    if (convention === this.#table.convention) return;
    this.#change({ ...this.#table, convention });
    this.#say(t(`form-convention-now-${convention}`), []);
  }

  #setAngleUnit(unit) {
    const before = this.#table;
    if (unit === before.angleUnit) return;
    this.#change({ ...before, angleUnit: unit });
    const numbers = before.rows.some((row) => [row.alpha, row.theta].some((cell) => /\d/.test(cell) && cell.trim() !== "0"));
    if (!numbers) return;
    const convert = el("button", {
      type: "button",
      text: t("form-unit-convert"),
      onclick: () => {
        this.#change(convertedAngles(this.#table, unit));
        announce(t("form-unit-converted"));
      },
    });
    this.#say(t(unit === "deg" ? "form-unit-now-deg" : "form-unit-now-rad"), [convert]);
  }

  #say(text, actions) {
    fill(
      this.notice,
      el("div", { class: "notice row", role: "status" }, el("span", { class: "grow", text }), actions, el("button", { type: "button", class: "quiet", text: t("form-undo"), onclick: () => this.#step("undo") })),
    );
  }

  #undoKeys(event) {
    if (!(event.ctrlKey || event.metaKey) || event.altKey) return;
    const key = event.key.toLowerCase();
    const direction = key === "y" || (key === "z" && event.shiftKey) ? "redo" : key === "z" ? "undo" : null;
    if (!direction) return;
    event.preventDefault();
    this.#step(direction);
  }

  #key(event, row, cell) {
    if (event.isComposing) return;
    const last = this.#table.rows.length - 1;
    const go = (to) => {
      event.preventDefault();
      this.focusCell(to, cell);
    };
    if (event.altKey && (event.key === "ArrowUp" || event.key === "ArrowDown")) {
      event.preventDefault();
      this.#move(row, row + (event.key === "ArrowUp" ? -1 : 1), cell);
    } else if (event.altKey && (event.key === "Insert" || event.key === "Enter")) {
      event.preventDefault();
      this.#add(row + 1);
    } else if (event.altKey && (event.key === "Delete" || event.key === "Backspace")) {
      event.preventDefault();
      this.#remove(row);
    } else if (event.ctrlKey || event.metaKey || event.altKey) return;
    else if (event.key === "ArrowUp" && row > 0) go(row - 1);
    else if (event.key === "ArrowDown" && row < last) go(row + 1);
    else if (event.key === "Enter" && row < last) go(row + 1);
    else if (event.key === "Enter") event.preventDefault();
  }

  #openPaste() {
    const order = COLUMNS[this.#table.convention];
    askForTable(this, order, this.#table.convention, (pasted) => this.#take(pasted, 0, true));
  }

  #paste(event, row, cell) {
    const text = event.clipboardData?.getData("text/plain") ?? "";
    if (!isTable(text)) return;
    const pasted = readPasted(text, COLUMNS[this.#table.convention]);
    const table = pasted ? null : withBlock(this.#table, text, row, cell);
    if (!pasted && !table) return;
    event.preventDefault();
    if (table) this.#change(table, { focus: [row, cell] });
    else this.#take(pasted, row, row === 0 && pasted.rows.length >= this.#table.rows.length);
  }

  #take(pasted, at, replace) {
    const before = this.#table;
    const next = withPasted(before, pasted, at, replace, this.#allowed);
    this.#change(next, { focus: [at, COLUMNS[next.convention][0]] });
    const changed = next.convention !== before.convention ? ` ${t(`form-convention-now-${next.convention}`)}` : "";
    this.#say(t("form-pasted", { rows: pasted.rows.length }) + changed, []);
  }
}

customElements.define("dh-table-editor", DhTableEditor);
