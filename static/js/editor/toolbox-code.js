/** Tables as students keep them in programs: one call a link, as in the Robotics Toolbox for MATLAB and for Python. */

import { cleaned } from "./cut.js";

const CALL = /\b(?:Link|(?:Revolute|Prismatic)(?:M?DH)?)\s*\(((?:[^()]|\([^()]*\))*)\)/g;
/** What stands at each place of a link's vector; with sigma = 1 the joint slides. */
const PLACES = ["theta", "d", "a", "alpha", "sigma", "offset"];

/** @param {string} text */
export function isCode(text) {
  return text.search(CALL) >= 0;
}

/**
 * Reads the calls in a text; angles are in radians, and a joint variable is what no value is given for.
 * @param {string} text
 * @returns {import("./paste.js").Pasted | null}
 */
export function readCode(text) {
  const calls = [...text.matchAll(CALL)];
  if (!calls.length) return null;
  const convention = calls.some(([call]) => /^\w*MDH|modified/.test(call)) ? "modified" : "standard";
  return { format: "code", convention, units: { angleUnit: "rad" }, rows: calls.map(readLink) };
}

/** @param {RegExpMatchArray} call @param {number} i */
function readLink([call, told], i) {
  const given = valuesIn(told);
  /** @type {import("./model.js").JointType} */
  const joint = call.startsWith("Prismatic") || given.get("sigma") === "1" ? "prismatic" : "revolute";
  const moved = joint === "prismatic" ? "d" : "theta";
  const offset = given.get("offset") ?? "0";
  const added = offset === "0" ? "" : `${/^[-−–]/.test(offset) ? "" : "+"}${offset}`;
  const cells = { alpha: "0", a: "0", d: "0", theta: "0" };
  for (const [name, value] of given) if (name in cells) cells[/** @type {"a"} */ (name)] = value;
  cells[moved] = `${moved === "d" ? "d" : "θ"}${i + 1}${added}`;
  return { joint, cells };
}

/** @param {string} told what stands between the brackets of a call @returns {Map<string, string>} */
function valuesIn(told) {
  const plain = told.replace(/\b(?:np|numpy|math|sp|sympy)\./g, "");
  const vector = /^\s*\[([^\]]*)\]/.exec(plain);
  const pairs = vector
    ? vector[1]
        .trim()
        .split(/\s*[,;]\s*|\s+/)
        .map((value, k) => [PLACES[k] ?? "", value])
    : [...plain.matchAll(/\b(theta|d|a|alpha|sigma|offset)\b['"]?\s*[,=]\s*([^,]+)/g)].map((found) => found.slice(1));
  return new Map(pairs.map(([name, value]) => [name, cleaned(value)]));
}
