/** A table to read, scrolled by keyboard where it is wide. */

import { el } from "./dom.js";

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
