/** The student's own robot: scene, joints, values of parameters, matrices. Nothing here knows the key. */

import { el, fill, uniqueId } from "../dom.js";
import { t } from "../i18n.js";
import { resetButton } from "../joint-sliders.js";
import { plain } from "../numbers.js";
import { problemNotice } from "../problem.js";
import { convertedValues } from "../units.js";

export class OwnCard {
  /**
   * @param {HTMLElement} place @param {import("../live-robot.js").LiveRobot} robot
   * @param {{api: import("../api.js").Api, given?: {parameters: Record<string, number>, kinds: [string, "angle" | "length"][],
   *   units: import("../units.js").Units}}} options `given` are the values that the exercise names
   */
  constructor(place, robot, { api, given = { parameters: {}, kinds: [], units: { angle: "deg", length: "m" } } }) {
    this.robot = robot;
    robot.parameters = given.parameters;
    this.units = given.units;
    this.kinds = new Map(given.kinds);
    this.scene = /** @type {any} */ (el("robot-scene", { label: t("form-own-scene"), hidden: true }));
    this.sliders = /** @type {any} */ (el("joint-sliders"));
    this.matrices = /** @type {any} */ (el("matrix-panel"));
    this.matrices.api = api;
    this.status = el("p", { class: "hint own-status", role: "status", text: t("form-own-empty") });
    this.fields = el("div", { class: "parameter-fields" });
    this.parameters = el("div", { class: "own-parameters", hidden: true }, el("h3", { text: t("form-own-parameters") }), this.fields);
    this.jointCard = el(
      "div",
      { class: "own-joints", hidden: true },
      el("div", { class: "card-head" }, el("h3", { text: t("form-joints") }), resetButton(this.sliders)),
      this.sliders,
    );
    const matrices = el("details", { class: "own-matrices" }, el("summary", {}, el("h3", { text: t("form-matrices") })), this.matrices);
    fill(place, this.scene, this.status, this.jointCard, this.parameters, matrices);
    this.#listen();
  }

  /**
   * Draws a table from now on. Values that are left out stay, and mean what they meant, whatever units it is in.
   * @param {any} table as it goes to the API
   * @param {{now?: boolean, parameters?: Record<string, number>, joints?: number[] | null}} [options]
   */
  take(table, { parameters, ...options } = {}) {
    const units = { angle: table.angle_unit, length: table.length_unit };
    const kindOf = (name) => (this.kinds.get(name) === "angle" ? "angle" : "length");
    const values = parameters ?? convertedValues(this.robot.parameters, kindOf, this.units, units);
    this.units = units;
    this.sliders.units = units;
    this.robot.take(table, { ...options, parameters: values });
    this.empty = emptyCells(table);
    if (this.empty) this.#wait(t("form-own-missing", { count: this.empty }));
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
    this.sliders.addEventListener("joints-change", (event) => this.#turn(event.detail.values));
  }

  /** Brings the robot to joint values. @param {number[]} values [rad or length] */
  show(values) {
    this.sliders.values = values;
    this.#turn(this.sliders.values);
  }

  #turn(values) {
    this.scene.joints = values;
    this.robot.joints = values;
  }

  #read({ reading, faults }) {
    if (!reading) this.#wait(this.empty ? t("form-own-missing", { count: this.empty }) : t("form-own-unread", { count: faults.length }));
  }

  /** Says what the picture waits for; until then it is the last one, if there is one. */
  #wait(text) {
    this.status.textContent = this.matrices.table ? `${text} ${t("form-own-last")}` : `${t("form-own-empty")} ${text}`;
    this.#dim(true);
  }

  #draw({ model, joints, values }) {
    this.sliders.joints = joints;
    this.sliders.values = values;
    this.scene.hidden = false;
    this.scene.joints = values;
    this.scene.model = model;
    this.scene.describe(this.#description(joints));
    this.jointCard.hidden = joints.length === 0;
    this.matrices.table = this.robot.subject?.table;
    this.status.textContent = t("form-own-shown", { joints: joints.length });
    this.#dim(false);
  }

  #description(joints) {
    const kinds = joints.map((joint) => `${joint.name}: ${t(`form-joint-${joint.type}`)}`).join(", ");
    return `${t("form-own-description", { joints: kinds })} ${t("form-scene-keys")}`;
  }

  #dim(dimmed) {
    this.scene.classList.toggle("stale", dimmed);
    this.scene.removeAttribute("aria-busy");
  }

  #fail(error) {
    fill(this.status, problemNotice(error));
    this.#dim(true);
  }

  /** Fields for what the student's table names; those that the exercise does not give have to be filled in. */
  #showParameters({ parameters, missing }) {
    this.parameters.hidden = parameters.length === 0;
    for (const { name, kind } of parameters) this.kinds.set(name, kind);
    const names = JSON.stringify([parameters.map(({ name, kind }) => [name, kind]), this.units]);
    if (names !== this.shownNames) fill(this.fields, parameters.map((parameter) => this.#field(parameter)));
    this.shownNames = names;
    this.#showValues();
    if (!missing.length) return;
    this.#wait(t("form-own-values", { names: missing.map(({ name }) => name).join(", ") }));
  }

  /** Fields show the robot's values, except the one that is being typed into. */
  #showValues() {
    for (const input of this.fields.querySelectorAll("input")) {
      const value = this.robot.parameters[input.name];
      const shown = Number.isFinite(value) ? plain(value, 6) : "";
      if (input !== document.activeElement && (shown || numberIn(input.value) !== null)) input.value = shown;
    }
  }

  #field({ name, kind }) {
    const id = uniqueId("parameter");
    const { angle, length } = this.units;
    const unit = kind === "angle" ? (angle === "deg" ? "°" : "rad") : length;
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
        el("input", { id, name, type: "text", inputmode: "decimal", oninput: (event) => take(event.target.value), onblur: () => this.#showValues() }),
        el("span", { class: "hint", text: unit }),
      ),
    );
  }
}

/** Number of cells in which nothing stands. @param {any} table */
function emptyCells({ rows }) {
  return rows.flatMap(({ alpha, a, d, theta }) => [alpha, a, d, theta]).filter((text) => String(text).trim() === "").length;
}

/** @param {string} text as people write numbers */
function numberIn(text) {
  const value = Number(text.trim().replace(",", ".").replace("−", "-"));
  return text.trim() !== "" && Number.isFinite(value) ? value : null;
}
