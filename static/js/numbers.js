/**
 * Numbers as people read them. In tables and matrices the decimal sign is a point: these are things to copy into programs.
 * In sentences it is the language's.
 */

const MINUS = "\u2212";
const LANGUAGE = globalThis.document?.documentElement?.lang || "en";

/**
 * A number with so many decimals at most, no trailing zeros, a true minus sign, and no negative zero.
 * @param {number} value @param {number} [decimals]
 */
export function shown(value, decimals = 4) {
  const text = plain(value, decimals);
  return text.startsWith("-") ? MINUS + text.slice(1) : text;
}

/** The same in a sentence, with the decimal sign of the language. @param {number} value @param {number} [decimals] */
export function inSentence(value, decimals = 4) {
  const text = shown(value, decimals);
  return LANGUAGE === "en" ? text : text.replace(".", ",");
}

/** The same with an ASCII hyphen, for programs. @param {number} value @param {number} [decimals] */
export function plain(value, decimals = 4) {
  if (!Number.isFinite(value)) return "–";
  const fixed = Math.abs(value) >= 1e6 ? value.toPrecision(7) : value.toFixed(decimals);
  const trimmed = fixed.includes(".") && !fixed.includes("e") ? fixed.replace(/\.?0+$/, "") : fixed;
  return trimmed === "-0" ? "0" : trimmed;
}

/** @type {Intl.NumberFormat | null} */
let points = null; // made when the first points are shown: a page answers some hundredths of a second sooner

/** Points, to a tenth: the same text however they were added up. @param {number} value */
export function asPoints(value) {
  points ??= new Intl.NumberFormat(LANGUAGE, { maximumFractionDigits: 1, useGrouping: false });
  return points.format(toTenth(value));
}

/** A share in percent, to a tenth as points are: 99.6 % is not all. @param {number} share */
export function percentOf(share) {
  return `${asPoints(share * 100)} %`;
}

/** Points for a message, which inflects the noun by a number; from a thousand on as text, whose digits are not grouped. @param {number} value */
export function pointsTold(value) {
  const told = toTenth(value);
  return told < 1000 ? told : asPoints(told);
}

/** @param {number} value */
function toTenth(value) {
  return Math.round(value * 10 + 1e-6) / 10;
}

/** A number with all its digits, for programs. @param {number} value */
export function exactly(value) {
  return Object.is(value, -0) ? "0" : String(value);
}

const SUBSCRIPTS = "₀₁₂₃₄₅₆₇₈₉";
const SUPERSCRIPTS = "⁰¹²³⁴⁵⁶⁷⁸⁹";

/** @param {number | string} index */
export const subscript = (index) => String(index).replace(/\d/g, (digit) => SUBSCRIPTS[Number(digit)]);

/** @param {number | string} index */
export const superscript = (index) => String(index).replace(/\d/g, (digit) => SUPERSCRIPTS[Number(digit)]);

/** @param {number} degrees */
export const radians = (degrees) => (degrees * Math.PI) / 180;

/** @param {number} rad */
export const degrees = (rad) => (rad * 180) / Math.PI;

/** What a copied text has around its digits, unseen: soft hyphens, joiners, marks of direction, of words, of bytes. */
const UNSEEN = /[\u00ad\u200b-\u200f\u2060\ufeff]/g;

/** Decimal digits: JavaScript also reads 0x10, 0b11 and 0o7, which the service refuses. */
const DECIMAL = /^[+-]?(?:\d+\.?\d*|\.\d+)(?:e[+-]?\d+)?$/i;

/** A number as people write it, with a decimal point or comma; null if it is none. @param {string} text */
export function numberIn(text) {
  const plainText = text
    .replace(UNSEEN, "")
    .trim()
    .replace(/^[−–‐‑﹣－]/, "-")
    .replace(/e−/i, "e-");
  const withPoint = plainText.replace(/^([+-]?\d*),(\d+)(?=e|$)/i, "$1.$2");
  const value = DECIMAL.test(withPoint) ? Number(withPoint) : NaN;
  return Number.isFinite(value) ? value : null;
}

/** A number, a root, or a fraction of either: 1/2, √2/2, -sqrt(3)/2, 1/√2. @param {string} text @returns {number | null} */
export function fractionIn(text) {
  const [above, below = "1", ...more] = text.split("/").map((each) => rootIn(each));
  if (typeof above !== "number" || below === null || more.length) return null;
  const value = above / Number(below);
  return Number.isFinite(value) ? value : null;
}

/** @param {string} text @returns {number | null} */
function rootIn(text) {
  const match = /^\s*([+\-−]?)\s*([\d.,]*)\s*[*·]?\s*(?:√|sqrt)\s*\(?\s*([\d.,]+)\s*\)?\s*$/i.exec(text);
  if (!match) return numberIn(text);
  const [factor, inner] = [match[2] ? numberIn(match[2]) : 1, numberIn(match[3])];
  if (factor === null || inner === null) return null;
  return (/[-−]/.test(match[1]) ? -1 : 1) * factor * Math.sqrt(inner);
}
