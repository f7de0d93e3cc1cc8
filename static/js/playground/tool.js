/**
 * One answer about the robot: closed until asked for, and then kept up to date.
 *
 * A tool is shown as a `<details>`; while it is open it is run again whenever the robot or its joints change,
 * one call at a time and the last one always.
 */

import { Throttled } from "../api.js";
import { el, fill } from "../dom.js";
import { problemNotice } from "../problem.js";

const PAUSE = 120;

/**
 * @typedef {{table: any, parameters: Record<string, number>, types: string[], joints: number[],
 *   ranges: import("../joint-ranges.js").JointRange[], units: {angle: string, length: string},
 *   limits: import("../joint-ranges.js").Limits}} Subject
 *   the robot in question as it goes to the API, its joint values and limits in the table's units, and its sliders' ranges
 */

export class Tool {
  #throttled = new Throttled(PAUSE);
  /** @type {Subject | null} */
  #subject = null;

  /**
   * @param {string} title @param {(subject: Subject, body: HTMLElement) => Promise<Node[]>} answer
   * @param {{controls?: Node[], closed?: () => void}} [options] what stands above the answer, and what is done when
   *   nobody looks at it any more
   */
  constructor(title, answer, { controls = [], closed = () => undefined } = {}) {
    this.answer = answer;
    this.closed = closed;
    this.body = el("div", { class: "tool-answer", "aria-live": "off" });
    this.element = el("details", { class: "tool" }, el("summary", {}, title), ...controls, this.body);
    this.element.addEventListener("toggle", () => (this.open ? this.refresh() : closed()));
  }

  get open() {
    return /** @type {HTMLDetailsElement} */ (this.element).open;
  }

  /** @param {Subject | null} subject */
  take(subject) {
    this.#subject = subject;
    this.body.classList.toggle("busy", !subject);
    this.refresh();
  }

  /** Asks again, if the tool is open and there is something to ask about. */
  refresh() {
    if (!this.open || !this.#subject) return;
    this.#throttled.run(() => this.#run()).catch(() => undefined);
  }

  async #run() {
    const subject = this.#subject;
    if (!subject) return;
    /** @type {Node[]} */
    let shown;
    try {
      shown = await this.answer(subject, this.body);
    } catch (error) {
      shown = [problemNotice(error)];
    }
    if (!this.open) this.closed(); // what it has drawn came after it was closed
    const present = [...this.body.childNodes];
    const same = present.length === shown.length && shown.every((node, i) => node === present[i]);
    if (subject === this.#subject && !same) fill(this.body, ...shown);
  }
}

/**
 * @typedef {{layer: (name: string, model: import("../scene/model.js").Model | null) => void,
 *   robot: () => import("../live-robot.js").Robot | null, joints: () => number[]}} Picture
 *   what tools draw in: layers over the robot, the robot that is drawn, its joint values [rad or length]
 */

/** Whether two subjects are the same robot, wherever its joints stand. @param {Subject | null} one @param {Subject | null} other */
export function sameRobot(one, other) {
  /** @param {any} subject */
  const robot = (subject) => subject && JSON.stringify([subject.table, subject.parameters]);
  return robot(one) === robot(other);
}

/** What every call about a robot starts with. @param {Subject} subject */
export function asked({ table, parameters }) {
  return Object.keys(parameters).length ? { table, parameters } : { table };
}
