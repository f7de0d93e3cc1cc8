/** A verdict as something to learn from: score, rows, reasons, repairs; never more than the API told. */

import { el, fill, icon } from "../dom.js";
import { t } from "../i18n.js";
import { columnText } from "../editor/grid.js";

const FACTS = ["twist", "length", "offset", "joint"];
const MARKS = { ok: "check", wrong: "cross", missing: "cross" };

/**
 * @param {any} verdict as the API gave it
 * @param {{convention: string, focusRow: (row: number, cell?: string) => void}} answer
 * @returns {HTMLElement}
 */
export function verdictView(verdict, { convention, focusRow }) {
  const score = Math.round(verdict.score * 100);
  return el(
    "div",
    { class: "stack" },
    el(
      "div",
      { class: `verdict-head ${verdict.correct ? "good" : score > 0 ? "partly" : "bad"}` },
      scoreRing(verdict.score),
      el(
        "div",
        {},
        el("p", { class: "verdict-word", text: t(verdict.correct ? "form-verdict-correct" : "form-verdict-wrong") }),
        el("p", { class: "hint", text: t(`form-basis-${verdict.basis}`) }),
      ),
    ),
    feedbackList(verdict.feedback ?? [], focusRow),
    verdict.links?.some(hasNews) ? linkTable(verdict.links, focusRow) : null,
    repairList(verdict.repairs ?? [], convention, focusRow),
  );
}

function hasNews(link) {
  return FACTS.some((fact) => link[fact] && link[fact] !== "hidden");
}

/** @param {number} score 0 … 1 */
function scoreRing(score) {
  const percent = Math.round(score * 100);
  const ring = el("div", { class: "score-ring", role: "img", "aria-label": t("form-score", { score: percent }) }, el("span", { text: `${percent} %` }));
  ring.style.setProperty("--score", `${percent}%`);
  return ring;
}

function rowLink(row, text, focusRow, cell) {
  return el("a", {
    href: `#row-${row}`,
    text,
    onclick: (event) => {
      event.preventDefault();
      focusRow(row - 1, cell);
    },
  });
}

function feedbackList(feedback, focusRow) {
  if (!feedback.length) return null;
  return el(
    "ul",
    { class: "feedback" },
    feedback.map(({ row, message, code }) =>
      el(
        "li",
        { dataset: { code } },
        row ? [rowLink(row, t("form-row", { row }), focusRow), ": "] : null,
        message,
      ),
    ),
  );
}

function linkTable(links, focusRow) {
  return el(
    "div",
    { class: "scroller", tabindex: "0", role: "region", "aria-label": t("form-links-caption") },
    el(
      "table",
      { class: "data links-table" },
      el("caption", { class: "visually-hidden", text: t("form-links-caption") }),
      el("thead", {}, el("tr", {}, el("th", { scope: "col", text: t("form-row-heading") }), FACTS.map((fact) => el("th", { scope: "col", text: t(`form-fact-${fact}`) })))),
      el(
        "tbody",
        {},
        links.map((link) =>
          el("tr", {}, el("th", { scope: "row" }, rowLink(link.row, String(link.row), focusRow)), FACTS.map((fact) => el("td", {}, finding(link[fact])))),
        ),
      ),
    ),
  );
}

/** @param {string} found */
function finding(found) {
  const tone = found === "ok" ? "good" : found === "wrong" || found === "missing" ? "bad" : "";
  return el("span", { class: `badge ${tone}` }, MARKS[found] ? icon(MARKS[found]) : null, t(`form-finding-${found}`));
}

function repairList(repairs, convention, focusRow) {
  if (!repairs.length) return null;
  const edit = ({ row, cell, message, code }) => {
    const name = cell && cell !== "joint" ? `, ${columnText(cell, convention)}` : "";
    return el(
      "li",
      { dataset: { code } },
      row ? [rowLink(row, t("form-row", { row }) + name, focusRow, cell), ": "] : null,
      message,
    );
  };
  return el(
    "div",
    {},
    el("h3", { text: t("form-repairs", { count: repairs.length }) }),
    repairs.map((repair, i) => [
      i > 0 ? el("p", { class: "hint", text: t("form-repair-or") }) : null,
      el("ul", { class: "feedback repairs" }, repair.edits.map(edit)),
    ]),
  );
}

/** A part beyond the table. @param {any} report @param {string} name @param {(where: (string | number)[]) => string} placeName */
export function partView(report, name, placeName) {
  const percent = Math.round(report.score * 100);
  const wrong = (report.facts ?? []).filter((fact) => fact.finding === "wrong" || fact.finding === "missing");
  return el(
    "section",
    { class: "part-report", "aria-label": name },
    el(
      "h3",
      {},
      name,
      " ",
      el("span", { class: `badge ${percent === 100 ? "good" : percent ? "warn" : "bad"}`, text: t("form-score", { score: percent }) }),
    ),
    feedbackList(report.feedback ?? [], () => {}),
    wrong.length ? el("p", { class: "hint" }, t("form-part-wrong"), " ", wrong.map((fact) => placeName(fact.where)).join(", ")) : null,
  );
}

/** @param {HTMLElement} place @param {...any} content */
export function showVerdict(place, ...content) {
  fill(place, ...content);
}
