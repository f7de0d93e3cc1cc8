/**
 * The robot of a table that is being typed: reads the table, asks for its link matrices, follows the sliders.
 * Events: `typed` (a new table is being looked at), `reading` (what was understood, or the faults), `robot` (a scene model and joints to move), `poses`
 * (matrices at the joints' present values), `failure` (the service could not be reached).
 */

import { Problem, Throttled } from "./api.js";
import { debounced } from "./dom.js";
import { degrees } from "./numbers.js";
import { reach, tableRobot } from "./scene/robots.js";
import { Understanding } from "./understanding.js";

const TYPING_PAUSE = 220;
const DRAGGING_PAUSE = 60;

/**
 * @typedef {{model: import("./scene/model.js").Model, joints: {name: string, type: string}[], size: number}} Robot
 */

export class LiveRobot extends EventTarget {
  #asked = 0;
  #table = /** @type {any} */ (null);
  /** @type {Record<string, number>} */
  #parameters = {};
  #joints = /** @type {number[]} */ ([]);
  #types = /** @type {string[]} */ ([]);
  #ready = false;
  /** @type {{key: string, robot: Robot} | null} */
  #drawn = null;

  /** @param {import("./api.js").Api} api @param {{size?: number, prime?: string}} [options] */
  constructor(api, options = {}) {
    super();
    this.api = api;
    this.options = options;
    this.understanding = new Understanding(api);
    this.dragging = new Throttled(DRAGGING_PAUSE);
    this.typed = debounced(() => this.#read(), TYPING_PAUSE);
  }

  /** The table as it goes to the API. @param {any} table @param {{now?: boolean}} [options] */
  take(table, { now = false } = {}) {
    this.#table = table;
    this.#asked += 1;
    this.#tell("typed", table);
    if (now) this.#read();
    else this.typed();
  }

  /**
   * The robot of the present table, as soon as it is drawn; null if it cannot be drawn, or another one came.
   * @param {any} table @returns {Promise<Robot | null>}
   */
  of(table) {
    const key = JSON.stringify(table);
    if (this.#drawn?.key === key) return Promise.resolve(this.#drawn.robot);
    if (JSON.stringify(this.#table) !== key) return Promise.resolve(null);
    return new Promise((resolve) => {
      const over = new AbortController();
      const settle = (robot) => {
        over.abort();
        resolve(robot);
      };
      const listen = (name, listener) => this.addEventListener(name, listener, { signal: over.signal });
      listen("robot", () => settle(this.#drawn?.key === key ? this.#drawn.robot : null));
      listen("reading", (event) => /** @type {CustomEvent} */ (event).detail.reading || settle(null));
      listen("parameters", (event) => /** @type {CustomEvent} */ (event).detail.missing.length && settle(null));
      listen("failure", () => settle(null));
      listen("typed", () => settle(null));
      this.#read();
    });
  }

  /** Values of the parameters, in the table's units. @param {Record<string, number>} parameters */
  set parameters(parameters) {
    this.#parameters = parameters;
    if (this.reading) this.#draw(this.#asked);
  }

  get parameters() {
    return this.#parameters;
  }

  /** Joint values [rad or length]. @param {number[]} values */
  set joints(values) {
    this.#joints = values;
    if (this.#ready) this.dragging.run(() => this.#pose()).catch((error) => this.#fail(error));
  }

  /** What goes into a call that concerns the table as it was last understood. */
  get request() {
    const names = new Set(this.reading?.parameters.map(({ name }) => name));
    const parameters = Object.fromEntries(Object.entries(this.#parameters).filter(([name]) => names.has(name)));
    return { table: this.read, parameters };
  }

  async #read() {
    const asked = this.#asked;
    const table = this.#table;
    try {
      const answer = await this.understanding.ask(table);
      if (!answer || asked !== this.#asked) return;
      this.reading = answer.reading;
      if (answer.reading) this.read = table;
      this.#tell("reading", answer);
      if (answer.reading) await this.#draw(asked);
    } catch (error) {
      this.#fail(error);
    }
  }

  async #draw(asked) {
    const reading = this.reading;
    const missing = reading.parameters.filter(({ name }) => !Number.isFinite(this.#parameters[name]));
    this.#ready = missing.length === 0;
    if (missing.length) return this.#tell("parameters", { missing, parameters: reading.parameters });
    const types = reading.rows.map((row) => row.joint).filter((joint) => joint !== "fixed");
    if (types.join() !== this.#types.join()) this.#joints = types.map(() => 0);
    this.#types = types;
    try {
      const request = { ...this.request, joints: types.map(() => 0), parts: ["links"] };
      const { links } = await this.api.post("forward-kinematics", request);
      if (asked !== this.#asked) return;
      const size = this.options.size ?? reach(links);
      const model = tableRobot({ convention: this.read.convention, rows: reading.rows, links, size, prime: this.options.prime });
      const joints = types.map((type, i) => ({ type, name: reading.variables[i] ?? `q${i + 1}` }));
      this.#tell("parameters", { missing: [], parameters: reading.parameters });
      this.#drawn = { key: JSON.stringify(this.read), robot: { model, joints, size } };
      this.#tell("robot", this.#drawn.robot);
      await this.dragging.run(() => this.#pose());
    } catch (error) {
      this.#fail(error);
    }
  }

  async #pose() {
    const asked = this.#asked;
    const inDegrees = this.read.angle_unit === "deg";
    const joints = this.#types.map((type, i) => {
      const value = this.#joints[i] ?? 0;
      return inDegrees && type === "revolute" ? degrees(value) : value;
    });
    const answer = await this.api.post("forward-kinematics", { ...this.request, joints });
    if (asked === this.#asked) this.#tell("poses", answer);
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
