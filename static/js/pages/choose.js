/** A teacher chooses the exercise of a link; the answer is posted to the platform, signed by the service. */

import { el, fill } from "../dom.js";
import { t } from "../i18n.js";
import { entryOf, settingsForm } from "../lecturer/settings-form.js";
import { api, pageAddress, startPage } from "../page.js";
import { problemNotice } from "../problem.js";

const place = /** @type {HTMLElement} */ (document.getElementById("choose"));

async function run() {
  try {
    await offer();
  } catch (error) {
    fill(place, problemNotice(error, { retry: () => location.reload() }));
  }
}

async function offer() {
  const asked = new URLSearchParams(location.hash.slice(1));
  const choice = asked.get("choice") ?? "";
  const { exercises } = await api.get("exercises");
  const published = asked.get("exercise");
  if (published) exercises.unshift(entryOf(await api.get(`exercises/${encodeURIComponent(published)}`)));
  const problem = el("div", {});
  let sending = false;
  const form = settingsForm(exercises, { points: 10, exercise: published ?? "" }, send, t("lecturer-insert"));
  const own = pageAddress(`author#choice=${encodeURIComponent(choice)}`);
  fill(
    place,
    el("p", { class: "hint", text: t("lecturer-choose-text") }),
    el("p", {}, el("a", { href: own, text: t("lecturer-choose-own") })),
    form,
    problem,
  );

  /** @param {any} settings */
  async function send(settings) {
    if (sending) return; // a second answer would make a second link
    sending = true;
    try {
      const { address, jwt } = await api.post("deep-links", { ...settings, choice });
      const answer = /** @type {HTMLFormElement} */ (
        el("form", { method: "post", action: address }, el("input", { type: "hidden", name: "JWT", value: jwt }))
      );
      place.append(answer);
      answer.submit();
    } catch (error) {
      sending = false;
      fill(problem, problemNotice(error));
    }
  }
}

startPage(run);
