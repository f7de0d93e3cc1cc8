/** Bars of a class's numbers, and the table that stands beside them: what screen readers and small screens read. */

import { drawing } from "../plots.js";

const ROW = 26;
const MOST_BARS = 40;
const LABEL = 0.38;
const CHARACTER = 6.6;

/**
 * Horizontal bars, each with a part of it filled.
 * @param {{label: string, all: number, part?: number}[]} bars
 * @param {string} title what the chart shows
 * @returns {HTMLElement | null} null where there is nothing to draw
 */
export function barChart(bars, title) {
  const shown = bars.slice(0, MOST_BARS);
  if (!shown.length) return null;
  const rows = shown.map((bar, i) => ({ ...bar, i }));
  const most = Math.max(1, ...rows.map(({ all }) => all));
  const longest = Math.max(...rows.map(({ label }) => label.length));
  const chart = drawing(title, (plot, width) => {
    const margin = Math.min(Math.ceil(longest * CHARACTER) + 16, Math.floor(width * LABEL));
    const room = Math.max(4, Math.floor((margin - 16) / CHARACTER));
    const cut = (/** @type {string} */ text) => (text.length > room ? `${text.slice(0, room - 1)}…` : text);
    return {
      height: rows.length * ROW + 12,
      marginTop: 4,
      marginBottom: 8,
      marginLeft: margin,
      marginRight: 64,
      x: { axis: null, domain: [0, most] },
      y: { label: null, tickSize: 0, padding: 0.3, tickFormat: (/** @type {number} */ i) => cut(rows[i].label) },
      marks: [
        plot.barX(rows, { x: "all", y: "i", fill: "var(--line-strong)" }),
        plot.barX(
          rows.filter(({ part }) => part !== undefined),
          { x: "part", y: "i", fill: "var(--curve-1)" },
        ),
        plot.text(rows, {
          x: "all",
          y: "i",
          dx: 6,
          textAnchor: "start",
          fill: "currentColor",
          text: (/** @type {any} */ { all, part }) => (part === undefined ? String(all) : `${part} / ${all}`),
        }),
        plot.ruleX([0], { stroke: "currentColor" }),
      ],
    };
  });
  chart.classList.add("bars");
  chart.style.minHeight = `${rows.length * ROW + 12}px`;
  return chart;
}
