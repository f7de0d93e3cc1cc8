/**
 * `<dh-table-editor>`: a DH table to type, paste, reorder, undo.
 *
 * Properties: `table` (as it goes to the API), `state` (as it is typed; JSON), `allowed` (conventions).
 * Methods: `load(table)`, `showMeaning(rows)`, `showFaults(faults)`, `showRefusal(faults, table)`, `focusCell(row, cell)`.
 * Events: `table-change` with `detail: {table, complete}` whenever something was typed; `cell-focus` with `{row, cell}`;
 * `row-play` with `{row}` where the film of a row is wanted.
 */

import { announce, el, fill, uniqueId } from "../dom.js";
import { language, t } from "../i18n.js";
import { stepAsked, UndoHistory } from "../undo.js";
import { Bar, editorFoot, symbolBar } from "./bar.js";
import { convertedAngles, convertedLengths, doubtfulAngle, holdsNumbers } from "./convert.js";
import { isTable } from "./cut.js";
import { Faults, placedFaults } from "./faults.js";
import { Grid } from "./grid.js";
import {
  CELLS,
  COLUMNS,
  emptyCells,
  fromWire,
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
import { readPasted, withBlock, withPasted } from "./paste.js";
import { isCode } from "./toolbox-code.js";

/** @typedef {import("./model.js").CellName} CellName */
/** @typedef {import("./model.js").Table} Table */

export class DhTableEditor extends HTMLElement {
  #history = new UndoHistory(newTable("modified", 1));
  #grid = /** @type {Grid} */ (/** @type {unknown} */ (null));
  #bar = /** @type {Bar} */ (/** @type {unknown} */ (null));
  #faults = /** @type {Faults} */ (/** @type {unknown} */ (null));
  #lastInput = /** @type {HTMLInputElement | null} */ (null);
  /** The unit that was asked about. @type {"deg" | "rad" | null} */
  #doubted = null;
  /** @type {("standard" | "modified")[]} */
  #allowed = ["standard", "modified"];

  notice = el("div", { class: "editor-notice", role: "status" });

  connectedCallback() {
    if (this.#grid) return;
    this.id ||= uniqueId("table");
    this.#bar = new Bar(this.id, {
      undo: () => this.#step("undo"),
      redo: () => this.#step("redo"),
      paste: () => this.#openPaste(),
      clear: () => this.#clear(),
    });
    this.#faults = new Faults(this.id, (row, cell) => this.focusCell(row, cell));
    this.#grid = new Grid(this.id, {
      edit: (row, cell, text) => this.#edit(row, cell, text),
      joint: (row, joint) =>
        this.#change(setJoint(this.#table, row, /** @type {any} */ (joint)), { focus: [row, "joint"] }),
      move: (row, to) => this.#move(row, to),
      remove: (row) => this.#remove(row),
      settle: () => this.#settle(),
      paste: (event, row, cell) => this.#paste(event, row, cell),
      key: (event, row, cell) => this.#key(event, row, cell),
      focus: (input, row, cell) => {
        this.#lastInput = input;
        this.#announceCell("cell-focus", { row, cell });
      },
      play: (row) => this.#announceCell("row-play", { row }),
    });
    this.addEventListener("keydown", (event) => this.#undoKeys(event));
    const frame = el("div", { class: "dh-frame" }, this.#grid.element);
    const symbols = symbolBar(() => this.#lastInput);
    const foot = editorFoot(() => this.#add(this.#table.rows.length));
    fill(this, this.#bar.element, this.notice, this.#faults.summary, this.#faults.general, symbols, frame, foot);
    this.#show();
  }

  get #table() {
    return this.#history.state;
  }

  /** The table as it goes to the API. */
  get table() {
    return toWire(this.#table, { decimalComma: language !== "en" });
  }

  set table(wire) {
    this.load(wire);
    this.#tell();
  }

  /** Takes a table without telling of it, for a page that takes more than the table at once. @param {any} wire */
  load(wire) {
    this.#history.change(fromWire(wire));
    if (!this.#grid) return;
    this.#faults.clear();
    this.#say("");
    this.#show();
  }

  /** Everything that was typed, as plain data. */
  get state() {
    return structuredClone(this.#table);
  }

  set state(state) {
    const rows = state.rows.map((row) => ({ ...row, key: newRow(0, "fixed").key }));
    this.#history = new UndoHistory({ ...state, rows });
    if (!this.#grid) return;
    this.#faults.clear();
    this.#say("");
    this.#show();
  }

  /** Conventions that may be chosen. */
  get allowed() {
    return this.#allowed;
  }

  set allowed(allowed) {
    this.#allowed = allowed;
    if (!allowed.includes(this.#table.convention))
      this.#history = new UndoHistory({ ...this.#table, convention: allowed[0] });
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
   * Shows what the service says of the table as it stands, at its cells.
   * @param {import("../api.js").Fault[]} faults with pointers such as /table/rows/2/alpha
   */
  showFaults(faults) {
    this.#faults.read(placedFaults(faults));
    this.#placeFaults();
  }

  /**
   * Shows what a table was refused for, with a summary that leads to each cell; cells that were typed into since
   * are left out. The summary takes the focus, unless somebody goes on typing.
   * @param {import("../api.js").Fault[]} faults @param {any} [table] that was refused; the present one, if left out
   * @returns {boolean} whether anything is left to show
   */
  showRefusal(faults, table = this.table) {
    const present = this.table;
    const sameRows =
      JSON.stringify({ ...table, rows: table.rows.length }) ===
      JSON.stringify({ ...present, rows: present.rows.length });
    const at = (/** @type {any} */ rows, /** @type {number} */ row, /** @type {string} */ cell) => rows[row]?.[cell];
    const stands = (/** @type {import("./faults.js").PlacedFault} */ { row, cell }) =>
      sameRows && (row < 0 || at(table.rows, row, cell) === at(present.rows, row, cell));
    const placed = placedFaults(faults).filter(stands);
    this.#refuse(placed);
    if (placed.length === 0) return false;
    if (JSON.stringify(table) === JSON.stringify(present)) this.#faults.summary.focus();
    else announce(`${this.#faults.title.textContent} ${placed[0].text}`);
    return true;
  }

  /** @param {number} row @param {CellName | "joint"} cell */
  focusCell(row, cell) {
    const input = this.#grid.at(row, /** @type {CellName} */ (cell))?.input;
    input?.focus();
    if (input instanceof HTMLInputElement) input.select();
  }

  /** @param {[number, any] | null} [focus] where the focus goes; otherwise it stays where it is, or in its place */
  #show(focus = null) {
    const before = this.#focused();
    this.#grid.show(this.#table);
    this.#showBar();
    this.#placeFaults();
    const kept = focus ?? (this.#grid.element.contains(document.activeElement) ? null : before);
    if (kept) this.#grid.at(kept[0], kept[1])?.input.focus({ preventScroll: false });
  }

  #focused() {
    const active = document.activeElement;
    for (const [key, { input }] of this.#grid.cells) {
      if (input === active) return /** @type {[number, any]} */ ([Number(key.split("/")[0]), key.split("/")[1]]);
    }
    return null;
  }

  /** @param {Table} table @param {{focus?: [number, any] | null}} [options] */
  #change(table, { focus = null } = {}) {
    if (table === this.#table) return;
    this.#history.change(table);
    this.#forgetFaults();
    this.#say("");
    this.#show(focus);
    this.#tell();
  }

  /** The focus does not vanish with a summary that it is in. */
  #forgetFaults() {
    const inside = this.#faults.summary.contains(document.activeElement);
    this.#faults.clear();
    if (inside) this.focusCell(0, COLUMNS[this.#table.convention][0]);
  }

  /** @param {number} row @param {CellName} cell @param {string} text */
  #edit(row, cell, text) {
    this.#history.change(setCell(this.#table, row, cell, text), `${row}/${cell}`);
    this.#faults.forget(row, cell);
    this.#grid.showFault(row, cell, "");
    this.#showUndo();
    this.#tell();
  }

  /** @param {string} name @param {{row: number, cell?: CellName}} detail */
  #announceCell(name, detail) {
    this.dispatchEvent(new CustomEvent(name, { detail, bubbles: true }));
  }

  /** Marks the cell that the picture shows; none, if there is no row. @param {number} row @param {string} [cell] */
  light(row, cell = "") {
    this.#grid.light(row, cell);
  }

  #tell() {
    this.dispatchEvent(
      new CustomEvent("table-change", { detail: { table: this.table, complete: this.complete }, bubbles: true }),
    );
  }

  #settle() {
    this.#history.settle();
    this.#doubt();
    setTimeout(() => this.#placeFaults());
  }

  /** Asks once, before anything is handed in, whether angles are meant in the unit that they are read in. */
  #doubt() {
    const doubtful = doubtfulAngle(this.#table);
    if (!doubtful || this.#doubted === doubtful.unit) return;
    this.#doubted = doubtful.unit;
    const change = () => {
      this.#change({ ...this.#table, angleUnit: doubtful.unit });
      this.#say(t(`form-unit-now-${doubtful.unit}`));
    };
    const button = el("button", { type: "button", text: t(`form-unit-read-${doubtful.unit}`), onclick: change });
    this.#say(t(`form-unit-doubt-${doubtful.unit}`, { value: doubtful.text }), [button]);
  }

  /** A fault in the cell that is being typed into waits until the cell is left, or the table handed in. */
  #placeFaults() {
    if (!this.#grid) return;
    for (const [key, { input }] of this.#grid.cells) {
      const [row, cell] = [Number(key.split("/")[0]), key.split("/")[1]];
      const text = this.#faults.at(row, cell);
      const typing = input === document.activeElement && input.tagName === "INPUT";
      if (text && typing && !this.#faults.isRefused(row, cell)) continue;
      this.#grid.showFault(row, /** @type {any} */ (cell), text);
    }
    this.#faults.showGeneral((row, cell) => Boolean(this.#grid.at(row, /** @type {any} */ (cell))));
  }

  /** Says which cells are empty, and what is known to be wrong with others, with links to all of them. */
  showMissing() {
    const empty = this.missing.map(({ row, cell }) => ({ row, cell, text: t("form-cell-empty") }));
    const columns = COLUMNS[this.#table.convention];
    const place = (/** @type {any} */ { row, cell }) => row * columns.length + columns.indexOf(cell);
    const known = this.#faults.known.filter(({ row }) => row >= 0);
    this.#refuse([...empty, ...known].sort((one, other) => place(one) - place(other)));
    this.#faults.summary.focus();
  }

  /** @param {import("./faults.js").PlacedFault[]} faults */
  #refuse(faults) {
    this.#faults.refuse(faults, this.#table);
    this.#placeFaults();
  }

  #showBar() {
    this.#bar.show(this.#table, this.#allowed, {
      convention: (value) => this.#setConvention(/** @type {any} */ (value)),
      angleUnit: (value) => this.#setAngleUnit(/** @type {any} */ (value)),
      lengthUnit: (value) => this.#setLengthUnit(/** @type {any} */ (value)),
    });
    this.#showUndo();
  }

  #showUndo() {
    this.#bar.enable(this.#history.canUndo, this.#history.canRedo);
  }

  /** @param {number} at */
  #add(at) {
    this.#change(insertRow(this.#table, at), { focus: [at, COLUMNS[this.#table.convention][0]] });
    announce(t("form-row-added", { row: at + 1 }));
  }

  /** @param {number} row */
  #remove(row) {
    if (this.#table.rows.length <= 1) return;
    const next = Math.min(row, this.#table.rows.length - 2);
    this.#change(removeRow(this.#table, row), { focus: [next, COLUMNS[this.#table.convention][0]] });
    announce(t("form-row-removed", { row: row + 1 }));
  }

  /** @param {number} row @param {number} to @param {CellName | null} [cell] */
  #move(row, to, cell = null) {
    if (to < 0 || to >= this.#table.rows.length) return;
    this.#change(moveRow(this.#table, row, to), cell ? { focus: [to, cell] } : {});
    if (!cell) {
      const label = to < row ? t("form-row-up", { row: to + 1 }) : t("form-row-down", { row: to + 1 });
      /** @type {HTMLElement} */ (this.querySelector(`[aria-label="${CSS.escape(label)}"]`))?.focus();
    }
    announce(t("form-row-moved", { row: row + 1, to: to + 1 }));
  }

  /** @param {"undo" | "redo"} direction */
  #step(direction) {
    if (!this.#history[direction]()) return;
    this.#forgetFaults();
    this.#show();
    this.#say("");
    announce(t(direction === "undo" ? "form-undone" : "form-redone"));
    this.#tell();
  }

  /** @param {Table["convention"]} convention */
  #setConvention(convention) {
    if (convention === this.#table.convention) return;
    this.#change({ ...this.#table, convention });
    this.#say(t(`form-convention-now-${convention}`));
  }

  /** @param {any} unit */
  #setAngleUnit(unit) {
    const before = this.#table;
    if (unit === before.angleUnit) return;
    this.#change({ ...before, angleUnit: unit });
    if (!holdsNumbers(before, ["alpha", "theta"])) return;
    this.#offer(t(unit === "deg" ? "form-unit-now-deg" : "form-unit-now-rad"), () =>
      convertedAngles(this.#table, unit),
    );
  }

  /** @param {any} unit */
  #setLengthUnit(unit) {
    const before = this.#table;
    if (unit === before.lengthUnit) return;
    this.#change({ ...before, lengthUnit: unit });
    if (!holdsNumbers(before, ["a", "d"])) return;
    this.#offer(t("form-unit-now-length", { unit }), () => convertedLengths(this.#table, before.lengthUnit, unit));
  }

  /** Says that numbers mean something else now, and offers to write them in the new unit. @param {string} text @param {any} converted */
  #offer(text, converted) {
    const convert = () => {
      const { table, left } = converted();
      this.#change(table);
      this.#say(convertedText(left));
    };
    this.#say(text, [el("button", { type: "button", text: t("form-unit-convert"), onclick: convert })]);
  }

  /** Says what became of the table, with a way back; nothing, if there is no text. @param {string} text @param {any} [actions] */
  #say(text, actions = []) {
    const inside = this.notice.contains(document.activeElement);
    const undo = el("button", {
      type: "button",
      class: "quiet",
      text: t("form-undo"),
      onclick: () => this.#step("undo"),
    });
    fill(
      this.notice,
      text ? el("div", { class: "notice row" }, el("span", { class: "grow", text }), actions, undo) : null,
    );
    if (inside) (text ? undo : this.#bar.undo).focus();
  }

  /** @param {any} event */
  #undoKeys(event) {
    if (event.target.closest("dialog")) return; // a text that is pasted there has the browser's own undo
    const direction = stepAsked(event);
    if (!direction) return;
    event.preventDefault();
    this.#step(direction);
  }

  /** @param {any} event @param {number} row @param {CellName} cell */
  #key(event, row, cell) {
    if (event.isComposing) return;
    const last = this.#table.rows.length - 1;
    /** @param {number} to */
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

  /** A new table in the same convention and units, with a way back. */
  #clear() {
    const { convention, angleUnit, lengthUnit } = this.#table;
    this.#change(newTable(convention, 1, { angleUnit, lengthUnit }), { focus: [0, COLUMNS[convention][0]] });
    this.#say(t("form-new-done"));
  }

  async #openPaste() {
    const { askForTable } = await import("./paste-dialog.js");
    const order = COLUMNS[this.#table.convention];
    askForTable(this, order, this.#table.convention, (pasted) => this.#take(pasted, 0, true));
  }

  /** @param {any} event @param {number} row @param {CellName} cell */
  #paste(event, row, cell) {
    const text = event.clipboardData?.getData("text/plain") ?? "";
    if (!isTable(text) && !isCode(text)) return;
    const pasted = readPasted(text, COLUMNS[this.#table.convention]);
    const table = pasted ? null : withBlock(this.#table, text, row, cell);
    if (!pasted && !table) return;
    event.preventDefault();
    if (table) this.#change(table, { focus: [row, cell] });
    else if (pasted) this.#take(pasted, row, row === 0 && pasted.rows.length >= this.#table.rows.length);
  }

  /** @param {import("./paste.js").Pasted} pasted @param {number} at @param {any} replace */
  #take(pasted, at, replace) {
    const before = this.#table;
    const { table: next, left } = withPasted(before, pasted, at, replace, this.#allowed);
    this.#change(next, { focus: [at, COLUMNS[next.convention][0]] });
    const said = [
      t("form-pasted", { rows: pasted.rows.length }),
      next.convention !== before.convention && t(`form-convention-now-${next.convention}`),
      next.angleUnit !== before.angleUnit && t(`form-unit-now-${next.angleUnit}`),
      next.lengthUnit !== before.lengthUnit && t("form-unit-now-length", { unit: next.lengthUnit }),
      left !== null && convertedText(left),
    ];
    this.#say(said.filter(Boolean).join(" "));
  }
}

/** @param {number} left cells that could not be converted */
function convertedText(left) {
  return left ? t("form-unit-converted-but", { count: left }) : t("form-unit-converted");
}

customElements.define("dh-table-editor", DhTableEditor);
