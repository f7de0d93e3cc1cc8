/**
 * Fields for what is asked besides the table. Each has the same interface:
 * `element`, `value` (as it goes to the API, or null if nothing was typed), `state` (get and set: what was
 * typed), `showFaults(faults)`, `focus(where?)`, `onchange`.
 */

import { el, faultLine, fill, setFault, uniqueId, VERBATIM } from "../dom.js";
import { t } from "../i18n.js";
import { typed } from "./typed.js";
import { showMathml, transformName } from "../typeset.js";
import { blockOf, readMatrix } from "./matrix-text.js";

const RELATIONS = [
  "coincident",
  "parallel",
  "intersecting_perpendicular",
  "intersecting_oblique",
  "skew_perpendicular",
  "skew_oblique",
];

/** A 4×4 of cells. */
export class MatrixField {
  onchange = () => {};
  /** What stood here before a matrix was put in as a whole. @type {string[][] | null} */
  #undo = null;

  /** @param {{from: number, to: number}} ends */
  constructor({ from, to }) {
    const id = uniqueId("matrix");
    const name = t("form-matrix-name", { from, to });
    this.cells = [0, 1, 2, 3].map((i) =>
      [0, 1, 2, 3].map((k) => {
        const line = faultLine(`${id}-${i}${k}-fault`);
        const meaning = el("div", { class: "meaning", id: `${id}-${i}${k}-meaning` });
        const input = /** @type {HTMLInputElement} */ (
          el("input", {
            id: `${id}-${i}${k}`,
            type: "text",
            ...VERBATIM,
            "aria-label": t("form-matrix-cell", { name, row: i + 1, column: k + 1 }),
            "aria-describedby": `${meaning.id} ${line.id}`,
            value: i === 3 ? (k === 3 ? "1" : "0") : "",
            oninput: () => (setFault(input, line, ""), this.onchange()),
            onpaste: (event) => this.#paste(event, i, k),
          })
        );
        return { input, line, meaning };
      }),
    );
    this.undo = el("button", {
      type: "button",
      class: "quiet small",
      hidden: true,
      text: t("form-undo"),
      onclick: () => this.#takeBack(),
    });
    this.element = el(
      "fieldset",
      { class: "matrix-field" },
      el("legend", {}, transformName(from, to), el("span", { class: "visually-hidden", text: name })),
      el(
        "div",
        { class: "scroller", tabindex: "0", role: "group", "aria-label": name },
        el(
          "table",
          { class: "matrix-cells", role: "presentation" },
          el(
            "tbody",
            {},
            this.cells.map((row) =>
              el(
                "tr",
                {},
                row.map(({ input, line, meaning }) => el("td", {}, input, meaning, line)),
              ),
            ),
          ),
        ),
      ),
      el("div", { class: "row" }, this.#asText(name), this.undo),
    );
  }

  /** Whether something besides the last row was typed. */
  get touched() {
    return this.cells.slice(0, 3).some((row) => row.some(({ input }) => input.value.trim() !== ""));
  }

  get value() {
    if (!this.touched) return null;
    return this.cells.map((row) => row.map(({ input }) => typed(input)));
  }

  get state() {
    return this.cells.map((row) => row.map(({ input }) => input.value));
  }

  set state(values) {
    values.forEach((row, i) => row.forEach((text, k) => (this.cells[i][k].input.value = text)));
    this.#undo = null;
    this.undo.hidden = true;
  }

  /** @param {{where: number[], text: string}[]} faults */
  showFaults(faults) {
    for (const row of this.cells) for (const { input, line } of row) setFault(input, line, "");
    for (const { where, text } of faults) {
      const cell = this.cells[where[0] ?? 0]?.[where[1] ?? 0];
      if (cell) setFault(cell.input, cell.line, text);
    }
  }

  /**
   * Shows what the cells were understood as, and what cannot be read in those that nobody is typing into.
   * @param {({mathml: string} | null)[][]} meanings @param {{where: number[], text: string}[]} faults
   */
  showMeaning(meanings, faults) {
    this.cells.forEach((row, i) =>
      row.forEach(({ input, line, meaning }, k) => {
        const mathml = meanings[i]?.[k]?.mathml ?? "";
        showMathml(meaning, mathml);
        const fault = faults.find(({ where }) => where[0] === i && where[1] === k);
        if (input !== document.activeElement || !fault) setFault(input, line, fault?.text ?? "");
      }),
    );
  }

  focus([row = 0, column = 0] = []) {
    this.cells[row]?.[column]?.input.focus();
  }

  /** @param {ClipboardEvent} event @param {number} row @param {number} column */
  #paste(event, row, column) {
    const text = event.clipboardData?.getData("text/plain") ?? "";
    const whole = readMatrix(text);
    const block = whole ?? blockOf(text);
    if (!block) return;
    event.preventDefault();
    this.#put(block, whole ? 0 : row, whole ? 0 : column);
  }

  /** Writes cells into the matrix; one step takes it back. @param {string[][]} block @param {number} row @param {number} column */
  #put(block, row, column) {
    const before = this.state;
    block.forEach((line, i) =>
      line.forEach((piece, k) => {
        const cell = this.cells[row + i]?.[column + k];
        if (cell) cell.input.value = piece;
      }),
    );
    this.#undo = before;
    this.undo.hidden = false;
    this.onchange();
  }

  #takeBack() {
    if (this.#undo) this.state = this.#undo;
    this.cells[0][0].input.focus();
    this.onchange();
  }

  /** A field that takes the whole matrix as text. @param {string} name */
  #asText(name) {
    const line = faultLine(uniqueId("fault"));
    /** @type {HTMLTextAreaElement} */
    const area = el("textarea", {
      rows: 4,
      ...VERBATIM,
      "aria-label": t("form-matrix-text-label", { name }),
      "aria-describedby": line.id,
      oninput: () => {
        const matrix = area.value.trim() ? readMatrix(area.value) : null;
        setFault(area, line, area.value.trim() && !matrix ? t("form-matrix-text-unread") : "");
        if (matrix) this.#put(matrix, 0, 0);
      },
    });
    return el("details", { class: "matrix-text" }, el("summary", { text: t("form-matrix-text") }), area, line);
  }
}

/** Several matrices, one for each row of the student's table. */
export class MatrixListField {
  onchange = () => {};

  constructor() {
    /** @type {MatrixField[]} */
    this.fields = [];
    this.element = el("div", { class: "stack matrix-list" });
  }

  /** @param {number} count */
  resize(count) {
    while (this.fields.length < count) {
      const field = new MatrixField({ from: this.fields.length, to: this.fields.length + 1 });
      field.onchange = () => this.onchange();
      this.fields.push(field);
    }
    fill(
      this.element,
      this.fields.slice(0, count).map((field) => field.element),
    );
    this.count = count;
  }

  get touched() {
    return this.fields.slice(0, this.count).some((field) => field.touched);
  }

  get value() {
    return this.touched ? this.fields.slice(0, this.count).map((field) => field.value) : null;
  }

  get state() {
    return this.fields.map((field) => field.state);
  }

  set state(states) {
    this.resize(Math.max(states.length, this.count ?? 0));
    states.forEach((state, i) => (this.fields[i].state = state));
  }

  /** @param {any} faults */
  showFaults(faults) {
    this.fields.forEach((field, i) =>
      field.showFaults(
        faults
          .filter((/** @type {any} */ { where }) => where[0] === i)
          .map((/** @type {any} */ { where, text }) => ({ where: where.slice(1), text })),
      ),
    );
  }

  /** The matrices that are on the page. */
  get shown() {
    return this.fields.slice(0, this.count);
  }

  focus([index = 0, ...where] = []) {
    this.fields[index]?.focus(where);
  }
}

/** Numbers with names: the radii of a workspace. */
export class NumbersField {
  onchange = () => {};

  /** @param {{name: string, label: string, unit: string}[]} numbers */
  constructor(numbers) {
    this.inputs = new Map();
    this.element = el(
      "div",
      { class: "row end" },
      numbers.map(({ name, label, unit }) => {
        const line = faultLine(uniqueId("fault"));
        const input = /** @type {HTMLInputElement} */ (
          el("input", {
            id: uniqueId("number"),
            type: "text",
            ...VERBATIM,
            size: 10,
            "aria-describedby": line.id,
            oninput: () => (setFault(input, line, ""), this.onchange()),
          })
        );
        this.inputs.set(name, { input, line });
        return el("div", { class: "field" }, el("label", { for: input.id, text: `${label} [${unit}]` }), input, line);
      }),
    );
  }

  get touched() {
    return [...this.inputs.values()].some(({ input }) => input.value.trim() !== "");
  }

  get value() {
    if (!this.touched) return null;
    return Object.fromEntries([...this.inputs].map(([name, { input }]) => [name, typed(input)]));
  }

  get state() {
    return Object.fromEntries([...this.inputs].map(([name, { input }]) => [name, input.value]));
  }

  set state(values) {
    for (const [name, text] of Object.entries(values)) {
      const field = this.inputs.get(name);
      if (field) field.input.value = text;
    }
  }

  /** @param {any} faults */
  showFaults(faults) {
    for (const { input, line } of this.inputs.values()) setFault(input, line, "");
    for (const { where, text } of faults) {
      const field = this.inputs.get(where[0]) ?? [...this.inputs.values()][0];
      setFault(field.input, field.line, text);
    }
  }

  /** @param {any} [options] */
  focus([name] = []) {
    (this.inputs.get(name) ?? [...this.inputs.values()][0]).input.focus();
  }
}

/** The structure: the type of each joint, and how each axis lies to the next. */
export class SchematicField {
  onchange = () => {};

  /** @param {number} joints */
  constructor(joints) {
    /** @param {string} label @param {any} options */
    const select = (label, options) => {
      const line = faultLine(uniqueId("fault"));
      const input = /** @type {HTMLSelectElement} */ (
        el(
          "select",
          {
            "aria-label": label,
            "aria-describedby": line.id,
            onchange: () => (setFault(input, line, ""), this.onchange()),
          },
          el("option", { value: "", text: t("form-choose") }),
          options.map((/** @type {any} */ [value, text]) => el("option", { value, text })),
        )
      );
      return { input, line };
    };
    const types = ["revolute", "prismatic"].map((joint) => [joint, t(`form-joint-${joint}`)]);
    const relations = RELATIONS.map((relation) => [relation, t(`form-relation-${relation.replaceAll("_", "-")}`)]);
    this.joints = Array.from({ length: joints }, (_, i) => select(t("form-schematic-joint", { joint: i + 1 }), types));
    this.relations = Array.from({ length: Math.max(0, joints - 1) }, (_, i) =>
      select(t("form-schematic-relation", { joint: i + 1, next: i + 2 }), relations),
    );
    this.element = el(
      "ol",
      { class: "schematic" },
      this.joints.map((joint, i) =>
        el(
          "li",
          {},
          el(
            "span",
            { class: "schematic-line" },
            el("span", { text: t("form-schematic-joint", { joint: i + 1 }) }),
            joint.input,
            joint.line,
          ),
          this.relations[i]
            ? el(
                "span",
                { class: "schematic-line" },
                el("span", { class: "hint", text: t("form-schematic-relation", { joint: i + 1, next: i + 2 }) }),
                this.relations[i].input,
                this.relations[i].line,
              )
            : null,
        ),
      ),
    );
  }

  get touched() {
    return [...this.joints, ...this.relations].some(({ input }) => input.value !== "");
  }

  get value() {
    if (!this.touched) return null;
    return {
      joints: this.joints.map(({ input }) => input.value),
      relations: this.relations.map(({ input }) => input.value),
    };
  }

  /** Choices that are still open, as faults. */
  get missing() {
    /** @param {any} fields @param {any} list */
    const open = (fields, list) =>
      fields.flatMap((/** @type {any} */ { input }, /** @type {number} */ i) =>
        input.value ? [] : [{ where: [list, i], text: t("form-choose-missing") }],
      );
    return this.touched ? [...open(this.joints, "joints"), ...open(this.relations, "relations")] : [];
  }

  get state() {
    return this.value ?? { joints: [], relations: [] };
  }

  set state({ joints, relations }) {
    this.joints.forEach(({ input }, i) => (input.value = joints[i] ?? ""));
    this.relations.forEach(({ input }, i) => (input.value = relations[i] ?? ""));
  }

  /** @param {any} faults */
  showFaults(faults) {
    for (const { input, line } of [...this.joints, ...this.relations]) setFault(input, line, "");
    for (const { where, text } of faults) {
      const list = where[0] === "relations" ? this.relations : this.joints;
      const field = list[Number(where[1] ?? 0)] ?? this.joints[0];
      setFault(field.input, field.line, text);
    }
  }

  /** @param {any} [options] */
  focus([list, index = 0] = []) {
    (list === "relations" ? this.relations : this.joints)[index]?.input.focus();
  }
}
