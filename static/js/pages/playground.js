/** The playground: a table, its robot, and every answer that the service has about it. */

import "../editor/dh-table-editor.js";
import "../scene/robot-scene.js";
import "../joint-sliders.js";
import "../matrix-panel.js";
import { Latest } from "../api.js";
import { announce, el, fill } from "../dom.js";
import { copyText } from "../clipboard.js";
import { OwnCard } from "../exercise/own-card.js";
import { connect } from "../exercise/pictures.js";
import { t } from "../i18n.js";
import { inward, LiveRobot, outward } from "../live-robot.js";
import { problemNotice } from "../problem.js";
import { api, forgetFragment, startPage } from "../page.js";
import { keep, recall } from "../storage.js";
import { convertTool } from "../playground/convert.js";
import { inverseTool } from "../playground/inverse.js";
import { jacobianTool } from "../playground/jacobian.js";
import { JointLimits } from "../playground/limits.js";
import { decode, permalink, sharedOf } from "../playground/permalink.js";
import { poseTool } from "../playground/pose.js";
import { axesSource, catalogueChoice, scmSource, urdfSource } from "../playground/sources.js";
import { trajectoryTool } from "../playground/trajectory.js";
import { workspaceTool } from "../playground/workspace.js";
import { shadeModel } from "../scene/figures.js";
import { together } from "../scene/model.js";

const DRAFT = "playground";

/** @typedef {import("../playground/sources.js").Found} Found */

class Playground {
  constructor() {
    this.editor = el("dh-table-editor");
    this.robot = new LiveRobot(api);
    /** @type {Found | null} */
    this.found = null;
    /** @type {Found | null} */
    this.offered = null;
    /** The table of what was found, as the editor has it: what is known goes with it. */
    this.foundTable = "";
    this.bringing = new Latest();
    this.configurations = el("div", {
      class: "configurations",
      role: "group",
      "aria-label": t("playground-configurations"),
      hidden: true,
    });
    this.card = new OwnCard(place("robot"), this.robot, {
      api,
      light: (row, cell) => this.editor.light(row, cell),
    });
    const picture = (this.picture = {
      layer: (/** @type {string} */ name, /** @type {any} */ model) => this.card.scene.layer(name, model),
      robot: () => this.robot.robot,
      joints: () => this.robot.joints,
    });
    this.limits = new JointLimits(() => this.#limited());
    this.trajectory = trajectoryTool(api, picture, { show: (joints) => this.show(joints, { silent: true }) });
    /** @type {{element: HTMLElement, take: (subject: import("../playground/tool.js").Subject | null) => void}[]} */
    this.tools = [
      poseTool(api),
      jacobianTool(api, picture),
      inverseTool(api, {
        pose: () => this.#pose(),
        show: (joints) => this.show(joints),
        shade: (postures) => picture.layer("solutions", this.#shades(postures)),
        found: (postures) =>
          this.trajectory.offer(
            "solutions",
            postures.map((joints, i) => ({ name: t("playground-solution", { number: i + 1 }), joints })),
          ),
      }),
      this.trajectory,
      workspaceTool(api, picture),
      convertTool(api, { use: (table) => this.use({ table, parameters: this.robot.parameters }, this.robot.joints) }),
    ];
  }

  build() {
    /** @param {any} found */
    const use = (found) => this.use(found);
    this.catalogue = catalogueChoice(api, (call) => this.bring(call));
    fill(place("table-body"), this.catalogue.element, this.configurations, this.editor);
    const share = el("button", { type: "button", class: "small", onclick: () => this.share() }, t("playground-share"));
    fill(place("table-tools"), share);
    fill(place("sources"), axesSource(api, use), scmSource(api, use), urdfSource(api, use));
    fill(
      place("tools"),
      this.limits.element,
      this.tools.map((tool) => tool.element),
      this.#more(),
    );
    this.listen();
  }

  /** Tools that are loaded when somebody asks for them. */
  #more() {
    const body = el("div", { class: "more-tools" }, el("p", { class: "hint", text: t("form-loading") }));
    const group = el("details", { class: "tool" }, el("summary", {}, t("playground-more")), body);
    const open = async () => {
      try {
        const { moreTools } = await import("../playground/more.js");
        const tools = moreTools({ ...this.picture, api, show: (joints) => this.show(joints) });
        fill(body, ...tools.map((tool) => tool.element));
        for (const tool of tools) tool.take(this.#subject());
        this.tools.push(...tools);
      } catch (error) {
        fill(body, problemNotice(error));
        group.addEventListener("toggle", open, { once: true });
      }
    };
    group.addEventListener("toggle", open, { once: true });
    return group;
  }

  listen() {
    connect(this.editor, this.card);
    this.editor.addEventListener("table-change", () => {
      this.bringing.cancel();
      this.#tell(null);
      if (this.found && !this.#known()) this.limits.take(null);
      this.card.take(this.editor.table, { limits: this.limits.limits });
      this.#changed();
    });
    this.robot.addEventListener("reading", (event) => {
      const { rows, faults } = /** @type {CustomEvent} */ (event).detail;
      this.editor.showMeaning(rows);
      this.editor.showFaults(faults);
    });
    this.robot.addEventListener("robot", () => {
      this.#showConfigurations();
      const subject = this.#subject();
      if (subject) this.limits.show(subject);
      this.#tell(subject);
    });
    place("robot").addEventListener("joints-change", () => this.#tell(this.#subject()));
    for (const name of ["input", "joints-change"]) place("robot").addEventListener(name, () => this.#changed());
    window.addEventListener("hashchange", () => this.restore());
  }

  /** The robot of the address, else the one that was here last, else the PUMA. */
  async restore() {
    const shared = decode(location.hash) ?? sharedOf(recall(DRAFT, null));
    if (shared) return this.use(shared, shared.joints);
    const brought = await this.bring((signal) => api.get("robots/puma560", { signal })).catch(() => true);
    if (brought && !this.found) this.use({ table: this.editor.table });
  }

  /**
   * Takes a robot that has to be fetched, unless another one came or something was typed in the meantime.
   * @param {(signal: AbortSignal) => Promise<Found>} call
   */
  async bring(call) {
    const answer = await this.bringing.run(call);
    if (answer) {
      forgetFragment("robot");
      this.use(answer.value);
    }
    return Boolean(answer);
  }

  /**
   * Takes a robot: its table, its values and its joints at once.
   * @param {Found} found @param {number[]} [joints] [rad or length]
   */
  use(found, joints = []) {
    this.bringing.cancel();
    this.found = found;
    this.catalogue?.show(found.id ?? "", found.source);
    this.editor.load(found.table);
    this.foundTable = JSON.stringify(this.editor.table);
    this.#tell(null);
    this.configurations.hidden = true;
    this.limits.take(found.limits ?? null, found.limits_source ?? "");
    this.trajectory.offer(
      "configurations",
      Object.values(found.configurations ?? {}).map(({ joints: posture, meaning }) => ({
        name: meaning,
        joints: posture,
      })),
    );
    this.card.take(this.editor.table, {
      now: true,
      parameters: { ...found.parameters },
      joints,
      limits: this.limits.limits,
    });
    this.#keep();
  }

  /** Limits were changed by hand: sliders and answers follow. */
  #limited() {
    this.#tell(null);
    this.card.take(this.editor.table, { joints: this.robot.joints, limits: this.limits.limits });
    this.#changed();
  }

  /** Postures as shades of the robot. @param {number[][]} postures in the table's units */
  #shades(postures) {
    const { subject, robot } = this.robot;
    if (!subject || !robot || !postures.length) return null;
    return together(postures.map((joints) => shadeModel(robot.model, inward({ ...subject, joints }))));
  }

  /** Brings the robot to joint values. @param {number[]} joints in the table's units @param {{silent?: boolean}} [options] */
  show(joints, { silent = false } = {}) {
    const subject = this.robot.subject;
    if (!subject || subject.types.length !== joints.length) return;
    this.card.show(inward({ ...subject, joints }));
    this.#tell(this.#subject());
    this.#changed();
    if (!silent) announce(t("playground-moved"));
  }

  async share() {
    const address = permalink(location.href, this.#shared());
    history.replaceState(history.state, "", address);
    announce(t((await copyText(address)) ? "playground-shared" : "form-copy-failed"));
  }

  /** What the catalogue knows of a robot goes with its table: with another one it is not that robot any more. */
  #known() {
    return this.found && JSON.stringify(this.editor.table) === this.foundTable ? this.found : null;
  }

  #showConfigurations() {
    const known = this.robot.subject && this.#known();
    if (!known) this.catalogue?.show("");
    const configurations = known?.configurations ?? {};
    this.configurations.hidden = Object.keys(configurations).length === 0;
    if (known === this.offered) return;
    this.offered = known;
    const buttons = Object.values(configurations).map(({ joints, meaning }) =>
      el("button", { type: "button", class: "small", onclick: () => this.show(joints) }, meaning),
    );
    fill(this.configurations, el("span", { class: "label", text: t("playground-configurations") }), buttons);
  }

  /** The robot as the tools ask about it; null while another one is being read. */
  #subject() {
    const { subject } = this.robot;
    if (!subject) return null;
    const units = { angle: subject.table.angle_unit, length: subject.table.length_unit };
    return { ...subject, joints: outward(subject), units, limits: this.limits.limits };
  }

  /** The pose of the last frame where the joints stand now. @returns {Promise<number[][] | null>} */
  async #pose() {
    const subject = this.#subject();
    if (!subject) return null;
    const { table, parameters, joints } = subject;
    const request = { table, ...(Object.keys(parameters).length ? { parameters } : {}), joints, parts: ["transform"] };
    return (await api.post("forward-kinematics", request)).transform;
  }

  #shared() {
    const { limits } = this.limits;
    const { parameters, joints } = this.robot;
    return { table: this.editor.table, parameters, joints, ...(limits ? { limits } : {}) };
  }

  /** What was shared stands in the address no longer than it is what is here. */
  #changed() {
    forgetFragment("robot");
    this.#keep();
  }

  #keep() {
    keep(DRAFT, this.#shared());
  }

  /** @param {import("../playground/tool.js").Subject | null} subject */
  #tell(subject) {
    for (const tool of this.tools) tool.take(subject);
  }
}

/** @param {string} id */
function place(id) {
  return /** @type {HTMLElement} */ (document.getElementById(id));
}

startPage(async () => {
  const playground = new Playground();
  playground.build();
  await playground.restore();
});
