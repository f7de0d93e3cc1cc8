/**
 * What the service makes of a typed table, cell by cell.
 *
 * @typedef {{joint: "revolute" | "prismatic" | "fixed", sign: number, latex: Partial<Record<string, string>>}} ReadRow
 * @typedef {{rows: ReadRow[], variables: string[], parameters: {name: string, kind: "length" | "angle"}[]}} Reading
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
   * @returns {Promise<{reading: Reading | null, rows: (ReadRow | null)[], faults: import("./api.js").Fault[]} | null>}
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

function readAnswer(answer) {
  const faults = answer.faults ?? [];
  return { reading: faults.length ? null : answer, rows: answer.rows, faults };
}
