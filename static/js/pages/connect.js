/** What a lecturer sends to the administrator of their platform: read, or copied as text. */

import { announce } from "../dom.js";
import { t } from "../i18n.js";
import { startPage } from "../page.js";

const letter = /** @type {HTMLElement} */ (document.getElementById("letter"));
const copy = /** @type {HTMLButtonElement} */ (document.getElementById("copy"));

function run() {
  copy.addEventListener("click", async () => {
    try {
      await navigator.clipboard.writeText(letter.innerText);
      announce(t("connect-copied"));
      copy.textContent = t("connect-copied");
    } catch {
      getSelection()?.selectAllChildren(letter); // the browser allows no writing: what is marked can be copied by hand
    }
  });
}

startPage(run);
