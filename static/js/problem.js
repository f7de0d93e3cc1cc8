/** A refusal or a failure, as something to read. */

import { Problem } from "./api.js";
import { el, fill } from "./dom.js";
import { t } from "./i18n.js";

/** What to say of an error. @param {unknown} error @returns {string[]} */
function sentencesOf(error) {
  if (error instanceof Problem) return error.faults.map((fault) => fault.detail);
  return [t("form-unreachable")];
}

/** @param {unknown} error @param {{retry?: () => void}} [options] */
export function problemNotice(error, { retry } = {}) {
  const sentences = sentencesOf(error);
  return el(
    "div",
    { class: "notice notice-problem", role: "alert" },
    sentences.length === 1
      ? el("p", { text: sentences[0] })
      : el(
          "ul",
          {},
          sentences.map((sentence) => el("li", { text: sentence })),
        ),
    retry ? el("button", { type: "button", onclick: retry, text: t("form-retry") }) : null,
  );
}

/**
 * Work that says at a place what went wrong.
 * @param {HTMLElement} place @param {() => Promise<void>} work @returns {() => Promise<void>}
 */
export function telling(place, work) {
  return async () => {
    try {
      await work();
    } catch (error) {
      fill(place, problemNotice(error));
    }
  };
}
