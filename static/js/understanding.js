/**
 * What the service makes of a typed table, cell by cell, and of its rows that have numbers: their link matrices.
 *
 * @typedef {{joint: "revolute" | "prismatic" | "fixed", sign: number, variable: string | null,
 *   meanings: Partial<Record<string, string>>, values: Partial<Record<string, number>>, texts: Partial<Record<string, string>>,
 *   link: number[][] | null}} ReadRow
 *   what each cell means as MathML and as text, and its number [rad or the table's unit] with the joint at zero,
 *   where there is one; pose of frame i in frame i-1 with the joint at zero, where all four have a number
 * @typedef {{rows: ReadRow[], variables: string[], parameters: {name: string, kind: "length" | "angle"}[]}} Reading
 * @typedef {{whole: boolean, reading: Reading, rows: ReadRow[], faults: import("./api.js").Fault[]}} Answer
 *   `whole` if every cell could be read
 */

import { Latest, Problem } from "./api.js";

export class Understanding {
  #latest = new Latest();

  /** @param {import("./api.js").Api} api */
  constructor(api) {
    this.api = api;
  }

  /**
   * @param {any} table as it goes to the API @param {Record<string, number>} parameters in its units
   * @returns {Promise<Answer | null>}
   *   null if it was overtaken by a newer question
   */
  async ask(table, parameters) {
    try {
      const request = { table, parameters };
      const answer = await this.#latest.run((signal) => this.api.post("understand", request, { signal }));
      return answer && readAnswer(answer.value);
    } catch (error) {
      if (!(error instanceof Problem) || error.passing) throw error;
      return { whole: false, reading: { rows: [], variables: [], parameters: [] }, rows: [], faults: error.faults };
    }
  }
}

/** @param {any} answer @returns {Answer} */
function readAnswer({ readable, rows: given, parameters, faults }) {
  const rows = given.map(readRow);
  const variables = rows.flatMap((/** @type {ReadRow} */ { variable }) => (variable === null ? [] : [variable]));
  return { whole: readable, reading: { rows, variables, parameters }, rows, faults };
}

/** @param {any} row @returns {ReadRow} */
function readRow({ joint, sign, variable, link, ...cells }) {
  const known = Object.entries(cells).filter(([, meaning]) => meaning);
  const of = (/** @type {string} */ part) => Object.fromEntries(known.map(([cell, meaning]) => [cell, meaning[part]]));
  const values = Object.fromEntries(Object.entries(of("value")).filter(([, value]) => value !== null));
  return { joint, sign, variable, meanings: of("mathml"), texts: of("text"), values, link: link ?? null };
}
