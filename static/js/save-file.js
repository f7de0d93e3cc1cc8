/** Files that a page hands over. */

import { el } from "./dom.js";

/** How long a browser may take to begin [ms]. */
const BEGUN = 10_000;

/** Has the browser save a file. @param {Blob} file @param {string} name */
export function saveFile(file, name) {
  const href = URL.createObjectURL(file);
  el("a", { href, download: name }).click();
  setTimeout(() => URL.revokeObjectURL(href), BEGUN);
}
