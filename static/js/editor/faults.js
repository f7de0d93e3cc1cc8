/** Faults of the API, tied to cells: beneath each cell, and in a summary that leads to them. */

import { el } from "../dom.js";
import { t } from "../i18n.js";
import { columnText } from "./grid.js";

/** @typedef {{row: number, cell: string, text: string}} PlacedFault row -1 is the table as a whole */

/** @param {import("../api.js").Fault[]} faults @returns {PlacedFault[]} */
export function placedFaults(faults) {
  return faults.map((fault) => {
    const match = /\/rows\/(\d+)(?:\/(\w+))?$/.exec(fault.pointer ?? "");
    return { row: match ? Number(match[1]) : -1, cell: match?.[2] ?? "joint", text: fault.detail };
  });
}

/**
 * A list of faults with links to their cells.
 * @param {PlacedFault[]} faults @param {string} id of the editor @param {string} convention
 * @param {(row: number, cell: any) => void} go
 */
export function faultSummary(faults, id, convention, go) {
  const line = ({ row, cell, text }) => {
    if (row < 0) return el("li", { text });
    const name = cell === "joint" ? t("form-joint") : columnText(/** @type {any} */ (cell), convention);
    const follow = (event) => {
      event.preventDefault();
      go(row, cell);
    };
    const place = t("form-row-cell", { row: row + 1, name });
    return el("li", {}, el("a", { href: `#${id}-${row}-${cell}`, onclick: follow, text: `${place}: ${text}` }));
  };
  return el(
    "div",
    { class: "notice notice-problem", role: "alert" },
    el("p", {}, el("strong", { text: t("form-faults", { count: faults.length }) })),
    el("ul", {}, faults.map(line)),
  );
}
