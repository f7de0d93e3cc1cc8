/** The student's own robot: scene, joints, values of parameters, matrices. Nothing here knows the key. */

import { debounced, el, fill, uniqueId } from "../dom.js";
import { t } from "../i18n.js";
import { resetButton, usualRanges } from "../joint-sliders.js";
import { plain } from "../numbers.js";
import { problemNotice } from "../problem.js";

export class OwnCard {
  /**
   * @param {HTMLElement} place @param {import("../live-robot.js").LiveRobot} robot
   * @param {{api: import("../api.js").Api, parameters: Record<string, number>, limits?: ({min: number, max: number} | null)[]}} options
   */
  constructor(place, robot, { api, parameters }) {
    this.robot = robot;
    /** @type {Record<string, number>} */
    this.values = { ...parameters };
    robot.parameters = this.values;
    this.scene = /** @type {any} */ (el("robot-scene", { label: t("form-own-scene") }));
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

  /** Says that the table has empty cells. @param {number} count */
  waitFor(count) {
    this.status.textContent = t("form-own-missing", { count });
    this.#dim(true);
  }

  /** @param {{angle: string, length: string}} units */
  set units(units) {
    this.sliders.units = units;
    this.lengthUnit = units.length;
    this.angleUnit = units.angle;
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
    this.sliders.addEventListener("joints-change", (event) => {
      this.scene.joints = event.detail.values;
      robot.joints = event.detail.values;
    });
  }

  #read({ reading, faults }) {
    if (reading) return;
    this.status.textContent = t("form-own-unread", { count: faults.length });
    this.#dim(true);
  }

  #draw({ model, joints, size }) {
    this.sliders.joints = usualRanges(joints, size);
    this.scene.joints = this.sliders.values;
    this.scene.model = model;
    this.scene.describe(this.#description(joints));
    this.robot.joints = this.sliders.values;
    this.jointCard.hidden = joints.length === 0;
    this.matrices.table = this.robot.request.table;
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
    this.status.textContent = "";
    this.status.append(problemNotice(error));
  }

  /** Fields for what the student's table names; those that the exercise does not give have to be filled in. */
  #showParameters({ parameters, missing }) {
    this.parameters.hidden = parameters.length === 0;
    const names = parameters.map(({ name, kind }) => `${name}/${kind}`).join();
    if (names !== this.shownNames) {
      this.shownNames = names;
      fill(this.fields, parameters.map((parameter) => this.#field(parameter)));
    }
    if (!missing.length) return;
    this.status.textContent = t("form-own-values", { names: missing.map(({ name }) => name).join(", ") });
    this.#dim(true);
  }

  #field({ name, kind }) {
    const id = uniqueId("parameter");
    const unit = kind === "angle" ? (this.angleUnit === "deg" ? "°" : "rad") : this.lengthUnit;
    const take = debounced((text) => {
      const value = Number(text.replace(",", "."));
      if (text.trim() === "" || !Number.isFinite(value)) delete this.values[name];
      else this.values[name] = value;
      this.robot.parameters = { ...this.values };
    }, 200);
    const value = this.values[name];
    return el(
      "div",
      { class: "field parameter" },
      el("label", { for: id, text: name }),
      el(
        "span",
        { class: "joint-number" },
        el("input", { id, type: "text", inputmode: "decimal", value: Number.isFinite(value) ? plain(value, 6) : "", oninput: (event) => take(event.target.value) }),
        el("span", { class: "hint", text: unit }),
      ),
    );
  }
}
