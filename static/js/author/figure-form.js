/** How the figure is drawn: from where it is seen, in which posture, what is marked, and all that a definition may nudge. */

import { el, iconButton } from "../dom.js";
import { named, t } from "../i18n.js";
import { field, numberField, part, refill, textField, tick } from "./fields.js";
import { entriesField, group, listField, numbersField, wordsField } from "./shapes.js";

/** @typedef {import("./draft-store.js").DraftStore} DraftStore */
/** @typedef {import("./draft-store.js").Path} Path */

const FIGURE = ["definition", "figure"];
const XYZ = ["x", "y", "z"];
const KINDS = ["frame", "between", "by", "joint"];

/** @param {DraftStore} store */
export function figureSection(store) {
  const element = el("div", { class: "stack" });
  /** @type {any[]} */
  let joints = [];
  const rebuild = (/** @type {() => void} */ change) => () => (change(), build());

  function build() {
    const names = Object.keys(store.at(["definition", "parameters"]) ?? {});
    refill(
      element,
      el(
        "div",
        { class: "author-columns" },
        slider(t("author-view-azimuth"), ["view", "azimuth"], -180, 180, -60),
        slider(t("author-view-elevation"), ["view", "elevation"], 0, 90, 24),
      ),
      listField(store, t("author-posture"), [...FIGURE, "posture"], jointNames()),
      ...part("author-marks", true),
      marksField(),
      names.length ? part("author-lengths", true) : null,
      el(
        "div",
        { class: "row" },
        names.map((name) => numberField(store, name, [...FIGURE, "lengths", name])),
      ),
      el("details", {}, el("summary", { text: t("author-figure-more") }), el("div", { class: "stack" }, more())),
    );
  }

  const jointNames = () => {
    const posture = store.at([...FIGURE, "posture"]) ?? joints;
    return posture.map((/** @type {any} */ _, /** @type {number} */ i) => `q${i + 1}`);
  };

  /** What is seldom needed. */
  function more() {
    const upright = ["roll", "pitch", "yaw"].map((name) =>
      numberField(store, t(`author-figure-${name}`), [...FIGURE, "upright", name]),
    );
    return [
      group(t("author-figure-upright"), upright),
      numberField(store, t("author-figure-width"), [...FIGURE, "width"], { placeholder: "480" }),
      recordsField(t("author-figure-points"), "points", pointFields, { frame: 0 }),
      recordsField(
        t("author-figure-joints"),
        "joints",
        (path) => [
          textField(store, t("author-figure-at"), [...path, "at"], { size: "8" }),
          textField(store, t("author-figure-label"), [...path, "label"], { size: "2", placeholder: "+ −" }),
          numberField(store, t("author-figure-scale"), [...path, "scale"]),
          numberField(store, t("author-figure-reach"), [...path, "reach"]),
        ],
        { at: "O0" },
      ),
      linksField(),
      group(t("author-figure-ground"), [
        textField(store, t("author-figure-at"), [...FIGURE, "ground", "at"], { size: "8" }),
        numbersField(store, t("author-figure-normal"), [...FIGURE, "ground", "normal"]),
      ]),
      group(t("author-figure-gripper"), [
        textField(store, t("author-figure-at"), [...FIGURE, "gripper", "at"], { size: "8" }),
        textField(store, t("author-figure-away"), [...FIGURE, "gripper", "away_from"], { size: "8" }),
        numbersField(store, t("author-figure-jaws"), [...FIGURE, "gripper", "jaws"]),
      ]),
      entriesField(
        store,
        t("author-figure-dimension"),
        [...FIGURE, "dimensions"],
        (path) => [
          textField(store, t("author-figure-name"), [...path, "name"], { size: "5" }),
          textField(store, t("author-figure-value"), [...path, "value"], { size: "6" }),
          textField(store, t("author-draw-from-short"), [...path, "from"], { size: "6" }),
          textField(store, t("author-draw-to-short"), [...path, "to"], { size: "6" }),
          numbersField(store, t("author-figure-offset"), [...path, "offset"]),
          numberField(store, t("author-figure-distance"), [...path, "distance"]),
        ],
        () => ({ name: "L1", from: "O0", to: "O1" }),
      ),
    ];
  }

  /** Chains of points, one a line. */
  function linksField() {
    const path = [...FIGURE, "links"];
    const set = (/** @type {any} */ event) => {
      const chains = event.target.value
        .split("\n")
        .map((/** @type {string} */ line) => line.split(/[\s,]+/).filter(Boolean))
        .filter((/** @type {string[]} */ chain) => chain.length);
      store.set(path, chains.length ? chains : undefined);
    };
    const value = (store.at(path) ?? []).map((/** @type {string[]} */ chain) => chain.join(" ")).join("\n");
    const area = el("textarea", { rows: "2", value, oninput: set, dataset: { path: path.join("/"), whole: "" } });
    return field(t("author-figure-links"), area, t("author-figure-links-hint"));
  }

  /** A point: in a frame of the key, between two points, displaced, or along a joint's axis. @param {Path} path @param {any} point */
  function pointFields(path, point) {
    const form = KINDS.find((name) => point?.[name] !== undefined) ?? "frame";
    /** @type {Record<string, any>} */
    const starts = {
      frame: { frame: 0 },
      between: { between: ["O0", "O1"] },
      by: { from: "O0", by: [0, 0, 1] },
      joint: { from: "O0", joint: 1, distance: 1 },
    };
    const select = el(
      "select",
      { onchange: (event) => rebuild(() => store.set(path, starts[event.target.value]))() },
      KINDS.map((name) => el("option", { value: name, selected: name === form, text: t(`author-figure-${name}`) })),
    );
    /** @type {Record<string, () => (HTMLElement | null)[]>} */
    const fields = {
      frame: () => [
        numberField(store, t("author-figure-frame"), [...path, "frame"]),
        listField(store, t("author-figure-coordinates"), [...path, "at"], XYZ, { names: true }),
      ],
      between: () => [
        wordsField(store, t("author-figure-between"), [...path, "between"]),
        numberField(store, t("author-figure-ratio"), [...path, "ratio"], { placeholder: "0.5" }),
      ],
      by: () => [
        textField(store, t("author-figure-from"), [...path, "from"], { size: "6" }),
        listField(store, t("author-figure-by"), [...path, "by"], XYZ, { names: true }),
      ],
      joint: () => [
        textField(store, t("author-figure-from"), [...path, "from"], { size: "6" }),
        numberField(store, t("author-figure-joint"), [...path, "joint"]),
        textField(store, t("author-figure-distance-along"), [...path, "distance"], { size: "6" }),
      ],
    };
    return [field(t("author-figure-form"), select), ...fields[form]()];
  }

  /** Entries by name. @param {string} label @param {string} key @param {(path: Path, entry: any) => (HTMLElement | null)[]} fields @param {any} fresh */
  function recordsField(label, key, fields, fresh) {
    const path = [...FIGURE, key];
    const entries = store.at(path) ?? {};
    const name = el("input", { type: "text", size: "6", "aria-label": named(label, t("author-figure-name")) });
    const add = () => {
      const wanted = name.value.trim();
      if (wanted) rebuild(() => store.set([...path, wanted], fresh))();
    };
    const remove = (/** @type {string} */ gone) => () => {
      const { [gone]: _gone, ...rest } = store.at(path);
      rebuild(() => store.set(path, Object.keys(rest).length ? rest : undefined))();
    };
    return group(label, [
      ...Object.entries(entries).map(([own, entry]) =>
        group(own, [
          ...fields([...path, own], entry),
          iconButton("remove", t("author-remove", { name: own }), remove(own)),
        ]),
      ),
      el(
        "span",
        { class: "row" },
        name,
        el("button", { type: "button", onclick: add, text: t("author-add", { name: label }) }),
      ),
    ]);
  }

  /** @param {string} label @param {string[]} key @param {number} min @param {number} max @param {number} usual */
  function slider(label, key, min, max, usual) {
    const path = [...FIGURE, ...key];
    const input = el("input", {
      type: "range",
      min,
      max,
      step: 1,
      value: store.at(path) ?? usual,
      dataset: { path: path.join("/") },
      oninput: (event) => store.set(path, Number(event.target.value)),
    });
    return field(label, input);
  }

  /** The one marked point that a tool needs, at the last origin; and any others by name. */
  function marksField() {
    const marks = store.at([...FIGURE, "marks"]) ?? [];
    return el(
      "div",
      { class: "row" },
      tick(t("author-mark-end"), marks.includes("P"), (on) => rebuild(() => markEnd(store, on, joints.length))()),
      wordsField(store, t("author-figure-marks"), [...FIGURE, "marks"]),
    );
  }

  return {
    element,
    fill: build,
    /** @param {any} view */
    show: (view) => {
      const changed = joints.length !== view.exercise.joints.length;
      joints = view.exercise.joints;
      if (changed) build();
    },
  };
}

/** Marks the last origin as P, or no more. @param {DraftStore} store @param {boolean} on @param {number} frames how many, if the draft does not say */
export function markEnd(store, on, frames) {
  const figure = store.at(FIGURE) ?? {};
  const rows = store.at(["definition", "reference", "rows"])?.length;
  const points = { ...figure.points };
  if (on) points.P ??= { frame: rows ?? frames };
  else delete points.P;
  const others = (figure.marks ?? []).filter((/** @type {string} */ mark) => mark !== "P");
  const next = { ...figure, points, marks: on ? [...others, "P"] : others };
  if (!next.marks.length) delete next.marks;
  if (!Object.keys(points).length) delete next.points;
  store.set(FIGURE, next);
}
