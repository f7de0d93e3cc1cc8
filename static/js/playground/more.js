/**
 * More about this robot: one entry a tool, with the call that it makes and how the answer is shown. Loaded when
 * somebody opens the group.
 */

import { Latest } from "../api.js";
import { el, fill, segmented, uniqueId, VERBATIM } from "../dom.js";
import { rowsTable } from "../editor/rows-table.js";
import { named as called, t } from "../i18n.js";
import { shown } from "../numbers.js";
import { Cells, cellValue } from "./cells.js";
import { MISTAKES } from "./mistakes.js";
import { asked, sameRobot, Tool } from "./tool.js";
import { angleSign, closedForm, formula, FORMATS, matrix, named, numbers, scroller } from "./values.js";

/**
 * @typedef {import("./tool.js").Subject} Subject
 * @typedef {{api: import("../api.js").Api, show: (joints: number[]) => void, again: () => void,
 *   robot: () => import("../live-robot.js").Robot | null, joints: () => number[]}} Context
 *   how the robot is moved to joint values in the table's units, how a tool is asked again, the robot that is drawn and
 *   its joint values [rad or length]
 * @typedef {{controls: Node[], take?: (subject: Subject) => void, value: () => any}} Fields what stands above an answer
 * @typedef {{id: string, fields?: (context: Context) => Fields,
 *   call: (subject: Subject, value: any, api: import("../api.js").Api) => Promise<[string, any] | string | null>,
 *   show: (answer: any, context: Context) => Node[]}} Entry
 *   `call` gives the path and the body of what is asked, a sentence that says why it cannot be, or null while there
 *   is nothing to ask
 */

/** @type {Entry[]} */
const ENTRIES = [
  {
    id: "inverse",
    call: async (subject) => ["inverse-kinematics", { ...symbolic(subject), formats: FORMATS }],
    show: inverseForms,
  },
  {
    id: "singularities",
    fields: conditionFields,
    call: async (subject, conditions) => ["check-singularities", { ...asked(subject), conditions }],
    show: singularities,
  },
  {
    id: "rotations",
    call: async (subject, _, api) => {
      const question = { ...asked(subject), joints: subject.joints, parts: ["transform"] };
      const { transform } = await api.post("forward-kinematics", question);
      const rows = transform.slice(0, 3).map((/** @type {number[]} */ row) => row.slice(0, 3));
      return ["rotations", { orientation: { matrix: rows }, angle_unit: subject.units.angle }];
    },
    show: notations,
  },
  { id: "dynamics", fields: bodyFields, call: motionCall, show: motion },
  ...MISTAKES,
  {
    id: "compare",
    fields: keptTable,
    call: async (subject, kept) => kept && comparison(kept, subject),
    show: compared,
  },
];

/** The tools of the group. @param {Omit<Context, "again">} context */
export function moreTools(context) {
  return ENTRIES.map((entry) => tool(entry, context));
}

/** @param {Entry} entry @param {Omit<Context, "again">} outer */
function tool(entry, outer) {
  const context = { ...outer, again: () => made.refresh() };
  const fields = entry.fields?.(context);
  const latest = new Latest();
  let key = "";
  /** @type {Node[]} */
  let nodes = [];
  /** @type {Subject | null} */
  let of = null;
  const made = new Tool(
    t(`playground-more-${entry.id}`),
    async (subject, body) => {
      const call = await entry.call(subject, fields?.value(), outer.api);
      if (!call) return [];
      if (typeof call === "string") return [el("p", { text: call })];
      if (JSON.stringify(call) === key) return nodes;
      body.setAttribute("aria-busy", "true");
      body.classList.add("busy");
      try {
        const found = await latest.run((signal) => outer.api.post(call[0], call[1], { signal }));
        if (!found) return nodes;
        nodes = entry.show(found.value, context);
        key = JSON.stringify(call);
        return nodes;
      } finally {
        body.removeAttribute("aria-busy");
        body.classList.remove("busy");
      }
    },
    {
      controls: [
        el(
          "div",
          { class: "stack" },
          el("p", { class: "hint", text: t(`playground-more-${entry.id}-hint`) }),
          fields?.controls,
        ),
      ],
    },
  );
  return {
    element: made.element,
    /** @param {Subject | null} subject */
    take(subject) {
      if (subject && !sameRobot(subject, of)) {
        latest.cancel();
        of = subject;
        fields?.take?.(subject);
      }
      made.take(subject);
    },
  };
}

/** A table in closed form: names stay names. @param {Subject} subject */
const symbolic = ({ table }) => ({ table, form: "symbolic", notation: "short" });

/** @param {any} answer */
function inverseForms({ equations, conditions, code, variables }) {
  const latex = equations.map((/** @type {any} */ equation) => equation.latex).join(" \\\\\n");
  const condition = (/** @type {any} */ { kind, latex: source }) =>
    el("li", {}, `${t(`playground-condition-${kind}`)} `, formula(source, { display: false }));
  const lines = equations.map((/** @type {any} */ { latex: source, meaning, conditions: own, singular }) => {
    const whole = meaning ? `${source}\\quad (=${meaning.latex})` : source;
    const hints = [...own.map(condition), ...singular.filter(determines).map(choice(variables))];
    return el("div", {}, formula(whole), el("ul", { class: "plain-list hint" }, hints));
  });
  const name = t("playground-more-inverse");
  const block = closedForm(name, { ...code, latex });
  fill(/** @type {Element} */ (block.querySelector(".scroller")), ...lines);
  return [block, ...(conditions.length ? [el("ul", { class: "plain-list" }, conditions.map(condition))] : [])];
}

/** Whether a singular case leaves a sum of angles determined. @param {any} singularCase */
const determines = ({ combination }) => combination !== undefined;

/** What may be chosen in a singular case, and what is determined there. @param {string[]} variables */
const choice =
  (variables) =>
  (/** @type {any} */ { free, combination, value, equations: [at] }) => {
    const joints = free.map((/** @type {number} */ joint) => variables[joint - 1]).join(" / ");
    const source = `${at.latex}:\\quad ${combination.latex}=${value.latex}`;
    return el("li", {}, `${t("playground-singular-choice", { joints })} `, formula(source, { display: false }));
  };

/** @param {Context} context @returns {Fields} */
function conditionFields({ again }) {
  const field = el("textarea", { rows: "2", ...VERBATIM, onchange: again });
  return {
    controls: [el("label", { class: "field" }, t("playground-conditions"), field)],
    value: () => field.value.split("\n").filter((line) => line.trim()),
  };
}

/** @param {any} answer @param {Context} context */
function singularities({ correct, whole, conditions, families }, { show }) {
  const verdict = conditions.length
    ? [el("p", { text: t(`playground-conditions-${correct ? "right" : "wrong"}`) })]
    : [];
  const said = conditions.filter((/** @type {any} */ { message }) => message);
  const postures = families.map((/** @type {any} */ { example, found }, /** @type {number} */ i) => {
    const name = t("playground-family", { number: i + 1 });
    const look = { type: "button", class: "small", "aria-label": called(name, t("playground-show")) };
    const label = conditions.length ? `${name} (${t(found === 1 ? "playground-found" : "playground-missing")})` : name;
    const button = example ? el("button", { ...look, onclick: () => show(example) }, t("playground-show")) : null;
    return el("li", { class: "row" }, label, button);
  });
  return [
    ...verdict,
    el(
      "ul",
      { class: "plain-list" },
      said.map((/** @type {any} */ { number, message }) => el("li", { text: called(number, message) })),
    ),
    el("p", { text: t(whole ? "playground-families" : "playground-families-some", { count: families.length }) }),
    el("ul", { class: "plain-list" }, postures),
  ];
}

/** @param {any} answer */
function notations({ matrix: rows, quaternion, axis, angle, sequences, angle_unit: unit }) {
  const sign = angleSign(unit);
  const lines = sequences.map((/** @type {any} */ { axes, turning, triples, family }) =>
    el(
      "tr",
      {},
      el("th", { scope: "row", text: `${axes}, ${t(`playground-turning-${turning}`)}` }),
      family
        ? el("td", { colspan: "2", text: lockedText(family, sign) })
        : triples.map((/** @type {number[]} */ triple) => el("td", { text: numbers(triple, sign) })),
    ),
  );
  const name = t("playground-sequences");
  return [
    named([
      [t("playground-quaternion"), numbers(quaternion)],
      [t("playground-axis-angle"), `${numbers(axis)} · ${numbers([angle], sign)}`],
    ]),
    matrix(t("playground-rotation-matrix"), rows, "R"),
    scroller(name, el("table", { class: "solutions" }, el("caption", { text: name }), el("tbody", {}, lines))),
  ];
}

/** @param {any} family @param {string} sign */
function lockedText({ middle, combination, value }, sign) {
  const relation = combination === "sum" ? "α + γ" : "α − γ";
  return `β = ${shown(middle)} ${sign}, ${relation} = ${shown(value)} ${sign}`;
}

/** @param {Context} context @returns {Fields} */
function bodyFields({ again }) {
  const names = ["mass", "x", "y", "z", "rate"];
  const columns = names.map((name) => ({ name, label: t(`playground-body-${name}`), otherwise: "0" }));
  const cells = new Cells(t("playground-bodies"), columns, { rows: [], fixed: true, onchange: () => again() });
  let form = "numbers";
  const mode = segmented({
    name: uniqueId("dynamics-mode"),
    label: t("form-matrix-mode"),
    value: form,
    options: ["numbers", "symbols"].map((value) => ({ value, label: t(`form-matrix-${value}`) })),
    onchange: (value) => {
      form = value;
      again();
    },
  });
  return {
    controls: [mode, cells.element],
    take: ({ table: { rows } }) => {
      if (rows.length === cells.rows.length) return;
      cells.rows = rows.map(() => ({ mass: "1" }));
    },
    value: () => ({ form, rows: cells.rows.map((row) => names.map((name) => cellValue(row[name]))) }),
  };
}

/** @param {Subject} subject @param {any} value @returns {Promise<[string, any]>} */
async function motionCall(subject, { form, rows }) {
  const inSymbols = form === "symbols";
  /** @param {any} row @param {number} i */
  const body = ([mass, ...at], i) => ({ mass: inSymbols && mass ? `m${i + 1}` : mass, centre: at.slice(0, 3) });
  const links = rows.map(body);
  if (inSymbols) return ["dynamics", { ...symbolic(subject), links, formats: FORMATS }];
  const rates = rows.map((/** @type {any} */ row) => row[4]);
  const moving = rates.filter(
    (/** @type {any} */ _, /** @type {number} */ i) => subject.table.rows[i].joint !== "fixed",
  );
  return ["dynamics", { ...asked(subject), links, joints: subject.joints, rates: moving }];
}

/** @param {any} answer */
function motion(answer) {
  return ["M", "C", "g"].map((part) => {
    const value = answer[part];
    const name = t(`playground-motion-${part}`);
    if (!Array.isArray(value)) return closedForm(name, value);
    return matrix(name, part === "g" ? value.map((/** @type {number} */ entry) => [entry]) : value, part);
  });
}

/** @param {Context} context @returns {Fields} */
function keptTable({ again }) {
  /** @type {any} */
  let present = null;
  /** @type {any} */
  let kept = null;
  const button = el("button", { type: "button" }, t("playground-compare-keep"));
  const shownKept = el("div", {});
  button.addEventListener("click", () => {
    kept = present;
    fill(shownKept, kept && rowsTable(kept.table));
    again();
  });
  return {
    controls: [el("div", {}, button), shownKept],
    take: ({ table, parameters }) => {
      present = { table, parameters };
    },
    value: () => kept,
  };
}

/** Both tables with the values of their names, which have to agree. @param {any} kept @param {Subject} subject */
function comparison(kept, { table, parameters }) {
  const names = Object.keys(kept.parameters).filter((name) => !same(kept.parameters[name], parameters[name]));
  if (names.length) return t("playground-compare-names", { names: names.join(", ") });
  const values = { ...kept.parameters, ...parameters };
  return /** @type {[string, any]} */ (["compare-tables", { first: kept.table, second: table, parameters: values }]);
}

/** Whether a name has one value, or only one of the tables has it. @param {any} kept @param {any} present */
function same(kept, present) {
  return present === undefined || String(kept) === String(present);
}

/** @param {any} answer */
function compared({ same, feedback }) {
  const imprecise = feedback.some((/** @type {any} */ { code }) => code === "entries_imprecise");
  const told = imprecise ? feedback.slice(1) : feedback;
  const sentences = told.map((/** @type {any} */ { message }) => el("li", { text: message }));
  const verdict = same ? "same" : imprecise ? "imprecise" : "different";
  return [el("p", { text: t(`playground-compare-${verdict}`) }), el("ul", { class: "plain-list" }, sentences)];
}
