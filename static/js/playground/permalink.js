/** The playground's state in its address: what stands behind # is the whole robot, and nothing is stored elsewhere. */

import { MOST_ROWS } from "../editor/model.js";

/**
 * @typedef {{table: any, parameters: Record<string, number>, joints: number[], limits?: import("../joint-ranges.js").Limits}} Shared
 *   a table as it goes to the API, values of its parameters, joint values [rad or length], limits in the table's units
 */

/** @param {Shared} shared @returns {string} */
export function encode(shared) {
  const bytes = new TextEncoder().encode(JSON.stringify(shared));
  const text = Array.from(bytes, (byte) => String.fromCharCode(byte)).join("");
  return btoa(text).replaceAll("+", "-").replaceAll("/", "_").replace(/=+$/, "");
}

/** What an address's fragment holds, or null if it holds no robot. @param {string} fragment @returns {Shared | null} */
export function decode(fragment) {
  const match = /^#robot=([\w-]+)$/.exec(fragment);
  if (!match) return null;
  try {
    const text = atob(match[1].replaceAll("-", "+").replaceAll("_", "/"));
    return sharedOf(JSON.parse(new TextDecoder().decode(Uint8Array.from(text, (c) => c.charCodeAt(0)))));
  } catch {
    return null;
  }
}

/** @type {Record<string, string[]>} */
const CHOICES = {
  convention: ["standard", "modified"],
  angle_unit: ["rad", "deg"],
  length_unit: ["m", "cm", "mm", "in"],
};
const JOINTS = ["revolute", "prismatic", "fixed"];

/**
 * A robot from data that anybody may have written; null if it is none. What its cells hold is for the API to judge.
 * @param {any} data @returns {Shared | null}
 */
export function sharedOf(data) {
  const rows = data?.table?.rows;
  if (!Array.isArray(rows) || rows.length < 1 || rows.length > MOST_ROWS || !rows.every(isRow)) return null;
  /** @param {string} name */
  const chosen = (name) => data.table[name] ?? CHOICES[name][0];
  const names = Object.keys(CHOICES);
  if (!names.every((name) => CHOICES[name].includes(chosen(name)))) return null;
  const table = { ...Object.fromEntries(names.map((name) => [name, chosen(name)])), rows };
  const values = Object.entries(data.parameters ?? {}).filter(([, value]) => Number.isFinite(value));
  const joints = Array.isArray(data.joints) && data.joints.every(Number.isFinite) ? data.joints : [];
  const limits = Array.isArray(data.limits) && data.limits.every(isLimit) ? { limits: data.limits } : {};
  return { table, parameters: Object.fromEntries(values), joints, ...limits };
}

/** @param {any} pair */
function isLimit(pair) {
  const isEnd = (/** @type {any} */ end) => end === null || Number.isFinite(end);
  return pair === null || (Array.isArray(pair) && pair.length === 2 && pair.every(isEnd));
}

/** @param {any} row */
function isRow(row) {
  /** @param {any} cell */
  const isCell = (cell) => ["string", "number", "undefined"].includes(typeof cell);
  if (typeof row !== "object" || row === null) return false;
  return (row.joint === undefined || JOINTS.includes(row.joint)) && [row.alpha, row.a, row.d, row.theta].every(isCell);
}

/** The page's address with the robot in it. @param {string} address @param {Shared} shared */
export function permalink(address, shared) {
  const url = new URL(address);
  url.hash = `robot=${encode(shared)}`;
  return url.href;
}
