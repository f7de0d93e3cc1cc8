/** The student's own robot: scene, joints, values of parameters, matrices. Nothing here knows the key. */

import { el, fill, uniqueId, VERBATIM } from "../dom.js";
import { named, t } from "../i18n.js";
import { resetButton } from "../joint-sliders.js";
import { numberIn, plain } from "../numbers.js";
import { FilmBar } from "./film-bar.js";
import { problemNotice } from "../problem.js";
import { convertedValues } from "../units.js";

/** @typedef {{name: string, kind: "length" | "angle"}} Named */

export class OwnCard {
  empty = 0;
  waiting = "";
  shownNames = "";

  /**
   * @param {HTMLElement} place @param {import("../live-robot.js").LiveRobot} robot
   * @param {{api: import("../api.js").Api, given?: {parameters: Record<string, number>, kinds: [string, "angle" | "length"][],
   *   units: import("../units.js").Units}, light?: (row: number, cell: string) => void}} options `given` are the values that the
   *   exercise names; `light` lights the cell that the film shows
   */
  constructor(
    place,
    robot,
    { api, given = { parameters: {}, kinds: [], units: { angle: "deg", length: "m" } }, light = () => {} },
  ) {
    this.place = place;
    place.classList.add("blank");
    this.robot = robot;
    robot.parameters = given.parameters;
    this.units = given.units;
    this.kinds = new Map(given.kinds);
    this.scene = el("robot-scene", { label: t("form-own-scene") });
    this.film = new FilmBar(this.scene, { units: () => this.units, light });
    this.sliders = el("joint-sliders");
    this.matrices = el("matrix-panel");
    this.matrices.api = api;
    this.status = el("p", { class: "hint own-status", text: t("form-own-empty") });
    /** Read out, beside what else is: a warning that is announced at the same time stays. */
    this.told = el("p", { class: "visually-hidden own-told", role: "status" });
    this.fields = el("div", { class: "parameter-fields" });
    this.parameters = el(
      "div",
      { class: "own-parameters", hidden: true },
      el("h3", { text: t("form-own-parameters") }),
      this.fields,
    );
    this.jointCard = el(
      "div",
      { class: "own-joints", hidden: true },
      el("div", { class: "card-head" }, el("h3", { text: t("form-joints") }), resetButton(this.sliders)),
      this.sliders,
    );
    this.withheld = el("p", { class: "hint", hidden: true, text: t("form-matrices-withheld") });
    this.panel = el(
      "details",
      { class: "own-matrices", ontoggle: () => this.#watch() },
      el("summary", {}, el("h3", { text: t("form-matrices") })),
      this.withheld,
      this.matrices,
    );
    fill(place, this.scene, this.film.element, this.status, this.told, this.jointCard, this.parameters, this.panel);
    this.#listen();
  }

  /**
   * Draws a table from now on. Values that are left out stay, and mean what they meant, whatever units it is in.
   * @param {any} table as it goes to the API
   * @param {{now?: boolean, parameters?: Record<string, number>, joints?: number[] | null,
   *   limits?: import("../joint-ranges.js").Limits}} [options] limits in the table's units
   */
  take(table, { parameters, ...options } = {}) {
    const units = { angle: table.angle_unit, length: table.length_unit };
    /** @param {string} name */
    const kindOf = (name) => (this.kinds.get(name) === "angle" ? "angle" : "length");
    const values = parameters ?? convertedValues(this.robot.parameters, kindOf, this.units, units);
    this.units = units;
    this.sliders.units = units;
    this.robot.take(table, { ...options, parameters: values });
    this.empty = emptyCells(table);
  }

  #listen() {
    const { robot } = this;
    robot.addEventListener("typed", () => this.scene.setAttribute("aria-busy", "true"));
    robot.addEventListener("reading", (event) => this.#read(/** @type {CustomEvent} */ (event).detail));
    robot.addEventListener("parameters", (event) => this.#showParameters(/** @type {CustomEvent} */ (event).detail));
    robot.addEventListener("robot", (event) => this.#draw(/** @type {CustomEvent} */ (event).detail));
    robot.addEventListener("poses", (event) => this.matrices.showNumbers(/** @type {CustomEvent} */ (event).detail));
    robot.addEventListener("failure", (event) => this.#fail(/** @type {CustomEvent} */ (event).detail));
    this.sliders.addEventListener("change", () => this.scene.settle());
    this.sliders.addEventListener("joints-change", (/** @type {any} */ event) => this.#turn(event.detail.values));
  }

  /** Keeps the matrices back while a part asks for them. @param {boolean} withheld */
  withhold(withheld) {
    this.withheld.hidden = !withheld;
    this.matrices.hidden = withheld;
    this.#watch();
  }

  #watch() {
    this.robot.watched = this.panel.open && !this.matrices.hidden;
  }

  /** Brings the robot to joint values. @param {number[]} values [rad or length] */
  show(values) {
    this.sliders.values = values;
    this.#turn(this.sliders.values);
  }

  /** @param {number[]} values */
  #turn(values) {
    this.scene.joints = values;
    this.film.joints = values;
    this.robot.joints = values;
  }

  /** @param {import("../understanding.js").Answer} answer */
  #read({ whole, rows, faults }) {
    this.waiting = "";
    if (whole) return;
    this.waiting = this.empty
      ? t("form-own-missing", { count: this.empty })
      : t("form-own-unread", { count: faults.length });
    if (rows.length) return;
    this.status.textContent = `${this.waiting} ${t("form-own-last")}`;
    this.#dim(true);
  }

  /** @param {import("../live-robot.js").Robot} robot */
  #draw(robot) {
    const { model, joints, values, rows, whole } = robot;
    this.sliders.joints = joints;
    this.sliders.values = values;
    this.scene.joints = values;
    this.scene.model = model;
    this.scene.describe(this.#description(joints));
    this.film.take(robot);
    this.jointCard.hidden = joints.length === 0;
    this.matrices.table = whole ? this.robot.subject?.table : null;
    this.place.classList.toggle("blank", rows.length === 0);
    const shown = rows.length ? t("form-own-rows", { rows: rows.length }) : t("form-own-empty");
    this.status.textContent = whole ? t("form-own-shown", { joints: joints.length }) : `${shown} ${this.waiting}`;
    if (!whole) this.told.textContent = "";
    else if (!this.told.textContent) this.told.textContent = this.status.textContent;
    this.#dim(false);
  }

  /** @param {import("../joint-ranges.js").JointRange[]} joints */
  #description(joints) {
    const kinds = joints.map((joint) => named(joint.name, t(`form-joint-${joint.type}`))).join(", ");
    return `${t("form-own-description", { joints: kinds, count: joints.length })} ${t("form-scene-keys")}`;
  }

  /** @param {boolean} dimmed */
  #dim(dimmed) {
    this.scene.classList.toggle("stale", dimmed);
    this.scene.removeAttribute("aria-busy");
  }

  /** @param {unknown} error */
  #fail(error) {
    const notice = problemNotice(error);
    // What stands there already would be read out again at every try.
    if (this.status.textContent !== notice.textContent) fill(this.status, notice);
    this.#dim(true);
  }

  /** Fields for what the student's table names; those that the exercise does not give have to be filled in. @param {{parameters: Named[], missing: Named[]}} used */
  #showParameters({ parameters, missing }) {
    this.parameters.hidden = parameters.length === 0;
    for (const { name, kind } of parameters) this.kinds.set(name, kind);
    const names = JSON.stringify([parameters.map(({ name, kind }) => [name, kind]), this.units]);
    const fields = names === this.shownNames ? null : parameters.map((parameter) => this.#field(parameter));
    if (fields) fill(this.fields, fields);
    this.shownNames = names;
    this.#showValues();
    const open = missing.map(({ name }) => name).join(", ");
    if (open && !this.empty) this.waiting = t("form-own-values", { names: open });
  }

  /** Fields show the robot's values, except the one that is being typed into. */
  #showValues() {
    for (const input of this.fields.querySelectorAll("input")) {
      const value = this.robot.parameters[input.name];
      const shown = Number.isFinite(value) ? plain(value, 6) : "";
      if (input !== document.activeElement && (shown || numberIn(input.value) !== null)) input.value = shown;
    }
  }

  /** @param {Named} parameter */
  #field({ name, kind }) {
    const id = uniqueId("parameter");
    const { angle, length } = this.units;
    const unit = kind === "angle" ? (angle === "deg" ? "°" : "rad") : length;
    /** @param {string} text */
    const take = (text) => {
      const { [name]: _, ...others } = this.robot.parameters;
      const value = numberIn(text);
      this.robot.parameters = value === null ? others : { ...others, [name]: value };
    };
    return el(
      "div",
      { class: "field parameter" },
      el("label", { for: id, text: name }),
      el(
        "span",
        { class: "joint-number" },
        el("input", {
          id,
          name,
          type: "text",
          ...VERBATIM,
          oninput: (event) => take(event.target.value),
          onblur: () => this.#showValues(),
        }),
        el("span", { class: "hint", text: unit }),
      ),
    );
  }
}

/** Number of cells in which nothing stands. @param {any} table */
function emptyCells({ rows }) {
  return rows
    .flatMap((/** @type {any} */ { alpha, a, d, theta }) => [alpha, a, d, theta])
    .filter((/** @type {string} */ text) => String(text).trim() === "").length;
}
