/** A verdict as something to learn from: score, rows, reasons, repairs; never more than the API told. */

import { el, icon } from "../dom.js";
import { t } from "../i18n.js";
import { columnText } from "../editor/grid.js";
import { plain } from "../numbers.js";

const FACTS = ["twist", "length", "offset", "joint"];
/** @type {Record<string, "check" | "cross">} */
const MARKS = { ok: "check", wrong: "cross", missing: "cross" };

/**
 * What is said of the table, and of the answer as a whole.
 * @param {any} graded as the API gave it
 * @param {{convention: string, focusRow: ((row: number, cell?: string) => void) | null}} answer
 * @returns {HTMLElement}
 */
export function verdictView(graded, { convention, focusRow }) {
  const share = shareOf(graded);
  const tone = share >= 1 ? "good" : share > 0 ? "partly" : "bad";
  return el(
    "div",
    { class: "stack" },
    el(
      "div",
      { class: `verdict-head ${tone}` },
      scoreRing(share),
      el(
        "div",
        {},
        el("p", { class: "verdict-word", text: verdictWord(graded) }),
        graded.basis && graded.correct ? el("p", { class: "hint", text: t(`form-basis-${graded.basis}`) }) : null,
      ),
    ),
    totalLine(graded),
    feedbackList(graded.feedback, focusRow),
    !graded.correct && graded.links.some(hasNews) ? linkTable(graded.links, focusRow) : null,
    repairList(graded.repairs, convention, focusRow),
    (graded.remarks ?? []).map((/** @type {string} */ text) => el("p", { class: "notice lecturer-remark", text })),
  );
}

/** What was earned of what could be earned with the parts that were handed in. @param {any} graded */
export function shareOf(graded) {
  const parts = Object.values(graded.parts);
  const most = parts.reduce((sum, part) => sum + part.max_points, 0);
  return most ? parts.reduce((sum, part) => sum + part.points, 0) / most : graded.score;
}

/** The verdict in a sentence. @param {any} graded */
export function verdictWord(graded) {
  if (graded.basis !== null) return t(graded.correct ? "form-verdict-correct" : "form-verdict-wrong");
  return t(graded.correct ? "form-verdict-all" : "form-verdict-some");
}

/** What was earned: of what was handed in, which the ring shows, and of all there is. @param {any} options */
function totalLine({ parts, total: { points, max_points: total, missing } }) {
  const names = missing.map((/** @type {string} */ kind) => t(`form-part-${kind.replaceAll("_", "-")}`));
  const most = Object.values(parts).reduce((sum, part) => sum + part.max_points, 0);
  const counted = { points: plain(points, 1), most: plain(most, 1), total: plain(total, 1) };
  return el(
    "p",
    { class: "hint" },
    t(missing.length ? "form-total-handed" : "form-total", counted),
    names.length ? ` ${t("form-total-missing", { parts: names.join(", ") })}` : null,
  );
}

/** @param {any} link */
function hasNews(link) {
  return FACTS.some((fact) => link[fact] && link[fact] !== "hidden");
}

/** @param {number} score 0 … 1 */
function scoreRing(score) {
  const percent = Math.round(score * 100);
  const ring = el(
    "div",
    { class: "score-ring", role: "img", "aria-label": t("form-score", { score: percent }) },
    el("span", { text: `${percent} %` }),
  );
  ring.style.setProperty("--score", `${percent}%`);
  return ring;
}

/** @param {any} row @param {string} text @param {any} focusRow @param {any} cell */
function rowLink(row, text, focusRow, cell = undefined) {
  if (!focusRow) return el("span", { text });
  return el("a", {
    class: "row-link",
    href: `#row-${row}`,
    text,
    onclick: (event) => {
      event.preventDefault();
      focusRow(row - 1, cell);
    },
  });
}

/** @param {any} feedback @param {any} focusRow */
function feedbackList(feedback, focusRow) {
  if (!feedback.length) return null;
  return el(
    "ul",
    { class: "feedback" },
    feedback.map((/** @type {any} */ { row, message, code }) =>
      el(
        "li",
        { dataset: { code } },
        message,
        row && focusRow ? [" ", rowLink(row, t("form-row-go", { row }), focusRow)] : null,
      ),
    ),
  );
}

/** @param {any} links @param {any} focusRow */
function linkTable(links, focusRow) {
  return el(
    "div",
    { class: "scroller", tabindex: "0", role: "group", "aria-label": t("form-links-caption") },
    el(
      "table",
      { class: "data links-table" },
      el("caption", { class: "visually-hidden", text: t("form-links-caption") }),
      el(
        "thead",
        {},
        el(
          "tr",
          {},
          el("th", { scope: "col", text: t("form-row-heading") }),
          FACTS.map((fact) => el("th", { scope: "col", text: t(`form-fact-${fact}`) })),
        ),
      ),
      el(
        "tbody",
        {},
        links.map((/** @type {any} */ link) =>
          el(
            "tr",
            {},
            el("th", { scope: "row" }, rowLink(link.row, String(link.row), focusRow)),
            FACTS.map((fact) => el("td", {}, finding(link[fact]))),
          ),
        ),
      ),
    ),
  );
}

/** @param {string} found */
function finding(found) {
  const tone = found === "ok" ? "good" : found === "wrong" || found === "missing" ? "bad" : "";
  return el(
    "span",
    { class: `badge ${tone}` },
    MARKS[found] ? icon(MARKS[found]) : null,
    el("span", { text: t(`form-finding-${found}`) }),
  );
}

/** @param {any} repairs @param {string} convention @param {any} focusRow */
function repairList(repairs, convention, focusRow) {
  if (!repairs.length) return null;
  /** @param {any} options */
  const edit = ({ row, cell, message, code }) => {
    const name = cell && cell !== "joint" ? `, ${columnText(cell, convention)}` : "";
    return el(
      "li",
      { dataset: { code } },
      message,
      row ? [" ", rowLink(row, t("form-row-go", { row }) + name, focusRow, cell)] : null,
    );
  };
  return el(
    "div",
    {},
    el("h3", { text: t("form-repairs") }),
    repairs.map((/** @type {any} */ repair, /** @type {number} */ i) => [
      i > 0 ? el("p", { class: "hint", text: t("form-repair-or") }) : null,
      el("ul", { class: "feedback repairs" }, repair.edits.map(edit)),
    ]),
  );
}

/**
 * What is said of a part beyond the table.
 * @param {any} report @param {string} name
 * @param {{nameOf: (where: (string | number)[]) => string, goTo: (where: (string | number)[]) => void}} places
 */
export function partView(report, name, { nameOf, goTo }) {
  const percent = Math.round(report.score * 100);
  const wrong = report.facts.filter(
    (/** @type {any} */ { finding: found }) => found === "wrong" || found === "missing",
  );
  const tone = percent === 100 ? "good" : percent ? "warn" : "bad";
  /** @param {any} options */
  const link = ({ where }) => {
    /** @param {any} event */
    const follow = (event) => {
      event.preventDefault();
      goTo(where);
    };
    return [" ", el("a", { class: "row-link", href: `#part-${report.kind}`, onclick: follow, text: nameOf(where) })];
  };
  return el(
    "section",
    { class: "part-report", "aria-label": name },
    el("h3", {}, name, " ", el("span", { class: `badge ${tone}`, text: t("form-score", { score: percent }) })),
    feedbackList(report.feedback, null),
    wrong.length ? el("p", { class: "hint" }, t("form-part-wrong"), wrong.map(link)) : null,
  );
}
