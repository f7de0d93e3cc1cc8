/** Fields that show and change a place of the draft. */

import { el, fill, uniqueId, VERBATIM } from "../dom.js";
import { t } from "../i18n.js";
import { numberIn } from "../numbers.js";

/**
 * @typedef {import("./draft-store.js").DraftStore} DraftStore
 * @typedef {import("./draft-store.js").Path} Path
 */

/** A control under its label. @param {string} label @param {HTMLElement} control @param {string} [hint] */
export function field(label, control, hint = "") {
  control.id ||= uniqueId("author");
  const told = hint ? el("p", { class: "hint", id: `${control.id}-hint`, text: hint }) : null;
  if (told) control.setAttribute("aria-describedby", told.id);
  return el("div", { class: "field" }, el("label", { for: control.id, text: label }), control, told);
}

/** A text. @param {DraftStore} store @param {string} label @param {Path} path @param {Record<string, any>} [more] */
export function textField(store, label, path, more = {}) {
  const input = el("input", {
    type: "text",
    value: store.at(path) ?? "",
    autocomplete: "off",
    dataset: { path: path.join("/") },
    ...more,
    oninput: (event) => store.set(path, event.target.value || undefined),
  });
  return field(label, input);
}

/** A number; an empty field takes the key away. @param {DraftStore} store @param {string} label @param {Path} path @param {Record<string, any>} [more] */
export function numberField(store, label, path, more = {}) {
  return field(label, numberInput(store, path, more));
}

/** @param {DraftStore} store @param {Path} path @param {Record<string, any>} [more] */
export function numberInput(store, path, more = {}) {
  return el("input", {
    type: "text",
    size: "7",
    value: store.at(path) ?? "",
    ...VERBATIM,
    dataset: { path: path.join("/") },
    ...more,
    oninput: (event) => store.set(path, numberOf(event.target.value)),
  });
}

/** A number as it is typed anywhere; what is none stays as it stands, for the service to refuse. @param {string} text @returns {number | string | undefined} */
export function numberOf(text) {
  return numberIn(text) ?? (text.trim() || undefined);
}

/**
 * One of several values.
 * @param {DraftStore} store @param {string} label @param {Path} path
 * @param {{value: string, label: string}[]} options @param {string} usual what holds where nothing is said
 */
export function choiceField(store, label, path, options, usual) {
  const now = store.at(path) ?? usual;
  const select = el(
    "select",
    { dataset: { path: path.join("/") }, onchange: (event) => store.set(path, event.target.value) },
    options.map(({ value, label: text }) => el("option", { value, selected: value === now, text })),
  );
  return field(label, select);
}

/** A switch. @param {string} label @param {boolean} checked @param {(on: boolean) => void} onchange @param {Record<string, any>} [more] */
export function tick(label, checked, onchange, more = {}) {
  const input = el("input", {
    type: "checkbox",
    checked,
    ...more,
    onchange: (event) => onchange(event.target.checked),
  });
  return el("label", { class: "choice" }, input, el("span", { text: label }));
}

/** A heading inside a card, with a hint below it. @param {string} id of the message; its hint is `<id>-hint` @param {boolean} [hint] */
export function part(id, hint = false) {
  return [el("h3", { text: t(id) }), hint ? el("p", { class: "hint", text: t(`${id}-hint`) }) : null];
}

/**
 * Fills a place anew. Whoever was at one of its controls goes on, as far as in a text, at the one that takes its
 * place, or at the last one.
 * @param {Element} place @param {...import("../dom.js").Child} children
 */
export function refill(place, ...children) {
  const all = () => /** @type {HTMLInputElement[]} */ ([...place.querySelectorAll("input, select, textarea, button")]);
  const name = (/** @type {HTMLInputElement} */ { dataset, ariaLabel, labels, textContent }) =>
    dataset.path ?? dataset.field ?? dataset.part ?? ariaLabel ?? labels?.[0]?.textContent ?? textContent;
  const before = all().find((control) => control === document.activeElement);
  const called = before && name(before);
  const same = () => all().filter((control) => name(control) === called);
  const number = before ? same().indexOf(before) : 0;
  const [start, end] = [before?.selectionStart ?? null, before?.selectionEnd ?? null];
  fill(place, ...children);
  if (!before || before.isConnected) return;
  const after = same()[number] ?? same().at(-1) ?? all().at(-1);
  after?.focus({ preventScroll: true });
  if (start !== null && after?.type === before.type) after.setSelectionRange(start, end);
}
