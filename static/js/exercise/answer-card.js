/** Everything that is handed in: the table, and what else the exercise asks. */

import { announce, el, fill, setAble } from "../dom.js";
import { newTable } from "../editor/model.js";
import { named, t } from "../i18n.js";
import { subscript, superscript } from "../numbers.js";
import { api } from "../page.js";
import { AnswerForm, formPlace } from "./answer-form.js";
import { FramesField, framePlace } from "./frames-field.js";
import { Help } from "./help.js";
import { MatrixReading } from "./matrix-reading.js";
import { MatrixField, MatrixListField, NumbersField, SchematicField } from "./part-fields.js";
import { partName, pointsText, Progress } from "./progress.js";

/** @typedef {{kind: string, points: number}} Part */

export class AnswerCard {
  /**
   * @param {HTMLElement} place @param {any} exercise
   * @param {{changed: (what: "table" | "part") => void, submit: (kind?: string) => void, owner?: string | null}} page
   *   `submit` hands in everything, or one part; `owner`: somebody in a course, for whom with one part goes all else that
   *   is ready, because what is handed in counts as a whole
   */
  constructor(place, exercise, { changed, submit, owner = null }) {
    this.exercise = exercise;
    this.changed = changed;
    this.together = owner !== null;
    /** In a course every press is an attempt, and says so. */
    this.labels = this.together
      ? { all: "session-hand-in", part: "session-hand-in-ready" }
      : { all: "form-submit", part: "form-submit-part" };
    this.help = new Help(exercise, owner);
    this.progress = new Progress(exercise, (kind) => this.goTo(kind));
    this.editor = /** @type {any} */ (document.createElement("dh-table-editor"));
    this.editor.allowed = exercise.conventions;
    const { angle_unit: angleUnit, length_unit: lengthUnit } = exercise;
    const joints = exercise.joints.length;
    this.editor.state = newTable(this.editor.allowed[0], joints, { angleUnit, lengthUnit });
    this.editor.addEventListener("table-change", () => this.#edited());
    this.parts = exercise.parts
      .filter((/** @type {any} */ { kind }) => kind !== "table")
      .map((/** @type {any} */ part) => ({ part, field: fieldFor(part, exercise) }));
    // Enter in a field presses the button too; a frame that allows no forms lets no form be submitted.
    /** @param {any} event */
    const press = (event) => (event.preventDefault(), submit());
    this.button = el("button", { type: "submit", class: "primary", onclick: press, text: t(this.labels.all) });
    this.problem = el("div", { id: "submit-problem" });
    const table = exercise.parts.find((/** @type {any} */ { kind }) => kind === "table");
    const several = this.parts.length > 1 || (this.parts.length > 0 && Boolean(table));
    this.sections = this.parts.map((/** @type {any} */ { part, field }) =>
      section(
        part.kind,
        part,
        exercise,
        several ? [field.element, this.#checkButton(part.kind, submit)] : field.element,
        several,
      ),
    );
    if (!table && this.sections.length === 1) this.sections[0].open = true;
    this.withTable = Boolean(table);
    const form = el(
      "form",
      {
        class: "stack",
        novalidate: true,
        onkeydown: (event) => {
          if (event.key === "Enter" && (event.ctrlKey || event.metaKey) && !event.target.closest("dialog")) {
            event.preventDefault();
            submit();
          }
        },
      },
      table
        ? section("table", table, exercise, [this.editor, several && this.#checkButton("table", submit)], several)
        : null,
      this.sections,
      el(
        "div",
        { class: "row submit-row no-print" },
        this.button,
        el("span", { class: "hint keys", text: t("form-submit-hint") }),
        this.help.element(),
      ),
      this.problem,
    );
    this.reading = new MatrixReading(api, this.parts, () => this.editor.table);
    for (const { field } of this.parts)
      field.onchange = () => (this.showProgress(), this.reading.soon(), this.changed("part"));
    fill(place, form, this.progress.element);
    this.#resize();
    this.showProgress();
  }

  /** What stands in each part, in the exercise's order. @returns {import("./progress.js").PartState[]} */
  get states() {
    const { key: _, ...table } = this.editor.table;
    return this.exercise.parts.map((/** @type {Part} */ { kind }) => {
      if (kind === "table") return { kind, touched: !this.editor.untouched, print: JSON.stringify(table) };
      const found = this.parts.find((/** @type {any} */ { part }) => part.kind === kind);
      return { kind, touched: found.field.touched, print: JSON.stringify(found.field.value) };
    });
  }

  showProgress() {
    this.parts.forEach((/** @type {any} */ { field }, /** @type {number} */ i) =>
      this.sections[i].classList.toggle("blank", !field.touched),
    );
    this.progress.show(this.states);
  }

  /** Takes what was found of an answer. @param {Wire.Graded} graded @param {import("./progress.js").PartState[]} handed */
  judged(graded, handed) {
    this.progress.take(graded, handed);
    this.showProgress();
  }

  /** Leads to a part, opened. @param {string} kind */
  goTo(kind) {
    if (kind === "table") return this.focus();
    this.focusPart(kind, []);
    document.getElementById(`part-${kind}`)?.scrollIntoView({ block: "nearest" });
  }

  /** @param {string} kind @param {(kind?: string) => void} submit */
  #checkButton(kind, submit) {
    const label = t(this.labels.part);
    const press = () => submit(kind);
    const name = named(label, partName(kind));
    return el(
      "p",
      { class: "no-print check-part" },
      el("button", { type: "button", "aria-label": name, onclick: press, text: label }),
    );
  }

  get table() {
    return this.editor.table;
  }

  get convention() {
    return this.editor.state.convention;
  }

  get state() {
    return {
      table: this.editor.state,
      parts: Object.fromEntries(this.parts.map((/** @type {any} */ { part, field }) => [part.kind, field.state])),
    };
  }

  set state({ table, parts }) {
    this.editor.state = table;
    this.#resize();
    this.parts.forEach((/** @type {any} */ { part, field }, /** @type {number} */ i) => {
      field.showFaults([]);
      if (parts?.[part.kind]) field.state = parts[part.kind];
      if (field.touched) /** @type {HTMLDetailsElement} */ (this.sections[i]).open = true;
    });
    this.reading.soon();
    this.showProgress();
  }

  /** @param {boolean} busy */
  set busy(busy) {
    if (busy) fill(this.problem);
    setAble(this.button, !busy);
    this.button.textContent = t(busy ? "form-submitting" : this.labels.all);
  }

  /**
   * What is sent, with how much help is wanted: everything that was typed, a table that nobody touched left out where
   * there is something else; or one part, with the table if it is whole, and the parts that were judged before.
   * @param {string | null} [kind] the part that is checked; null: everything
   * @returns {Record<string, any> | null} null if something is missing, which is then pointed out
   */
  request(kind = null) {
    if (this.button.getAttribute("aria-disabled") === "true") return null;
    const judged = this.progress.judged(this.states);
    const asked = this.parts.filter((/** @type {any} */ { part, field }) => {
      if (kind === null || part.kind === kind) return true;
      return this.together ? field.touched && !field.missing?.length : judged.has(part.kind);
    });
    const open = asked.find((/** @type {any} */ { field }) => field.missing?.length);
    if (open) {
      open.field.showFaults(open.field.missing);
      this.focusPart(open.part.kind, open.field.missing[0].where);
      return null;
    }
    const typed = asked
      .map((/** @type {any} */ { part, field }) => [part.kind, field.value])
      .filter((/** @type {any} */ [, value]) => value !== null);
    /** @type {Record<string, any>} */
    const others = Object.fromEntries(typed);
    if (kind !== null && kind !== "table" && !(kind in others)) {
      announce(t("form-part-empty"));
      this.focusPart(kind, []);
      return null;
    }
    const needsTable = this.withTable && ("link_matrices" in others || this.#needsTable(kind, typed));
    const whole = this.withTable && this.editor.complete && !this.editor.untouched;
    if (needsTable && !this.editor.complete) {
      this.editor.showMissing();
      return null;
    }
    const answer = needsTable || whole ? { table: this.editor.table, ...others } : others;
    return { ...answer, ...this.help.wanted(answer) };
  }

  /** @param {string | null} kind @param {any[]} typed */
  #needsTable(kind, typed) {
    return kind === "table" || (kind === null && (!typed.length || !this.editor.untouched));
  }

  /** What the service understood. @param {import("../understanding.js").Answer} answer */
  showReading({ rows, faults: read, reading }) {
    this.editor.showMeaning(rows);
    const faults = [...read, ...unknownNames(this.exercise, rows, reading?.parameters ?? [])];
    const empty = new Set(this.editor.missing.map((/** @type {any} */ { row, cell }) => `/rows/${row}/${cell}`));
    this.editor.showFaults(faults.filter((fault) => !empty.has(fault.pointer.replace(/^\/table/, ""))));
  }

  /**
   * Shows what an answer was refused for, and leads there.
   * @param {import("../api.js").Fault[]} faults none, if it was not refused
   * @param {any} table as it was handed in
   * @returns {boolean} whether anything is left to show: what was typed into since is left out
   */
  showRefusal(faults, table) {
    const ofTable = [];
    const ofParts = new Map(this.parts.map((/** @type {any} */ { part }) => [part.kind, []]));
    for (const fault of faults) {
      const [, kind, ...rest] = fault.pointer.split("/");
      const where = rest.map((step) => (/^\d+$/.test(step) ? Number(step) : step));
      if (ofParts.has(kind)) ofParts.get(kind).push({ where, text: fault.detail });
      else ofTable.push(fault);
    }
    this.parts.forEach((/** @type {any} */ { part, field }, /** @type {number} */ i) => {
      const own = ofParts.get(part.kind);
      field.showFaults(own);
      if (own.length) /** @type {HTMLDetailsElement} */ (this.sections[i]).open = true;
    });
    if (this.withTable && this.editor.showRefusal(ofTable, table)) return true;
    const first = this.parts.find((/** @type {any} */ { part }) => ofParts.get(part.kind).length);
    first?.field.focus(ofParts.get(first.part.kind)[0].where);
    return Boolean(first);
  }

  focus() {
    if (!this.withTable) return this.parts[0]?.field.focus();
    this.editor.focusCell(0, this.convention === "standard" ? "theta" : "alpha");
  }

  /** @param {number} row @param {string} [cell] */
  focusRow(row, cell) {
    this.editor.focusCell(row, cell ?? (this.convention === "standard" ? "theta" : "alpha"));
  }

  /** Leads to a place in a part. @param {string} kind @param {(string | number)[]} where */
  focusPart(kind, where) {
    const i = this.parts.findIndex((/** @type {any} */ { part }) => part.kind === kind);
    if (i < 0) return;
    /** @type {HTMLDetailsElement} */ (this.sections[i]).open = true;
    this.parts[i].field.focus(where);
  }

  #edited() {
    this.#resize();
    this.reading.soon();
    this.showProgress();
    this.changed("table");
  }

  #resize() {
    const rows = this.editor.state.rows.length;
    for (const { field } of this.parts)
      if (field instanceof MatrixListField && field.count !== rows) field.resize(rows);
  }
}

/**
 * Names in a table that are no dimension of the robot, as faults of the cells that hold them.
 * @param {Wire.Exercise} exercise @param {import("../understanding.js").ReadRow[]} rows @param {{name: string}[]} parameters
 * @returns {import("../api.js").Fault[]}
 */
function unknownNames({ dimensions }, rows, parameters) {
  const plainName = (/** @type {string} */ name) => name.replaceAll("_", "");
  const known = new Set(dimensions.flatMap(({ name, aliases = [] }) => [name, ...aliases].map(plainName)));
  const unknown = parameters.map(({ name }) => name).filter((name) => !known.has(plainName(name)));
  const names = dimensions.map(({ name }) => name).join(", ");
  return unknown.flatMap((name) =>
    rows.flatMap(({ texts }, row) =>
      Object.entries(texts)
        .filter(([, text]) => text?.match(/[\p{L}_][\p{L}\d_]*/gu)?.includes(name))
        .map(([cell]) => ({
          code: "name_unknown",
          pointer: `/table/rows/${row}/${cell}`,
          detail: t("form-name-unknown", { name, names, known: names ? "some" : "none" }),
          params: {},
        })),
    ),
  );
}

/** One thing that is asked. What comes besides the table is folded, so that a phone's page stays short. @param {string} kind @param {any} part @param {Wire.Exercise} exercise @param {any} content @param {any} several */
function section(kind, part, exercise, content, several) {
  const name = partName(kind);
  const share = several && part ? el("span", { class: "badge", text: pointsText(part.points, exercise.points) }) : null;
  if (kind === "table") {
    const title = several ? el("h3", { class: "row" }, name, " ", share) : null;
    return el("section", { class: "part", id: "part-table", "aria-label": name }, title, content);
  }
  return el(
    "details",
    { class: "part", id: `part-${kind}` },
    el("summary", {}, el("h3", { class: "row" }, name, share)),
    el("p", { class: "hint", text: part.task }),
    content,
  );
}

/** @param {any} part @param {Wire.Exercise} exercise */
function fieldFor(part, exercise) {
  const joints = exercise.joints.length;
  if (part.form.length) return new AnswerForm(part);
  switch (part.kind) {
    case "schematic":
      return new SchematicField(joints);
    case "frames":
      return new FramesField(exercise);
    case "link_matrices":
      return new MatrixListField();
    case "transform":
      return new MatrixField({ from: 0, to: joints });
    case "pose":
      return new MatrixField({ from: 0, to: joints });
    default:
      return new NumbersField([
        { name: "inner", label: t("form-radius-inner"), unit: exercise.length_unit },
        { name: "outer", label: t("form-radius-outer"), unit: exercise.length_unit },
      ]);
  }
}

/**
 * How a place of a part's answer is called: a name, and where in what is called so.
 * @typedef {{name: string, at: string}} Place
 * @param {any} part @param {(string | number)[]} where
 * @returns {Place | null} null of what has no place of its own
 */
export function placeOf({ kind, form }, where) {
  if (form.length) return formPlace(form, where);
  const at = where
    .slice(-2)
    .map((step) => Number(step) + 1)
    .join(", ");
  if (kind === "frames") return { name: framePlace(where), at: "" };
  if (kind === "link_matrices") {
    const name = `${superscript(where[0])}T${subscript(Number(where[0]) + 1)}`;
    return { name, at: where.length > 1 ? at : "" };
  }
  if (kind === "schematic" && where.length > 1) {
    const number = Number(where[1]) + 1;
    const name =
      where[0] === "joints"
        ? t("form-schematic-joint", { joint: number })
        : t("form-schematic-relation", { joint: number, next: number + 1 });
    return { name, at: "" };
  }
  if (where.length === 2) return { name: "", at };
  return { name: t(`form-radius-${where[0]}`), at: "" };
}
