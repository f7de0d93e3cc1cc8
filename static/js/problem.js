/** A refusal or a failure, as something to read. */

import { Problem } from "./api.js";
import { el, fill } from "./dom.js";
import { named, t } from "./i18n.js";

/** @type {Record<string, string>} */
const GREEK = { alpha: "α", theta: "θ" };

/**
 * What to say of an error, with the row and the column that it concerns, or the place that is named for it.
 * @param {unknown} error @param {(pointer: string) => string} placeOf @returns {string[]}
 */
function sentencesOf(error, placeOf) {
  const isOurs = error instanceof Problem && error.code; // a gateway's 502 or 413 has no sentence
  if (!isOurs) return [t("form-unreachable")];
  return error.faults.map(({ pointer, detail }) => {
    const [, grid, row, cell] = /\/(rows|joints)\/(\d+)\/(\w+)$/.exec(pointer ?? "") ?? [];
    const place = placeOf(pointer ?? "");
    if (!cell) return place ? named(place, detail) : detail;
    const name = grid === "joints" ? cell.toUpperCase() : (GREEK[cell] ?? cell);
    return named(t("form-row-cell", { row: Number(row) + 1, name }), detail);
  });
}

/** @param {unknown} error @param {{retry?: () => void, placeOf?: (pointer: string) => string}} [options] */
export function problemNotice(error, { retry, placeOf = () => "" } = {}) {
  const sentences = sentencesOf(error, placeOf);
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
 * Work that says at a place what went wrong; asked for again while it is under way, it is not begun anew.
 * @param {HTMLElement} place @param {() => Promise<void>} work @returns {() => Promise<void>}
 */
export function telling(place, work) {
  let underWay = false;
  return async () => {
    if (underWay) return;
    underWay = true;
    try {
      await work();
    } catch (error) {
      fill(place, problemNotice(error));
    } finally {
      underWay = false;
    }
  };
}
