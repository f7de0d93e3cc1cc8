/**
 * How much is told of a wrong answer: as much as the exercise allows, less if the student wants less, or one step
 * after another: the row, the kind of mistake, the principle, a worked step on another robot. The next step needs a
 * changed answer, so that nobody climbs by pressing the button.
 */

import { el, uniqueId } from "../dom.js";
import { t } from "../i18n.js";
import { keep, recall } from "../storage.js";

const LEVELS = ["verdict", "row", "kind", "repair"];
const STEPS = ["row", "kind", "principle", "worked"];
/** What the student chooses, beside the levels. */
const STEPWISE = "steps";
/** Facts of a row, in the order in which a student looks for a mistake. */
const FACTS = /** @type {const} */ (["joint", "twist", "length", "offset"]);

/** The lesser of two levels; the first if the second is none. @param {string} level @param {string | null} other */
export function leastHelp(level, other) {
  return other === null ? level : LEVELS[Math.min(LEVELS.indexOf(level), LEVELS.indexOf(other))];
}

export class Help {
  /** @param {Wire.Exercise} exercise @param {string | null} owner whose answers these are, where somebody is signed in */
  constructor(exercise, owner) {
    this.exercise = exercise;
    this.key = ["wrong", exercise.id, exercise.seed, owner].filter(Boolean).join(":");
    this.levels = LEVELS.slice(0, LEVELS.indexOf(exercise.help) + 1);
    this.steps = STEPS.slice(0, this.levels.includes("kind") ? STEPS.length : this.levels.includes("row") ? 1 : 0);
  }

  /** What the student chose, in every exercise of this browser; as much as is allowed, at first. */
  get chosen() {
    const wanted = recall("help", this.exercise.help);
    const offered = [...this.levels, ...(this.steps.length > 1 ? [STEPWISE] : [])];
    return offered.includes(wanted) ? wanted : this.exercise.help;
  }

  /** The choice, or null where there is none. */
  element() {
    if (this.levels.length < 2) return null;
    const id = uniqueId("help");
    const offered = [...this.levels, ...(this.steps.length > 1 ? [STEPWISE] : [])];
    const options = offered.map((value) =>
      el("option", { value, selected: value === this.chosen, text: t(`form-help-${value}`) }),
    );
    const choose = (/** @type {any} */ { target: { value } }) =>
      keep("help", value === this.exercise.help ? null : value);
    const select = el("select", { id, onchange: choose }, options);
    return el("div", { class: "row help-choice" }, el("label", { for: id, text: t("form-help") }), select);
  }

  /**
   * What a request says of help: the level, and which different answer this is, where the exercise has a ladder.
   * @param {Record<string, any>} answer that is handed in
   */
  wanted(answer) {
    const ladder = this.exercise.access?.ladder ?? [];
    const rising = ladder.length > 1 || (this.exercise.access?.attempts ?? null) !== null;
    const attempt = rising ? { attempt: this.#place(answer) + 1 } : {};
    if (this.chosen === this.exercise.help) return attempt;
    const step = this.#step(answer);
    return { help: this.chosen === STEPWISE ? (step === "row" ? "row" : "kind") : this.chosen, ...attempt };
  }

  /**
   * What is said beyond the verdict of a wrong answer, one step after another; null where nothing is.
   * @param {Wire.Graded} graded @param {Record<string, any>} answer
   */
  further(graded, answer) {
    if (graded.correct || graded.basis === null || this.chosen !== STEPWISE) return null;
    const step = this.#step(answer);
    const fact = wrongFact(graded);
    const at = this.steps.indexOf(step);
    const shows = (/** @type {string} */ name) =>
      fact && this.steps.indexOf(name) >= 0 && this.steps.indexOf(name) <= at;
    return el(
      "div",
      { class: "help-steps" },
      shows("principle") ? paragraph(t("form-help-principle"), t(`form-principle-${fact}`)) : null,
      shows("worked") ? paragraph(t("form-help-worked"), t(`form-worked-${fact}`)) : null,
      at < this.steps.length - 1 ? el("p", { class: "hint", text: t("form-help-next") }) : null,
    );
  }

  /** Remembers an answer that was judged; a right one starts anew. @param {Record<string, any>} answer @param {boolean} right */
  judged(answer, right) {
    const place = this.#place(answer);
    if (right) keep(this.key, null);
    else keep(this.key, [...this.#wrong.slice(0, place), printOf(answer)]);
  }

  /** How many different wrong answers came before this one. @param {Record<string, any>} answer */
  #place(answer) {
    const found = this.#wrong.indexOf(printOf(answer));
    return found < 0 ? this.#wrong.length : found;
  }

  /** @param {Record<string, any>} answer */
  #step(answer) {
    return this.steps[Math.min(this.#place(answer), this.steps.length - 1)];
  }

  /** @returns {string[]} */
  get #wrong() {
    return recall(this.key, []);
  }
}

/** The first fact that a verdict calls wrong. @param {Wire.Graded} graded */
function wrongFact({ links, departure }) {
  const wrong = (/** @type {Wire.Link} */ link) => FACTS.find((fact) => ["wrong", "missing"].includes(link[fact]));
  const link = links.find((entry) => wrong(entry) && (!departure || entry.row === departure.row)) ?? links.find(wrong);
  return link ? wrong(link) : null;
}

/** @param {string} heading @param {string} text */
function paragraph(heading, text) {
  return el("p", {}, el("strong", { text: heading }), ` ${text}`);
}

/** A short mark of an answer, however it is asked about. @param {Record<string, any>} answer */
function printOf({ help: _, attempt: __, ...answer }) {
  let hash = 5381;
  for (const character of JSON.stringify(answer)) hash = ((hash << 5) + hash + (character.codePointAt(0) ?? 0)) | 0;
  return hash.toString(36);
}
