/** What the cells of matrices are understood as while they are typed, in the variables of the student's own table. */

import { Latest } from "../api.js";
import { debounced } from "../dom.js";
import { MatrixField, MatrixListField } from "./part-fields.js";

const PAUSE = 250;

export class MatrixReading {
  #latest = new Latest();

  /** @param {import("../api.js").Api} api @param {{field: any}[]} parts @param {() => any} table as it goes to the API */
  constructor(api, parts, table) {
    this.api = api;
    this.parts = parts;
    this.table = table;
    this.paused = debounced(() => void this.#read(), PAUSE);
  }

  /** Reads once typing has paused; what is on its way was of other cells. */
  soon() {
    this.#latest.cancel();
    this.paused();
  }

  /** @returns {MatrixField[]} */
  get #matrices() {
    const all = this.parts.flatMap(({ field }) => (field instanceof MatrixListField ? field.shown : [field]));
    return all.filter((field) => field instanceof MatrixField);
  }

  async #read() {
    const fields = this.#matrices.filter(({ touched }) => touched);
    for (const field of this.#matrices) if (!field.touched) field.showMeaning([], []);
    if (!fields.length) return;
    const matrices = fields.map((field) => field.value);
    const question = { table: this.table(), matrices };
    const answer = await this.#latest
      .run((signal) => this.api.post("understand", question, { signal }))
      .catch(() => null);
    if (!answer) return;
    const { matrices: read, faults } = answer.value;
    fields.forEach((field, i) => {
      const own = faults
        .map((/** @type {any} */ { pointer, detail }) => ({ where: placeOf(pointer), text: detail }))
        .filter((/** @type {any} */ { where }) => where[0] === i)
        .map((/** @type {any} */ { where, text }) => ({ where: where.slice(1), text }));
      field.showMeaning(read[i] ?? [], own);
    });
  }
}

/** @param {string} pointer such as /matrices/0/1/2; of anything else nothing */
function placeOf(pointer) {
  const [, room, ...where] = pointer.split("/");
  return room === "matrices" ? where.map(Number) : [];
}
