/** Steps of a launch that need a script: the platform's storage, a window of its own, the end of a registration. */

import { el, fill } from "../dom.js";
import { t } from "../i18n.js";
import { root, startPage } from "../page.js";
import { readFrom, storeAt } from "../session/platform-storage.js";

const launch = /** @type {HTMLElement} */ (document.getElementById("launch"));
const { step, address = "", key = "", value = "", frame = "", origin = "", code = "", again = "" } = launch.dataset;

async function run() {
  if (step === "store") {
    await storeAt({ frame, origin }, key, value).catch(() => null); // the cookie may do
    location.replace(address);
  } else if (step === "compare") {
    const found = await readFrom({ frame, origin }, key).catch(() => "");
    post(`${root}lti/confirm`, { code, value: found });
  } else if (step === "window") {
    offerWindow();
  } else if (step === "close") {
    (window.opener ?? window.parent).postMessage({ subject: "org.imsglobal.lti.close" }, "*");
  }
}

/** The launch is begun again where the browser keeps cookies: in a window that is not framed. */
function offerWindow() {
  const form = formOf(`${root}lti/login`, Object.fromEntries(new URLSearchParams(again)));
  form.target = "_blank";
  form.rel = "noopener";
  form.append(el("button", { type: "submit", class: "primary", text: t("session-new-window") }));
  launch.append(form);
}

/** @param {string} action @param {Record<string, string>} fields */
function post(action, fields) {
  const form = formOf(action, fields);
  launch.append(form);
  form.submit();
}

/** @param {string} action @param {Record<string, string>} fields */
function formOf(action, fields) {
  const form = /** @type {HTMLFormElement} */ (el("form", { method: "post", action }));
  fill(
    form,
    Object.entries(fields).map(([name, text]) => el("input", { type: "hidden", name, value: text })),
  );
  return form;
}

startPage(run);
