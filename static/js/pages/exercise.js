/** The page of an exercise: read, look, type, watch, submit, learn. */

import { Problem } from "../api.js";
import { browserAttempts } from "../attempts.js";
import { announce, el, fill, variable } from "../dom.js";
import "../editor/dh-table-editor.js";
import { Access } from "../exercise/access.js";
import { AnswerCard } from "../exercise/answer-card.js";
import { isPackaged, PackageFrame } from "../exercise/embedding.js";
import { showFigure } from "../exercise/figure-card.js";
import { leastHelp } from "../exercise/help.js";
import { showHistory } from "../exercise/history.js";
import { arrangePictures, connect } from "../exercise/pictures.js";
import { partName } from "../exercise/progress.js";
import { OwnCard } from "../exercise/own-card.js";
import { VerdictCard } from "../exercise/verdict-card.js";
import { t } from "../i18n.js";
import "../joint-sliders.js";
import { LiveRobot, robotOf } from "../live-robot.js";
import "../matrix-panel.js";
import { api, pageAddress, startPage, warnAbove, watchOtherTabs } from "../page.js";
import { inSentence } from "../numbers.js";
import { problemNotice } from "../problem.js";
import "../scene/robot-scene.js";
import { keep, recall } from "../storage.js";
import { notOpened, openAsked, openSession, receiptView } from "../session/session.js";
import { convertedValues } from "../units.js";

/** @typedef {import("../session/course-session.js").CourseSession} CourseSession */

/** @param {string} id */
const $ = (id) => /** @type {HTMLElement} */ (document.getElementById(id));
const id = $("exercise").dataset.id ?? "";
const seed = new URLSearchParams(location.search).get("seed");
const query = seed ? `?seed=${encodeURIComponent(seed)}` : "";
let draftKey = `draft:${id}${seed ? `:${seed}` : ""}`;
let attempts = browserAttempts;

async function run() {
  /** @type {Wire.Exercise} */
  let exercise;
  /** @type {CourseSession | null} */
  let course = null;
  try {
    const told = await openSession(api, () => warnAbove(t("session-ended")));
    if (told?.exercise === id) {
      const { CourseSession } = await import("../session/course-session.js");
      course = new CourseSession(api, told);
    }
    if (course && told.seed !== seed) return openAsked(told);
    if (told?.exercise && !course && told.role === "learner") {
      const action = { text: t("session-elsewhere-go"), run: () => openAsked(told) };
      warnAbove(t("session-elsewhere"), action);
    }
    exercise = await api.get(`exercises/${id}${query}`);
  } catch (error) {
    fill($("answer"), notOpened(error));
    return;
  }
  if (course) {
    $("exercise").after(course.banner);
    draftKey += `:${course.key}`;
    attempts = course.attempts;
    const asked = course.told.parts;
    if (asked.length) exercise.parts = exercise.parts.filter(({ kind }) => asked.includes(kind));
    exercise.points = exercise.parts.reduce((sum, { points }) => sum + points, 0);
    course.points = exercise.points;
    exercise.help = leastHelp(exercise.help, course.told.help);
  }
  arrangePictures();
  showFigure(exercise, {
    mode: $("figure-mode"),
    body: $("figure-body"),
    drawing: /** @type {HTMLImageElement} */ ($("figure-drawing")),
    description: $("figure-description"),
  });
  const asksTable = exercise.parts.some(({ kind }) => kind === "table");
  if (!asksTable) for (const id of ["own-card", "write-table"]) $(id).hidden = true;
  const robot = new LiveRobot(api);
  showRules(exercise);
  const own = new OwnCard($("own"), robot, {
    api,
    given: givenBy(exercise),
    light: (row, cell) => answer.editor.light(row, cell),
  });
  const verdict = new VerdictCard($("verdict-card"), $("verdict"));
  const answer = new AnswerCard($("answer"), exercise, {
    changed: (what) => {
      keepDraft();
      frame?.draft(answer.state);
      verdict.outdated();
      if (what === "table") follow();
    },
    submit: (kind) => submit(kind),
    owner: course?.key ?? null,
  });
  connect(answer.editor, own);
  const access = new Access(exercise, answer.progress);
  access.apply(own);
  robot.addEventListener("reading", (event) => answer.showReading(/** @type {CustomEvent} */ (event).detail));

  const here = recall(draftKey, null);
  const { state: latest, other } = course ? course.latest(here) : { state: here, other: null };
  restore(latest);
  if (other) {
    const action = { text: t("session-draft-take"), run: () => resume(other.state) };
    warnAbove(t("session-draft-other", { when: other.at }), action);
  }
  const readOff = recall(`read-off:${id}`, null);
  if (readOff) {
    resume({ ...answer.state, table: readOff });
    keep(`read-off:${id}`, null);
  }
  const frame = isPackaged() ? new PackageFrame(resume) : null;
  watchOtherTabs(draftKey, t("form-other-tab"), () => resume(recall(draftKey, null)));
  follow({ now: true });
  await listAttempts();
  const lecturers = !course && !frame && !api.context;
  if (lecturers) prepareSharing(exercise);

  /** @param {any} state of an earlier visit; the form stays as it is, if an earlier version wrote something else */
  function restore(state) {
    const before = JSON.stringify(answer.states);
    try {
      if (state) answer.state = state;
    } catch (error) {
      console.warn(error);
    }
    if (JSON.stringify(answer.states) !== before) verdict.outdated();
  }

  function keepDraft() {
    const { state } = answer;
    keep(draftKey, state);
    course?.draft(state);
  }

  /** @param {any} state of an earlier visit, from wherever it was stored */
  function resume(state) {
    restore(state);
    keepDraft();
    follow({ now: true });
  }

  /**
   * Tells the package around this page what an answer earned, with a receipt that the browser cannot forge.
   * @param {Record<string, any>} request @param {Wire.Graded} graded @param {any} state
   */
  async function report(request, graded, state) {
    const { points, max_points: most, missing } = graded.total;
    const body = { ...request, ...(seed ? { seed } : {}), name: seed ?? "-" };
    const issued = await api.post(`exercises/${id}/receipts`, body).catch(() => null);
    frame?.verdict({ points, max_points: most, complete: !missing.length, receipt: issued?.receipt ?? null, state });
  }

  /** @param {{now?: boolean}} [options] */
  function follow(options = {}) {
    if (asksTable) own.take(answer.table, options);
  }

  /** @param {string} [kind] the part that is checked; everything, if it is left out */
  async function submit(kind) {
    const request = answer.request(kind);
    if (!request) return;
    const { state: handed, states } = answer;
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
      const drawn = await drawnFor(graded, request.table);
      answer.judged(graded, states);
      access.apply(own);
      const further = answer.help.further(graded, request);
      if (graded.basis !== null) answer.help.judged(request, graded.correct);
      const { table } = request;
      const { convention } = handed.table;
      const receipt = course || frame ? null : { request: { ...request, ...(seed ? { seed } : {}) }, state: handed };
      verdict.show(graded, {
        exercise,
        answer,
        convention,
        table,
        drawn,
        later: graded.departure_later ? () => departing(graded.attempt, request.table) : null,
        changed: changed(),
        further,
        kind,
        access,
        receipt,
      });
      const wrong = firstWrong(graded);
      if (wrong !== null && !changed()) own.film.show(wrong.row - 1, wrong.cell);
      await listAttempts();
    } catch (error) {
      const refused = error instanceof Problem && error.code && error.status < 500;
      if (!refused || !answer.showRefusal(error.faults, request.table)) showProblem(error);
    } finally {
      answer.busy = false;
    }
  }

  /**
   * The exercise's own values, and what the student gave a value to, in a table's units.
   * @param {any} table @param {Wire.Exercise} [asked] the exercise, if it is not this page's
   */
  function valuesFor({ angle_unit: angle, length_unit: length }, asked = exercise) {
    const { parameters, kinds, units } = givenBy(asked);
    /** @param {string} name */
    const kindOf = (name) => new Map(kinds).get(name) ?? "length";
    return { ...robot.parameters, ...convertedValues(parameters, kindOf, units, { angle, length }) };
  }

  /**
   * The robot of a table that was handed in, if its verdict draws it.
   * @param {Wire.Graded} graded @param {any} table @param {Wire.Exercise} [asked]
   */
  function drawnFor({ certificate, figure, departure }, table, asked) {
    const draws = table && ((certificate && figure) || departure);
    return draws ? robotOf(api, table, valuesFor(table, asked)).catch(() => null) : null;
  }

  /** Where the robot of an attempt departs, of which too many answers kept the service when it was judged. @param {number} number @param {any} table */
  async function departing(number, table) {
    const { report: graded } = await /** @type {CourseSession} */ (course).attempt(number);
    return { graded, drawn: await drawnFor(graded, table) };
  }

  /** @param {any} state what was handed in */
  function takeBack(state) {
    restore(state);
    keepDraft();
    frame?.draft(answer.state);
    follow({ now: true });
    answer.focus();
    announce(t("form-history-restored"));
  }

  /**
   * Takes an earlier attempt back and shows what was found of it, by the exercise as it was then, once all of it is here.
   * @param {CourseSession} course @param {import("../attempts.js").Attempt} attempt
   */
  async function reopen(course, attempt) {
    const number = attempt.number ?? 0;
    const mended = !course.isCurrent(attempt) && attempt.version?.startsWith(`${id}-`);
    const found = await course.reopen(number, async ({ report, form, answer: sent }) => {
      const then = mended ? await api.get(`exercises/${attempt.version}${query}`) : exercise;
      const drawn = report && (await drawnFor(report, sent.table, then));
      return { report, form, table: sent?.table, then, drawn };
    });
    if (!found) return;
    const { report, form, table, then, drawn } = found;
    takeBack(form);
    if (report === null) return fill($("submit-problem"), receiptView({ attempt: number }));
    const convention = table?.convention ?? "standard";
    const further = mended ? mendedNotice(attempt) : null;
    verdict.show(report, { exercise: then, answer, convention, table, drawn, changed: false, further });
  }

  /** @param {unknown} error */
  function showProblem(error) {
    if (error instanceof Problem && error.code === "answer_empty") {
      const parts = exercise.parts.map(({ kind }) => partName(kind)).join(" · ");
      fill(
        $("submit-problem"),
        el("p", { class: "notice notice-problem", role: "alert", text: t("form-answer-empty", { parts }) }),
      );
      answer.focus();
    } else fill($("submit-problem"), problemNotice(error));
  }

  async function listAttempts() {
    const list = await attempts.list(id);
    $("history-card").hidden = list.length === 0;
    showHistory(
      $("history"),
      list,
      exercise.points,
      async (attempt) => {
        if (course && attempt.number) await reopen(course, attempt).catch((error) => showProblem(error));
        else takeBack(attempt.submission);
      },
      course
        ? null
        : async () => {
            await attempts.clear(id);
            await listAttempts();
            $("answer-heading").focus();
          },
    );
  }
}

/** Said of an attempt whose exercise was mended since. @param {import("../attempts.js").Attempt} attempt */
function mendedNotice({ number, version }) {
  const href = pageAddress(`exercises/${version}${query}`);
  return el(
    "p",
    { class: "notice" },
    t("session-attempt-then", { attempt: number ?? 0 }),
    " ",
    el("a", { href, target: "_blank", rel: "noopener", text: t("session-exercise-then") }),
  );
}

/**
 * Where the student's robot departs from the exercise's, as far as the help tells: the picture shows that row.
 * @param {Wire.Graded} graded
 */
function firstWrong({ correct, links, departure }) {
  const cells = { twist: "alpha", length: "a", offset: "d" };
  if (correct) return null;
  const wrong = (/** @type {Wire.Link} */ link) =>
    Object.entries(cells).find(([fact]) => link[/** @type {"twist"} */ (fact)] === "wrong");
  const found = links.filter((link) => wrong(link) && (!departure || link.row === departure.row));
  if (found.length) return { row: found[0].row, cell: wrong(found[0])?.[1] };
  return departure ? { row: departure.row } : null;
}

/** What lecturers take away is loaded when somebody opens it. @param {Wire.Exercise} exercise */
function prepareSharing(exercise) {
  const place = $("sharing");
  place.hidden = false;
  const open = async () => place.append((await import("../exercise/sharing.js")).sharingPanel({ api, exercise }));
  place.addEventListener("toggle", () => void open(), { once: true });
}

/** The exercise's values, and the units that they are in. @param {any} options */
function givenBy({ parameters, dimensions, angle_unit: angle, length_unit: length }) {
  const kinds = dimensions.map((/** @type {any} */ { name, unit }) => [name, unit === length ? "length" : "angle"]);
  return { parameters, kinds, units: { angle, length } };
}

/** Below the statement: what is given, and what is free to choose. @param {any} options */
function showRules({ dimensions, rules }) {
  const given = dimensions.map((/** @type {any} */ { name, value, unit }) =>
    el("li", {}, variable(name), ` = ${inSentence(value, 6)} ${unit}`),
  );
  fill(
    $("givens"),
    given.length ? [el("h3", { text: t("form-exercise-givens") }), el("ul", { class: "givens" }, given)] : null,
    rules.length
      ? el(
          "details",
          {},
          el("summary", { text: t("form-exercise-rules") }),
          el(
            "ul",
            {},
            rules.map((/** @type {any} */ rule) => el("li", { text: rule })),
          ),
        )
      : null,
  );
}

startPage(run);
