/** Ways to a table other than typing it: a catalogue robot, joint axes, an SCM chain, URDF. */

import { Latest, Problem } from "../api.js";
import { el, fill, uniqueId, VERBATIM } from "../dom.js";
import { t } from "../i18n.js";
import { problemNotice } from "../problem.js";
import { Cells, cellValue } from "./cells.js";

/**
 * @typedef {{table: any, parameters?: Record<string, number>, configurations?: Record<string, {joints: number[], meaning: string}>,
 *   limits?: import("../joint-ranges.js").Limits, limits_source?: string | null, id?: string,
 *   source?: {document: string, place: string, figures: string}}} Found a robot as it goes into the page
 */

/**
 * A choice of the catalogue's robots.
 * @param {import("../api.js").Api} api @param {(call: (signal: AbortSignal) => Promise<Found>) => Promise<unknown>} bring
 * @returns {{element: HTMLElement, show: (id: string, from?: Found["source"]) => void}} `show` says which robot it is, if
 *   it is one of these, and where its figures come from
 */
export function catalogueChoice(api, bring) {
  const id = uniqueId("catalogue");
  const select = /** @type {HTMLSelectElement} */ (
    el("select", { id }, el("option", { value: "", text: t("playground-catalogue-choose") }))
  );
  const problem = el("div", { hidden: true });
  const origin = el("details", { hidden: true });
  /** @param {unknown} error */
  const show = (error) => {
    problem.hidden = !error;
    fill(problem, error ? problemNotice(error) : null);
  };
  select.addEventListener("change", () => {
    show(null);
    if (select.value) bring((signal) => api.get(`robots/${select.value}`, { signal })).catch(show);
  });
  let shown = "";
  api.get("robots").then(({ robots }) => {
    select.append(...robots.map((/** @type {any} */ robot) => el("option", { value: robot.id, text: robot.name })));
    if (!select.value) select.value = shown; // the robot may have come before the list that names it
  }, show);
  const element = el(
    "div",
    { class: "field" },
    el("label", { for: id, text: t("playground-catalogue") }),
    select,
    origin,
    problem,
  );
  return {
    element,
    show: (robot, from) => {
      shown = robot;
      select.value = robot;
      origin.hidden = !robot || !from;
      if (!from) return;
      fill(
        origin,
        el("summary", { text: t("playground-origin") }),
        el("p", { class: "hint", text: `${from.document}: ${from.place}.` }),
        el("p", { class: "hint", text: from.figures }),
      );
    },
  };
}

const JOINTS = () => ["revolute", "prismatic"].map((value) => ({ value, label: t(`form-joint-${value}`) }));

/** Joint axes in, a table out. @param {import("../api.js").Api} api @param {(found: Found) => void} use */
export function axesSource(api, use) {
  const columns = [
    { name: "joint", label: t("form-joint"), options: JOINTS(), otherwise: "revolute" },
    ...["px", "py", "pz"].map((name) => ({ name, label: t(`playground-axis-${name}`), otherwise: "0" })),
    ...["ux", "uy", "uz"].map((name) => ({
      name,
      label: t(`playground-axis-${name}`),
      otherwise: name === "uz" ? "1" : "0",
    })),
  ];
  const rows = [
    { joint: "revolute", px: "0", py: "0", pz: "0", ux: "0", uy: "0", uz: "1" },
    { joint: "revolute", px: "0", py: "0", pz: "0.4", ux: "0", uy: "-1", uz: "0" },
    { joint: "revolute", px: "0.5", py: "0", pz: "0.4", ux: "0", uy: "-1", uz: "0" },
  ];
  const grid = new Cells(t("playground-axes"), columns, { rows });
  /** @param {string} convention @param {any} signal */
  const run = async (convention, signal) => {
    const axes = grid.rows.map((row) => ({
      joint: row.joint,
      point: [row.px, row.py, row.pz].map(cellValue),
      direction: [row.ux, row.uy, row.uz].map(cellValue),
    }));
    const answer = await api.post("assign-frames", { axes, convention, angle_unit: "deg" }, { signal });
    return { found: { table: answer.table }, shown: frameList(answer) };
  };
  return source(t("playground-from-axes"), t("playground-axes-hint"), [grid.element], use, {
    [t("playground-to-modified")]: (signal) => run("modified", signal),
    [t("playground-to-standard")]: (signal) => run("standard", signal),
  });
}

/** @param {any} options */
function frameList({ frames, warnings = [] }) {
  const items = frames.map((/** @type {any} */ frame, /** @type {number} */ i) => {
    const free = frame.free.map((/** @type {string} */ name) => t(`playground-free-${name}`)).join(", ");
    const rule = t(`playground-rule-${frame.rule}`);
    return el(
      "li",
      {},
      el("strong", { text: t("playground-frame", { number: i }) }),
      ` ${rule}${free ? ` · ${free}` : ""}`,
    );
  });
  return [
    el("ul", { class: "frame-rules" }, items),
    ...warnings.map((/** @type {any} */ warning) =>
      el("p", { class: "notice", text: warning.detail ?? warning.message }),
    ),
  ];
}

/** An SCM chain in, a modified table out. @param {import("../api.js").Api} api @param {(found: Found) => void} use */
export function scmSource(api, use) {
  const entries = ["x", "y", "z", "a", "b", "c"].map((name) => ({ name, label: name.toUpperCase(), otherwise: "0" }));
  const row = (/** @type {(string | number)[]} */ ...cells) =>
    Object.fromEntries(entries.map(({ name }, i) => [name, String(cells[i])]));
  const joints = new Cells(t("playground-chain"), entries, {
    rows: [
      row(0, 0, "L0", "a1", 0, 0),
      row(0, "L1", 0, 0, "a2", 0),
      row(0, 0, "d3", 0, 0, 0),
      row(0, 0, 0, "a4", 0, 0),
      row(0, 0, 0, 0, "a5", 0),
      row(0, 0, "L2", "a6", 0, 0),
    ],
  });
  const ends = new Cells(t("playground-chain-end"), entries, { rows: [row(0, 0, 0, 0, 0, 0)], fixed: true });
  /** @param {any} signal */
  const run = async (signal) => {
    const chain = { joints: joints.rows.map(values), final: values(ends.rows[0]), angle_unit: "deg" };
    const answer = await api.post("convert", { scm: chain, to: "modified" }, { signal });
    return { found: { table: answer.table }, shown: [] };
  };
  const title = el("h3", { text: t("playground-chain-end") });
  return source(t("playground-from-scm"), t("playground-scm-hint"), [joints.element, title, ends.element], use, {
    [t("playground-to-modified")]: run,
  });
}

/** @param {any} row */
const values = (row) => Object.fromEntries(Object.entries(row).map(([name, text]) => [name, cellValue(text)]));

/** URDF in, a table out. @param {import("../api.js").Api} api @param {(found: Found) => void} use */
export function urdfSource(api, use) {
  const id = uniqueId("urdf");
  const area = /** @type {HTMLTextAreaElement} */ (el("textarea", { id, rows: "8", ...VERBATIM }));
  const field = el("div", { class: "field" }, el("label", { for: id, text: "URDF" }), area);
  /** @param {any} to @param {any} signal */
  const run = async (to, signal) => {
    const answer = await api.post("convert", { urdf: area.value, to, angle_unit: "deg" }, { signal });
    return { found: { table: answer.table, limits: answer.limits ?? null }, shown: [] };
  };
  return source(t("playground-from-urdf"), t("playground-urdf-hint"), [field], use, {
    [t("playground-to-modified")]: (signal) => run("modified", signal),
    [t("playground-to-standard")]: (signal) => run("standard", signal),
  });
}

/**
 * @param {string} title @param {string} hint @param {Node[]} fields @param {(found: Found) => void} use
 * @param {Record<string, (signal: AbortSignal) => Promise<{found: Found, shown: Node[]}>>} actions by the label of
 *   their button; of several that were pressed, the last one counts
 */
function source(title, hint, fields, use, actions) {
  const answer = el("div", { class: "tool-answer", role: "status" });
  const latest = new Latest();
  /** @param {any} action */
  const press = async (action) => {
    try {
      const done = await latest.run(action);
      if (!done) return;
      use(done.value.found);
      fill(answer, el("p", { text: t("playground-taken") }), ...done.value.shown);
    } catch (error) {
      if (!(error instanceof Problem)) console.error(error);
      fill(answer, problemNotice(error));
    }
  };
  const buttons = Object.entries(actions).map(([label, action]) =>
    el("button", { type: "button", onclick: () => press(action) }, label),
  );
  return el(
    "details",
    { class: "tool" },
    el("summary", {}, title),
    el(
      "div",
      { class: "stack" },
      el("p", { class: "hint", text: hint }),
      ...fields,
      el("div", { class: "row" }, buttons),
      answer,
    ),
  );
}
