/** One link: its numbers, the attempts behind them, its rules, what is done with it. */

import { Latest, Problem } from "../api.js";
import { dataTable } from "../data-table.js";
import { announce, el, fill } from "../dom.js";
import { dates, named, t } from "../i18n.js";
import { percentOf } from "../numbers.js";
import { problemNotice, telling } from "../problem.js";
import { studentName } from "./class-view.js";
import { linkNumbers, LISTED } from "./link-numbers.js";
import { linkWork } from "./link-work.js";
import { entryOf, settingsForm } from "./settings-form.js";

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
      const numbers = link.exercise ? linkNumbers(found, (...asked) => this.#opener(...asked)) : null;
      const rules = this.#rules(settings, choice);
      const act = { path: (/** @type {string} */ rest) => this.#path(rest, link), changed: this.act.changed };
      fill(body, numbers, this.behind, rules, link.exercise ? linkWork(this.api, link, settings, act) : null);
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
}
