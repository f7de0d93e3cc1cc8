/** The attempts so far, newest first, each of which can be taken back into the form. */

import { el, fill } from "../dom.js";
import { dates, t } from "../i18n.js";
import { pointsText } from "./progress.js";

/**
 * @param {HTMLElement} place @param {import("../attempts.js").Attempt[]} attempts @param {number} total points of the exercise
 * @param {(attempt: import("../attempts.js").Attempt) => void} restore
 * @param {(() => void) | null} clear forgets them; null: the course keeps them
 */
export function showHistory(place, attempts, total, restore, clear) {
  const when = dates({ dateStyle: "medium", timeStyle: "short" });
  fill(
    place,
    el(
      "ol",
      { class: "history", reversed: true },
      [...attempts].reverse().map((attempt, i) => {
        const number = attempt.number ?? attempts.length - i;
        return el(
          "li",
          { class: "row", value: number },
          el("span", {
            class: `badge ${attempt.score === null ? "" : attempt.correct ? "good" : "warn"}`,
            text: attempt.score === null ? t("session-handed-in") : pointsText(attempt.score * total, total),
          }),
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
      el("span", { text: t(clear ? "form-history-kept" : "session-attempts-kept") }),
      (attempts[0]?.number ?? 1) > 1 && el("span", { text: t("session-attempts-latest", { count: attempts.length }) }),
      clear && el("button", { type: "button", class: "quiet small", onclick: clear, text: t("form-history-clear") }),
    ),
  );
}
