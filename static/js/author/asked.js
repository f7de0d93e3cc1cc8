/** What is asked and what it is worth; what a table is held to; values drawn per student; help. */

import { el, fill } from "../dom.js";
import { knows, t } from "../i18n.js";
import { choiceField, field, numberField, numberInput, numberOf, part, textField, tick } from "./fields.js";

/** @typedef {import("./draft-store.js").DraftStore} DraftStore */

const KINDS = ["schematic", "table", "frames", "link_matrices", "transform", "pose", "workspace"];
const POINTS = 15;

/** The parts, each with its points. @param {DraftStore} store */
export function partsSection(store) {
  const element = el("div", { class: "stack" });
  const total = el("p", { class: "hint", role: "status" });
  const parts = () => store.at(["definition", "parts"]) ?? [];

  /** @param {string} kind @param {boolean} on */
  function ask(kind, on) {
    const others = parts().filter((/** @type {any} */ entry) => entry.kind !== kind);
    const next = on ? [...others, partOf(kind)] : others;
    next.sort((/** @type {any} */ a, /** @type {any} */ b) => KINDS.indexOf(a.kind) - KINDS.indexOf(b.kind));
    store.set(["definition", "parts"], next);
    build();
  }

  /** @param {string} kind */
  function partOf(kind) {
    if (kind === "pose") return { kind, points: POINTS, joints: postureOf(store) };
    if (kind === "workspace") return { kind, points: POINTS, point: endName(store), from: "axis" };
    return { kind, points: POINTS };
  }

  function build() {
    const asked = parts();
    fill(
      element,
      KINDS.filter((kind) => knows(`form-part-${kind.replaceAll("_", "-")}`)).map((kind) => {
        const i = asked.findIndex((/** @type {any} */ entry) => entry.kind === kind);
        const name = t(`form-part-${kind.replaceAll("_", "-")}`);
        const path = ["definition", "parts", i, "points"];
        const points = i < 0 ? null : numberInput(store, path, { "aria-label": t("author-points-of", { part: name }) });
        return el(
          "div",
          { class: "row author-part" },
          tick(name, i >= 0, (on) => ask(kind, on), { dataset: { part: kind } }),
          points,
          i < 0 ? null : el("span", { class: "hint", text: t("author-points") }),
          i >= 0 && kind === "workspace" ? pointField(i) : null,
        );
      }),
      total,
    );
    show();
  }

  /** Of which point the workspace is asked. @param {number} i */
  function pointField(i) {
    return textField(store, t("author-workspace-point"), ["definition", "parts", i, "point"], { size: "5" });
  }

  function show() {
    const sum = parts().reduce((/** @type {number} */ all, /** @type {any} */ entry) => all + Number(entry.points), 0);
    total.textContent = t("author-points-total", { points: sum });
  }
  return { element, fill: build, show };
}

/** @param {DraftStore} store */
function postureOf(store) {
  const n =
    store.at(["definition", "figure", "posture"])?.length ?? store.at(["definition", "reference", "rows"])?.length ?? 1;
  return Array.from({ length: n }, (_, i) => [30, 45, -60, 90, -30, 60][i % 6]);
}

/** A marked point, or the name that one would have. @param {DraftStore} store */
function endName(store) {
  return store.at(["definition", "figure", "marks"])?.[0] ?? "P";
}

/** @type {Record<string, {usual: string, values: string[]}>} */
const RULES = {
  convention: { usual: "any", values: ["any", "standard", "modified"] },
  base: { usual: "free", values: ["free", "axis", "origin", "frame"] },
  tool: { usual: "axis", values: ["free", "point", "axis", "frame"] },
  zero: { usual: "free", values: ["free", "figure"] },
  direction: { usual: "free", values: ["free", "figure"] },
};

/** The policy, with what it means for this robot. @param {DraftStore} store */
export function policySection(store) {
  const fields = el("div", { class: "author-columns" });
  const meaning = el("p", { class: "author-meaning", role: "status" });
  const rules = el("ul", {});
  function build() {
    fill(
      fields,
      Object.entries(RULES).map(([name, { usual, values }]) =>
        choiceField(
          store,
          t(`author-rule-${name}`),
          ["definition", "policy", name],
          values.map((value) => ({ value, label: t(`author-rule-${name}-${value}`) })),
          usual,
        ),
      ),
      ["length", "angle"].map((name) =>
        numberField(store, t(`author-tolerance-${name}`), ["definition", "policy", "tolerance", name], {
          placeholder: "0.005",
        }),
      ),
    );
  }
  return {
    element: el("div", { class: "stack" }, fields, meaning, rules),
    fill: build,
    /** @param {any} view */
    show: (view) => {
      meaning.textContent = view.policy.message;
      fill(
        rules,
        view.exercise.rules.map((/** @type {string} */ text) => el("li", { text })),
      );
    },
  };
}

/** Values, and from what a student's own are drawn. @param {DraftStore} store */
export function valuesSection(store) {
  const element = el("div", { class: "stack" });
  function build() {
    const names = Object.keys(store.at(["definition", "parameters"]) ?? {});
    const own = Boolean(store.at(["definition", "reference"]));
    fill(
      element,
      names.length
        ? el("p", { class: "hint", text: t("author-values-hint") })
        : el("p", { text: t("author-values-none") }),
      names.map((name) => {
        const path = ["definition", "parameters", name];
        const draw = store.at([...path, "draw"]);
        const label = (/** @type {string} */ what) => ({ "aria-label": t(`author-draw-${what}`, { name }) });
        return el(
          "fieldset",
          { class: "author-value" },
          el("legend", { text: name }),
          own ? numberField(store, t("author-value"), [...path, "value"]) : null,
          tick(t("author-drawn"), Boolean(draw), (on) => {
            store.set([...path, "draw"], on ? rangeOf(store.at([...path, "value"]) ?? 1) : undefined);
            build();
          }),
          draw
            ? ["from", "to", "step"].map((what) =>
                field(t(`author-draw-${what}-short`), numberInput(store, [...path, "draw", what], label(what))),
              )
            : null,
          aliasField(path),
        );
      }),
    );
  }
  /** @param {(string | number)[]} path */
  function aliasField(path) {
    const value = (store.at([...path, "aliases"]) ?? []).join(" ");
    const set = (/** @type {any} */ event) => {
      const names = event.target.value.split(/[\s,]+/).filter(Boolean);
      store.set([...path, "aliases"], names.length ? names : undefined);
    };
    return field(
      t("author-aliases"),
      el("input", { type: "text", size: "8", value, oninput: set, autocomplete: "off" }),
    );
  }
  return { element, fill: build, show: () => undefined };
}

/** About four fifths to six fifths of a value, in round steps. @param {number} value */
function rangeOf(value) {
  const size = Math.abs(Number(value)) || 1;
  const step = 10 ** Math.floor(Math.log10(size / 4));
  const middle = Math.round(Number(value) / step) * step;
  const round = (/** @type {number} */ number) => Number(number.toPrecision(6));
  return { from: round(middle - 2 * step), to: round(middle + 2 * step), step: round(step) };
}

const LEVELS = ["verdict", "row", "kind", "repair"];
const TOOLS = ["catalogue", "playground", "matrices", "trainer"];

/** How much is told, how often one may try, and what may be used meanwhile. @param {DraftStore} store */
export function helpSection(store) {
  const element = el("div", { class: "stack" });
  function build() {
    const options = LEVELS.map((value) => ({ value, label: t(`form-help-${value}`) }));
    const ladder = store.at(["definition", "help", "ladder"]);
    fill(
      element,
      choiceField(store, t("author-help-most"), ["definition", "help", "most"], options, "repair"),
      tick(t("author-help-ladder"), Boolean(ladder), (on) => {
        const most = store.at(["definition", "help", "most"]) ?? "repair";
        const rungs = LEVELS.slice(1, Math.max(2, LEVELS.indexOf(most) + 1));
        store.set(["definition", "help", "ladder"], on ? rungs : undefined);
      }),
      numberField(store, t("author-attempts"), ["definition", "access", "attempts"], { placeholder: "∞" }),
      ...part("author-access", true),
      TOOLS.map((tool) =>
        tick(t(`author-access-${tool}`), store.at(["definition", "access", tool]) !== false, (on) =>
          store.set(["definition", "access", tool], on ? undefined : false),
        ),
      ),
    );
  }
  return { element, fill: build, show: () => undefined };
}

/** From where the robot is seen, in which posture, and what is marked. @param {DraftStore} store */
export function figureSection(store) {
  const element = el("div", { class: "stack" });
  /** @type {any[]} */
  let joints = [];
  function build() {
    const posture = store.at(["definition", "figure", "posture"]) ?? joints.map(() => 0);
    const names = Object.keys(store.at(["definition", "parameters"]) ?? {});
    fill(
      element,
      el(
        "div",
        { class: "author-columns" },
        slider(t("author-view-azimuth"), ["view", "azimuth"], -180, 180, -60),
        slider(t("author-view-elevation"), ["view", "elevation"], 0, 90, 24),
      ),
      ...part("author-posture"),
      el(
        "div",
        { class: "row" },
        posture.map((/** @type {number} */ value, /** @type {number} */ i) =>
          field(`q${i + 1}`, jointInput(posture.length, i, value)),
        ),
      ),
      ...part("author-marks", true),
      pointFields(),
      names.length ? part("author-lengths", true) : null,
      el(
        "div",
        { class: "row" },
        names.map((name) => numberField(store, name, ["definition", "figure", "lengths", name])),
      ),
    );
  }

  /** @param {string} label @param {string[]} key @param {number} min @param {number} max @param {number} usual */
  function slider(label, key, min, max, usual) {
    const path = ["definition", "figure", ...key];
    const input = el("input", {
      type: "range",
      min,
      max,
      step: 1,
      value: store.at(path) ?? usual,
      oninput: (event) => store.set(path, Number(event.target.value)),
    });
    return field(label, input);
  }

  /** @param {number} count @param {number} i @param {number} value */
  function jointInput(count, i, value) {
    const set = (/** @type {any} */ event) => {
      const now = store.at(["definition", "figure", "posture"]) ?? Array.from({ length: count }, () => 0);
      const next = numberOf(event.target.value) ?? 0;
      store.set(
        ["definition", "figure", "posture"],
        now.map((/** @type {any} */ entry, /** @type {number} */ k) => (k === i ? next : entry)),
      );
    };
    return el("input", { type: "text", inputmode: "decimal", size: "5", value, oninput: set, autocomplete: "off" });
  }

  /** The one marked point that a tool needs: in the last frame, on its axes. */
  function pointFields() {
    const marks = store.at(["definition", "figure", "marks"]) ?? [];
    const rows = store.at(["definition", "reference", "rows"])?.length;
    const marked = marks.includes("P");
    return tick(t("author-mark-end"), marked, (on) => {
      const figure = store.at(["definition", "figure"]) ?? {};
      const points = { ...figure.points };
      if (on) points.P ??= { frame: rows ?? joints.length };
      else delete points.P;
      const next = {
        ...figure,
        points,
        marks: on ? [...marks, "P"] : marks.filter((/** @type {string} */ m) => m !== "P"),
      };
      if (!next.marks.length) delete next.marks;
      if (!Object.keys(points).length) delete next.points;
      store.set(["definition", "figure"], next);
    });
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
