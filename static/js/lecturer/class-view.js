/** The class at a glance: every student and every link, and scores that did not arrive. */

import { LiveTable, liveButtons } from "../data-table.js";
import { el, fill } from "../dom.js";
import { named, ownDirection, t } from "../i18n.js";
import { percentOf } from "../numbers.js";
import { adviceFor } from "./score-advice.js";

/** @type {Record<string, string>} */
const TONES = { solved: "good", stuck: "bad", begun: "warn", opened: "", absent: "" };

/**
 * What a student is called: the name, where the platform shares it, and the beginning of the pseudonym, since two may have one name.
 * @param {any} options
 */
export function studentName({ name, key }) {
  const short = key.slice(0, 8);
  return name ? `${ownDirection(name)} (${short})` : short;
}

const COUNTS = ["absent", "opened", "begun", "stuck", "solved"];

/**
 * @typedef {{openLink: (link: any) => void, openStudent: (link: any, student: any) => void,
 *   openState: (link: any, state: string, students: any[]) => void}} Act
 */

/** The class, which is brought up to date and never made anew: whoever reads it with a keyboard keeps the place. */
export class ClassView {
  #students = /** @type {any[]} */ ([]);
  #links = /** @type {any[]} */ ([]);
  #nobody = el("p", { class: "hint", text: t("lecturer-nobody") });

  /** @param {HTMLElement} place @param {HTMLElement} refuge takes the focus where nothing is left that had it @param {Act} act */
  constructor(place, refuge, act) {
    this.act = act;
    const counts = COUNTS.map((name) => t(`lecturer-state-${name}`));
    const headings = [t("lecturer-link"), t("lecturer-exercise"), ...counts];
    this.summary = new LiveTable(
      t("lecturer-links"),
      headings,
      ({ id }) => id,
      () => this.#linkLine(),
      refuge,
    );
    this.people = new LiveTable(
      t("lecturer-students"),
      [],
      ({ key }) => key,
      () => this.#studentLine(),
      refuge,
    );
    this.place = place;
  }

  /** @param {any} found */
  show({ links, students }) {
    if (!this.summary.element.isConnected) fill(this.place, this.summary.element, this.people.element, this.#nobody);
    this.#links = links;
    this.#students = students;
    const titles = links.map((/** @type {any} */ { title, exercise_title: exercise }) => title || exercise || "–");
    this.people.headings = [t("lecturer-student"), ...titles];
    this.summary.show(links);
    this.people.show(students);
    this.#nobody.hidden = students.length > 0;
  }

  /** The row of a link: its title, and how many are in a state, which opens what is behind it. */
  #linkLine() {
    const button = liveButtons();
    return (/** @type {any} */ link) => {
      const exercise = link.exercise_title ?? t("lecturer-no-exercise");
      const title = button("link", link.title || exercise, () => this.act.openLink(link), { kind: "quiet" });
      const number = (/** @type {string} */ state) => {
        if (!link[state]) return 0;
        const label = named(t(`lecturer-state-${state}`), link[state]);
        return button(state, String(link[state]), () => this.#openState(link, state), { label });
      };
      return [title, exercise, ...COUNTS.map(number)];
    };
  }

  /** @param {any} link @param {string} state */
  #openState(link, state) {
    const own = this.#students.filter(({ links }) => (links[link.id]?.state ?? "absent") === state);
    this.act.openState(link, state, own);
  }

  /** The row of a student: how far each link is. */
  #studentLine() {
    const button = liveButtons();
    return (/** @type {any} */ student) => {
      const cell = (/** @type {any} */ link) => {
        const found = student.links[link.id];
        const state = found?.state ?? "absent";
        const said = t(`lecturer-state-${state}`);
        if (!found) return el("span", { class: "badge", text: said });
        const share = found.score === null ? "" : ` ${percentOf(found.score)}`;
        const text = found.attempts ? `${said}${share} (${found.attempts})` : said;
        return button(link.id, text, () => this.act.openStudent(link, student), { kind: `badge ${TONES[state]}` });
      };
      return [studentName(student), ...this.#links.map(cell)];
    };
  }
}

/** Scores that did not arrive at the platform. */
export class UndeliveredView {
  /** @param {HTMLElement} card @param {HTMLElement} place @param {HTMLElement} refuge @param {(link: number) => void} resend */
  constructor(card, place, refuge, resend) {
    this.card = card;
    const headings = ["student", "link", "score", "problem", "resend"].map((name) => t(`lecturer-${name}`));
    const line = () => {
      const button = liveButtons();
      return (/** @type {any} */ entry) => [
        studentName(entry),
        entry.title,
        percentOf(entry.score),
        el("span", {
          dataset: { code: entry.problem },
          text: `${t(`lecturer-problem-${adviceFor(entry)}`)} (${entry.problem})`,
        }),
        entry.dead ? button("resend", t("lecturer-resend"), () => resend(entry.link)) : t("lecturer-waiting"),
      ];
    };
    this.list = new LiveTable(t("lecturer-undelivered"), headings, ({ link, key }) => `${link} ${key}`, line, refuge);
    fill(place, el("p", { text: t("lecturer-undelivered-text") }), this.list.element);
  }

  /** @param {any[]} lost */
  show(lost) {
    this.list.show(lost);
    this.card.hidden = lost.length === 0;
  }
}
