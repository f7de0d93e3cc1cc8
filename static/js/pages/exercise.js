/** The page of an exercise: read, look, type, watch, submit, learn. */

import { Problem } from "../api.js";
import { browserAttempts } from "../attempts.js";
import { announce, el, fill } from "../dom.js";
import "../editor/dh-table-editor.js";
import { AnswerCard } from "../exercise/answer-card.js";
import { isPackaged, PackageFrame } from "../exercise/embedding.js";
import { showFigure } from "../exercise/figure-card.js";
import { showHistory } from "../exercise/history.js";
import { OwnCard } from "../exercise/own-card.js";
import { VerdictCard } from "../exercise/verdict-card.js";
import { t } from "../i18n.js";
import "../joint-sliders.js";
import { LiveRobot, robotOf } from "../live-robot.js";
import "../matrix-panel.js";
import { api, startPage } from "../page.js";
import { plain } from "../numbers.js";
import { problemNotice } from "../problem.js";
import "../scene/robot-scene.js";
import { keep, recall } from "../storage.js";
import { CourseSession, openSession, receiptView } from "../session/course-session.js";
import { convertedValues } from "../units.js";

const $ = (id) => /** @type {HTMLElement} */ (document.getElementById(id));
const id = $("exercise").dataset.id;
const seed = new URLSearchParams(location.search).get("seed");
const query = seed ? `?seed=${encodeURIComponent(seed)}` : "";
let draftKey = `draft:${id}${seed ? `:${seed}` : ""}`;
let attempts = browserAttempts;

async function run() {
  let exercise;
  /** @type {CourseSession | null} */
  let course = null;
  try {
    const told = await openSession(api);
    if (told?.exercise === id) course = new CourseSession(api, told);
    exercise = await api.get(`exercises/${id}${query}`);
  } catch (error) {
    fill($("answer"), problemNotice(error, { retry: () => location.reload() }));
    return;
  }
  if (course) {
    $("exercise").after(course.banner);
    draftKey += `:${course.key}`;
    attempts = course.attempts;
    const asked = course.told.parts;
    if (asked.length) exercise.parts = exercise.parts.filter(({ kind }) => asked.includes(kind));
  }
  arrange();
  showFigure(exercise, {
    mode: $("figure-mode"),
    body: $("figure-body"),
    drawing: /** @type {HTMLImageElement} */ ($("figure-drawing")),
    description: $("figure-description"),
  });
  const robot = new LiveRobot(api);
  showRules(exercise);
  const own = new OwnCard($("own"), robot, { api, given: givenBy(exercise) });
  const verdict = new VerdictCard($("verdict-card"), $("verdict"));
  const answer = new AnswerCard($("answer"), exercise, {
    changed: (what) => {
      keep(draftKey, answer.state);
      frame?.draft(answer.state);
      course?.draft(answer.state);
      verdict.outdated();
      if (what === "table") follow();
    },
    submit: () => submit(),
  });
  robot.addEventListener("reading", (event) => answer.showReading(/** @type {CustomEvent} */ (event).detail));

  restore(recall(draftKey, null) ?? course?.told.draft?.state);
  const frame = isPackaged() ? new PackageFrame(resume) : null;
  follow({ now: true });
  await listAttempts();

  /** @param {any} state of an earlier visit; the form stays as it is, if an earlier version wrote something else */
  function restore(state) {
    try {
      if (state) answer.state = state;
    } catch (error) {
      console.warn(error);
    }
  }

  /** @param {any} state of an earlier visit, from wherever it was stored */
  function resume(state) {
    restore(state);
    keep(draftKey, answer.state);
    follow({ now: true });
  }

  /** Tells the package around this page what an answer earned, with a receipt that the browser cannot forge. */
  async function report(request, graded, state) {
    const { points, max_points: most, missing } = graded.total;
    const body = { ...request, ...(seed ? { seed } : {}), name: seed ?? "-" };
    const issued = await api.post(`exercises/${id}/receipts`, body).catch(() => null);
    frame?.verdict({ points, max_points: most, complete: !missing.length, receipt: issued?.receipt ?? null, state });
  }

  function follow(options) {
    own.take(answer.table, options);
  }

  async function submit() {
    const request = answer.request();
    if (!request) return;
    const handed = answer.state;
    const changed = () => JSON.stringify(answer.state) !== JSON.stringify(handed);
    answer.busy = true;
    try {
      const graded = course
        ? await course.submit(request, handed)
        : await api.post(`exercises/${id}/grade`, { ...request, ...(seed ? { seed } : {}) });
      if (frame) void report(request, graded, handed);
      answer.showRefusal([], request.table);
      if (graded.shown === "receipt") {
        fill($("submit-problem"), receiptView(graded));
        await listAttempts();
        return;
      }
      await attempts.add(id, {
        at: new Date().toISOString(),
        score: graded.total.score,
        correct: graded.correct && graded.total.score >= 1,
        submission: handed,
        verdict: graded,
      });
      const drawn = graded.certificate && graded.figure ? await robotOf(api, request.table, valuesFor(request.table)).catch(() => null) : null;
      verdict.show(graded, { exercise, answer, convention: handed.table.convention, drawn, changed: changed() });
      await listAttempts();
    } catch (error) {
      const shown = error instanceof Problem && error.status < 500 && answer.showRefusal(error.faults, request.table);
      if (!shown) fill($("submit-problem"), problemNotice(error));
    } finally {
      answer.busy = false;
    }
  }

  /** The exercise's own values, and what the student gave a value to, in a table's units. */
  function valuesFor({ angle_unit: angle, length_unit: length }) {
    const { parameters, kinds, units } = givenBy(exercise);
    const kindOf = (name) => new Map(kinds).get(name) ?? "length";
    return { ...robot.parameters, ...convertedValues(parameters, kindOf, units, { angle, length }) };
  }

  async function listAttempts() {
    const list = await attempts.list(id);
    $("history-card").hidden = list.length === 0;
    showHistory(
      $("history"),
      list,
      (attempt) => {
        restore(attempt.submission);
        keep(draftKey, answer.state);
        follow({ now: true });
        answer.focus();
        announce(t("form-history-restored"));
      },
      async () => {
        await attempts.clear(id);
        await listAttempts();
      },
    );
  }
}

/** The exercise's values, and the units that they are in. */
function givenBy({ parameters, dimensions, angle_unit: angle, length_unit: length }) {
  const kinds = dimensions.map(({ name, unit }) => [name, unit === length ? "length" : "angle"]);
  return { parameters, kinds, units: { angle, length } };
}

/** Below the statement: what is given, and what is free to choose. */
function showRules({ dimensions, rules }) {
  const given = dimensions.map(({ name, value, unit }) => el("li", {}, variable(name), ` = ${plain(value, 6)} ${unit}`));
  fill(
    $("givens"),
    given.length ? [el("h3", { text: t("form-exercise-givens") }), el("ul", { class: "givens" }, given)] : null,
    rules.length ? el("details", {}, el("summary", { text: t("form-exercise-rules") }), el("ul", {}, rules.map((rule) => el("li", { text: rule })))) : null,
  );
}

/** A name with its digits as an index. @param {string} name */
function variable(name) {
  const match = /^([A-Za-z]+)_?(\d*)$/.exec(name);
  return el("var", {}, match ? match[1] : name, match?.[2] ? el("sub", { text: match[2] }) : null);
}

/** On wide screens figure and robot stand beside the answer; in the document, always where they are read. */
function arrange() {
  const wide = matchMedia("(min-width: 64rem)");
  const place = () => {
    if (wide.matches) $("own-side").append($("figure-card"), $("own-card"));
    else {
      $("statement-card").after($("figure-card"));
      $("answer-card").after($("own-card"));
    }
  };
  wide.addEventListener("change", place);
  place();
}

startPage(run);
