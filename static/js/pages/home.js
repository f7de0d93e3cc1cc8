/** The list of exercises. */

import { browserAttempts } from "../attempts.js";
import { el, fill } from "../dom.js";
import { language, t } from "../i18n.js";
import { pointsTold } from "../numbers.js";
import { api, pageAddress, startPage } from "../page.js";
import { problemNotice } from "../problem.js";

/** Parts of one exercise about a robot's table; any other part is a subject of its own. */
const ABOUT_THE_TABLE = ["table", "schematic", "link_matrices", "transform", "pose", "workspace"];

/** Subjects in the order of a course; any other comes last. */
const AS_TAUGHT = [
  ...["table", "frames", "orientation", "rotation_check", "frame_chain", "inverse_kinematics"],
  ...["jacobian", "jacobian_form", "singularities", "screws", "equations_of_motion"],
];

async function run() {
  const list = /** @type {HTMLElement} */ (document.getElementById("exercises"));
  try {
    const { exercises } = await api.get("exercises");
    exercises.sort(
      (/** @type {any} */ one, /** @type {any} */ other) =>
        one.joints - other.joints || one.title.localeCompare(other.title, language),
    );
    const subjects = Map.groupBy(exercises, subjectOf);
    const order = [...subjects.keys()].sort((one, other) => place(one) - place(other));
    const groups = order.map((subject) => group(subject, subjects.get(subject) ?? []));
    fill(list, contents(order, subjects), await Promise.all(groups));
    document.getElementById(location.hash.slice(1))?.scrollIntoView();
  } catch (error) {
    fill(/** @type {HTMLElement} */ (document.getElementById("exercises-problem")), problemNotice(error));
  } finally {
    list.removeAttribute("aria-busy");
  }
}

/** What an exercise is about: the kind of its part. @param {{parts: string[]}} exercise */
function subjectOf({ parts }) {
  return parts.find((kind) => !ABOUT_THE_TABLE.includes(kind)) ?? "table";
}

/** @param {string} subject */
function place(subject) {
  const found = AS_TAUGHT.indexOf(subject);
  return found < 0 ? AS_TAUGHT.length : found;
}

/** Links to the subjects, with the number of exercises. @param {string[]} order @param {Map<string, any[]>} subjects */
function contents(order, subjects) {
  const entries = order.map((subject) =>
    el(
      "li",
      {},
      el("a", { href: `#${subject}` }, titleOf(subject), el("span", { text: ` ${subjects.get(subject)?.length}` })),
    ),
  );
  return el("nav", { class: "subjects", "aria-label": t("form-home-subjects") }, el("ul", {}, entries));
}

/** @param {string} subject */
function titleOf(subject) {
  return t(`form-part-${subject.replaceAll("_", "-")}`);
}

/** @param {string} subject @param {any[]} exercises */
async function group(subject, exercises) {
  const title = titleOf(subject);
  return el(
    "section",
    { id: subject, class: "subject", "aria-label": title },
    el("h3", { class: "section-title", text: title }),
    el("ul", { class: "exercise-list" }, await Promise.all(exercises.map(entry))),
  );
}

/** @param {any} options */
async function entry({ id, title, summary, joints, points, parts }) {
  const attempts = await browserAttempts.list(id);
  const best = attempts.reduce((most, attempt) => Math.max(most, attempt.score ?? 0), 0);
  return el(
    "li",
    { class: "card exercise-card" },
    el("img", {
      src: api.address(`exercises/${id}/figure.svg?lang=${language}`),
      alt: "",
      width: 320,
      height: 220,
      loading: "lazy",
      class: "figure-paper",
    }),
    el(
      "div",
      { class: "exercise-text" },
      el("h4", {}, el("a", { href: pageAddress(`exercises/${id}`), text: title })),
      summary ? el("p", { class: "hint", text: summary }) : null,
      el(
        "p",
        { class: "row" },
        el("span", { class: "badge", text: t("form-home-joints", { joints }) }),
        attempts.length
          ? el("span", {
              class: `badge ${best >= 1 ? "good" : "warn"}`,
              text: t("form-home-best", { points: pointsTold(best * points), total: pointsTold(points) }),
            })
          : null,
        subjectOf({ parts }) === "table"
          ? el("a", { class: "trainer-link", href: pageAddress(`trainer/${id}`), text: t("form-home-trainer") })
          : null,
      ),
    ),
  );
}

startPage(run);
