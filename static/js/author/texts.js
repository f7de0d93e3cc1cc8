/** Title and statement, per language; what the service writes itself comes in every language. */

import { el, fill, segmented } from "../dom.js";
import { language, t } from "../i18n.js";
import { field, numberField, refill, textField } from "./fields.js";

const LANGUAGES = { en: "English", ro: "Română", pt: "Português", fr: "Français", uk: "Українська", es: "Español" };

/** @param {import("./draft-store.js").DraftStore} store */
export function textsSection(store) {
  let shown = language;
  const body = el("div", { class: "stack" });
  const reading = el("div", { class: "prose author-reading" });
  /** @type {Record<string, string>} */
  let html = {};

  function build() {
    const area = el("textarea", {
      rows: "6",
      lang: shown,
      value: store.at(["statements", shown]) ?? "",
      dataset: { path: `statements/${shown}` },
      oninput: (event) => store.set(["statements", shown], event.target.value.trim() ? event.target.value : undefined),
    });
    refill(
      body,
      textField(store, t("author-title-of"), ["definition", "title", shown], { lang: shown, maxlength: "200" }),
      field(t("author-statement"), area, t("author-statement-hint")),
      numberField(store, t("author-version"), ["definition", "version"]),
      el("h3", { text: t("author-statement-preview") }),
      reading,
    );
    show();
  }

  function show() {
    // The service wrote this from the statement and let nothing of the source through but a few elements.
    const written = new DOMParser().parseFromString(html[shown] ?? "", "text/html");
    fill(reading, [...written.body.childNodes]);
    reading.lang = shown;
    if (html[shown]) return;
    const text = t(store.at(["statements", shown]) ? "author-statement-waiting" : "author-statement-none");
    fill(reading, el("p", { class: "hint", text }));
  }

  const tabs = segmented({
    name: "author-language",
    label: t("author-language"),
    value: shown,
    options: Object.entries(LANGUAGES).map(([value, label]) => ({ value, label })),
    onchange: (value) => {
      shown = value;
      build();
    },
  });
  return {
    element: el("div", { class: "stack" }, tabs, body),
    fill: build,
    /** @param {any} view */
    show: (view) => {
      html = view.statements;
      show();
    },
  };
}
