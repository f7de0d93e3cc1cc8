/** A student's work at an exercise in a course: what is typed and handed in is stored at the service. */

import { Latest, pauseAfter, Problem, Throttled } from "../api.js";
import { debounced, el, fill } from "../dom.js";
import { dates, t } from "../i18n.js";
import { percentOf, pointsTold } from "../numbers.js";
import { warnAbove } from "../page.js";
import { keep, recall } from "../storage.js";
import { isRefused, signedIn } from "./session.js";

const PAUSE = 1500;
const LONGEST_WAIT = 2 ** 31 - 1;
/** How often an answer is sent again by itself where the service is busy. */
const TRIES_AGAIN = 3;
/** Status of a refusal because somebody has asked for too much in a minute. */
const TOO_MANY = 429;

/** @typedef {import("../attempts.js").AttemptStore} AttemptStore */
/** @typedef {{request: string, key: string, arrival: string}} Sent a submission under way, its key and its ticket */

/** A student's exercise in a course: attempts and draft are kept at the service. */
export class CourseSession {
  #api;
  #store;
  /** @type {any} */
  #told;
  /** Milliseconds that this computer's clock is behind the service's. */
  #behind = 0;
  /** Drafts go one after another: one that is slow on its way never takes the place of a later one. */
  #drafts = new Throttled(0);
  #failures = 0;
  #reopening = new Latest();

  /** @param {import("../api.js").Api} api @param {any} told what the service says of the session */
  constructor(api, told) {
    this.#api = api;
    this.told = told;
    /** @type {string | null} what the exercise was when this page was opened */
    this.version = told.version;
    this.seed = told.seed;
    this.total = 0;
    this.banner = el("section", { class: "card session-banner", "aria-label": t("session-heading") });
    this.isTold = false;
    /** @type {unknown} */
    this.typed = null;
    this.#store = debounced((/** @type {unknown} */ state) => this.#drafts.run(() => this.#put(state)), PAUSE);
    this.#show();
    this.#awaitChange();
  }

  get told() {
    return this.#told;
  }

  set told(told) {
    this.#told = told;
    this.#behind = Date.parse(told.now) - Date.now();
  }

  /** What time it is at the service. */
  get #now() {
    return Date.now() + this.#behind;
  }

  /** Has the service keep what is typed, soon; until it has, this browser knows of it. @param {unknown} state */
  draft(state) {
    this.#reopening.cancel();
    this.typed = state;
    keep(this.#unsent, this.#now);
    this.#store(state);
  }

  /** @param {unknown} state */
  async #put(state) {
    try {
      await this.#api.put("session/draft", state);
      this.#failures = 0;
      if (this.typed === state) keep(this.#unsent, null);
    } catch (error) {
      if (!(error instanceof Problem) || error.passing) this.#putLater(state, error);
      if (this.isTold || !isRefused(error)) return;
      this.isTold = true;
      warnAbove(/** @type {Error} */ (error).message);
    }
  }

  /** Has what could not be stored now stored later, unless more is typed: nobody may type again. @param {unknown} state @param {unknown} error */
  #putLater(state, error) {
    this.#failures += 1;
    const pause = pauseAfter(this.#failures, error instanceof Problem ? error.wait : 0);
    setTimeout(() => this.typed === state && this.#store(state), pause);
  }

  /** Asks how things stand; where the service cannot be reached, what was told last holds, and so does the clock. */
  async #refresh() {
    const told = await this.#api.get("session").catch(() => null);
    if (told) this.told = told;
    this.#show();
  }

  /**
   * What was typed last, in whatever browser, and what else was: this browser's may not have reached the service.
   * @param {any} here what this browser keeps
   * @returns {{state: any, other: {state: any, at: string} | null}}
   */
  latest(here) {
    const { draft } = this.told;
    const typed = Number(recall(this.#unsent, 0));
    if (!draft) return { state: here, other: null };
    if (!typed || !here || JSON.stringify(here) === JSON.stringify(draft.state))
      return { state: draft.state, other: null };
    const own = { state: here, at: dayAndTime(typed) };
    const stored = { state: draft.state, at: dayAndTime(draft.at) };
    return typed > Date.parse(draft.at) ? { ...own, other: stored } : { ...stored, other: own };
  }

  /** When attempts open or close while the page is open, the banner says so. */
  #awaitChange() {
    const { opens, closes } = this.told;
    const waits = [opens, closes].map((time) => Date.parse(time) - this.#now).filter((wait) => wait > 0);
    if (waits.length === 0) return;
    setTimeout(
      async () => {
        await this.#refresh();
        this.#awaitChange();
      },
      Math.min(...waits, LONGEST_WAIT),
    );
  }

  /** What the exercise is worth; the banner says by it what counts. @param {number} total */
  set points(total) {
    this.total = total;
    this.#show();
  }

  /** Names what this browser keeps for this person at this link and for no other. */
  get key() {
    return `${this.told.link.id}:${this.told.person.key}`;
  }

  /**
   * Hands in. An answer that was lost on its way is asked for again under the same key, also after a reload: it is one
   * attempt, however often it is sent. One that the service could not take counts as of when it was sent first.
   * @param {unknown} request @param {unknown} form @returns {Promise<any>}
   */
  async submit(request, form) {
    this.#reopening.cancel();
    const sent = this.#sentOf(JSON.stringify(request));
    let graded;
    try {
      const body = {
        .../** @type {any} */ (request),
        form,
        seed: this.seed,
        ...(this.version ? { version: this.version } : {}),
      };
      graded = await this.#api.post("session/attempts", body, { ...sent, patience: TRIES_AGAIN });
    } catch (error) {
      if (error instanceof Problem && (error.status >= 500 || error.status === TOO_MANY))
        keep(this.#sent, { ...sent, arrival: error.arrival });
      else if (error instanceof Problem) this.#forgetSent();
      throw error;
    }
    this.#forgetSent();
    await this.#refresh();
    return graded;
  }

  /** Whether an attempt was made at the exercise as it is now. @param {import("../attempts.js").Attempt} attempt */
  isCurrent({ version }) {
    return version === this.version;
  }

  /** An attempt with what was found of it, as far as it may be shown now. @param {number} number @returns {Promise<any>} */
  attempt(number) {
    return this.#api.get(`session/attempts/${number}`);
  }

  /**
   * An attempt to go on with; null if another one is wanted, or something is typed or handed in, before all of it is here.
   * @template Found
   * @param {number} number @param {(attempt: any) => Promise<Found>} more brings what is shown with it
   * @returns {Promise<Found | null>}
   */
  async reopen(number, more) {
    const found = await this.#reopening.run(async () => more(await this.attempt(number)));
    return found && found.value;
  }

  /** What a submission is sent with: as before, if it has had no answer. @param {string} request @returns {Sent} */
  #sentOf(request) {
    const before = recall(this.#sent, { request: "", key: "", arrival: "" });
    if (before.request === request) return before;
    const sent = { request, key: randomKey(), arrival: "" };
    keep(this.#sent, sent);
    return sent;
  }

  #forgetSent() {
    keep(this.#sent, null);
  }

  /** Where the browser keeps what was sent and has had no answer. */
  get #sent() {
    return `sent:${this.key}`;
  }

  /** Where the browser keeps that the service has not stored what was typed. */
  get #unsent() {
    return `unsent:${this.key}`;
  }

  /** @type {AttemptStore} */
  get attempts() {
    return {
      list: async () =>
        this.told.attempts.map((/** @type {any} */ { number, version, at, score, correct }) => ({
          number,
          version,
          at,
          score: score ?? null,
          correct: Boolean(correct),
          submission: null,
          verdict: null,
        })),
      add: async () => undefined,
      clear: async () => undefined,
    };
  }

  #show() {
    const {
      attempts_allowed: allowed,
      attempts_made: made,
      counting,
      penalty,
      opens,
      closes,
      grade,
      gradebook,
      refusal,
      return_url: back,
    } = this.told;
    const isBefore = (/** @type {string | null} */ time) => time !== null && this.#now < Date.parse(time);
    const facts = [
      el("span", {
        text: signedIn(this.told),
      }),
      el("span", {
        text: allowed === null ? t("session-attempts", { made }) : t("session-attempts-of", { made, allowed }),
      }),
      counting !== "best" && allowed !== 1 ? el("span", { text: t("session-counting", { counting }) }) : null,
      penalty > 0 && allowed !== 1 ? el("span", { text: t("session-penalty", { percent: percentOf(penalty) }) }) : null,
      isBefore(opens) ? el("span", { text: t("session-opens", { when: dayAndTime(opens) }) }) : null,
      closes ? el("span", { text: t("session-closes", { when: dayAndTime(closes) }) }) : null,
      grade
        ? el("span", {
            class: "badge good",
            text: t("session-grade", { points: pointsTold(grade.score * this.total), total: pointsTold(this.total) }),
          })
        : null,
      grade && gradebook ? el("span", { text: t("session-gradebook", { percent: percentOf(grade.score) }) }) : null,
      refusal ? el("span", { class: "badge warn", text: t("session-no-more") }) : null,
      closes && !refusal && !isBefore(closes) ? el("span", { class: "badge warn", text: t("session-late") }) : null,
      this.told.attempts.every((/** @type {any} */ attempt) => this.isCurrent(attempt))
        ? null
        : el("span", { class: "badge warn", text: t("session-exercise-changed") }),
      back ? el("a", { href: back, target: "_top", text: t("session-back") }) : null,
    ];
    fill(this.banner, el("p", { class: "row" }, facts));
  }
}

/** @param {string | number} time */
function dayAndTime(time) {
  const day = /** @type {const} */ ({ year: "numeric", month: "short", day: "numeric" });
  const zoned = /** @type {const} */ ({ ...day, hour: "numeric", minute: "2-digit", timeZoneName: "short" });
  return dates(zoned).format(new Date(time));
}

/** 128 random bits; also where a page without TLS has no `randomUUID`. */
function randomKey() {
  return [...crypto.getRandomValues(new Uint8Array(16))].map((byte) => byte.toString(16).padStart(2, "0")).join("");
}
