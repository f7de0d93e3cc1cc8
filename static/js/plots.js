/**
 * Plots by Observable Plot, loaded when the first one is wanted, each with the same numbers as a table beside it.
 *
 * Plot writes a style sheet into each drawing, which the content security policy refuses; its few rules stand in
 * plots.css, and the element is taken out before the drawing enters the page.
 */

import { dataTable } from "./data-table.js";
import { el, fill } from "./dom.js";
import { t } from "./i18n.js";
import { loadedOnce } from "./page.js";

const ROWS_AT_MOST = 200;

/**
 * @typedef {{caption: string, head: string[], rows: (string | number)[][]}} Numbers what a plot shows, as a table
 * @typedef {typeof import("../vendor/plot/plot.js")} Plot
 */

const library = loadedOnce(() => import("../vendor/plot/plot.js"), "css/plots.css");

/**
 * A drawing as wide as its place, and drawn again when its width changes. The same numbers stand in a table beside it.
 * @param {string} label what the plot shows, for those who do not see it
 * @param {(plot: Plot, width: number) => import("@observablehq/plot").PlotOptions} options at a width [px]
 * @returns {HTMLElement}
 */
export function drawing(label, options) {
  const place = el("div", { class: "plot-drawing" });
  let drawn = 0;
  const draw = async () => {
    const width = Math.floor(place.clientWidth);
    if (!width || width === drawn) return;
    drawn = width;
    const plot = await library();
    const shape = plot.plot({ className: "plot", width, ...options(plot, width) });
    for (const style of shape.querySelectorAll("style")) style.remove();
    // Inside of an image nothing is announced; its groups keep their names for the style sheet.
    for (const group of shape.querySelectorAll("g[aria-label]")) {
      group.setAttribute("data-mark", group.getAttribute("aria-label") ?? "");
      group.removeAttribute("aria-label");
    }
    const picture = shape.matches("svg") ? shape : shape.querySelector("svg");
    picture?.setAttribute("role", "img");
    picture?.setAttribute("aria-label", label);
    fill(place, shape);
  };
  new ResizeObserver(() => {
    draw().catch(() => fill(place, el("p", { class: "hint", text: t("form-unreachable") })));
  }).observe(place);
  return place;
}

/**
 * A drawing with its title, and its numbers to be unfolded.
 * @param {string} label what the plot shows
 * @param {(plot: Plot, width: number) => import("@observablehq/plot").PlotOptions} options at a width [px]
 * @param {Numbers} numbers
 * @returns {HTMLElement}
 */
export function figure(label, options, { caption, head, rows }) {
  return el(
    "figure",
    { class: "plot-figure" },
    el("figcaption", { text: label }),
    drawing(label, options),
    el(
      "details",
      {},
      el("summary", { text: t("playground-numbers") }),
      dataTable(caption, head, rows.slice(0, ROWS_AT_MOST), { kind: "plot-numbers" }),
    ),
  );
}

/** Colours of curves that stay apart for every kind of colour vision and on either ground; dashes tell them apart, too. */
export const CURVES = [1, 2, 3, 4, 5, 6, 7, 8].map((k) => `var(--curve-${k})`);
export const DASHES = ["none", "7 3", "2 3", "9 3 2 3", "12 4", "4 2 1 2", "1 4", "14 3 4 3"];
