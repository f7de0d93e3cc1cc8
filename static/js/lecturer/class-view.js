/** The class at a glance: every student and every link, and scores that did not arrive. */

import { dataTable } from "../data-table.js";
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

/**
 * @param {HTMLElement} place @param {any} found
 * @param {{openLink: (link: any) => void, openStudent: (link: any, student: any) => void,
 *   openState: (link: any, state: string, students: any[]) => void}} act
 */
export function showClass(place, { links, students }, { openLink, openStudent, openState }) {
  const counts = ["absent", "opened", "begun", "stuck", "solved"];
  /** How many are in a state, which opens what is behind it. @param {any} link @param {string} state */
  const number = (link, state) => {
    if (!link[state]) return 0;
    const own = students.filter((/** @type {any} */ each) => (each.links[link.id]?.state ?? "absent") === state);
    return el("button", {
      type: "button",
      class: "quiet small",
      "aria-label": named(t(`lecturer-state-${state}`), link[state]),
      onclick: () => openState(link, state, own),
      text: String(link[state]),
    });
  };
  const summary = dataTable(
    t("lecturer-links"),
    [t("lecturer-link"), t("lecturer-exercise"), ...counts.map((name) => t(`lecturer-state-${name}`))],
    links.map((/** @type {any} */ link) => [
      el("button", {
        type: "button",
        class: "quiet",
        onclick: () => openLink(link),
        text: link.title || link.exercise_title || t("lecturer-no-exercise"),
      }),
      link.exercise_title ?? t("lecturer-no-exercise"),
      ...counts.map((name) => number(link, name)),
    ]),
  );
  /** @param {any} student @param {any} link */
  const cell = (student, link) => {
    const found = student.links[link.id];
    const state = found?.state ?? "absent";
    const said = t(`lecturer-state-${state}`);
    if (!found) return el("span", { class: "badge", text: said });
    const share = found.score === null ? "" : ` ${percentOf(found.score)}`;
    return el("button", {
      type: "button",
      class: `badge ${TONES[state]}`,
      onclick: () => openStudent(link, student),
      text: found.attempts ? `${said}${share} (${found.attempts})` : said,
    });
  };
  const people = dataTable(
    t("lecturer-students"),
    [
      t("lecturer-student"),
      ...links.map((/** @type {any} */ { title, exercise_title: exercise }) => title || exercise || "–"),
    ],
    students.map((/** @type {any} */ student) => [
      studentName(student),
      ...links.map((/** @type {any} */ link) => cell(student, link)),
    ]),
  );
  fill(place, summary, students.length ? people : el("p", { class: "hint", text: t("lecturer-nobody") }));
}

/** @param {HTMLElement} card @param {HTMLElement} place @param {any[]} lost @param {(link: number) => void} resend */
export function showUndelivered(card, place, lost, resend) {
  card.hidden = lost.length === 0;
  fill(
    place,
    el("p", { text: t("lecturer-undelivered-text") }),
    dataTable(
      t("lecturer-undelivered"),
      [t("lecturer-student"), t("lecturer-link"), t("lecturer-score"), t("lecturer-problem"), t("lecturer-resend")],
      lost.map((entry) => [
        studentName(entry),
        entry.title,
        percentOf(entry.score),
        el("span", {
          dataset: { code: entry.problem },
          text: `${t(`lecturer-problem-${adviceFor(entry)}`)} (${entry.problem})`,
        }),
        entry.dead
          ? el("button", {
              type: "button",
              class: "quiet small",
              onclick: () => resend(entry.link),
              text: t("lecturer-resend"),
            })
          : t("lecturer-waiting"),
      ]),
    ),
  );
}
