/** A table to read, scrolled by keyboard where it is wide. */

import { arrange, el, fill } from "./dom.js";

/** @typedef {import("./dom.js").Child} Cell */

/**
 * @param {string} caption
 * @param {Cell[]} headings
 * @param {Cell[][]} rows the first cell heads its row
 * @param {{ kind?: string, captioned?: boolean }} [options] a class of its own; whether the caption is for all to see
 */
export function dataTable(caption, headings, rows, { kind = "", captioned = false } = {}) {
  return el(
    "div",
    { class: "scroller", tabindex: "0", role: "group", "aria-label": caption },
    el(
      "table",
      { class: `data ${kind}`.trim() },
      el("caption", { class: captioned ? null : "visually-hidden", text: caption }),
      columnHeads(headings),
      el(
        "tbody",
        {},
        rows.map(([first, ...others]) =>
          el(
            "tr",
            {},
            el("th", { scope: "row" }, first),
            others.map((cell) => el("td", {}, cell)),
          ),
        ),
      ),
    ),
  );
}

/**
 * A table whose rows stay the same elements while what they say changes: the focus stays, and so does what is being typed.
 * @template Entry
 */
export class LiveTable {
  /** @type {Map<string | number, {row: HTMLElement, cells: (entry: Entry) => Cell[]}>} */
  #lines = new Map();
  #body = el("tbody");

  /**
   * @param {string} caption @param {Cell[]} headings @param {(entry: Entry) => string | number} keyOf
   * @param {() => (entry: Entry) => Cell[]} line makes a row: what its cells hold, texts or elements that stay
   * @param {HTMLElement} refuge takes the focus when all rows are gone
   */
  constructor(caption, headings, keyOf, line, refuge) {
    this.keyOf = keyOf;
    this.line = line;
    this.refuge = refuge;
    this.element = dataTable(caption, headings, []);
    this.#table.replaceChild(this.#body, /** @type {Element} */ (this.#table.lastElementChild));
  }

  get #table() {
    return /** @type {HTMLTableElement} */ (this.element.firstElementChild);
  }

  /** @param {Cell[]} headings */
  set headings(headings) {
    const [, head] = this.#table.children;
    this.#table.replaceChild(columnHeads(headings), head);
  }

  /** @param {Entry[]} entries */
  show(entries) {
    const within = this.element.contains(document.activeElement);
    const lines = entries.map((entry) => {
      const line = this.#lines.get(this.keyOf(entry)) ?? { row: el("tr"), cells: this.line() };
      place(line.row, line.cells(entry));
      return line;
    });
    this.#lines = new Map(lines.map((line, i) => [this.keyOf(entries[i]), line]));
    arrange(
      this.#body,
      lines.map(({ row }) => row),
    );
    this.element.hidden = entries.length === 0;
    if (within && !(entries.length && this.element.contains(document.activeElement)))
      (entries.length ? this.element : this.refuge).focus();
  }
}

/** Brings a row to hold these; what it holds already stays. @param {HTMLElement} row @param {Cell[]} cells */
function place(row, cells) {
  cells.forEach((cell, i) => {
    const box = row.children[i] ?? row.appendChild(i ? el("td") : el("th", { scope: "row" }));
    const element = typeof cell === "object";
    if (element ? box.firstChild !== cell : box.textContent !== String(cell)) fill(box, cell);
  });
  for (const box of [...row.children].slice(cells.length)) box.remove();
}

/** Buttons by name, each of which stays the same element, whatever it says and does now. */
export function liveButtons() {
  /** @typedef {{button: HTMLButtonElement, run: () => void}} Live */
  /** @type {Map<string | number, Live>} */
  const all = new Map();
  /**
   * @param {string | number} name @param {string} text @param {() => void} run
   * @param {{kind?: string, label?: string}} [options] its class, and what it is read as
   */
  return (name, text, run, { kind = "quiet small", label = "" } = {}) => {
    /** @type {Live} */
    const found = all.get(name) ?? { run, button: el("button", { type: "button", onclick: () => found.run() }) };
    all.set(name, found);
    found.run = run;
    found.button.textContent = text;
    found.button.className = kind;
    if (label) found.button.setAttribute("aria-label", label);
    return found.button;
  };
}

/** @param {Cell[]} headings */
export function columnHeads(headings) {
  return el(
    "thead",
    {},
    el(
      "tr",
      {},
      headings.map((heading) => el("th", { scope: "col" }, heading)),
    ),
  );
}
