/** A verdict as something to learn from: score, rows, reasons, repairs; never more than the API told. */

import { dataTable } from "../data-table.js";
import { el, icon } from "../dom.js";
import { named, t } from "../i18n.js";
import { columnText } from "../editor/grid.js";
import { asPoints } from "../numbers.js";
import { partName, pointsText } from "./progress.js";

const FACTS = ["twist", "length", "offset", "joint"];
/** @type {Record<string, "check" | "cross">} */
const MARKS = { ok: "check", wrong: "cross", missing: "cross" };
/** @type {Record<string, string>} */
const TONES = { ok: "good", wrong: "bad", missing: "bad", doubtful: "warn" };
/** The facts that findings speak of. @type {Record<string, string>} */
const FACT_OF = {
  length_wrong: "length",
  twist_wrong: "twist",
  offset_wrong: "offset",
  angle_wrong: "offset",
  joint_type_wrong: "joint",
  variable_zero_wrong: "joint",
  variable_direction_wrong: "joint",
  a: "length",
  α: "twist",
  d: "offset",
};

/**
 * What is said of the table, and of the answer as a whole.
 * @param {any} graded as the API gave it
 * @param {{convention: string, rows: number, focusRow: ((row: number, cell?: string) => void) | null}} answer the table's
 *   convention and number of rows; what leads to a row, if something does
 * @returns {HTMLElement}
 */
export function verdictView(graded, answer) {
  const tone = toneOf(graded);
  const linked = rowLinks(answer);
  return el(
    "div",
    { class: "stack" },
    el(
      "div",
      { class: `verdict-head ${tone}` },
      scoreRing(graded.total),
      el(
        "div",
        {},
        el("p", { class: "verdict-word", text: verdictWord(graded) }),
        graded.basis && graded.correct ? el("p", { class: "hint", text: t(`form-basis-${graded.basis}`) }) : null,
      ),
    ),
    totalLines(graded),
    feedbackList(graded.feedback, linked),
    !graded.correct && graded.links.some(hasNews) ? linkTable(graded.links, doubts(graded.feedback), linked) : null,
    repairList(graded.repairs, answer.convention, linked),
    (graded.remarks ?? []).map((/** @type {string} */ text) => el("p", { class: "notice lecturer-remark", text })),
  );
}

/** How what was handed in went: all right, partly, not at all. @param {any} graded */
function toneOf(graded) {
  const parts = Object.values(graded.parts);
  const most = parts.reduce((sum, part) => sum + part.max_points, 0);
  const share = most ? parts.reduce((sum, part) => sum + part.points, 0) / most : graded.score;
  return share >= 1 ? "good" : share > 0 ? "partly" : "bad";
}

/** The verdict in a sentence. @param {any} graded */
export function verdictWord(graded) {
  if (graded.basis !== null) return t(graded.correct ? "form-verdict-correct" : "form-verdict-wrong");
  return t(graded.correct ? "form-verdict-all" : "form-verdict-some");
}

/** The points: of the whole exercise, what those of a wrong table are for, and those of each part. @param {any} graded */
function totalLines({ parts, basis, correct, total: { points, max_points: most, missing } }) {
  const isWrongTable = basis !== null && !correct && parts.table;
  const entries = Object.entries(parts).map(([kind, part]) => [
    partName(kind),
    pointsText(part.points, part.max_points),
  ]);
  for (const kind of missing) entries.push([partName(kind), t("form-part-missing")]);
  return [
    el("p", { class: "total" }, el("strong", { text: pointsText(points, most) })),
    isWrongTable ? el("p", { class: "hint", text: t("form-points-for") }) : null,
    entries.length > 1
      ? el(
          "ul",
          { class: "hint part-points" },
          entries.map(([name, said]) => el("li", { text: named(name, said) })),
        )
      : null,
  ];
}

/** @param {any} link */
function hasNews(link) {
  return FACTS.some((fact) => link[fact] && link[fact] !== "hidden");
}

/** @param {{points: number, max_points: number}} total */
function scoreRing({ points, max_points: most }) {
  const ring = el(
    "div",
    { class: "score-ring", role: "img", "aria-label": pointsText(points, most) },
    el("span", { text: asPoints(points) }),
    el("small", { text: `/ ${asPoints(most)}` }),
  );
  ring.style.setProperty("--score", `${most ? (100 * points) / most : 0}%`);
  return ring;
}

/**
 * A link to a row of the table that was handed in, or to one of its cells; null where there is none to go to.
 * @typedef {(row: number, text: string, cell?: string) => HTMLElement | null} RowLink
 */

/** @param {{rows: number, focusRow: ((row: number, cell?: string) => void) | null}} answer @returns {RowLink} */
function rowLinks({ rows, focusRow }) {
  return (row, text, cell) => {
    if (!focusRow || row > rows) return null;
    return el("a", {
      class: "row-link",
      href: `#row-${row}`,
      text,
      onclick: (event) => {
        event.preventDefault();
        focusRow(row - 1, cell);
      },
    });
  };
}

/** @param {string} code of a finding or an edit; some speak of a row that the table does not have yet */
const isOfMissingRow = (code) => code.endsWith("row_missing");

/** A finding or an edit, with a link to its row. @param {any} said @param {RowLink} linked @param {string} [cell] @param {string} [name] of the cell */
function lineOf({ row, message, code }, linked, cell, name = "") {
  const link = row && !isOfMissingRow(code) ? linked(row, t("form-row-go", { row }) + name, cell) : null;
  return el("li", { dataset: { code } }, message, link ? [" ", link] : null);
}

/** @param {any[]} feedback @param {RowLink} linked */
function feedbackList(feedback, linked) {
  if (!feedback.length) return null;
  return el(
    "ul",
    { class: "feedback" },
    feedback.map((said) => lineOf(said, linked)),
  );
}

/**
 * Whether a fact is one of those of which only one is wrong, and nobody can say which.
 * @param {any[]} feedback
 * @returns {(row: number, fact: string) => boolean}
 */
function doubts(feedback) {
  const from = feedback.findIndex(({ code }) => code === "one_of_these");
  const facts = (/** @type {any} */ { code, row, params }) =>
    (code === "sign_wrong" ? params.cells.split(", ") : [code]).map(
      (/** @type {string} */ name) => `${row} ${FACT_OF[name]}`,
    );
  const sure = new Set(feedback.slice(0, Math.max(from, 0)).flatMap(facts));
  const choice = new Set(from < 0 ? [] : feedback.slice(from + 1).flatMap(facts));
  return (row, fact) => choice.has(`${row} ${fact}`) && !sure.has(`${row} ${fact}`);
}

/**
 * Row by row; a missing row stands where it belongs.
 * @param {any[]} links @param {(row: number, fact: string) => boolean} isDoubtful @param {RowLink} linked
 */
function linkTable(links, isDoubtful, linked) {
  const isMissing = (/** @type {any} */ { joint }) => joint === "missing";
  const placed = links.toSorted(
    (one, other) => one.row - other.row || Number(isMissing(other)) - Number(isMissing(one)),
  );
  const heading = (/** @type {any} */ link) => {
    if (isMissing(link)) return t("form-row-missing", { after: link.row - 1 });
    return linked(link.row, String(link.row)) ?? String(link.row);
  };
  return dataTable(
    t("form-links-caption"),
    [t("form-row-heading"), ...FACTS.map((fact) => t(`form-fact-${fact}`))],
    placed.map((link) => [
      heading(link),
      ...FACTS.map((fact) => finding(link[fact] === "wrong" && isDoubtful(link.row, fact) ? "doubtful" : link[fact])),
    ]),
    { kind: "links-table" },
  );
}

/** @param {string} found */
function finding(found) {
  const tone = TONES[found] ?? "";
  return el(
    "span",
    { class: `badge ${tone}` },
    MARKS[found] ? icon(MARKS[found]) : null,
    el("span", { text: t(`form-finding-${found}`) }),
  );
}

/** @param {any[]} repairs @param {string} convention @param {RowLink} linked */
function repairList(repairs, convention, linked) {
  if (!repairs.length) return null;
  const line = (/** @type {any} */ edit) => {
    const name = edit.cell && edit.cell !== "joint" ? `, ${columnText(edit.cell, convention)}` : "";
    return lineOf(edit, linked, edit.cell, name);
  };
  return el(
    "div",
    {},
    el("h3", { text: t("form-repairs") }),
    repairs.map((repair, i) => [
      i > 0 ? el("p", { class: "hint", text: t("form-repair-or") }) : null,
      el("ul", { class: "feedback repairs" }, repair.edits.map(line)),
    ]),
  );
}

/**
 * What is said of a part beyond the table.
 * @param {any} report @param {string} name
 * @param {{placeOf: (where: (string | number)[]) => import("./answer-card.js").Place | null,
 *   goTo: ((where: (string | number)[]) => void) | null}} places what leads to a place, if something does
 */
export function partView(report, name, { placeOf, goTo }) {
  /** @type {Map<string, HTMLElement[]>} */
  const wrong = new Map();
  for (const { where, finding: found } of report.facts) {
    const place = found === "wrong" || found === "missing" ? placeOf(where) : null;
    if (!place) continue;
    const text = place.at ? `(${place.at})` : place.name;
    const label = place.at ? { "aria-label": `${place.name} (${place.at})` } : {};
    const follow = (/** @type {Event} */ event) => (event.preventDefault(), goTo?.(where));
    const link = goTo
      ? el("a", { class: "row-link", href: `#part-${report.kind}`, onclick: follow, ...label, text })
      : el("span", { text });
    const named = place.at ? place.name : "";
    wrong.set(named, [...(wrong.get(named) ?? []), link]);
  }
  const tone = report.points >= report.max_points ? "good" : report.points > 0 ? "warn" : "bad";
  const places = [...wrong].flatMap(([named, links]) => [
    named ? ` ${named}` : "",
    ...links.flatMap((link) => [" ", link]),
  ]);
  return el(
    "section",
    { class: "part-report", "aria-label": name, dataset: { kind: report.kind } },
    el("h3", {}, name, " ", el("span", { class: `badge ${tone}`, text: pointsText(report.points, report.max_points) })),
    feedbackList(report.feedback, () => null),
    wrong.size ? el("p", { class: "hint" }, t("form-part-wrong"), places) : null,
  );
}
