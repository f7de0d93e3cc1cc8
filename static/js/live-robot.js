/**
 * The robot of a table that is being typed: asks what the table means, draws what can be drawn, follows the sliders.
 *
 * One call to the service makes a keystroke's picture: it reads the table and brings the link matrices of the rows
 * that have numbers. The robot is drawn as far as these go, from the first row on. Matrices at the joints' present
 * values are asked for only while somebody looks at them (`watched`).
 *
 * What is looked at is one state, replaced as a whole; what is drawn is one `Subject`, made of one state and the
 * service's answer to it. Every call is built from one of them, so that no call ever mixes the table of one robot
 * with the values or the joints of another.
 *
 * Events: `typed` (a new table is being looked at), `reading` (what was understood, and the faults), `parameters`
 * (the names that the table uses, and which of them have no value), `robot` (a scene model and joints to move),
 * `poses` (matrices at the joints' present values), `failure` (the service could not be reached or was busy; it is
 * asked again until it answers, and while it has asked to be left alone, whatever is typed, not before).
 */

import { pauseAfter, Problem, Throttled } from "./api.js";
import { debounced } from "./dom.js";
import { clamped, limited, usualRanges } from "./joint-ranges.js";
import { degrees, radians } from "./numbers.js";
import { poseAt, stepsOf } from "./scene/film.js";
import { reach, tableRobot } from "./scene/robots.js";
import { Understanding } from "./understanding.js";

const TYPING_PAUSE = 30;
const DRAGGING_PAUSE = 60;

/**
 * @typedef {import("./joint-ranges.js").JointRange} JointRange
 * @typedef {import("./understanding.js").Reading} Reading
 * @typedef {import("./understanding.js").ReadRow} ReadRow
 * @typedef {import("./joint-ranges.js").Limits} Limits
 * @typedef {{table: any, parameters: Record<string, number>, joints: number[] | null, limits: Limits}} State
 *   what is looked at: the table as it goes to the API, values of parameters in its units, the joint values
 *   [rad or length] that it is to be shown at, or null to leave the joints where they are, and joint limits in the
 *   table's units
 * @typedef {{table: any, parameters: Record<string, number>, types: string[], ranges: JointRange[], joints: number[]}} Subject
 *   what is drawn: a table that could be read, values of just its parameters, joint types and ranges, joint values
 * @typedef {{model: import("./scene/robots.js").TableModel, joints: JointRange[], values: number[], size: number,
 *   rows: ReadRow[], whole: boolean, parameters: Record<string, number>}} Robot
 *   `rows` are those that are drawn; `whole` if these are all; values of the table's parameters, in its units
 */

export class LiveRobot extends EventTarget {
  /** @type {State} */
  #state = { table: null, parameters: {}, joints: null, limits: null };
  /** The state that the service has answered about. @type {State | null} */
  #answered = null;
  /** @type {{subject: Subject, robot: Robot, state: State} | null} */
  #drawn = null;
  #watched = false;
  #failures = 0;
  /** When the service may be asked again [ms]. */
  #after = 0;
  #timer = 0;

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
   * @param {{now?: boolean, parameters?: Record<string, number>, joints?: number[] | null, limits?: Limits}} [options]
   *   `now` does not wait for a pause in typing; parameters that are left out stay as they are, and so do joints
   */
  take(table, { now = false, parameters = this.#state.parameters, joints = this.#pending, limits = null } = {}) {
    this.#state = { table, parameters, joints, limits };
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
    this.#pose();
  }

  /** Joint values that were asked for [rad or length], or those of the robot that is drawn. */
  get joints() {
    return this.#pending ?? this.#drawn?.subject.joints ?? [];
  }

  /** Whether the matrices at the joints' present values are wanted. */
  set watched(watched) {
    this.#watched = watched;
    if (watched) this.#pose();
  }

  get watched() {
    return this.#watched;
  }

  /** What is drawn, if it is what is looked at, and whole. @returns {Subject | null} */
  get subject() {
    return this.#drawn?.state === this.#state && this.#drawn.robot.whole ? this.#drawn.subject : null;
  }

  /** What is drawn, whole or not. @returns {Robot | null} */
  get robot() {
    return this.#drawn?.robot ?? null;
  }

  /** Joint values that were asked for and not yet shown. */
  get #pending() {
    return this.#drawn?.state === this.#state ? null : this.#state.joints;
  }

  /** Asks about the table unless that was done, and draws what has numbers. */
  async #look() {
    const state = this.#state;
    if (this.#answered === state || this.#rests) return;
    try {
      const answer = await this.understanding.ask(state.table, state.parameters);
      if (!answer || state !== this.#state) return;
      this.#answered = state;
      this.#failures = 0;
      this.#tell("reading", answer);
      const { parameters } = answer.reading;
      const missing = parameters.filter(({ name }) => !Number.isFinite(state.parameters[name]));
      if (answer.rows.length) this.#tell("parameters", { missing, parameters });
      this.#draw(state, answer.reading);
    } catch (error) {
      if (state === this.#state) this.#fail(error);
    }
  }

  /** @param {State} state @param {Reading} reading of its table */
  #draw(state, reading) {
    if (reading.rows.length === 0) return;
    const { subject, ...robot } = modelled(state, reading, this.options);
    const values = this.#values(robot.joints);
    this.#drawn = { subject: { ...subject, joints: values }, robot: { ...robot, values }, state };
    this.#tell("robot", this.#drawn.robot);
    this.#pose();
  }

  /**
   * Where the joints of a robot stand at first: as asked for, else where they stood, as far as they may.
   * @param {JointRange[]} joints
   */
  #values(joints) {
    const asked = this.#pending;
    if (asked) return joints.map((_, i) => (asked.length === joints.length ? asked[i] : 0));
    const before = this.#drawn?.subject;
    return joints.map((joint, i) => clamped(joint, before?.types[i] === joint.type ? before.joints[i] : 0));
  }

  /** The matrices at the joints' present values, if somebody looks. */
  #pose() {
    if (!this.#watched || !this.subject || this.#rests) return;
    this.dragging.run(() => this.#askPose()).catch((error) => this.#fail(error));
  }

  async #askPose() {
    if (!this.#drawn?.robot.whole) return;
    const { subject, robot } = this.#drawn;
    const { table, parameters } = subject;
    try {
      const answer = await this.api.post("forward-kinematics", { table, parameters, joints: outward(subject) });
      if (robot === this.#drawn.robot) this.#tell("poses", answer);
    } catch (error) {
      if (robot === this.#drawn.robot) throw error;
    }
  }

  /** @param {unknown} error */
  #fail(error) {
    if (error instanceof Error && error.name === "AbortError") return;
    if (error instanceof Problem && !error.passing) {
      this.#tell("reading", { whole: false, rows: [], faults: error.faults });
    } else {
      this.#answered = null;
      this.#tell("failure", error);
      this.#askLater(error instanceof Problem ? error.wait : 0);
    }
  }

  /** Whether the service has asked to be left alone for now. */
  get #rests() {
    return Date.now() < this.#after;
  }

  /** @param {number} wait seconds that the service asked for */
  #askLater(wait) {
    if (!this.#timer) this.#failures += 1; // what was typed while it waits says nothing new of the service
    const pause = pauseAfter(this.#failures, wait);
    this.#after = wait ? Date.now() + pause : 0;
    clearTimeout(this.#timer);
    this.#timer = setTimeout(() => {
      this.#timer = this.#after = 0;
      void this.#look();
    }, pause);
  }

  /** @param {string} name @param {unknown} detail */
  #tell(name, detail) {
    this.dispatchEvent(new CustomEvent(name, { detail }));
  }
}

/**
 * The robot of a table at given values, for once; null if not every row can be drawn.
 * @param {import("./api.js").Api} api @param {any} table @param {Record<string, number>} parameters in its units
 * @param {{size?: number, prime?: string}} [options]
 * @returns {Promise<Omit<Robot, "values"> | null>}
 */
export async function robotOf(api, table, parameters, options = {}) {
  const answer = await new Understanding(api).ask(table, parameters);
  const found = answer?.whole ? modelled({ table, parameters }, answer.reading, options) : null;
  return found?.whole ? found : null;
}

/**
 * A scene model from the service's link matrices, all joints at zero, as far as rows have one: frame 0 alone, if not
 * even the first has.
 * @param {{table: any, parameters: Record<string, number>, limits?: Limits}} state @param {Reading} reading of its table
 * @param {{size?: number, prime?: string}} options
 */
function modelled(
  { table, parameters: values, limits = null },
  { rows: all, variables, parameters: names },
  { size: given, prime },
) {
  const poses = all.map((row) => row.link ?? carried(table.convention, row));
  const end = poses.indexOf(null);
  const rows = end < 0 ? all : all.slice(0, end);
  const parameters = Object.fromEntries(names.map(({ name }) => [name, values[name]]));
  const types = rows.map((row) => row.joint).filter((joint) => joint !== "fixed");
  const links = /** @type {number[][][]} */ (poses.slice(0, rows.length));
  const size = given ?? reach(links);
  const model = tableRobot({ convention: table.convention, rows, links, size, prime });
  const named = types.map((type, i) => ({ type, name: variables[i] ?? `q${i + 1}` }));
  const joints = limited(usualRanges(named, size), limits, table.angle_unit);
  const subject = { table, parameters, types, ranges: joints };
  return { subject, model, joints, size, rows, whole: rows.length === table.rows.length, parameters };
}

/**
 * Where a row carries its frame, as the film shows it: from its four numbers, for whoever is told no matrices.
 * @param {"standard" | "modified"} convention @param {ReadRow} row
 */
function carried(convention, row) {
  if (Object.keys(row.values).length < 4) return null;
  const steps = stepsOf(convention, row, 0);
  return poseAt(steps, steps.length);
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
