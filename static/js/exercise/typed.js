/** What was typed into a field, as the service reads it: a decimal comma, where the language writes one, as a point. */

import { withPoint } from "../editor/model.js";
import { language } from "../i18n.js";

/** @param {HTMLInputElement | HTMLSelectElement} input */
export function typed(input) {
  const text = input.value.trim();
  return language === "en" ? text : withPoint(text);
}
