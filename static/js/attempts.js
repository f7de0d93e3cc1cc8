/**
 * History of attempts. Pages talk to an `AttemptStore`; today's keeps them in the browser, and one that keeps
 * them at the service can take its place.
 *
 * @typedef {{at: string, score: number | null, correct: boolean, submission: unknown, verdict: unknown, number?: number,
 *   version?: string}} Attempt `at` is an ISO 8601 time, `score` the share of all points (null: not told yet), `submission` what the form can
 *   take back (null: the service is asked for it); `number` and `version` (of the exercise) are those of an attempt that the service keeps
 * @typedef {{list: (exercise: string) => Promise<Attempt[]>, add: (exercise: string, attempt: Attempt) => Promise<void>,
 *   clear: (exercise: string) => Promise<void>}} AttemptStore
 */

import { keep, recall } from "./storage.js";

const MOST = 50;

/** @type {AttemptStore} */
export const browserAttempts = {
  async list(exercise) {
    return recall(`attempts:${exercise}`, []);
  },
  async add(exercise, attempt) {
    /** @type {Attempt[]} */
    const attempts = recall(`attempts:${exercise}`, []);
    keep(`attempts:${exercise}`, [...attempts, attempt].slice(-MOST));
  },
  async clear(exercise) {
    keep(`attempts:${exercise}`, null);
  },
};
