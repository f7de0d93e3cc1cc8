/** The playground: a table, its robot, and every answer that the service has about it. */

import "../editor/dh-table-editor.js";
import "../scene/robot-scene.js";
import "../joint-sliders.js";
import "../matrix-panel.js";
import { announce, el, fill } from "../dom.js";
import { copyText } from "../clipboard.js";
import { OwnCard } from "../exercise/own-card.js";
import { t } from "../i18n.js";
import { LiveRobot } from "../live-robot.js";
import { degrees, radians } from "../numbers.js";
import { api, startPage } from "../page.js";
import { keep, recall } from "../storage.js";
import { convertTool } from "../playground/convert.js";
import { inverseTool } from "../playground/inverse.js";
import { jacobianTool } from "../playground/jacobian.js";
import { decode, permalink } from "../playground/permalink.js";
import { poseTool } from "../playground/pose.js";
import { axesSource, catalogueChoice, scmSource, urdfSource } from "../playground/sources.js";
import { workspaceTool } from "../playground/workspace.js";

const DRAFT = "playground";

class Playground {
  constructor() {
    this.editor = /** @type {any} */ (el("dh-table-editor"));
    this.robot = new LiveRobot(api);
    this.limits = /** @type {[number, number][] | null} */ (null);
    this.pose = /** @type {number[][] | null} */ (null);
    this.joints = /** @type {number[]} */ ([]);
    this.wanted = /** @type {number[] | null} */ (null);
    this.configurations = el("div", { class: "row", hidden: true });
    this.card = new OwnCard(place("robot"), this.robot, { api, parameters: {} });
    this.tools = [
      poseTool(api),
      jacobianTool(api),
      inverseTool(api, { pose: () => this.pose, show: (joints) => this.show(joints) }),
      convertTool(api, { use: (table) => this.use({ table, parameters: this.card.values }) }),
      workspaceTool(api, { limits: () => this.limits }),
    ];
  }

  build() {
    fill(place("table-body"), catalogueChoice(api, (found) => this.use(found)), this.configurations, this.editor);
    const share = el("button", { type: "button", class: "small", onclick: () => this.share() }, t("playground-share"));
    fill(place("table-tools"), share);
    fill(place("sources"), axesSource(api, (found) => this.use(found)), scmSource(api, (found) => this.use(found)), urdfSource(api, (found) => this.use(found)));
    fill(place("tools"), this.tools.map((tool) => tool.element));
    this.listen();
  }

  listen() {
    this.editor.addEventListener("table-change", () => this.#changed());
    this.robot.addEventListener("reading", (event) => {
      const { reading, rows, faults } = /** @type {CustomEvent} */ (event).detail;
      this.editor.showMeaning(rows);
      this.editor.showFaults(faults);
      if (!reading) this.#tell(null);
    });
    this.robot.addEventListener("robot", () => {
      if (!this.wanted) return;
      const wanted = this.wanted;
      this.wanted = null;
      this.card.sliders.values = wanted;
      this.card.scene.joints = wanted;
      this.robot.joints = wanted;
    });
    this.robot.addEventListener("poses", (event) => {
      this.pose = /** @type {CustomEvent} */ (event).detail.transform;
      this.joints = this.card.sliders.values;
      this.#tell(this.#subject());
      this.#keep();
    });
    window.addEventListener("hashchange", () => this.restore());
  }

  /** The robot of the address, else the one that was here last, else the PUMA. */
  async restore() {
    const shared = decode(location.hash) ?? recall(DRAFT, null);
    if (shared) return this.use(shared, shared.joints);
    const puma = await api.get("robots/puma560").catch(() => null);
    this.use(puma ?? { table: this.editor.table });
  }

  /** @param {import("../playground/sources.js").Found} found @param {number[]} [joints] [rad or length] */
  use(found, joints) {
    this.limits = found.limits ?? null;
    this.wanted = joints ?? null;
    this.card.values = { ...(found.parameters ?? {}) };
    this.card.shownNames = "";
    this.robot.parameters = this.card.values;
    this.editor.table = found.table;
    this.#showConfigurations(found.configurations ?? {});
    this.#changed({ now: true });
  }

  /** Brings the robot to joint values. @param {number[]} joints in the table's units */
  show(joints) {
    const inside = this.#inward(joints);
    this.card.sliders.values = inside;
    this.card.scene.joints = inside;
    this.robot.joints = inside;
    announce(t("playground-moved"));
  }

  async share() {
    const address = permalink(location.href, this.#shared());
    history.replaceState(history.state, "", address);
    announce(t((await copyText(address)) ? "playground-shared" : "form-copy-failed"));
  }

  #changed(options = {}) {
    const { table, complete } = { table: this.editor.table, complete: this.editor.complete };
    this.card.units = { angle: table.angle_unit, length: table.length_unit };
    if (complete) this.robot.take(table, options);
    else {
      this.robot.take(table, options);
      this.#tell(null);
    }
  }

  #showConfigurations(configurations) {
    const buttons = Object.values(configurations).map(({ joints, meaning }) =>
      el("button", { type: "button", class: "small", onclick: () => this.show(joints) }, meaning),
    );
    this.configurations.hidden = buttons.length === 0;
    fill(this.configurations, buttons);
  }

  #subject() {
    const { table, parameters } = this.robot.request;
    return { table, parameters, joints: this.#outward(this.joints), units: { angle: table.angle_unit, length: table.length_unit } };
  }

  #shared() {
    return { table: this.editor.table, parameters: this.robot.parameters, joints: this.card.sliders.values };
  }

  #keep() {
    keep(DRAFT, this.#shared());
  }

  #tell(subject) {
    for (const tool of this.tools) tool.take(subject);
  }

  #types() {
    return this.robot.reading?.rows.map((row) => row.joint).filter((joint) => joint !== "fixed") ?? [];
  }

  #outward(joints) {
    const inDegrees = this.editor.table.angle_unit === "deg";
    return this.#types().map((type, i) => (inDegrees && type === "revolute" ? degrees(joints[i] ?? 0) : (joints[i] ?? 0)));
  }

  #inward(joints) {
    const inDegrees = this.editor.table.angle_unit === "deg";
    return this.#types().map((type, i) => (inDegrees && type === "revolute" ? radians(joints[i] ?? 0) : (joints[i] ?? 0)));
  }
}

function place(id) {
  return /** @type {HTMLElement} */ (document.getElementById(id));
}

startPage(async () => {
  const playground = new Playground();
  playground.build();
  await playground.restore();
});
