/**
 * The robot of a table that is being typed: reads the table, asks for its link matrices, follows the sliders.
 *
 * What is looked at is one state, replaced as a whole; what is drawn is one `Subject`, made of one state and the
 * service's reading of its table. Every call is built from one of them, so that no call ever mixes the table of
 * one robot with the values or the joints of another.
 *
 * Events: `typed` (a new table is being looked at), `reading` (what was understood, or the faults), `parameters`
 * (the names that the table uses, and which of them have no value), `robot` (a scene model and joints to move),
 * `poses` (matrices at the joints' present values), `failure` (the service could not be reached).
 */

import { Latest, Problem, Throttled } from "./api.js";
import { debounced } from "./dom.js";
import { clamped, usualRanges } from "./joint-ranges.js";
import { degrees, radians } from "./numbers.js";
import { reach, tableRobot } from "./scene/robots.js";
import { Understanding } from "./understanding.js";

const TYPING_PAUSE = 220;
const DRAGGING_PAUSE = 60;

/**
 * @typedef {import("./joint-ranges.js").JointRange} JointRange
 * @typedef {{table: any, parameters: Record<string, number>, joints: number[] | null}} State
 *   what is looked at: the table as it goes to the API, values of parameters in its units, and the joint values
 *   [rad or length] that it is to be shown at, or null to leave the joints where they are
 * @typedef {{table: any, parameters: Record<string, number>, types: string[], ranges: JointRange[], joints: number[]}} Subject
 *   what is drawn: a table that could be read, values of just its parameters, joint types and ranges, joint values
 * @typedef {{model: import("./scene/model.js").Model, joints: JointRange[], values: number[], size: number}} Robot
 */

export class LiveRobot extends EventTarget {
  /** @type {State} */
  #state = { table: null, parameters: {}, joints: null };
  /** @type {{table: any, reading: import("./understanding.js").Reading} | null} */
  #read = null;
  /** @type {{subject: Subject, robot: Robot, state: State} | null} */
  #drawn = null;
  #drawing = new Latest();

  /** @param {import("./api.js").Api} api @param {{size?: number, prime?: string}} [options] */
  constructor(api, options = {}) {
    super();
    this.api = api;
    this.options = options;
    this.understanding = new Understanding(api);
    this.dragging = new Throttled(DRAGGING_PAUSE);
    this.paused = debounced(() => this.#look(), TYPING_PAUSE);
  }

  /**
   * Looks at a table from now on.
   * @param {any} table as it goes to the API
   * @param {{now?: boolean, parameters?: Record<string, number>, joints?: number[] | null}} [options]
   *   `now` does not wait for a pause in typing; parameters that are left out stay as they are, and so do joints
   */
  take(table, { now = false, parameters = this.#state.parameters, joints = this.#pending } = {}) {
    this.#state = { table, parameters, joints };
    this.#tell("typed", table);
    if (now) this.#look();
    else this.paused();
  }

  /** Values of the parameters, in the table's units. @param {Record<string, number>} parameters */
  set parameters(parameters) {
    this.#state = { ...this.#state, parameters, joints: this.#pending };
    if (this.#state.table) this.paused();
  }

  get parameters() {
    return this.#state.parameters;
  }

  /** Joint values of the robot that is drawn [rad or length]. @param {number[]} joints */
  set joints(joints) {
    if (!this.#drawn) return;
    this.#drawn = { ...this.#drawn, subject: { ...this.#drawn.subject, joints } };
    this.dragging.run(() => this.#pose()).catch((error) => this.#fail(error));
  }

  /** Joint values that were asked for [rad or length], or those of the robot that is drawn. */
  get joints() {
    return this.#pending ?? this.#drawn?.subject.joints ?? [];
  }

  /** What is drawn, if it is what is looked at. @returns {Subject | null} */
  get subject() {
    return this.#drawn?.state === this.#state ? this.#drawn.subject : null;
  }

  /** Joint values that were asked for and not yet shown. */
  get #pending() {
    return this.#drawn?.state === this.#state ? null : this.#state.joints;
  }

  /** Reads the table unless that was done, and draws it. */
  async #look() {
    const { table } = this.#state;
    if (this.subject) return;
    try {
      if (this.#read?.table !== table) {
        this.#drawing.cancel();
        const answer = await this.understanding.ask(table);
        if (!answer || table !== this.#state.table) return;
        this.#read = answer.reading && { table, reading: answer.reading };
        this.#tell("reading", answer);
      }
      if (this.#read) await this.#draw(this.#state, this.#read.reading);
    } catch (error) {
      if (table === this.#state.table) this.#fail(error);
    }
  }

  /** @param {State} state @param {import("./understanding.js").Reading} reading of its table */
  async #draw(state, reading) {
    const missing = reading.parameters.filter(({ name }) => !Number.isFinite(state.parameters[name]));
    this.#tell("parameters", { missing, parameters: reading.parameters });
    if (missing.length) return this.#drawing.cancel();
    const answer = await this.#drawing.run((signal) => modelled(this.api, state, reading, { ...this.options, signal }));
    if (!answer || state !== this.#state) return;
    const { subject, model, joints, size } = answer.value;
    const values = this.#values(state, joints);
    this.#drawn = { subject: { ...subject, joints: values }, robot: { model, joints, values, size }, state };
    this.#tell("robot", this.#drawn.robot);
    await this.dragging.run(() => this.#pose());
  }

  /** Where the joints of a robot stand at first: as asked for, else where they stood, as far as they may. */
  #values(state, joints) {
    if (state.joints) return joints.map((_, i) => (state.joints?.length === joints.length ? state.joints[i] : 0));
    const before = this.#drawn?.subject;
    const same = before && before.types.join() === joints.map(({ type }) => type).join();
    return joints.map((joint, i) => clamped(joint, same ? before.joints[i] : 0));
  }

  async #pose() {
    const { subject, robot } = this.#drawn;
    const { table, parameters } = subject;
    try {
      const answer = await this.api.post("forward-kinematics", { table, parameters, joints: outward(subject) });
      if (robot === this.#drawn.robot) this.#tell("poses", answer);
    } catch (error) {
      if (robot === this.#drawn.robot) throw error;
    }
  }

  #fail(error) {
    if (error?.name === "AbortError") return;
    if (error instanceof Problem) this.#tell("reading", { reading: null, rows: [], faults: error.faults });
    else this.#tell("failure", error);
  }

  #tell(name, detail) {
    this.dispatchEvent(new CustomEvent(name, { detail }));
  }
}

/**
 * The robot of a table at given values, for once; null if it cannot be read or a value is missing.
 * @param {import("./api.js").Api} api @param {any} table @param {Record<string, number>} parameters in its units
 * @returns {Promise<Omit<Robot, "values"> | null>}
 */
export async function robotOf(api, table, parameters) {
  const answer = await new Understanding(api).ask(table);
  const reading = answer?.reading;
  if (!reading || reading.parameters.some(({ name }) => !Number.isFinite(parameters[name]))) return null;
  return modelled(api, { table, parameters }, reading);
}

/**
 * A scene model from the service's link matrices, all joints at zero.
 * @param {import("./api.js").Api} api @param {{table: any, parameters: Record<string, number>}} state
 * @param {import("./understanding.js").Reading} reading of its table
 * @param {{size?: number, prime?: string, signal?: AbortSignal}} [options]
 */
async function modelled(api, { table, parameters: values }, { rows, variables, parameters: names }, { signal, size: given, prime } = {}) {
  const parameters = Object.fromEntries(names.map(({ name }) => [name, values[name]]));
  const types = rows.map((row) => row.joint).filter((joint) => joint !== "fixed");
  const request = { table, parameters, joints: types.map(() => 0), parts: ["links"] };
  const { links } = await api.post("forward-kinematics", request, { signal });
  const size = given ?? reach(links);
  const model = tableRobot({ convention: table.convention, rows, links, size, prime });
  const joints = usualRanges(types.map((type, i) => ({ type, name: variables[i] ?? `q${i + 1}` })), size);
  return { subject: { table, parameters, types, ranges: joints }, model, joints, size };
}

/** A subject's joint values in its table's units. @param {Subject} subject */
export function outward({ table, types, joints }) {
  const inDegrees = table.angle_unit === "deg";
  return types.map((type, i) => (inDegrees && type === "revolute" ? degrees(joints[i]) : joints[i]));
}

/** The same back: joint values in the table's units as radians and lengths. @param {Subject} subject */
export function inward({ table, types, joints }) {
  const inDegrees = table.angle_unit === "deg";
  return types.map((type, i) => (inDegrees && type === "revolute" ? radians(joints[i]) : joints[i]));
}
