/** Another robot in a draft: what is not about the robot stays. */

/**
 * @param {import("./draft-store.js").Draft | null} before
 * @param {import("./draft-store.js").Draft} fresh as the service starts it
 * @param {string[]} begun titles as text that drafts were started with: one that nobody has written over goes
 * @returns {import("./draft-store.js").Draft}
 */
export function withRobot(before, fresh, begun = []) {
  if (!before) return fresh;
  const [old, next] = [before.definition, fresh.definition];
  const same = typesOf(old) !== "" && typesOf(old) === typesOf(next);
  const names = Object.keys(next.parameters ?? {});
  const definition = { ...old };
  for (const key of ["robot", "reference", "parameters", "figure", "parts", "tests"]) {
    if (next[key] === undefined) delete definition[key];
    else definition[key] = next[key];
  }
  if (begun.includes(JSON.stringify(old.title))) definition.title = next.title;
  if (same) {
    definition.parts = old.parts;
    definition.figure = old.figure ? withoutLengths(old.figure, names) : next.figure;
    definition.tests = old.tests;
  }
  if (names.length && old.parameters)
    definition.parameters = Object.fromEntries(
      names.map((name) => [name, keptParameter(old.parameters[name], next.parameters[name])]),
    );
  if (definition.needs)
    definition.needs = definition.needs.filter((/** @type {string} */ name) => names.includes(name));
  return { ...before, definition: inOrder(definition), statements: withNames(before, fresh, old, names) };
}

/** A dimension's draw and aliases stay while its value does. @param {any} old @param {any} next */
function keptParameter(old, next) {
  return old && old.value === next.value ? old : { ...next, ...(old?.aliases ? { aliases: old.aliases } : {}) };
}

/** @param {any} figure @param {string[]} names */
function withoutLengths(figure, names) {
  if (!figure.lengths) return figure;
  const kept = Object.entries(figure.lengths).filter(([name]) => names.includes(name));
  const { lengths: _lengths, ...rest } = figure;
  return kept.length ? { ...rest, lengths: Object.fromEntries(kept) } : rest;
}

/** Statements that nobody has written over name the dimensions of the new robot. @param {any} before @param {any} fresh @param {any} old @param {string[]} names */
function withNames(before, fresh, old, names) {
  const had = Object.keys(old.parameters ?? {});
  const list = (/** @type {string[]} */ all) => (all.length ? ` ${all.map((name) => `*${name}*`).join(", ")}` : "");
  return Object.fromEntries(
    Object.entries(before.statements).map(([language, text]) => {
      const usual = (fresh.statements[language] ?? "").replace(list(names), list(had));
      return [language, text === usual ? fresh.statements[language] : text];
    }),
  );
}

/** @param {any} definition */
function typesOf(definition) {
  return (definition.reference?.rows ?? []).map((/** @type {any} */ row) => row.joint ?? "fixed").join();
}

const ORDER = [
  "version",
  "needs",
  "robot",
  "title",
  "reference",
  "policy",
  "help",
  "weights",
  "access",
  "parameters",
  "parts",
  "figure",
  "remarks",
  "tests",
];

/** @param {Record<string, any>} definition */
function inOrder(definition) {
  const rank = (/** @type {string} */ key) => (ORDER.includes(key) ? ORDER.indexOf(key) : ORDER.length);
  return Object.fromEntries(Object.entries(definition).sort(([a], [b]) => rank(a) - rank(b)));
}
