/** A DH table to read. */

import { dataTable } from "../data-table.js";
import { t } from "../i18n.js";
import { shown } from "../numbers.js";
import { columnName } from "./grid.js";
import { COLUMNS } from "./model.js";

/** @param {string | number} cell */
const text = (cell) => (typeof cell === "number" ? shown(cell, 6) : String(cell).replaceAll("-", "−"));

/** @param {any} table */
export function rowsTable({ convention, rows }) {
  /** @type {("alpha" | "a" | "d" | "theta")[]} */
  const columns = COLUMNS[/** @type {"standard" | "modified"} */ (convention)];
  return dataTable(
    t("form-table-caption", { convention: t(`form-convention-${convention}`) }),
    [t("form-row-heading"), ...columns.map((name) => columnName(name, convention))],
    rows.map((/** @type {any} */ row, /** @type {number} */ i) => [i + 1, ...columns.map((name) => text(row[name]))]),
    { captioned: true },
  );
}
