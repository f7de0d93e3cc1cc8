/** What is asked and what it is worth; what a table is held to; values drawn per student; help. */

import { el, fill, uniqueId } from "../dom.js";
import { t } from "../i18n.js";
import { choiceField, field, numberField, numberInput, part, refill, tick } from "./fields.js";
import { markEnd } from "./figure-form.js";
import { choicesField, group, keyField, numbersField, wordsField } from "./shapes.js";

/** @typedef {import("./draft-store.js").DraftStore} DraftStore */

const POINTS = 15;
/** What an exercise with a table usually asks, in the order in which it is asked; other kinds come after. */
const FIRST = ["schematic", "table", "frames", "link_matrices", "transform", "pose", "workspace"];

/** The parts, each with its points and what else its definition may say, as the service describes the kinds. @param {DraftStore} store */
export function partsSection(store) {
  const element = el("div", { class: "stack" });
  const total = el("p", { class: "hint", role: "status" });
  const parts = () => store.at(["definition", "parts"]) ?? [];
  /** @type {any[]} */
  let kinds = [];
  /** @type {string[]} */
  let points = [];
  let built = "";

  /** @param {any} kind @param {boolean} on */
  function ask(kind, on) {
    const others = parts().filter((/** @type {any} */ entry) => entry.kind !== kind.kind);
    const start = kind.start.point && points.length ? { ...kind.start, point: points[0] } : kind.start;
    const next = on ? [...others, { kind: kind.kind, points: POINTS, ...start }] : others;
    const place = (/** @type {any} */ part) => kinds.findIndex((known) => known.kind === part.kind);
    store.set(
      ["definition", "parts"],
      next.sort((/** @type {any} */ a, /** @type {any} */ b) => place(a) - place(b)),
    );
    if (on && start.point && !points.length) markEnd(store, true, 0);
    build();
  }

  function build() {
    const asked = parts();
    const isAsked = (/** @type {any} */ { kind }) => asked.some((/** @type {any} */ entry) => entry.kind === kind);
    built = JSON.stringify([kinds, points, asked.map((/** @type {any} */ { kind }) => kind)]);
    refill(
      element,
      kinds.map((kind) => {
        const i = asked.findIndex((/** @type {any} */ entry) => entry.kind === kind.kind);
        const path = ["definition", "parts", i];
        const worth = { "aria-label": t("author-points-of", { part: kind.label }) };
        const given = i < 0 ? kinds.find((other) => isAsked(other) && givesAway(kind, other)) : null;
        const why =
          given &&
          el("span", {
            class: "hint",
            id: uniqueId("author"),
            text: t("author-part-not-beside", { part: given.label }),
          });
        return el(
          "div",
          { class: "stack" },
          el(
            "div",
            { class: "row author-part" },
            tick(kind.label, i >= 0, (on) => ask(kind, on), {
              dataset: { part: kind.kind },
              disabled: Boolean(why),
              "aria-describedby": why?.id,
            }),
            why,
            i < 0 ? null : numberInput(store, [...path, "points"], worth),
            i < 0 ? null : el("span", { class: "hint", text: t("author-points") }),
          ),
          i >= 0 && kind.keys.length
            ? el(
                "details",
                { class: "author-keys", open: true },
                el("summary", { text: t("author-part-keys", { part: kind.label }) }),
                el(
                  "div",
                  { class: "row" },
                  kind.keys.map((/** @type {any} */ key) => keyField(store, path, key, points)),
                ),
              )
            : null,
        );
      }),
      total,
    );
    show();
  }

  function show() {
    const sum = parts().reduce((/** @type {number} */ all, /** @type {any} */ entry) => all + Number(entry.points), 0);
    total.textContent = t("author-points-total", { points: sum });
  }
  return {
    element,
    fill: build,
    /** @param {any} view */
    show: (view) => {
      const rank = (/** @type {any} */ { kind }) => (FIRST.includes(kind) ? FIRST.indexOf(kind) : FIRST.length);
      kinds = view.kinds.toSorted((/** @type {any} */ a, /** @type {any} */ b) => rank(a) - rank(b));
      points = store.at(["definition", "figure", "marks"]) ?? [];
      const asked = parts().map((/** @type {any} */ { kind }) => kind);
      if (JSON.stringify([kinds, points, asked]) !== built) build();
      else show();
    },
  };
}

/** Whether one of two kinds shows the answer to the other. @param {any} one @param {any} other @returns {boolean} */
function givesAway(one, other) {
  return one.gives_away.includes(other.kind) || other.gives_away.includes(one.kind);
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
    refill(
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
    refill(
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
            ? [
                ...["from", "to", "step"].map((what) =>
                  field(t(`author-draw-${what}-short`), numberInput(store, [...path, "draw", what], label(what))),
                ),
                numbersField(store, t("author-draw-without"), [...path, "draw", "without"]),
              ]
            : null,
          wordsField(store, t("author-aliases"), [...path, "aliases"]),
        );
      }),
      names.length ? part("author-needs", true) : null,
      names.length
        ? choicesField(
            store,
            t("author-needs"),
            ["definition", "needs"],
            names.map((value) => ({ value, label: value })),
          )
        : null,
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
/** What each is where nothing is said. */
const WEIGHTS = { joint: "1", twist: "1", length: "1", offset: "1", rule: "1", sign: "0.5", row: "2", table: "3" };
const TOOLS = ["catalogue", "playground", "matrices", "trainer"];

/** How much is told, how often one may try, and what may be used meanwhile. @param {DraftStore} store */
export function helpSection(store) {
  const element = el("div", { class: "stack" });
  function build() {
    const options = LEVELS.map((value) => ({ value, label: t(`form-help-${value}`) }));
    const ladder = store.at(["definition", "help", "ladder"]);
    refill(
      element,
      choiceField(store, t("author-help-most"), ["definition", "help", "most"], options, "repair"),
      tick(t("author-help-ladder"), Boolean(ladder), (on) => {
        const most = store.at(["definition", "help", "most"]) ?? "repair";
        const rungs = LEVELS.slice(1, Math.max(2, LEVELS.indexOf(most) + 1));
        store.set(["definition", "help", "ladder"], on ? rungs : undefined);
        build();
      }),
      ladder ? rungsField(ladder) : null,
      numberField(store, t("author-attempts"), ["definition", "access", "attempts"], { placeholder: "∞" }),
      numberField(store, t("author-variants"), ["definition", "access", "variants"], { placeholder: "∞" }),
      ...part("author-access", true),
      TOOLS.map((tool) =>
        tick(
          t(`author-access-${tool}`),
          store.at(["definition", "access", tool]) !== false,
          (on) => store.set(["definition", "access", tool], on ? undefined : false),
          { dataset: { path: `definition/access/${tool}` } },
        ),
      ),
      ...part("author-weights", true),
      el(
        "div",
        { class: "author-columns" },
        Object.entries(WEIGHTS).map(([name, usual]) =>
          numberField(store, t(`author-weight-${name}`), ["definition", "weights", name], { placeholder: usual }),
        ),
      ),
    );
  }

  /** The most that is told at the first attempt, the second, and so on. @param {string[]} ladder */
  function rungsField(ladder) {
    const path = ["definition", "help", "ladder"];
    const become = (/** @type {string[]} */ next) => {
      store.set(path, next);
      build();
    };
    const rung = (/** @type {string} */ level, /** @type {number} */ i) =>
      field(
        t("author-rung", { number: i + 1 }),
        el(
          "select",
          {
            dataset: { path: [...path, i].join("/") },
            onchange: (event) => become(ladder.map((entry, k) => (k === i ? event.target.value : entry))),
          },
          LEVELS.map((value) => el("option", { value, selected: value === level, text: t(`form-help-${value}`) })),
        ),
      );
    const last = ladder[ladder.length - 1];
    return group(t("author-rungs"), [
      ...ladder.map(rung),
      el("button", { type: "button", onclick: () => become([...ladder, last]), text: t("author-rung-more") }),
      ladder.length > 1
        ? el("button", { type: "button", onclick: () => become(ladder.slice(0, -1)), text: t("author-rung-less") })
        : null,
    ]);
  }
  return { element, fill: build, show: () => undefined };
}
