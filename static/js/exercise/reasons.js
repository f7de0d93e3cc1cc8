/** After a right answer: why each row is right, from how its two z axes lie, and a second valid table to compare. */

import { el, fill } from "../dom.js";
import { rowsTable } from "../editor/rows-table.js";
import { t } from "../i18n.js";

/** @typedef {import("../understanding.js").ReadRow} ReadRow */

const CLOSE = 1e-9;

/** How the z axes of frames i−1 and i lie relative to each other. @param {ReadRow} row @param {number} size of the robot */
function relationOf({ values }, size) {
  const [s, c] = [Math.sin(values.alpha ?? 0), Math.cos(values.alpha ?? 0)];
  const near = Math.abs(values.a ?? 0) < CLOSE * size;
  if (Math.abs(s) < CLOSE) return near ? "coincident" : "parallel";
  return `${near ? "intersecting" : "skew"}-${Math.abs(c) < CLOSE ? "perpendicular" : "oblique"}`;
}

/** @param {ReadRow[]} rows of the accepted table @param {any} table as it was handed in @param {number} size of the robot */
export function reasonsList(rows, table, size) {
  const item = (/** @type {ReadRow} */ row, /** @type {number} */ i) => {
    const { alpha, a, d } = table.rows[i];
    const relation = t(`form-relation-${relationOf(row, size)}`);
    return el("li", {
      text: t("form-why-row", { row: i + 1, before: i, relation, alpha: String(alpha), a: String(a), d: String(d) }),
    });
  };
  return el("details", { class: "reasons" }, el("summary", { text: t("form-why") }), el("ul", {}, rows.map(item)));
}

/**
 * Another table of the same robot under the exercise's rules, fetched when it is looked at.
 * @param {import("../api.js").Api} api @param {any} table that was accepted @param {any} policy of the exercise
 * @param {Record<string, number>} parameters values of the table's parameters
 */
export function secondTable(api, table, policy, parameters) {
  const place = el("div");
  const load = async (/** @type {any} */ event) => {
    if (!event.target.open || place.hasChildNodes()) return;
    const found = await api.post("other-tables", { table, policy, parameters }).catch(() => null);
    const other = found?.tables[0];
    const missing = t(found ? "form-second-none" : "form-unreachable");
    fill(place, other ? [differences(other), rowsTable(other.table)] : el("p", { class: "hint", text: missing }));
  };
  return el("details", { class: "reasons", ontoggle: load }, el("summary", { text: t("form-second-table") }), place);
}

/** @param {any} other */
function differences({ table, reasons }) {
  const convention = t(`form-convention-${table.convention}`);
  const said = reasons.map((/** @type {string} */ reason) =>
    t(`form-second-${reason.replaceAll("_", "-")}`, { convention }),
  );
  return el("p", { class: "hint", text: said.join(" ") });
}
