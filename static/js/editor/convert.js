/** Numbers that were typed, in another unit. Variables and parameters stay as they are; so does what is not a sum. */

import { convertedLength } from "../units.js";
import { CELLS } from "./model.js";

/**
 * @typedef {import("./model.js").Table} Table
 * @typedef {{table: Table, left: number}} Converted `left` is the number of cells whose numbers stand in
 *   something else than a sum; they are as they were
 */

const NUMBER = /^(?:\d+(?:[.,]\d*)?|[.,]\d+)(?:e[+\-−–]?\d+)?$/i;
/** What is said with π is in radians in every table, what is said with ° in degrees. */
const OWN_UNIT = /pi(?![A-Za-z0-9_])|π|°/iu;
/** The terms of a sum; the sign of a number's exponent begins no term. */
const TERMS = /(\s*[+\-−–]?\s*)((?:(?<![\p{L}\d_])[\d.,]+e[+\-−–]\d+|[^+\-−–])+)/giu;
const PI_FRACTION = /^(?:(\d+)\s*\*?\s*)?(?:pi|π)(?:\s*\/\s*(\d+))?$/i;

/**
 * @param {Table} table @param {"deg" | "rad"} to
 * @param {{keepsPi?: boolean}} [options] whether what is said with π, and means the same in every table, stays
 * @returns {Converted}
 */
export function convertedAngles(table, to, { keepsPi = false } = {}) {
  const inUnit = to === "rad" ? angleInRadians : angleInDegrees;
  const change = (/** @type {string} */ term) => (keepsPi && OWN_UNIT.test(term) ? term : inUnit(term));
  return converted({ ...table, angleUnit: to }, ["alpha", "theta"], change);
}

/** @param {Table} table @param {Table["lengthUnit"]} from @param {Table["lengthUnit"]} to @returns {Converted} */
export function convertedLengths(table, from, to) {
  /** @param {string} term */
  const change = (term) => (NUMBER.test(term) ? written(convertedLength(valueOf(term), from, to), term) : null);
  return converted({ ...table, lengthUnit: to }, ["a", "d"], change);
}

/** Whether there is a number in these columns that would be written otherwise in another unit. @param {Table} table @param {string[]} columns */
export function holdsNumbers(table, columns) {
  const cells = CELLS.filter((cell) => columns.includes(cell));
  /** @param {any} options */
  const counts = ({ term }) => !isSymbol(term) && valueOf(term) !== 0;
  return table.rows.some((row) => cells.some((cell) => termsOf(row[cell])?.some(counts) ?? true));
}

/**
 * A number among the angles that is usual in the other unit and hardly ever in the table's: 90 rad, 1.5708°.
 * @param {Table} table @returns {{text: string, unit: "deg" | "rad"} | null} as it was typed, and that other unit
 */
export function doubtfulAngle({ angleUnit, rows }) {
  const unit = angleUnit === "rad" ? "deg" : "rad";
  const twelfths = (/** @type {number} */ value) => (value * 12) / Math.PI;
  /** @param {string} text */
  const isDoubtful = (text) => {
    const value = valueOf(text);
    if (unit === "deg") return value > 2 * Math.PI;
    const nearest = Math.round(twelfths(value));
    return /[.,]\d\d/.test(text) && nearest > 0 && nearest <= 24 && Math.abs(twelfths(value) - nearest) < 0.02;
  };
  const terms = rows.flatMap(({ alpha, theta }) => [alpha, theta].flatMap((text) => termsOf(text) ?? []));
  const found = terms.map(({ term }) => term).find((term) => NUMBER.test(term) && isDoubtful(term));
  return found ? { text: found, unit } : null;
}

/** @param {Table} table @param {("alpha" | "a" | "d" | "theta")[]} columns @param {(term: string) => string | null} change */
function converted(table, columns, change) {
  let left = 0;
  /** @param {string} text */
  const cell = (text) => {
    const changed = convertedSum(text, change);
    if (changed === null) left += 1;
    return changed ?? text;
  };
  const rows = table.rows.map((/** @type {any} */ row) => ({
    ...row,
    ...Object.fromEntries(columns.map((/** @type {string} */ name) => [name, cell(row[name])])),
  }));
  return { table: { ...table, rows }, left };
}

/**
 * A sum whose numbers are changed; null if it is none, or if one of its terms cannot be changed.
 * @param {string} text @param {(term: string) => string | null} change
 */
export function convertedSum(text, change) {
  const terms = termsOf(text);
  if (!terms) return null;
  let whole = "";
  for (const { sign, term, blank } of terms) {
    const next = isSymbol(term) ? term : change(term);
    if (next === null) return null;
    whole += sign + next + blank;
  }
  return whole;
}

/** The terms of a sum with the signs and blanks before them; null if it holds parentheses. @param {string} text */
function termsOf(text) {
  if (/[()[\]{}]/.test(text)) return null;
  const parts = [...text.trim().matchAll(TERMS)];
  if (parts.map(([whole]) => whole).join("") !== text.trim()) return null;
  return parts.map(([, sign, term]) => {
    const trimmed = term.trimEnd();
    return { sign, term: trimmed, blank: term.slice(trimmed.length) };
  });
}

/** Whether a term holds a variable or parameter, so that its unit is not its own. @param {string} term */
function isSymbol(term) {
  return !NUMBER.test(term) && /[A-Za-zΑ-ω]/u.test(term.replace(new RegExp(OWN_UNIT, "giu"), ""));
}

/** @param {string} term */
function angleInRadians(term) {
  if (OWN_UNIT.test(term)) return term;
  return NUMBER.test(term) ? fractionOfPi(valueOf(term), term) : null;
}

/** @param {string} term */
function angleInDegrees(term) {
  const match = PI_FRACTION.exec(term);
  if (match) return written((Number(match[1] ?? 1) * 180) / Number(match[2] ?? 1));
  if (OWN_UNIT.test(term)) return term;
  return NUMBER.test(term) ? written((valueOf(term) * 180) / Math.PI, term) : null;
}

/** @param {number} degrees @param {string} typed */
function fractionOfPi(degrees, typed) {
  if (degrees === 0) return "0";
  for (const [numerator, denominator] of [
    [1, 1],
    [1, 2],
    [1, 3],
    [2, 3],
    [1, 4],
    [3, 4],
    [1, 6],
    [5, 6],
    [1, 12],
    [2, 1],
  ]) {
    if (degrees === (180 * numerator) / denominator)
      return `${numerator === 1 ? "" : `${numerator}*`}pi${denominator === 1 ? "" : `/${denominator}`}`;
  }
  return written((degrees * Math.PI) / 180, typed);
}

/** What a number says, with a decimal point or comma and any minus sign in its exponent. @param {string} term */
function valueOf(term) {
  return Number(term.replace(",", ".").replace(/[−–]/, "-"));
}

/** A number, with the decimal sign of the one that it takes the place of. @param {number} value @param {string} [typed] */
function written(value, typed = "") {
  const text = String(Number(value.toPrecision(12)));
  return typed.includes(",") ? text.replace(".", ",") : text;
}
