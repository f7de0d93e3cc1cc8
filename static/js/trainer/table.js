/** The table that follows from the frames, row by row as they become complete. */

import { el } from "../dom.js";
import { t } from "../i18n.js";
import { shown } from "../numbers.js";

const COLUMNS = { modified: ["alpha", "a", "d", "theta"], standard: ["theta", "d", "a", "alpha"] };
const LETTERS = { alpha: "α", a: "a", d: "d", theta: "θ" };

/** @param {{rows: any[]}} judged @param {"standard" | "modified"} convention */
export function tableView({ rows }, convention) {
  const columns = COLUMNS[convention];
  const caption = t("form-table-caption", { convention: t(`form-convention-${convention}`) });
  const previous = (name) => convention === "modified" && (name === "alpha" || name === "a");
  return el(
    "div",
    { class: "scroller", tabindex: "0", role: "region", "aria-label": caption },
    el(
      "table",
      { class: "solutions" },
      el("caption", { class: "visually-hidden", text: caption }),
      el("thead", {}, el("tr", {}, el("th", { scope: "col", text: "i" }), columns.map((name) => el("th", { scope: "col" }, symbol(LETTERS[name], previous(name)))))),
      el(
        "tbody",
        {},
        rows.map((row, i) =>
          el("tr", {}, el("th", { scope: "row", text: String(i + 1) }), columns.map((name) => el("td", { text: row ? cell(row[name]) : "·" }))),
        ),
      ),
    ),
  );
}

function symbol(letter, previous) {
  return [el("i", { text: letter }), el("sub", { text: previous ? "i−1" : "i" })];
}

const cell = (value) => (typeof value === "number" ? shown(value) : String(value).replace("-", "−"));
