/** What stands above and below the table: convention, units, undo, paste; a new row, symbols, keys. */

import { el, fill, iconButton, segmented, setAble } from "../dom.js";
import { t } from "../i18n.js";
import { pageAddress } from "../page.js";

const SYMBOLS = ["θ", "π", "√", "°", "−", "/"];
const LENGTHS = ["m", "cm", "mm", "in"];

export class Bar {
  /** @param {string} id of the editor @param {{undo: () => void, redo: () => void, paste: () => void, clear: () => void}} actions */
  constructor(id, actions) {
    this.id = id;
    this.offered = "";
    /** @type {HTMLSelectElement} */
    this.length = el("select");
    this.undo = iconButton("undo", t("form-undo"), actions.undo);
    this.redo = iconButton("redo", t("form-redo"), actions.redo);
    const paste = iconButton("paste", t("form-paste-title"), actions.paste);
    this.choices = el("div", { class: "row" });
    this.element = el(
      "div",
      { class: "editor-bar" },
      this.choices,
      el(
        "div",
        { class: "editor-steps no-print" },
        el("button", { type: "button", class: "quiet small", onclick: actions.clear, text: t("form-new") }),
        this.undo,
        this.redo,
        paste,
      ),
    );
  }

  /**
   * @param {import("./model.js").Table} table @param {string[]} allowed conventions
   * @param {{convention: (value: string) => void, angleUnit: (value: string) => void, lengthUnit: (value: string) => void}} set
   */
  show(table, allowed, set) {
    const offered = allowed.join();
    if (offered !== this.offered) this.#build(allowed, set);
    this.offered = offered;
    for (const [stem, value] of [
      ["convention", table.convention],
      ["angle-unit", table.angleUnit],
    ]) {
      const choice = /** @type {HTMLInputElement | null} */ (
        this.choices.querySelector(`[name="${this.id}-${stem}"][value="${value}"]`)
      );
      if (choice) choice.checked = true;
    }
    this.length.value = table.lengthUnit;
  }

  /** @param {boolean} undo @param {boolean} redo whether there is something to take back or do again */
  enable(undo, redo) {
    setAble(this.undo, undo);
    setAble(this.redo, redo);
  }

  /** @param {any} allowed @param {any} set */
  #build(allowed, set) {
    const conventions = allowed.map((/** @type {any} */ value) => ({ value, label: t(`form-convention-${value}`) }));
    const angles = [
      { value: "deg", label: t("form-degrees") },
      { value: "rad", label: t("form-radians") },
    ];
    this.length = /** @type {HTMLSelectElement} */ (
      el(
        "select",
        {
          name: `${this.id}-length-unit`,
          class: "editor-length no-print",
          "aria-label": t("form-length-unit"),
          onchange: (event) => set.lengthUnit(event.target.value),
        },
        LENGTHS.map((unit) => el("option", { value: unit, text: unit })),
      )
    );
    fill(
      this.choices,
      this.#choice("convention", t("form-convention"), conventions, set.convention),
      el("a", {
        class: "term small no-print",
        href: `${pageAddress("lesson")}#conventions`,
        text: t("form-convention-what"),
      }),
      this.#choice("angle-unit", t("form-angle-unit"), angles, set.angleUnit),
      this.length,
    );
  }

  /** @param {string} stem @param {string} label @param {any} options @param {any} onchange */
  #choice(stem, label, options, onchange) {
    return segmented({ name: `${this.id}-${stem}`, label, value: "", options, onchange });
  }
}

/** The row of symbols for fields. @param {() => HTMLInputElement | null} lastInput the field that symbols go into */
export function symbolBar(lastInput) {
  const insert = (/** @type {string} */ symbol) => {
    const input = lastInput();
    if (!input?.isConnected) return;
    input.focus();
    const text = symbol === "√" ? "sqrt()" : symbol;
    input.setRangeText(text, input.selectionStart ?? 0, input.selectionEnd ?? 0, "end");
    const inside = (input.selectionEnd ?? 1) - 1;
    if (symbol === "√") input.setSelectionRange(inside, inside);
    input.dispatchEvent(new Event("input", { bubbles: true }));
  };
  const button = (/** @type {string} */ symbol) =>
    el("button", {
      type: "button",
      class: "quiet symbol",
      "aria-label": t("form-symbol-insert", { symbol }),
      // The field keeps the focus, so that a phone's keyboard stays open.
      onpointerdown: (event) => event.preventDefault(),
      onclick: () => insert(symbol),
      text: symbol,
    });
  return el("div", { class: "symbols no-print", role: "group", "aria-label": t("form-symbols") }, SYMBOLS.map(button));
}

/** @param {() => void} add */
export function editorFoot(add) {
  return el(
    "div",
    { class: "editor-foot no-print" },
    el("button", { type: "button", class: "add-row", onclick: add }, "+ ", t("form-row-add")),
    el("p", { class: "hint keys", text: t("form-keys") }),
  );
}
