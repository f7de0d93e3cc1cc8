/** For lecturers: links that carry their settings, signed, and packages for a learning platform. */

import { el, uniqueId } from "../dom.js";
import { language, t } from "../i18n.js";
import { problemNotice } from "../problem.js";

const TOOLS = ["catalogue", "playground", "matrices", "trainer"];
const LEVELS = ["verdict", "row", "kind", "repair"];

/** The settings, and what is made of them. @param {{api: import("../api.js").Api, exercise: Wire.Exercise}} page */
export function sharingPanel({ api, exercise }) {
  const levels = LEVELS.slice(0, LEVELS.indexOf(exercise.help) + 1);
  const tools = TOOLS.map((tool) => {
    const input = el("input", { type: "checkbox", name: tool, checked: !exercise.access.off.includes(tool) });
    return { tool, input, element: el("label", { class: "row" }, input, t(`form-sharing-${tool}`)) };
  });
  const [helpId, attemptsId] = [uniqueId("sharing"), uniqueId("sharing")];
  const help = el(
    "select",
    { id: helpId },
    levels.map((value) => el("option", { value, selected: value === exercise.help, text: t(`form-help-${value}`) })),
  );
  const placeholder = String(exercise.access.attempts ?? "∞");
  const attempts = el("input", { id: attemptsId, type: "number", min: 1, max: 1000, placeholder });
  const result = el("div", { role: "status" });
  const settings = () => ({
    off: tools.filter(({ input }) => !input.checked).map(({ tool }) => tool),
    help: help.value === exercise.help ? null : help.value,
    attempts: attempts.value ? attempts.valueAsNumber : null,
  });
  const link = async () => {
    try {
      const { url } = await api.post(`exercises/${exercise.id}/links`, settings());
      const field = el("input", { type: "text", readonly: true, value: url, "aria-label": t("form-sharing-link") });
      result.replaceChildren(field);
      field.select();
    } catch (error) {
      result.replaceChildren(problemNotice(error));
    }
  };
  const scorm = (/** @type {string} */ version) => () => {
    const { off, help: level, attempts: limit } = settings();
    const query = new URLSearchParams({ version, lang: language });
    for (const tool of off) query.append("off", tool);
    if (level) query.set("help", level);
    if (limit) query.set("attempts", String(limit));
    location.assign(api.address(`exercises/${exercise.id}/scorm.zip?${query}`));
  };
  const button = (/** @type {string} */ text, /** @type {() => void} */ onclick) =>
    el("button", { type: "button", onclick, text });
  return el(
    "div",
    { class: "stack" },
    el("p", { class: "hint", text: t("form-sharing-text") }),
    el(
      "fieldset",
      { class: "choices" },
      el("legend", { text: t("form-sharing-may") }),
      tools.map(({ element }) => element),
    ),
    el(
      "div",
      { class: "row end" },
      el("div", { class: "field" }, el("label", { for: helpId, text: t("form-sharing-help") }), help),
      el("div", { class: "field" }, el("label", { for: attemptsId, text: t("form-sharing-attempts") }), attempts),
    ),
    el(
      "div",
      { class: "row" },
      button(t("form-sharing-link"), link),
      button("SCORM 1.2", scorm("1.2")),
      button("SCORM 2004", scorm("2004")),
    ),
    result,
    el("p", {}, el("a", { href: "../receipts", text: t("form-sharing-receipts") })),
  );
}
