/** What of the page is switched off: by the exercise, by the link, or because an open part asks for it. */

/** Parts whose answers are matrices that the panel would show. */
const MATRIX_PARTS = ["link_matrices", "transform", "pose"];

export class Access {
  /** @param {Wire.Exercise} exercise @param {import("./progress.js").Progress} progress */
  constructor(exercise, progress) {
    /** @type {string[]} */
    this.off = exercise.access?.off ?? [];
    this.progress = progress;
    this.asked = exercise.parts.map(({ kind }) => kind).filter((kind) => MATRIX_PARTS.includes(kind));
  }

  /** Whether a tool may be used. @param {string} tool */
  allows(tool) {
    return !this.off.includes(tool);
  }

  /** Whether other tables may be made of a table: the call for it belongs to playground and matrices. */
  get converts() {
    return this.allows("playground") && this.allows("matrices");
  }

  /** Shows of the own robot what may be shown: its picture always, its matrices where they give no part away. @param {import("./own-card.js").OwnCard} own */
  apply(own) {
    own.panel.hidden = !this.allows("matrices");
    own.withhold(this.asked.some((kind) => !this.progress.isRight(kind)));
  }
}
