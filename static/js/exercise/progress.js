/** What is done and what is left, always in sight: one entry for each part, and the points of the whole exercise. */

import { el, fill, icon } from "../dom.js";
import { named, t } from "../i18n.js";
import { pointsTold } from "../numbers.js";

/** @typedef {{kind: string, touched: boolean, print: string}} PartState what stands in a part's fields */

/** Points out of points, as they are said everywhere. @param {number} earned @param {number} total */
export function pointsText(earned, total) {
  return t("form-points", { points: pointsTold(earned), total: pointsTold(total) });
}

/** @param {string} kind */
export function partName(kind) {
  return t(`form-part-${kind.replaceAll("_", "-")}`);
}

export class Progress {
  /** What was last found of each part, and what stood in it then. @type {Map<string, {print: string, points: number, most: number}>} */
  #found = new Map();

  /** @param {Wire.Exercise} exercise @param {(kind: string) => void} go leads to a part */
  constructor(exercise, go) {
    this.exercise = exercise;
    this.go = go;
    this.list = el("ul");
    this.sum = el("strong");
    this.element = el("nav", { class: "progress no-print", "aria-label": t("form-progress") }, this.sum, this.list);
  }

  /** Takes what was found of an answer. @param {Wire.Graded} graded @param {PartState[]} handed the parts as they were handed in */
  take(graded, handed) {
    for (const { kind, print } of handed) {
      const report = graded.parts?.[kind];
      if (report) this.#found.set(kind, { print, points: report.points, most: report.max_points });
    }
  }

  /** Parts that were judged and not changed since. @param {PartState[]} states */
  judged(states) {
    return new Set(states.filter(({ kind, print }) => this.#found.get(kind)?.print === print).map(({ kind }) => kind));
  }

  /** Whether all of a part was right when it was last judged. @param {string} kind */
  isRight(kind) {
    const found = this.#found.get(kind);
    return found !== undefined && found.points >= found.most;
  }

  /** @param {PartState[]} states of all parts, in the exercise's order */
  show(states) {
    const judged = this.judged(states);
    const found = [...judged].map((kind) => /** @type {{points: number}} */ (this.#found.get(kind)));
    const points = found.reduce((sum, entry) => sum + entry.points, 0);
    this.sum.textContent = pointsText(points, this.exercise.points);
    this.sum.hidden = states.length === 1;
    fill(
      this.list,
      states.map((state) => el("li", {}, this.#entry(state, judged.has(state.kind)))),
    );
  }

  /** @param {PartState} state @param {boolean} judged */
  #entry({ kind, touched }, judged) {
    const found = this.#found.get(kind);
    const right = judged && this.isRight(kind);
    const tone = judged ? (right ? "good" : "warn") : "";
    const said =
      judged && found
        ? pointsText(found.points, found.most)
        : t(touched ? "form-progress-typed" : "form-progress-open");
    const follow = (/** @type {Event} */ event) => (event.preventDefault(), this.go(kind));
    return el(
      "a",
      { class: `badge ${tone}`, href: `#part-${kind}`, onclick: follow },
      right ? icon("check") : null,
      el("span", {}, named(partName(kind), said)),
    );
  }
}
