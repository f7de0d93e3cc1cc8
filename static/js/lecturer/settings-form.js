/** The form with which a teacher chooses the exercise of a link and its rules. */

import { announce, el } from "../dom.js";
import { dates, language, t } from "../i18n.js";
import { instant, local } from "./local-time.js";

/** @type {Record<string, string[]>} */
const CHOICES = {
  counting: ["best", "last", "first"],
  feedback: ["at_once", "after_attempts", "after_deadline", "verdict_only", "on_release"],
  mode: ["practice", "exam"],
  help: ["", "verdict", "row", "kind", "repair"],
};

/** The browser's time zone in the reader's language; its identifier is English, and may name a city as it was once spelled. */
function timeZone() {
  const parts = dates({ timeZoneName: "longGeneric" }).formatToParts();
  return parts.find(({ type }) => type === "timeZoneName")?.value;
}

/**
 * @param {any[]} exercises the list of the service
 * @param {any} settings what holds now
 * @param {(settings: any) => void} save
 * @param {string} action what the button says
 */
export function settingsForm(exercises, settings, save, action) {
  /** @param {string} name @param {any} control @param {string} [more] */
  const field = (name, control, more = "") =>
    el("label", {}, `${t(`lecturer-${name.replaceAll("_", "-")}`)}${more}`, control);
  /** @param {string} name */
  const select = (name) =>
    field(
      name,
      el(
        "select",
        { name },
        CHOICES[name].map((/** @type {any} */ value) =>
          el("option", {
            value,
            selected: (settings[name] ?? "") === value,
            text: t(`lecturer-${name}-${(value || "exercise").replaceAll("_", "-")}`),
          }),
        ),
      ),
    );
  /** @param {string} name @param {any} attributes */
  const number = (name, attributes) =>
    field(name, el("input", { type: "number", name, ...attributes, value: settings[name] ?? "" }));
  /** @param {string} name */
  const time = (name) => {
    const value = local(settings[name]);
    const step = value.length > 16 ? 1 : 60;
    return field(name, el("input", { type: "datetime-local", name, step, value }), ` (${timeZone()})`);
  };
  const byTitle = [...exercises].sort((one, other) => one.title.localeCompare(other.title, language));
  const parts = el("fieldset", { class: "wide" });
  const exercise = /** @type {HTMLSelectElement} */ (
    el(
      "select",
      { name: "exercise", required: true, onchange: () => showParts() },
      byTitle.map(({ id, title }) => el("option", { value: id, selected: id === settings.exercise, text: title })),
    )
  );
  function showParts() {
    const chosen = exercises.find(({ id }) => id === exercise.value);
    const kinds = chosen?.parts ?? [];
    parts.replaceChildren(
      el("legend", { text: t("lecturer-parts") }),
      ...kinds.map((/** @type {string} */ kind) =>
        el(
          "label",
          { class: "row" },
          el("input", {
            type: "checkbox",
            name: "parts",
            value: kind,
            checked: !settings.parts?.length || settings.parts.includes(kind),
          }),
          t(`form-part-${kind.replaceAll("_", "-")}`),
        ),
      ),
    );
  }
  showParts();
  const after = number("feedback_after", { min: 1, max: 1000 });
  const timing = select("feedback");
  const showAfter = () => {
    after.hidden = /** @type {HTMLSelectElement} */ (timing.querySelector("select")).value !== "after_attempts";
    // A number that is wrong and cannot be seen would keep the form from being sent.
    after.querySelector("input")?.toggleAttribute("disabled", after.hidden);
  };
  timing.addEventListener("change", showAfter);
  showAfter();
  const closes = time("closes");
  const past = el("p", { class: "notice notice-warn wide", text: t("lecturer-closes-past") });
  const showPast = () => {
    const { value } = /** @type {HTMLInputElement} */ (closes.querySelector("input"));
    past.hidden = !value || new Date(value) > new Date();
  };
  closes.addEventListener("change", () => {
    showPast();
    if (!past.hidden) announce(past.textContent ?? "");
  });
  showPast();
  const form = /** @type {HTMLFormElement} */ (
    el(
      "form",
      {
        class: "lecturer-form",
        onsubmit: (event) => {
          event.preventDefault();
          save({ ...settingsOf(form, settings), language: settings.language ?? null });
        },
      },
      field("exercise", exercise),
      number("points", { min: 0.01, step: "any", max: 1000000, required: true }),
      number("attempts", { min: 1, max: 1000, placeholder: t("lecturer-help-exercise") }),
      select("counting"),
      number("penalty", { min: 0, max: 1, step: 0.01 }),
      time("opens"),
      closes,
      past,
      select("mode"),
      timing,
      after,
      select("help"),
      el(
        "label",
        { class: "row" },
        el("input", { type: "checkbox", name: "per_student", checked: settings.per_student }),
        t("lecturer-per-student"),
      ),
      number("variants", { min: 1, max: 1000, placeholder: "–" }),
      parts,
      el("p", { class: "wide" }, el("button", { type: "submit", class: "primary", text: action })),
    )
  );
  return form;
}

/** @param {HTMLFormElement} form @param {any} before */
function settingsOf(form, before) {
  const data = new FormData(form);
  /** @param {string} name */
  const number = (name) => (data.get(name) ? Number(data.get(name)) : null);
  /** @param {string} name */
  const time = (name) => instant(String(data.get(name) ?? ""), before[name]);
  const boxes = /** @type {HTMLInputElement[]} */ ([...form.querySelectorAll("input[name=parts]")]);
  const chosen = boxes.filter(({ checked }) => checked).map(({ value }) => value);
  return {
    exercise: data.get("exercise"),
    parts: chosen.length === boxes.length ? [] : chosen,
    points: number("points"),
    attempts: number("attempts"),
    counting: data.get("counting"),
    penalty: number("penalty") ?? 0,
    opens: time("opens"),
    closes: time("closes"),
    mode: data.get("mode"),
    feedback: data.get("feedback"),
    feedback_after: number("feedback_after") ?? before.feedback_after ?? 1,
    help: data.get("help") || null,
    per_student: data.get("per_student") === "on",
    variants: number("variants"),
  };
}

/** An exercise that stands in no list, as an entry of it. @param {any} exercise */
export function entryOf({ id, title, parts }) {
  return { id, title, parts: parts.map((/** @type {any} */ { kind }) => kind) };
}
