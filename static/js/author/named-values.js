/** Values of the names in a table or chain that somebody types: those of the draft; the others get one, to be changed later. */

import { convertedValues } from "../units.js";

/** What a dimension without a value is, in each unit: a usual link, a turn that nobody takes for a right angle. @type {Record<string, number>} */
const USUAL = { m: 0.3, cm: 30, mm: 300, in: 12, deg: 30, rad: 0.5 };

/**
 * @param {{name: string, kind: "angle" | "length"}[]} names that need a value
 * @param {{angle_unit?: string, length_unit?: string}} source the table or chain that they stand in
 * @param {any} definition of the draft, or nothing
 * @returns {Record<string, number>} values in the units of the source; a name of the draft means what it meant there
 */
export function namedValues(names, source, definition) {
  const units = unitsOf(source);
  const old = definition?.reference ? unitsOf(definition.reference) : units;
  const kinds = Object.fromEntries(names.map(({ name, kind }) => [name, kind]));
  const known = Object.entries(definition?.parameters ?? {}).flatMap(([name, parameter]) =>
    name in kinds && typeof parameter?.value === "number" ? [[name, parameter.value]] : [],
  );
  return {
    ...Object.fromEntries(names.map(({ name, kind }) => [name, USUAL[units[kind]]])),
    ...convertedValues(Object.fromEntries(known), (name) => kinds[name], old, units),
  };
}

/** Units as the API takes them when nothing is said. @param {{angle_unit?: string, length_unit?: string}} written */
function unitsOf({ angle_unit = "rad", length_unit = "m" }) {
  return { angle: angle_unit, length: length_unit };
}

/** The kinds of an SCM chain's names: what turns stands under a, b, c. @param {any} chain @param {string[]} names */
export function kindsInChain(chain, names) {
  const entries = [...chain.joints, chain.final].flatMap((row) => Object.entries(row));
  /** @param {string} name */
  const turns = (name) => entries.some(([key, cell]) => "abc".includes(key) && wordsOf(String(cell)).includes(name));
  return names.map((name) => ({ name, kind: /** @type {"angle" | "length"} */ (turns(name) ? "angle" : "length") }));
}

/** @param {string} text */
function wordsOf(text) {
  return Array.from(text.replaceAll("_", "").matchAll(/\p{L}[\p{L}\d]*/gu), ([word]) => word);
}
