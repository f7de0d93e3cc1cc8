/**
 * Units of tables, and values carried from one into another.
 *
 * @typedef {{angle: string, length: string}} Units
 */

import { degrees, radians } from "./numbers.js";

/** Metres in each unit of length. @type {Record<string, number>} */
export const METRES = { m: 1, cm: 0.01, mm: 0.001, in: 0.0254 };

/** @param {number} value @param {string} from @param {string} to units of length */
export function convertedLength(value, from, to) {
  return from === to ? value : rounded((value * METRES[from]) / METRES[to]);
}

/** @param {number} value @param {string} from @param {string} to "deg" or "rad" */
function convertedTurn(value, from, to) {
  if (from === to) return value;
  return rounded(to === "rad" ? radians(value) : degrees(value));
}

/**
 * Values of parameters in other units; they go on meaning the same.
 * @param {Record<string, number>} values @param {(name: string) => "angle" | "length"} kindOf
 * @param {Units} from @param {Units} to
 */
export function convertedValues(values, kindOf, from, to) {
  /** @param {string} name @param {any} value */
  const change = (name, value) =>
    kindOf(name) === "angle"
      ? convertedTurn(value, from.angle, to.angle)
      : convertedLength(value, from.length, to.length);
  return Object.fromEntries(Object.entries(values).map(([name, value]) => [name, change(name, value)]));
}

/** Without the last digits, which conversions make up. @param {number} value */
function rounded(value) {
  return Number(value.toPrecision(12));
}
