/**
 * The film of a row, over the student's robot: how its four numbers carry frame i−1 into frame i, forwards and
 * backwards, step by step. Where motion is unwelcome it goes on in stills. What is asked of it is read out; where it only
 * follows the cursor it is silent, because the cell is read out already.
 */

import { announce, el, fill, icon, iconButton, setAble } from "../dom.js";
import { LETTERS } from "../editor/model.js";
import { t } from "../i18n.js";
import { degrees, inSentence, subscript } from "../numbers.js";
import { emptyModel, poses } from "../scene/model.js";
import { still, stepsOf } from "../scene/film.js";

/** @typedef {import("../live-robot.js").Robot} Robot */
/** @typedef {import("../scene/film.js").Step} Step */

const SECONDS_A_STEP = 1.4;

export class FilmBar {
  /** @type {Robot | null} */
  #robot = null;
  #joints = /** @type {number[]} */ ([]);
  #row = -1;
  #phase = 0;
  #running = 0;

  /**
   * @param {any} scene the `<robot-scene>` it is shown over
   * @param {{units: () => {angle: string, length: string}, light: (row: number, cell: string) => void}} page
   *   units of the table, and how to light the cell that is being shown (row -1: none)
   */
  constructor(scene, { units, light }) {
    this.scene = scene;
    this.units = units;
    this.light = light;
    this.button = el("button", { type: "button", class: "icon quiet", onclick: () => this.#toggle() });
    this.text = el("p", { class: "film-text" });
    const row = (/** @type {number} */ by) => () => {
      this.show(this.#row + by);
      announce(this.text.textContent);
    };
    this.rows = [
      iconButton("up", t("form-film-row-before"), row(-1)),
      iconButton("down", t("form-film-row-after"), row(1)),
    ];
    this.element = el(
      "div",
      { class: "film no-print", role: "group", "aria-label": t("form-film"), hidden: true },
      this.rows,
      iconButton("back", t("form-film-back"), () => this.step(-1)),
      this.button,
      iconButton("forward", t("form-film-forward"), () => this.step(1)),
      this.text,
    );
    this.#showButton();
  }

  /** Takes the robot that is drawn now; the film goes on where it was. @param {Robot} robot */
  take(robot) {
    this.#robot = robot;
    this.#joints = robot.values;
    this.element.hidden = false;
    if (this.#row >= robot.rows.length) this.clear();
    else this.#draw();
  }

  /** @param {number[]} joints [rad or length] */
  set joints(joints) {
    this.#joints = joints;
    this.#draw();
  }

  /** Shows a row as a still: up to a cell, or from its beginning. @param {number} row @param {string} [cell] */
  show(row, cell) {
    const rows = this.#robot?.rows.length ?? 0;
    if (row < 0 || row >= rows) return;
    this.pause();
    this.#row = row;
    this.#phase = cell ? this.#steps().findIndex((step) => step.cell === cell) + 1 : 0;
    this.#draw();
  }

  /** Plays a row from its beginning. @param {number} row */
  play(row) {
    if (!this.#robot || row >= this.#robot.rows.length) return announce(t("form-film-none", { row: row + 1 }));
    this.show(row);
    this.#toggle();
  }

  /** One step on or back. @param {1 | -1} by */
  step(by) {
    if (this.#row < 0) this.show(0);
    else {
      this.pause();
      const at = by > 0 ? Math.floor(this.#phase) + 1 : Math.ceil(this.#phase) - 1;
      this.#phase = Math.max(0, Math.min(4, at));
      this.#draw();
    }
    announce(this.text.textContent);
  }

  /** No film: the robot alone. */
  clear() {
    this.pause();
    this.#row = -1;
    this.#draw();
  }

  pause() {
    cancelAnimationFrame(this.#running);
    this.#running = 0;
    this.#showButton();
  }

  #toggle() {
    if (this.#running) return this.pause();
    if (this.#row < 0) return this.play(0);
    if (this.#phase >= 4) this.#phase = 0;
    if (matchMedia("(prefers-reduced-motion: reduce)").matches) return this.step(1);
    let last = performance.now();
    const tick = (/** @type {number} */ now) => {
      this.#phase = Math.min(4, this.#phase + (now - last) / 1000 / SECONDS_A_STEP);
      last = now;
      this.#draw();
      if (this.#phase >= 4) return this.pause();
      this.#running = requestAnimationFrame(tick);
    };
    this.#running = requestAnimationFrame(tick);
    this.#showButton();
  }

  /** @returns {Step[]} */
  #steps() {
    const { rows, model } = /** @type {Robot} */ (this.#robot);
    const row = rows[this.#row];
    const joint = rows.slice(0, this.#row).filter(({ joint }) => joint !== "fixed").length;
    const q = row.joint === "fixed" ? 0 : (this.#joints[joint] ?? 0);
    return stepsOf(model.convention, row, q);
  }

  #draw() {
    const robot = this.#robot;
    setAble(this.rows[0], this.#row > 0);
    setAble(this.rows[1], robot !== null && this.#row < robot.rows.length - 1);
    if (!robot || this.#row < 0) {
      if (this.scene.overlay.items.length) this.scene.overlay = emptyModel();
      this.light(-1, "");
      this.text.textContent = t("form-film-hint");
      return;
    }
    const steps = this.#steps();
    const start = poses(robot.model, this.#joints)[robot.model.frames[this.#row]];
    this.scene.overlay = still(steps, this.#phase, start, { size: robot.size, index: this.#row });
    const step = steps[Math.max(0, Math.ceil(this.#phase) - 1)];
    this.light(this.#row, this.#phase > 0 ? step.cell : "");
    const text = this.#sentence(step);
    if (this.text.textContent === text) return;
    this.text.textContent = text;
    if (this.#running) announce(text);
  }

  /** What happens in a step. @param {Step} step */
  #sentence({ cell, axis, turns, amount }) {
    const [before, row] = [this.#row, this.#row + 1];
    if (this.#phase === 0) return t("form-film-start", { row, frame: before });
    const standard = this.#robot?.model.convention === "standard";
    const { angle, length } = this.units();
    const value = turns
      ? angle === "deg"
        ? `${inSentence(degrees(amount), 2)}°`
        : `${inSentence(amount)} rad`
      : `${inSentence(amount)} ${length}`;
    // Standard: about z of frame i−1, then x of frame i; modified: x of frame i−1, then z of frame i.
    const index = (axis === "x") === standard ? row : before;
    const number = Math.ceil(this.#phase);
    return t(turns ? "form-film-turn" : "form-film-slide", {
      row,
      number,
      axis: `${axis}${subscript(index)}`,
      letter: LETTERS[cell],
      value,
    });
  }

  #showButton() {
    const playing = this.#running !== 0;
    fill(this.button, icon(playing ? "pause" : "play"));
    const label = t(playing ? "form-pause" : "form-film-play");
    this.button.setAttribute("aria-label", label);
    this.button.title = label;
  }
}
