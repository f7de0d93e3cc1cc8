/** Inverse kinematics: a pose to reach, every set of joint values that reaches it, and a look at each. */

import { Latest, Problem } from "../api.js";
import { dataTable } from "../data-table.js";
import { el, fill, setAble } from "../dom.js";
import { named, t } from "../i18n.js";
import { fractionIn, plain, shown } from "../numbers.js";
import { problemNotice } from "../problem.js";
import { Cells } from "./cells.js";
import { asked, sameRobot } from "./tool.js";

const ROWS = [0, 1, 2];

/**
 * @param {import("../api.js").Api} api
 * @param {{pose: () => Promise<number[][] | null>, show: (joints: number[]) => void, shade: (postures: number[][]) => void,
 *   found: (postures: number[][]) => void}} options
 *   the robot's present pose, how to bring it to joint values, how to draw postures beside it, and who else wants to
 *   know them (all in the table's units)
 */
export function inverseTool(api, { pose, show, shade, found: tell }) {
  /** @type {import("./tool.js").Subject | null} */
  let subject = null;
  /** Whose solutions are shown. @type {import("./tool.js").Subject | null} */
  let of = null;
  const columns = ["x", "y", "z", "p"].map((name) => ({ name, label: t(`playground-target-${name}`), otherwise: "0" }));
  let edited = false;
  const target = new Cells(t("playground-target"), columns, {
    rows: poseRows(identity()),
    fixed: true,
    onchange: () => {
      edited = true;
      poses.cancel();
      forget(answer.querySelector("[role=alert]")); // which says what is to be corrected
    },
  });
  const answer = el("div", { class: "tool-answer", role: "status" });
  /** Solutions that are drawn side by side. @type {number[][]} */
  let postures = [];
  let shaded = true;
  const draw = () => shade(shaded && element.open ? postures : []);
  /** @param {number[][]} next */
  const know = (next) => {
    postures = next;
    draw();
    tell(next);
  };
  const ghosts = {
    get shown() {
      return shaded;
    },
    /** @param {boolean} next */
    set(next) {
      shaded = next;
      draw();
    },
  };
  const take = el("button", { type: "button", onclick: () => takePose() }, t("playground-target-present"));
  const solve = el("button", { type: "button", class: "primary", onclick: () => run() }, t("playground-solve"));
  const element = /** @type {HTMLDetailsElement} */ (
    el(
      "details",
      { class: "tool" },
      el("summary", {}, t("playground-inverse")),
      el("div", { class: "stack" }, target.element, el("div", { class: "row" }, take, solve), answer),
    )
  );
  const poses = new Latest();
  /** The present pose on its way into the fields: what is solved is what will stand there. @type {Promise<void>} */
  let taking = Promise.resolve();
  const takePose = () => {
    taking = poses.run(pose).then(
      (present) => {
        if (!present?.value) return;
        target.rows = poseRows(present.value);
        edited = false;
        forget();
      },
      () => undefined,
    );
  };
  /** Marks the cells that hold no number, and says which. @returns {boolean} whether there are none */
  const isNumeric = () => {
    const faults = target.rows.flatMap((cells, row) =>
      columns
        .filter(({ name }) => fractionIn(cells[name]) === null)
        .map(({ name, label }) => ({ row, name, text: t("form-row-cell", { row: row + 1, name: label }) })),
    );
    target.mark(faults);
    if (faults.length) {
      const lines = faults.map(({ text }) => el("li", { text: named(text, t("playground-target-number")) }));
      fill(answer, el("div", { class: "notice notice-problem", role: "alert" }, el("ul", {}, lines)));
      know([]);
    }
    return faults.length === 0;
  };
  const latest = new Latest();
  /** What was found, or is on its way, was for another robot, other limits or another target. @param {Element | null} [notice] that stays */
  const forget = (notice = null) => {
    latest.cancel();
    setAble(solve, true);
    fill(answer, notice);
    know([]);
  };
  /** Solving was asked for while the robot was being read. */
  let wanted = false;
  const run = async () => {
    await taking;
    wanted = !subject;
    if (!subject || !isNumeric()) return;
    const limits = subject.limits ? { limits: subject.limits } : {};
    const request = { ...asked(subject), ...limits, target: matrixOf(target.rows) };
    setAble(solve, false);
    try {
      const found = await latest.run((signal) => api.post("inverse-kinematics", request, { signal }));
      if (!found) return;
      fill(answer, ...report(found.value, show, ghosts));
      know(found.value.solutions.map((/** @type {any} */ { joints }) => joints));
    } catch (error) {
      fill(
        answer,
        isSkew(error)
          ? el("p", { class: "notice notice-problem", role: "alert", text: t("playground-target-skew") })
          : problemNotice(error),
      );
      know([]);
    }
    setAble(solve, true);
  };
  element.addEventListener("toggle", () => {
    draw();
    if (element.open && !edited && !answer.hasChildNodes()) takePose();
  });
  return {
    element,
    /** @param {import("./tool.js").Subject | null} next */
    take(next) {
      if (next && !sameRobot(next, of)) {
        forget();
        if (!edited) takePose();
      } else if (next && JSON.stringify(next.limits) !== JSON.stringify(of?.limits)) forget();
      of = next ?? of;
      subject = next;
      if (next && wanted) run();
    },
  };
}

/** @param {any} found @param {any} show @param {{shown: boolean, set: (shown: boolean) => void}} ghosts */
function report(found, show, ghosts) {
  const count = found.solutions.length;
  const status = t(`playground-status-${found.status}`, { count });
  const complete = t(found.complete ? "playground-complete" : "playground-incomplete");
  const outside = found.outside_limits ? t("playground-outside-limits", { count: found.outside_limits }) : "";
  if (!count) return [el("p", { text: `${status} ${outside}` })];
  const names = found.solutions[0].joints.map((/** @type {any} */ _, /** @type {number} */ i) => `q${i + 1}`);
  const table = dataTable(
    t("playground-solutions"),
    [t("playground-show"), ...names, t("playground-residual")],
    found.solutions.map((/** @type {any} */ solution, /** @type {number} */ i) => [
      el(
        "button",
        {
          type: "button",
          class: "small",
          "aria-label": t("playground-show-solution", { number: i + 1 }),
          onclick: () => show(solution.joints),
        },
        t("playground-show"),
      ),
      ...solution.joints.map((/** @type {number} */ q) => shown(q, 3)),
      solution.residual.toExponential(1),
    ]),
    { kind: "solutions" },
  );
  return [
    el("p", { text: `${status} ${complete} ${outside}` }),
    el(
      "label",
      { class: "check" },
      el("input", { type: "checkbox", checked: ghosts.shown, onchange: (event) => ghosts.set(event.target.checked) }),
      t("playground-ghosts"),
    ),
    table,
  ];
}

/** Whether a pose is refused for its axes: what else the service says of them is about requests. @param {unknown} error */
function isSkew(error) {
  return error instanceof Problem && error.code === "pose_not_orthonormal";
}

const identity = () => [
  [1, 0, 0, 0],
  [0, 1, 0, 0],
  [0, 0, 1, 0],
  [0, 0, 0, 1],
];

/** @param {any} pose */
function poseRows(pose) {
  return ROWS.map((i) => Object.fromEntries(["x", "y", "z", "p"].map((name, k) => [name, plain(pose[i][k], 10)])));
}

/** @param {any} rows */
function matrixOf(rows) {
  return [
    ...rows.map((/** @type {any} */ { x, y, z, p }) => [x, y, z, p].map((text) => fractionIn(text))),
    [0, 0, 0, 1],
  ];
}
