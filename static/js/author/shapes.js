/** Fields of the shapes that a definition's values have: numbers by name, words, draws, pairs of frames, ranges. */

import { el, iconButton, VERBATIM } from "../dom.js";
import { named, t } from "../i18n.js";
import { field, numberField, numberOf, refill, textField, tick } from "./fields.js";

/**
 * @typedef {import("./draft-store.js").DraftStore} DraftStore
 * @typedef {import("./draft-store.js").Path} Path
 * @typedef {{name: string, label: string, shape: string, labels: string[], options: {value: string, label: string}[]}} Key
 *   a key of a part's definition, as the service describes it
 */

/** A list of entries, a field for each label; with nothing in any of them the key goes. @param {DraftStore} store @param {string} label @param {Path} path @param {string[]} labels @param {{names?: boolean}} [options] names may stand instead of numbers */
export function listField(store, label, path, labels, { names = false } = {}) {
  const input = (/** @type {string} */ name, /** @type {number} */ i) => {
    const set = (/** @type {any} */ event) => {
      const now = store.at(path) ?? labels.map(() => 0);
      const typed = names ? numberOf(event.target.value) : (numberOf(event.target.value) ?? 0);
      store.set(
        path,
        labels.map((_, k) => (k === i ? (typed ?? 0) : (now[k] ?? 0))),
      );
    };
    return field(
      name,
      el("input", {
        type: "text",
        size: "5",
        ...VERBATIM,
        value: store.at([...path, i]) ?? "",
        dataset: { path: [...path, i].join("/") },
        oninput: set,
      }),
    );
  };
  return group(label, labels.map(input));
}

/** Words in one field, between spaces or commas. @param {DraftStore} store @param {string} label @param {Path} path @param {string} [hint] */
export function wordsField(store, label, path, hint = "") {
  const set = (/** @type {any} */ event) => {
    const words = event.target.value.split(/[\s,]+/).filter(Boolean);
    store.set(path, words.length ? words : undefined);
  };
  const value = (store.at(path) ?? []).join(" ");
  const input = el("input", {
    type: "text",
    value,
    oninput: set,
    ...VERBATIM,
    dataset: { path: path.join("/"), whole: "" },
  });
  return field(label, input, hint);
}

/** Some of several words. @param {DraftStore} store @param {string} label @param {Path} path @param {{value: string, label: string}[]} options */
export function choicesField(store, label, path, options) {
  const now = () => store.at(path) ?? [];
  const choose = (/** @type {string} */ value) => (/** @type {boolean} */ on) => {
    const kept = options.map((option) => option.value).filter((name) => (name === value ? on : now().includes(name)));
    store.set(path, kept.length ? kept : undefined);
  };
  const more = { dataset: { path: path.join("/"), whole: "" } };
  return group(
    label,
    options.map((option) => tick(option.label, now().includes(option.value), choose(option.value), more)),
  );
}

/** From where a student's own value is drawn. @param {DraftStore} store @param {string} label @param {Path} path @param {any} usual what to begin with */
function drawField(store, label, path, usual) {
  const place = el("div", { class: "row" });
  const build = () => {
    const draw = store.at(path);
    const switched = tick(label, Boolean(draw), (on) => {
      store.set(path, on ? usual : undefined);
      build();
    });
    refill(place, switched, draw ? drawFields(store, path) : null);
  };
  build();
  return place;
}

/** @param {DraftStore} store @param {Path} path of a draw */
function drawFields(store, path) {
  return [
    ...["from", "to", "step"].map((what) => numberField(store, t(`author-draw-${what}-short`), [...path, what])),
    numbersField(store, t("author-draw-without"), [...path, "without"]),
  ];
}

/** Numbers in one field, between spaces. @param {DraftStore} store @param {string} label @param {Path} path */
export function numbersField(store, label, path) {
  const set = (/** @type {any} */ event) => {
    const numbers = event.target.value
      .split(/[\s;]+/)
      .filter(Boolean)
      .map(numberOf);
    store.set(path, numbers.length ? numbers : undefined);
  };
  const value = (store.at(path) ?? []).join(" ");
  const input = el("input", {
    type: "text",
    size: "8",
    value,
    oninput: set,
    ...VERBATIM,
    dataset: { path: path.join("/"), whole: "" },
  });
  return field(label, input);
}

/** Entries that are added and taken away. @param {DraftStore} store @param {string} label @param {Path} path @param {(path: Path, entry: any) => (HTMLElement | null)[]} fields @param {() => any} fresh @param {(count: number) => string} [nameOf] */
export function entriesField(store, label, path, fields, fresh, nameOf = (number) => `${label} ${number}`) {
  const place = el("div", { class: "stack" });
  const entries = () => store.at(path) ?? [];
  const become = (/** @type {any[]} */ next) => {
    store.set(path, next.length ? next : undefined);
    build();
  };
  const remove = (/** @type {number} */ i) => () =>
    become(entries().filter((/** @type {any} */ _, /** @type {number} */ k) => k !== i));
  const build = () =>
    refill(
      place,
      entries().map((/** @type {any} */ entry, /** @type {number} */ i) =>
        group(nameOf(i + 1), [
          ...fields([...path, i], entry),
          iconButton("remove", t("author-remove", { name: nameOf(i + 1) }), remove(i)),
        ]),
      ),
      el(
        "div",
        {},
        el("button", {
          type: "button",
          onclick: () => become([...entries(), fresh()]),
          text: t("author-add", { name: label }),
        }),
      ),
    );
  build();
  return place;
}

/** A key of a part, as the service describes it. @param {DraftStore} store @param {Path} path of the part @param {Key} key @param {string[]} points names of marked points */
export function keyField(store, path, key, points) {
  const at = [...path, key.name];
  switch (key.shape) {
    case "number":
      return numberField(store, key.label, at);
    case "choice":
      return optionalChoice(store, key.label, at, key.options);
    case "choices":
      return choicesField(store, key.label, at, key.options);
    case "numbers":
      return listField(store, key.label, at, key.labels);
    case "cells":
      return listField(store, key.label, at, key.labels, { names: true });
    case "draw":
      return drawField(store, key.label, at, key.name === "slides" ? SLIDES : TURNS);
    case "frames":
      return pairField(store, key.label, at);
    case "frame_pairs":
      return entriesField(
        store,
        key.label,
        at,
        (inner) => [
          numberField(store, t("author-draw-from-short"), [...inner, "from"]),
          numberField(store, t("author-draw-to-short"), [...inner, "to"]),
        ],
        () => ({ from: 0, to: 1 }),
      );
    case "ranges":
      return rangesField(store, key.label, at, key.labels);
    case "bodies":
      return entriesField(
        store,
        key.label,
        at,
        (inner) => bodyFields(store, inner),
        () => ({ mass: 0 }),
        (number) => t("author-body", { number }),
      );
    case "quantities":
      return quantitiesField(store, key.label, at);
    case "point":
      return optionalChoice(store, key.label, at, [
        ...key.options,
        ...points.map((value) => ({ value, label: value })),
      ]);
    default:
      return textField(store, key.label, at);
  }
}

const TURNS = { from: -90, to: 90, step: 15, without: [0] };
const SLIDES = { from: 0.1, to: 0.3, step: 0.05 };

/** Mass, centre and moments of inertia of a link. @param {DraftStore} store @param {Path} path */
function bodyFields(store, path) {
  const coordinates = ["x", "y", "z"];
  return [
    massField(store, [...path, "mass"]),
    listField(store, t("author-body-centre"), [...path, "centre"], coordinates, { names: true }),
    listField(store, t("author-body-moments"), [...path, "moments"], coordinates, { names: true }),
  ];
}

/** @param {DraftStore} store @param {Path} path */
function massField(store, path) {
  return textField(store, t("author-body-mass"), path, {
    size: "5",
    oninput: (/** @type {any} */ event) => store.set(path, numberOf(event.target.value)),
  });
}

/** Quantities by name, each with a value and perhaps a draw. @param {DraftStore} store @param {string} label @param {Path} path */
function quantitiesField(store, label, path) {
  const place = el("div", { class: "stack" });
  const name = el("input", { type: "text", size: "5", ...VERBATIM, "aria-label": t("author-quantity-name") });
  const build = () =>
    refill(
      place,
      ...Object.keys(store.at(path) ?? {}).map((quantity) =>
        group(quantity, [
          numberField(store, t("author-quantity-value"), [...path, quantity, "value"]),
          drawField(store, t("author-quantity-draw"), [...path, quantity, "draw"], { from: 1, to: 2, step: 0.25 }),
          iconButton("remove", t("author-remove", { name: quantity }), () => change(quantity, undefined)),
        ]),
      ),
      el(
        "div",
        { class: "row" },
        name,
        el("button", { type: "button", onclick: add, text: t("author-add", { name: label }) }),
      ),
    );
  const change = (/** @type {string} */ quantity, /** @type {any} */ value) => {
    store.set([...path, quantity], value);
    build();
  };
  const add = () => name.value.trim() && change(name.value.trim(), { value: 1 });
  build();
  return place;
}

/** One of some words, or none. @param {DraftStore} store @param {string} label @param {Path} path @param {{value: string, label: string}[]} options */
function optionalChoice(store, label, path, options) {
  const now = store.at(path) ?? "";
  const known = options.some(({ value }) => value === now) || now === "";
  const shown = [{ value: "", label: t("author-usual") }, ...options, ...(known ? [] : [{ value: now, label: now }])];
  const select = el(
    "select",
    { dataset: { path: path.join("/") }, onchange: (event) => store.set(path, event.target.value || undefined) },
    shown.map(({ value, label: text }) => el("option", { value, selected: value === now, text })),
  );
  return field(label, select);
}

/** @param {DraftStore} store @param {string} label @param {Path} path */
function pairField(store, label, path) {
  return group(label, [
    numberField(store, t("author-draw-from-short"), [...path, "from"]),
    numberField(store, t("author-draw-to-short"), [...path, "to"]),
  ]);
}

/** For each label the least and the greatest value; both empty: none. @param {DraftStore} store @param {string} label @param {Path} path @param {string[]} labels */
function rangesField(store, label, path, labels) {
  const now = () => (Array.isArray(store.at(path)) ? store.at(path) : labels.map(() => []));
  const input = (/** @type {number} */ i, /** @type {number} */ end, /** @type {string} */ what) => {
    const set = (/** @type {any} */ event) => {
      const pair = [now()[i]?.[0], now()[i]?.[1]];
      pair[end] = numberOf(event.target.value);
      const next = now().map((/** @type {any} */ entry, /** @type {number} */ k) =>
        k === i ? (pair.every((value) => value === undefined) ? [] : pair.map((value) => value ?? 0)) : entry,
      );
      store.set(path, next.some((/** @type {any} */ entry) => entry.length) ? next : undefined);
    };
    return el("input", {
      type: "text",
      size: "5",
      ...VERBATIM,
      value: now()[i]?.[end] ?? "",
      "aria-label": named(`${label}, ${labels[i]}`, what),
      dataset: { path: [...path, i, end].join("/") },
      oninput: set,
    });
  };
  return group(
    label,
    labels.map((name, i) =>
      el(
        "span",
        { class: "row" },
        name,
        input(i, 0, t("author-draw-from-short")),
        "…",
        input(i, 1, t("author-draw-to-short")),
      ),
    ),
  );
}

/** @param {string} label @param {(Node | null)[]} fields */
export function group(label, fields) {
  return el("fieldset", { class: "author-value" }, el("legend", { text: label }), fields);
}
