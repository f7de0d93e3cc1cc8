/** The list of exercises. */

import { browserAttempts } from "../attempts.js";
import { el, fill } from "../dom.js";
import { language, t } from "../i18n.js";
import { plain } from "../numbers.js";
import { api, pageAddress, startPage } from "../page.js";
import { problemNotice } from "../problem.js";

async function run() {
  const list = /** @type {HTMLElement} */ (document.getElementById("exercises"));
  try {
    const { exercises } = await api.get("exercises");
    exercises.sort(
      (/** @type {any} */ one, /** @type {any} */ other) =>
        one.joints - other.joints || one.title.localeCompare(other.title, language),
    );
    fill(list, await Promise.all(exercises.map(entry)));
  } catch (error) {
    fill(/** @type {HTMLElement} */ (document.getElementById("exercises-problem")), problemNotice(error));
  } finally {
    list.removeAttribute("aria-busy");
  }
}

/** @param {any} options */
async function entry({ id, title, summary, joints, points, parts }) {
  const attempts = await browserAttempts.list(id);
  const best = attempts.reduce((most, attempt) => Math.max(most, attempt.score), 0);
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
      el("h3", {}, el("a", { href: pageAddress(`exercises/${id}`), text: title })),
      summary ? el("p", { class: "hint", text: summary }) : null,
      el(
        "p",
        { class: "row" },
        el("span", { class: "badge", text: t("form-home-joints", { joints }) }),
        attempts.length
          ? el("span", {
              class: `badge ${best >= 1 ? "good" : "warn"}`,
              text: t("form-home-best", { points: plain(best * points, 1), total: plain(points, 1) }),
            })
          : null,
        parts.includes("table")
          ? el("a", { class: "trainer-link", href: pageAddress(`trainer/${id}`), text: t("form-home-trainer") })
          : null,
      ),
    ),
  );
}

startPage(run);
