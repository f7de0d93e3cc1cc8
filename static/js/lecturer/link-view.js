/** One link: its numbers, the attempts behind them, its rules, regrading, export. */

import { Latest, Problem } from "../api.js";
import { dataTable } from "../data-table.js";
import { announce, el, fill } from "../dom.js";
import { partName } from "../exercise/progress.js";
import { dates, knows, named, t } from "../i18n.js";
import { percentOf } from "../numbers.js";
import { pageAddress } from "../page.js";
import { problemNotice, telling } from "../problem.js";
import { barChart } from "./chart.js";
import { studentName } from "./class-view.js";
import { entryOf, settingsForm } from "./settings-form.js";

const DAYS = 40;
/** Attempts that the service lists at most. */
const LISTED = 200;

export class LinkView {
  #shown = new Latest();
  #listed = new Latest();

  /**
   * @param {import("../api.js").Api} api @param {any[]} exercises
   * @param {{card: HTMLElement, heading: HTMLElement, body: HTMLElement}} places
   * @param {{openAttempt: (id: number) => void, changed: () => Promise<any>}} act
   */
  constructor(api, exercises, places, act) {
    this.api = api;
    this.exercises = exercises;
    this.places = places;
    this.act = act;
    this.behind = el("div", { class: "stack" });
    this.link = /** @type {any} */ (null);
  }

  /**
   * Shows a link once all of it is here: until then the one before stands, whose rules are saved for it alone.
   * @param {any} link
   * @returns {Promise<boolean>} false if another link was asked for in the meantime
   */
  async show(link) {
    const { body } = this.places;
    try {
      const answer = await this.#shown.run((signal) => this.#ask(link, signal));
      if (!answer) return false;
      const { settings, found, choice } = answer.value;
      this.#begin(link);
      const numbers = link.exercise ? [this.#numbers(found), this.#mistakes(found), this.#unexplained(found)] : [];
      const rules = this.#rules(settings, choice);
      fill(body, numbers, this.behind, rules, link.exercise ? this.#work(settings) : null);
    } catch (error) {
      this.#begin(link);
      fill(body, problemNotice(error));
    }
    return true;
  }

  /** @param {any} link @param {AbortSignal} signal */
  async #ask(link, signal) {
    const settings = await this.api.get(this.#path("settings", link), { signal });
    const found = await this.api.get(this.#path("statistics", link), { signal });
    return { settings, found, choice: await this.#choice(settings) };
  }

  /** @param {any} link whose numbers and rules come now */
  #begin(link) {
    const { card, heading } = this.places;
    this.link = link;
    this.#listed.cancel();
    card.hidden = false;
    heading.textContent = link.title || link.exercise || t("lecturer-no-exercise");
    fill(this.behind);
  }

  /** @param {any} link @param {any} student */
  async showStudent(link, student) {
    if (!(await this.show(link)) || !(await this.#open({ person: student.key }))) return;
    this.behind.prepend(el("h3", { text: studentName(student) }), this.#allowance(student));
    this.behind.scrollIntoView({ block: "nearest" });
  }

  /**
   * Those who are in a state of the class overview: their attempts, or who they are, where they have made none.
   * @param {any} link @param {string} state @param {any[]} students
   */
  async showState(link, state, students) {
    if (!(await this.show(link))) return;
    if (state === "absent" || state === "opened") {
      const heading = t(`lecturer-state-${state}`);
      const names = students.map((student) => el("li", { text: studentName(student) }));
      fill(this.behind, el("h3", { text: heading }), el("ul", { class: "names" }, names));
      announce(named(heading, students.length));
    } else if (!(await this.#open({ state }))) return;
    this.behind.scrollIntoView({ block: "nearest" });
  }

  /** @param {any} rest @param {any} [link] */
  #path(rest, link = this.link) {
    return `course/links/${link.id}/${rest}`;
  }

  /** @param {any} options */
  #numbers({ attempts, students, solved, first_attempt_rate: first, days, sequence }) {
    const percent = first === null ? "–" : percentOf(first);
    const facts = [
      [t("lecturer-attempts-made"), this.#opener(attempts, {})],
      [t("lecturer-students"), this.#opener(students, {})],
      [t("lecturer-solved"), this.#opener(solved, { outcome: "solved" })],
      [t("lecturer-first-rate"), this.#opener(first ?? 0, { number: 1, correct: true }, percent)],
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
          this.#opener(all, { day }),
          this.#opener(correct, { day, correct: true }),
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
          this.#opener(step.reached, { number: step.attempt, outcome: "reached" }),
          this.#opener(step.solved, { number: step.attempt, outcome: "solved" }),
          this.#opener(step.dropped_out, { number: step.attempt, outcome: "left" }),
        ]),
      ),
    ];
  }

  /** @param {any} options */
  #mistakes({ misconceptions }) {
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
          this.#opener(entry.attempts, { kind: entry.kind, code: entry.code }),
          this.#opener(entry.students, { kind: entry.kind, code: entry.code }),
          entry.example ?? "–",
        ]),
      ),
    ];
  }

  /** @param {any} options */
  #unexplained({ unexplained }) {
    if (!unexplained.length) return null;
    return [
      el("h3", { text: t("lecturer-unexplained") }),
      dataTable(
        t("lecturer-unexplained"),
        [t("lecturer-does-not-fit"), t("lecturer-attempts-made")],
        unexplained.map((/** @type {any} */ { facts, attempts }) => [
          facts.map(factName).join(", "),
          this.#opener(attempts.length, { ids: attempts.slice(0, LISTED).join(",") }),
        ]),
      ),
    ];
  }

  /**
   * A number that opens the attempts behind it.
   * @param {number} count @param {Record<string, any>} asked @param {string} [text] how the number is written
   */
  #opener(count, asked, text = String(count)) {
    if (!count) return text;
    const label = t("lecturer-open-attempts", { count });
    return el("button", {
      type: "button",
      class: "quiet small",
      "aria-label": text === String(count) ? label : named(text, t("lecturer-attempts-made")),
      onclick: () => this.#open(asked),
      text,
    });
  }

  /** Lists attempts, or says why not. @param {Record<string, any>} asked @returns {Promise<boolean>} false if others were asked for in the meantime */
  async #open(asked) {
    let stands = true;
    await telling(this.behind, async () => {
      stands = await this.#list(asked);
    })();
    return stands;
  }

  /** @param {Record<string, any>} asked */
  async #list(asked) {
    const address = this.#path(`attempts?${new URLSearchParams(asked)}`);
    const answer = await this.#listed.run((signal) => this.api.get(address, { signal }));
    if (!answer) return false;
    const { attempts } = answer.value;
    const when = dates({ dateStyle: "short", timeStyle: "short" });
    fill(
      this.behind,
      el("h3", { text: t("lecturer-attempts-made") }),
      attempts.length >= LISTED ? el("p", { class: "hint", text: t("lecturer-latest", { count: LISTED }) }) : null,
      dataTable(
        t("lecturer-attempts-made"),
        [t("lecturer-student"), t("lecturer-attempt"), t("lecturer-time"), t("lecturer-score"), t("lecturer-open")],
        attempts.map((/** @type {any} */ attempt) => [
          studentName(attempt),
          attempt.number,
          when.format(new Date(attempt.at)),
          percentOf(attempt.score),
          el("button", {
            type: "button",
            class: "quiet small",
            onclick: () => this.act.openAttempt(attempt.id),
            text: t("lecturer-open"),
          }),
        ]),
      ),
    );
    announce(t("lecturer-open-attempts", { count: attempts.length }));
    return true;
  }

  /** @param {any} student */
  #allowance(student) {
    const given = student.links[this.link.id] ?? { extra_seconds: 0, extra_attempts: 0 };
    const minutes = el("input", {
      type: "number",
      required: true,
      min: 0,
      max: 527040,
      value: given.extra_seconds / 60,
    });
    const attempts = el("input", { type: "number", required: true, min: 0, max: 1000, value: given.extra_attempts });
    const said = el("div", { role: "status" });
    const give = telling(said, async () => {
      fill(said);
      if (![minutes, attempts].every((/** @type {any} */ field) => field.reportValidity())) return;
      const value = (/** @type {any} */ field) => Number(field.value);
      await this.api.post(this.#path("allowances"), {
        person: student.key,
        extra_minutes: value(minutes),
        extra_attempts: value(attempts),
      });
      fill(said, el("span", { class: "badge good", text: t("lecturer-saved") }));
      await this.act.changed();
    });
    return el(
      "div",
      { class: "row", role: "group", "aria-label": studentName(student) },
      el("label", { class: "row" }, t("lecturer-extra-minutes"), minutes),
      el("label", { class: "row" }, t("lecturer-extra-attempts"), attempts),
      el("button", { type: "button", onclick: give, text: t("lecturer-give") }),
      said,
    );
  }

  /** The exercises among which the link's own always is: a published one stands in no list. @param {any} settings */
  async #choice({ exercise, parts }) {
    if (!exercise || this.exercises.some(({ id }) => id === exercise)) return this.exercises;
    try {
      return [entryOf(await this.api.get(`exercises/${encodeURIComponent(exercise)}`)), ...this.exercises];
    } catch (error) {
      if (!(error instanceof Problem)) throw error;
      return [{ id: exercise, title: exercise, parts }, ...this.exercises];
    }
  }

  /** @param {any} settings @param {any[]} exercises */
  #rules(settings, exercises) {
    const said = el("div", { role: "status" });
    const { link } = this;
    let saving = false; // a second press would be refused: the rules would have changed since they were read
    const save = async (/** @type {any} */ chosen) => {
      if (saving) return;
      saving = true;
      try {
        await this.api.put(this.#path("settings", link), { ...chosen, version: settings.version });
        link.exercise = chosen.exercise;
        await this.act.changed();
        if (!(await this.show(link))) return;
        fill(this.behind, el("p", { class: "notice notice-good", text: t("lecturer-saved") }));
        announce(t("lecturer-saved"));
        this.behind.scrollIntoView({ block: "nearest" });
      } catch (error) {
        fill(said, problemNotice(error));
      } finally {
        saving = false;
      }
    };
    const open = !settings.exercise;
    return el(
      "details",
      { open },
      el("summary", {}, el("h3", { text: t("lecturer-rules") })),
      settingsForm(exercises, settings, save, t("lecturer-save")),
      said,
    );
  }

  /** @param {any} settings */
  #work({ mode, feedback }) {
    const said = el("div", { class: "stack", role: "status" });
    const { link } = this;
    const release = telling(said, async () => {
      await this.api.post(this.#path("release"), {});
      link.released = true;
      releasing.remove();
      fill(said, el("p", { text: t("lecturer-released") }));
    });
    const askFirst = async () =>
      fill(
        said,
        el("p", { class: "notice notice-warn", text: t("lecturer-release-sure") }),
        el(
          "div",
          {},
          el("button", { type: "button", class: "primary", onclick: release, text: t("lecturer-release-now") }),
        ),
      );
    const preview = async () => {
      const { exercise, code } = await this.api.post(this.#path("preview"), {});
      const address = `${pageAddress(`exercises/${exercise}`)}#session=${code}`;
      const link = el("a", { href: address, target: "_blank", rel: "noopener", text: t("lecturer-preview-open") });
      fill(said, el("p", {}, link), el("p", { class: "hint", text: t("lecturer-preview-text") }));
      link.focus();
    };
    const regrade = async (/** @type {string} */ scope) => {
      fill(said, el("p", { text: t("form-loading") }));
      const { run, changes, unread } = await this.api.post(this.#path("regradings"), { scope });
      const apply = telling(said, async () => {
        await this.api.post(this.#path(`regradings/${run}/apply`), {});
        await this.act.changed();
        fill(said, el("p", { text: t("lecturer-applied") }));
      });
      const row = (/** @type {any} */ { before, ...entry }) => [studentName(entry), entry.number, percentOf(before)];
      const rows = changes.map((/** @type {any} */ entry) => [...row(entry), percentOf(entry.after)]);
      const kept = [t("lecturer-student"), t("lecturer-attempt"), t("lecturer-before")];
      const headings = [...kept, t("lecturer-after")];
      fill(
        said,
        changes.length ? dataTable(t("lecturer-changes"), headings, rows) : el("p", { text: t("lecturer-no-changes") }),
        changes.length
          ? el("button", { type: "button", class: "primary", onclick: apply, text: t("lecturer-apply") })
          : null,
        unread.length ? dataTable(t("lecturer-unread"), kept, unread.map(row)) : null,
      );
    };
    /** @param {string} text @param {() => Promise<void>} work */
    const button = (text, work) => el("button", { type: "button", onclick: telling(said, work), text });
    const releasing = button(t("lecturer-release"), askFirst);
    const isWithheld = !link.released && (mode === "exam" || feedback !== "at_once");
    return el(
      "section",
      { class: "stack" },
      link.released ? el("p", { class: "hint", text: t("lecturer-released") }) : null,
      el(
        "p",
        { class: "row no-print" },
        button(t("lecturer-preview"), preview),
        isWithheld ? releasing : null,
        button(t("lecturer-regrade-counted"), () => regrade("counted")),
        button(t("lecturer-regrade-all"), () => regrade("all")),
        button("CSV", () => this.#download("csv")),
        button("JSON", () => this.#download("json")),
      ),
      said,
    );
  }

  /** A file with every attempt; the token goes in a header, so that no address holds it. @param {string} form */
  async #download(form) {
    const answer = await fetch(this.api.address(this.#path(`export.${form}`)), {
      headers: { Authorization: `Bearer ${this.api.token}` },
      credentials: "omit",
    });
    if (!answer.ok) throw new Problem(answer.status, await answer.json());
    const address = URL.createObjectURL(await answer.blob());
    const anchor = /** @type {HTMLAnchorElement} */ (el("a", { href: address, download: `attempts.${form}` }));
    anchor.click();
    setTimeout(() => URL.revokeObjectURL(address), 10_000);
  }
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
