/**
 * What the service makes of a typed table, cell by cell.
 *
 * @typedef {{joint: "revolute" | "prismatic" | "fixed", sign: number, variable: string | null,
 *   meanings: Partial<Record<string, string>>}} ReadRow what each cell means as MathML, where it can be read
 * @typedef {{rows: ReadRow[], variables: string[], parameters: {name: string, kind: "length" | "angle"}[]}} Reading
 * @typedef {{reading: Reading | null, rows: ReadRow[], faults: import("./api.js").Fault[]}} Answer
 *   `reading` is there if the whole table could be read
 */

import { Latest, Problem } from "./api.js";

export class Understanding {
  #latest = new Latest();

  /** @param {import("./api.js").Api} api */
  constructor(api) {
    this.api = api;
  }

  /**
   * @param {any} table as it goes to the API
   * @returns {Promise<Answer | null>}
   *   null if it was overtaken by a newer question
   */
  async ask(table) {
    try {
      const answer = await this.#latest.run((signal) => this.api.post("understand", { table }, { signal }));
      return answer && readAnswer(answer.value);
    } catch (error) {
      if (error instanceof Problem && error.status < 500) return { reading: null, rows: [], faults: error.faults };
      throw error;
    }
  }
}

/** @returns {Answer} */
function readAnswer({ readable, rows, parameters, faults }) {
  const read = rows.map(({ joint, sign, variable, ...cells }) => {
    const known = Object.entries(cells).filter(([, meaning]) => meaning);
    return { joint, sign, variable, meanings: Object.fromEntries(known.map(([cell, { mathml }]) => [cell, mathml])) };
  });
  const variables = read.map((row) => row.variable).filter((variable) => variable !== null);
  return { reading: readable ? { rows: read, variables, parameters } : null, rows: read, faults };
}
