/**
 * The table that follows from the frames, in the names of the exercise: a2 and not 0.4318, 90 or pi/2 and not
 * 1.5707963267948966.
 */

import { dataTable } from "../data-table.js";
import { el } from "../dom.js";
import { columnName } from "../editor/grid.js";
import { COLUMNS } from "../editor/model.js";
import { t } from "../i18n.js";
import { degrees } from "../numbers.js";
import { column, minus, norm, plus, times } from "../scene/matrix.js";

/** @typedef {{alpha: string, a: string, d: string, theta: string, joint: Wire.JointType}} NamedRow */
/** @typedef {{name: string, value: number, at?: Wire.Vector}} Dimension `at` is the middle of the line that it measures in the figure */

const CLOSE = 1e-6;
const FRACTIONS = [1, 2, 3, 4, 6, 12];

/** An angle [rad] in the exercise's unit. @param {number} angle @param {"deg" | "rad"} unit */
function angleText(angle, unit) {
  if (Math.abs(angle) < CLOSE) return "0";
  if (unit === "deg") return String(Number(degrees(angle).toFixed(6)));
  for (const denominator of FRACTIONS) {
    const numerator = (angle * denominator) / Math.PI;
    if (Math.abs(numerator - Math.round(numerator)) > CLOSE) continue;
    const whole = Math.round(numerator);
    const top = Math.abs(whole) === 1 ? (whole < 0 ? "-pi" : "pi") : `${whole}*pi`;
    return denominator === 1 ? top : `${top}/${denominator}`;
  }
  return String(Number(angle.toFixed(6)));
}

/** A length in the names of the dimensions: one of them, or a sum or difference of two. @param {number} length @param {Dimension[]} dimensions @param {number} size of the robot */
function lengthText(length, dimensions, size) {
  const near = (/** @type {number} */ value) => Math.abs(value - length) < CLOSE * size;
  if (near(0)) return "0";
  const signed = dimensions.flatMap(({ name, value }) => [
    { text: name, value },
    { text: `-${name}`, value: -value },
  ]);
  const one = signed.find(({ value }) => near(value));
  if (one) return one.text;
  for (const first of signed) {
    for (const second of signed) {
      if (first.text.replace("-", "") === second.text.replace("-", "") || !near(first.value + second.value)) continue;
      const [lead, tail] = first.text.startsWith("-") ? [second, first] : [first, second];
      return tail.text.startsWith("-") ? `${lead.text} - ${tail.text.slice(1)}` : `${lead.text} + ${tail.text}`;
    }
  }
  return String(Number(length.toFixed(6)));
}

/**
 * A row of /check-frames in names. Where a joint is zero is free in most exercises: its offset is then left out.
 * @param {any} row angles in radians @param {{dimensions: Dimension[], angle: "deg" | "rad", size: number, zeroIsFree: boolean}} names
 * @param {{a?: Wire.Vector, d?: Wire.Vector}} [middles] of the lines that its two lengths are, in the figure
 * @returns {NamedRow}
 */
export function namedRow(row, { dimensions, angle, size, zeroIsFree }, middles = {}) {
  const angleCell = (/** @type {number} */ value) => angleText(value, angle);
  const lengthCell = (/** @type {"a" | "d"} */ cell) => (/** @type {number} */ value) =>
    lengthText(value, nearest(dimensions, middles[cell]), size);
  const cell = (/** @type {string | number} */ value, /** @type {(value: number) => string} */ text) => {
    if (typeof value === "number") return text(value);
    const { variable, offset } = variableIn(value);
    const rest = zeroIsFree ? "0" : text(offset);
    return rest === "0" ? variable : rest.startsWith("-") ? `${variable} - ${rest.slice(1)}` : `${variable} + ${rest}`;
  };
  return {
    joint: row.joint,
    alpha: cell(row.alpha, angleCell),
    a: cell(row.a, lengthCell("a")),
    d: cell(row.d, lengthCell("d")),
    theta: cell(row.theta, angleCell),
  };
}

/** Of dimensions that are equally long, the one that is drawn nearest comes first. @param {Dimension[]} dimensions @param {Wire.Vector} [middle] */
function nearest(dimensions, middle) {
  if (!middle) return dimensions;
  const away = (/** @type {Dimension} */ { at }) => (at ? norm(minus(at, middle)) : Infinity);
  return [...dimensions].sort((one, other) => away(one) - away(other));
}

/**
 * Middles of the lines that a row's lengths are: a along the x and d along the z that the convention says.
 * @param {string} convention @param {number[][]} before @param {number[][]} after poses of frame i-1 and i in the figure
 */
export function middlesOf(convention, before, after) {
  const [from, to] = [column(before, 3), column(after, 3)];
  const way = minus(to, from);
  const axis = convention === "standard" ? column(before, 2) : column(before, 0);
  const corner = plus(from, times(axis, way[0] * axis[0] + way[1] * axis[1] + way[2] * axis[2]));
  const middle = (/** @type {Wire.Vector} */ a, /** @type {Wire.Vector} */ b) => times(plus(a, b), 0.5);
  const [first, second] = [middle(from, corner), middle(corner, to)];
  return convention === "standard" ? { d: first, a: second } : { a: first, d: second };
}

/** A cell's variable with its sign, and what is added to it. @param {string} text such as "-q2 + 0.5" */
export function variableIn(text) {
  const match = /^\s*(-?q\d+)\s*(?:([+-])\s*(\S+))?\s*$/.exec(text);
  if (!match) return { variable: text, offset: 0 };
  return { variable: match[1], offset: match[3] ? Number(match[3]) * (match[2] === "-" ? -1 : 1) : 0 };
}

/**
 * The fixed row that leads from the last frame of a modified table to a point off its axis: Rot_x(α) Trans_x(a) Trans_z(d).
 * @param {number[]} point in the last frame
 */
export function rowToPoint([x, y, z]) {
  const d = Math.hypot(y, z);
  return { joint: "fixed", alpha: d > CLOSE ? Math.atan2(-y, z) : 0, a: x, d, theta: 0 };
}

/** @param {(NamedRow | null)[]} rows @param {"standard" | "modified"} convention @param {{play: (row: number) => void}} options */
export function tableView(rows, convention, { play }) {
  const columns = COLUMNS[convention];
  const caption = t("form-table-caption", { convention: t(`form-convention-${convention}`) });
  return dataTable(
    caption,
    ["i", ...columns.map((name) => columnName(name, convention))],
    rows.map((row, i) => [
      row ? playButton(i, play) : i + 1,
      ...columns.map((name) => (row ? row[name].replaceAll("-", "−").replace(/^q(\d)/, "θ$1") : "·")),
    ]),
    { kind: "solutions" },
  );
}

/** @param {number} i @param {(row: number) => void} play */
function playButton(i, play) {
  const label = t("form-row-play", { row: i + 1 });
  return el("button", {
    type: "button",
    class: "quiet dh-play",
    "aria-label": label,
    title: label,
    onclick: () => play(i),
    text: String(i + 1),
  });
}
