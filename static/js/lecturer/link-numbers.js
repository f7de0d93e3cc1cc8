/** The numbers of one link: attempts by day and in their order, mistakes, what is unexplained; each opens what is behind it. */

import { dataTable } from "../data-table.js";
import { el } from "../dom.js";
import { partName } from "../exercise/progress.js";
import { dates, knows, named, t } from "../i18n.js";
import { percentOf } from "../numbers.js";
import { barChart } from "./chart.js";

const DAYS = 40;
/** Attempts that the service lists at most. */
export const LISTED = 200;

/**
 * @typedef {(count: number, asked: Record<string, any>, text?: string) => HTMLElement | string} Opener
 *   a number, however it is written, that opens the attempts which are asked for so
 */

/** @param {any} found statistics of the link @param {Opener} opener */
export function linkNumbers(found, opener) {
  return [attemptNumbers(found, opener), mistakes(found, opener), unexplainedFacts(found, opener)];
}

/** @param {any} options @param {Opener} opener */
function attemptNumbers({ attempts, students, solved, first_attempt_rate: first, days, sequence }, opener) {
  const percent = first === null ? "–" : percentOf(first);
  const facts = [
    [t("lecturer-attempts-made"), opener(attempts, {})],
    [t("lecturer-students"), opener(students, {})],
    [t("lecturer-solved"), opener(solved, { outcome: "solved" })],
    [t("lecturer-first-rate"), opener(first ?? 0, { number: 1, correct: true }, percent)],
  ];
  const dayBars = days
    .slice(-DAYS)
    .map((/** @type {any} */ { day, attempts: all, correct: part }) => ({ label: dayName(day), all, part }));
  return [
    el(
      "dl",
      { class: "row" },
      facts.map(([name, value]) => el("div", {}, el("dt", { text: name }), el("dd", {}, value))),
    ),
    el("h3", { text: t("lecturer-by-day") }),
    barChart(dayBars, t("lecturer-by-day")),
    dataTable(
      t("lecturer-by-day"),
      [t("lecturer-day"), t("lecturer-attempts-made"), t("lecturer-right")],
      days.map((/** @type {any} */ { day, attempts: all, correct }) => [
        dayName(day),
        opener(all, { day }),
        opener(correct, { day, correct: true }),
      ]),
    ),
    el("h3", { text: t("lecturer-sequence") }),
    barChart(
      sequence.map((/** @type {any} */ { attempt, reached, solved: part }) => ({
        label: t("lecturer-attempt-number", { attempt }),
        all: reached,
        part,
      })),
      t("lecturer-sequence"),
    ),
    dataTable(
      t("lecturer-sequence"),
      [t("lecturer-attempt"), t("lecturer-reached"), t("lecturer-solved"), t("lecturer-left")],
      sequence.map((/** @type {any} */ step) => [
        step.attempt,
        opener(step.reached, { number: step.attempt, outcome: "reached" }),
        opener(step.solved, { number: step.attempt, outcome: "solved" }),
        opener(step.dropped_out, { number: step.attempt, outcome: "left" }),
      ]),
    ),
  ];
}

/** @param {any} options @param {Opener} opener */
function mistakes({ misconceptions }, opener) {
  if (!misconceptions.length) return null;
  return [
    el("h3", { text: t("lecturer-mistakes") }),
    barChart(
      misconceptions.map((/** @type {any} */ entry) => ({ label: mistakeName(entry), all: entry.attempts })),
      t("lecturer-mistakes"),
    ),
    dataTable(
      t("lecturer-mistakes"),
      [t("lecturer-mistake"), t("lecturer-attempts-made"), t("lecturer-students"), t("lecturer-example")],
      misconceptions.map((/** @type {any} */ entry) => [
        entry.kind.startsWith("part:") ? partName(entry.kind.slice("part:".length)) : mistakeName(entry),
        opener(entry.attempts, { kind: entry.kind, code: entry.code }),
        opener(entry.students, { kind: entry.kind, code: entry.code }),
        entry.example ?? "–",
      ]),
    ),
  ];
}

/** @param {any} options @param {Opener} opener */
function unexplainedFacts({ unexplained }, opener) {
  if (!unexplained.length) return null;
  return [
    el("h3", { text: t("lecturer-unexplained") }),
    dataTable(
      t("lecturer-unexplained"),
      [t("lecturer-does-not-fit"), t("lecturer-attempts-made")],
      unexplained.map((/** @type {any} */ { facts, attempts }) => [
        facts.map(factName).join(", "),
        opener(attempts.length, { ids: attempts.slice(0, LISTED).join(",") }),
      ]),
    ),
  ];
}

/** @param {string} fact of a row, such as "2:length", or a part, such as ":pose" */
function factName(fact) {
  const [row, name] = fact.split(":");
  if (!row) return t(`form-part-${name.replaceAll("_", "-")}`);
  return named(`${t("form-row-heading")} ${row}`, t(`form-fact-${name}`));
}

/** What a mistake is called: those in tables have names, others what a student was told. @param {any} entry */
function mistakeName({ code, example }) {
  return knows(`option-${code}`) ? t(`option-${code}`) : (example ?? code);
}

/** @param {string} day as the service counts them, in UTC */
function dayName(day) {
  return dates({ dateStyle: "medium", timeZone: "UTC" }).format(new Date(day));
}
