/** The same robot written otherwise: the other convention, the product of exponentials, URDF. */

import { Latest } from "../api.js";
import { copyText } from "../clipboard.js";
import { dataTable } from "../data-table.js";
import { announce, el, fill } from "../dom.js";
import { rowsTable } from "../editor/rows-table.js";
import { t } from "../i18n.js";
import { shown } from "../numbers.js";
import { problemNotice } from "../problem.js";
import { asked, sameRobot } from "./tool.js";
import { matrix } from "./values.js";

const TARGETS = ["standard", "modified", "poe", "urdf"];

/** @param {import("../api.js").Api} api @param {{use: (table: any) => void}} options */
export function convertTool(api, { use }) {
  /** @type {import("./tool.js").Subject | null} */
  let subject = null;
  /** Whose other form is shown. @type {import("./tool.js").Subject | null} */
  let of = null;
  const answer = el("div", { class: "tool-answer", role: "status" });
  const latest = new Latest();
  /** @param {any} to */
  const run = async (to) => {
    if (!subject) return;
    try {
      const symbolic = to === "standard" || to === "modified";
      const request = symbolic ? { table: subject.table } : asked(subject);
      const found = await latest.run((signal) => api.post("convert", { ...request, to }, { signal }));
      if (found) fill(answer, ...report(found.value, to, use));
    } catch (error) {
      fill(answer, problemNotice(error));
    }
  };
  const buttons = TARGETS.map((to) =>
    el("button", { type: "button", onclick: () => run(to) }, t(`playground-to-${to}`)),
  );
  const element = el(
    "details",
    { class: "tool" },
    el("summary", {}, t("playground-convert")),
    el("div", { class: "stack" }, el("div", { class: "row" }, buttons), answer),
  );
  return {
    element,
    /** @param {import("./tool.js").Subject | null} next */
    take(next) {
      if (next && !sameRobot(next, of)) {
        latest.cancel();
        fill(answer);
        of = next;
      }
      subject = next;
    },
  };
}

/** @param {any} found @param {any} to @param {any} use */
function report(found, to, use) {
  if (to === "urdf") return [sourceText(found.urdf, "URDF")];
  if (to === "poe") return [screwTable(found), matrix(t("playground-home-pose"), found.home, "M")];
  /** @param {any} pose */
  const moved = (pose) =>
    pose &&
    pose.some((/** @type {any} */ row, /** @type {number} */ i) =>
      row.some((/** @type {any} */ value, /** @type {number} */ k) => value !== (i === k ? 1 : 0)),
    );
  return [
    rowsTable(found.table),
    moved(found.base) ? matrix(t("playground-base"), found.base, "B") : null,
    moved(found.tool) ? matrix(t("playground-tool"), found.tool, "E") : null,
    el("div", {}, el("button", { type: "button", onclick: () => use(found.table) }, t("playground-use-table"))),
  ].filter(Boolean);
}

/** @param {any} found */
function screwTable(found) {
  return dataTable(
    t("playground-screws"),
    ["S", "ωx", "ωy", "ωz", "vx", "vy", "vz"],
    found.screws.map((/** @type {any} */ { angular, linear }, /** @type {number} */ i) => [
      `S${i + 1}`,
      ...[...angular, ...linear].map((value) => shown(value)),
    ]),
    { kind: "solutions" },
  );
}

/** @param {string} text @param {string} name */
function sourceText(text, name) {
  const copy = async () => announce(t((await copyText(text)) ? "form-copied" : "form-copy-failed", { format: name }));
  return el(
    "div",
    { class: "stack" },
    el("div", {}, el("button", { type: "button", onclick: copy }, t("playground-copy-text", { format: name }))),
    el("pre", { class: "source-text", tabindex: "0", role: "region", "aria-label": name }, el("code", { text })),
  );
}
