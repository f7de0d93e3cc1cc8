/** A dialog that takes a whole table as text, for keyboards and phones that cannot paste into cells. */

import { dataTable } from "../data-table.js";
import { el, fill, showDialog, uniqueId, VERBATIM } from "../dom.js";
import { t } from "../i18n.js";
import { columnText } from "./grid.js";
import { readPasted } from "./paste.js";

/**
 * Asks for a table; calls back with what was read.
 * @param {HTMLElement} parent @param {import("./model.js").CellName[]} order @param {string} convention
 * @param {(pasted: import("./paste.js").Pasted) => void} take
 */
export function askForTable(parent, order, convention, take) {
  const area = uniqueId("paste");
  const title = uniqueId("paste-title");
  const preview = el("div", { class: "paste-preview", role: "status" });
  const text = /** @type {HTMLTextAreaElement} */ (
    el("textarea", { id: area, rows: 8, ...VERBATIM, oninput: () => show() })
  );
  /** @param {any} event */
  const use = (event) => {
    event.preventDefault();
    dialog.close();
    if (pasted) take(pasted);
  };
  const apply = el("button", { type: "submit", class: "primary", onclick: use, text: t("form-paste-apply") });
  /** @type {import("./paste.js").Pasted | null} */
  let pasted = null;
  const show = () => {
    pasted = text.value.trim() ? readPasted(text.value, order) : null;
    apply.disabled = !pasted;
    fill(
      preview,
      pasted
        ? previewOf(pasted, order, pasted.convention ?? convention)
        : text.value.trim()
          ? el("p", { class: "fault", text: t("form-paste-nothing") })
          : null,
    );
  };
  const dialog = /** @type {HTMLDialogElement} */ (
    el(
      "dialog",
      { class: "dialog", "aria-labelledby": title, onclose: () => dialog.remove() },
      el(
        "form",
        { method: "dialog", class: "stack" },
        el("h2", { id: title, text: t("form-paste-title") }),
        el("div", { class: "field" }, el("label", { for: area, text: t("form-paste-label") }), text),
        el("p", {
          class: "hint",
          text: t("form-paste-order", { order: order.map((cell) => columnText(cell, convention)).join("  ") }),
        }),
        preview,
        el(
          "div",
          { class: "row" },
          apply,
          el("button", { type: "button", onclick: () => dialog.close(), text: t("form-cancel") }),
        ),
      ),
    )
  );
  show();
  showDialog(dialog, parent);
  text.focus();
}

/** @param {any} pasted @param {any} order @param {string} convention */
function previewOf(pasted, order, convention) {
  return [
    el("p", { class: "hint", text: t("form-paste-found", { rows: pasted.rows.length }) }),
    dataTable(
      t("form-paste-preview"),
      [t("form-row-heading"), ...order.map((/** @type {any} */ cell) => columnText(cell, convention))],
      pasted.rows.map((/** @type {any} */ row, /** @type {number} */ i) => [
        i + 1,
        ...order.map((/** @type {any} */ cell) => row.cells[cell] ?? ""),
      ]),
      { kind: "mono" },
    ),
  ];
}
