/** The attempts so far, newest first, each of which can be taken back into the form. */

import { el, fill } from "../dom.js";
import { language, t } from "../i18n.js";
import { plain } from "../numbers.js";

/** What an attempt earned, of all that the exercise has to give. @param {any} attempt */
function pointsOf({ score, verdict }) {
  const { points, max_points: total } = verdict?.total ?? { points: score * 100, max_points: 100 };
  return t("form-points", { points: plain(points, 1), total: plain(total, 1) });
}

/**
 * @param {HTMLElement} place @param {import("../attempts.js").Attempt[]} attempts
 * @param {(attempt: import("../attempts.js").Attempt) => void} restore @param {() => void} clear
 */
export function showHistory(place, attempts, restore, clear) {
  const when = new Intl.DateTimeFormat(language, { dateStyle: "medium", timeStyle: "short" });
  fill(
    place,
    el(
      "ol",
      { class: "history", reversed: true },
      [...attempts].reverse().map((attempt, i) => {
        const number = attempts.length - i;
        return el(
          "li",
          { class: "row", value: number },
          el("span", { class: `badge ${attempt.correct ? "good" : "warn"}`, text: pointsOf(attempt) }),
          el("time", { datetime: attempt.at, text: when.format(new Date(attempt.at)) }),
          el("button", {
            type: "button",
            class: "quiet small",
            "aria-label": `${t("form-history-restore")} (${number})`,
            onclick: () => restore(attempt),
            text: t("form-history-restore"),
          }),
        );
      }),
    ),
    el(
      "p",
      { class: "hint row" },
      el("span", { text: t("form-history-kept") }),
      el("button", { type: "button", class: "quiet small", onclick: clear, text: t("form-history-clear") }),
    ),
  );
}
