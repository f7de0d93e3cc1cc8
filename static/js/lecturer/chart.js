/** A bar chart with its table beside it: the table is what screen readers and small screens read. */

import { el, svg } from "../dom.js";

const WIDTH = 640;
const ROW = 24;
const LABEL = 200;

/**
 * Horizontal bars, each with a part of it filled.
 * @param {{label: string, all: number, part?: number}[]} bars
 * @param {string} title what the chart shows
 */
export function barChart(bars, title) {
  const most = Math.max(1, ...bars.map(({ all }) => all));
  const length = (/** @type {number} */ count) => ((WIDTH - LABEL - 50) * count) / most;
  return svg(
    "svg",
    { class: "bars", viewBox: `0 0 ${WIDTH} ${Math.max(1, bars.length) * ROW}`, role: "img", "aria-label": title },
    bars.map(({ label, all, part }, i) => {
      const y = i * ROW;
      return svg(
        "g",
        {},
        svg(
          "text",
          { x: LABEL - 8, y: y + 16, "text-anchor": "end" },
          label.length > 28 ? `${label.slice(0, 27)}…` : label,
        ),
        svg("rect", { class: "bar-all", x: LABEL, y: y + 4, width: length(all), height: ROW - 8, rx: 2 }),
        part === undefined
          ? null
          : svg("rect", { class: "bar-part", x: LABEL, y: y + 4, width: length(part), height: ROW - 8, rx: 2 }),
        svg("text", { x: LABEL + length(all) + 6, y: y + 16 }, part === undefined ? String(all) : `${part} / ${all}`),
      );
    }),
  );
}

/**
 * @param {string} caption @param {string[]} headings
 * @param {(string | number | Node | null)[][]} rows the first cell heads its row
 */
export function dataTable(caption, headings, rows) {
  return el(
    "div",
    { class: "scroller", tabindex: "0", role: "group", "aria-label": caption },
    el(
      "table",
      { class: "data" },
      el("caption", { class: "visually-hidden", text: caption }),
      el(
        "thead",
        {},
        el(
          "tr",
          {},
          headings.map((text) => el("th", { scope: "col", text })),
        ),
      ),
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
