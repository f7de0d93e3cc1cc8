/**
 * Tables as people paste them: which column is which, and how the rows go into the form's table.
 *
 * @typedef {import("./model.js").CellName} CellName
 * @typedef {import("./model.js").JointType} JointType
 * @typedef {{angleUnit?: "deg" | "rad", lengthUnit?: "m" | "cm" | "mm" | "in"}} Units
 * @typedef {{format: string, convention: "standard" | "modified" | null, units: Units,
 *   rows: {joint: JointType | null, cells: Partial<Record<CellName, string>>}[]}} Pasted
 */

import { convertedAngles, convertedLengths, holdsNumbers } from "./convert.js";
import { cleaned, gridOf } from "./cut.js";
import { CELLS, COLUMNS, inferredJoint, insertRow, MOST_ROWS, newRow, setCell } from "./model.js";
import { readCode } from "./toolbox-code.js";

const HEADINGS = /** @type {[CellName | "joint" | "index", RegExp][]} */ ([
  ["alpha", /^(α|alpha|alfa|альфа|twist|al)[ijkn]?(?![a-zа-я])/i],
  ["theta", /^(θ|ϑ|theta|thêta|teta|тета|th)[ijkn]?(?![a-zа-я])/i],
  ["a", /^a[ijkn]?(?![a-zа-я])|^(length|longueur|lungime|comprimento|longitud)/i],
  ["d", /^(d|r)[ijkn]?(?![a-zа-я])|^offset/i],
  ["joint", /^(joint|type|tip|tipo|σ|sigma|articulation|articula|тип|cuplă|cupla|junta|з'єднання)/i],
  ["index", /^(i|j|n|#|№|no\.?|nr\.?|link|row|elo|lien|ланка|eslab[oó]n|element)$/i],
]);

/** What a heading says. @param {string} heading */
function meaningOf(heading) {
  const text = heading.replace(/\s/g, "").replace(/[[(].*$/, "");
  return HEADINGS.find(([, pattern]) => pattern.test(text))?.[0] ?? null;
}

const TYPES = /** @type {[JointType, RegExp][]} */ ([
  [
    "revolute",
    /^(r|rev|revolute|rotational|rotary|rotoid[eă]?|rotați[ae]|rotativ[aăo]?|rota(ç|c)i?[ãa]?o?|rotaci[oó]n|revoluta|обертальн\S*|0)$/i,
  ],
  [
    "prismatic",
    /^(p|t|pris|prismatic|prismati[cq]\S*|sliding|translați[ae]|transla\S*|prismática|призматичн\S*|поступальн\S*|1)$/i,
  ],
  ["fixed", /^(f|fix|fixed|fix[eăoа]\S*|fij[oa]|нерухом\S*|-|–|—|2)$/i],
]);

/** @param {string} text @returns {JointType | null} */
function jointOf(text) {
  return TYPES.find(([, pattern]) => pattern.test(text.trim()))?.[0] ?? null;
}

/**
 * Reads a pasted table.
 * @param {string} text
 * @param {CellName[]} order the columns as the form shows them: what four columns without headings are
 * @returns {Pasted | null} null if there is no table in it
 */
export function readPasted(text, order) {
  const code = readCode(text);
  if (code) return code;
  const { format, grid } = gridOf(text);
  const rows = filledColumns(regrouped(grid.filter((row) => row.some((cell) => cell !== ""))));
  if (rows.length === 0) return null;
  const heading = headingOf(rows[0]);
  const body = heading ? rows.slice(1) : rows;
  if (body.length === 0) return null;
  const columns = numbered(heading?.columns ?? (looksLikeValues(body) ? guessedColumns(body, order) : null), body);
  if (!columns) return null;
  const read = body.map((row) => readRow(row, columns));
  return { format, convention: heading?.convention ?? null, units: heading?.units ?? {}, rows: read };
}

/**
 * The rows of a table of which every cell came on a line of its own, as from many PDF files: its headings, or the numbers
 * of its rows, say how wide it is.
 * @param {string[][]} rows
 */
function regrouped(rows) {
  const cells = rows.flat();
  if (cells.length > rows.length) return rows;
  const meanings = cells.map(meaningOf);
  const headings = meanings.findIndex((meaning, i) => meaning === null || meanings.indexOf(meaning) < i);
  const width = headingOf(cells.slice(0, headings)) ? headings : 5;
  const every = (/** @type {number} */ k) => cells.slice(k * width, (k + 1) * width);
  const cut = Array.from({ length: cells.length / width }, (_, k) => every(k));
  const isTable = width === headings || cut.every(([first], k) => first === String(k + 1));
  return isTable && cut.length > 1 && cells.length % width === 0 ? cut : rows;
}

/** Without columns before and after the four in which nothing stands; beside numbered rows one of the four may be empty. @param {string[][]} rows */
function filledColumns(rows) {
  const width = Math.max(0, ...rows.map((row) => row.length));
  const isEmpty = (/** @type {number} */ i) => rows.every((row) => !row[i]);
  if (width <= 4 || rows.every((row, k) => row[0] === String(k + 1))) return rows;
  return rows.map((row) => row.filter((_, i) => !((i === 0 || i === width - 1) && isEmpty(i))));
}

/** A column of joints that only counts them says nothing of their types. @param {any[] | null} columns @param {string[][]} body */
function numbered(columns, body) {
  /** @param {number} i */
  const counts = (i) =>
    body.every(
      (/** @type {string[]} */ row, /** @type {number} */ k) => (row[i] ?? "").replace(/\.$/, "") === String(k + 1),
    );
  return columns?.map((/** @type {string} */ name, /** @type {number} */ i) =>
    name === "joint" && counts(i) ? "index" : name,
  );
}

/**
 * @param {string[]} row
 * @returns {{columns: (CellName | "joint" | "index" | null)[], convention: "standard" | "modified" | null, units: Units} | null}
 */
function headingOf(row) {
  const khalil = ["d", "r"].every((letter) =>
    row.some((cell) => new RegExp(`^${letter}[_{\\s]*[ijn]?}?(?![a-z])`).test(cell)),
  );
  const columns = row.map(khalil ? meaningForKhalil : meaningOf);
  const found = columns.filter((name) => name !== null && /** @type {string[]} */ (CELLS).includes(name));
  if (new Set(found).size < 3 || found.length !== new Set(found).size) return null;
  if (row.some((/** @type {string} */ cell, /** @type {number} */ i) => columns[i] && /^[θq][_ ]?\d/.test(cell)))
    return null;
  const lengths = row
    .filter((/** @type {any} */ _, /** @type {number} */ i) => columns[i] === "alpha" || columns[i] === "a")
    .join(" ");
  const before = /[ijn]\s*[-−–]\s*1|[ijn]₋₁/i.test(lengths);
  const same = /[_\s]*[ijn]\b|[ᵢⱼₙ]/i.test(lengths.replace(/alpha|alfa|α/gi, ""));
  const convention = khalil || before ? "modified" : same ? "standard" : null;
  return { columns, convention, units: { ...unitIn(row, columns, ANGLES), ...unitIn(row, columns, LENGTHS) } };
}

/** In the notation of Khalil and Kleinfinger d is the length, r the offset, and a the link before. @param {string} heading */
function meaningForKhalil(heading) {
  const meaning = meaningOf(heading);
  if (meaning === "d") return /^d/i.test(heading) ? "a" : "d";
  return meaning === "a" ? null : meaning;
}

const ANGLES = { key: "angleUnit", cells: ["alpha", "theta"], units: { "°": "deg", deg: "deg", rad: "rad" } };
const LENGTHS = { key: "lengthUnit", cells: ["a", "d"], units: { mm: "mm", cm: "cm", m: "m", in: "in" } };

/**
 * The unit that headings name in brackets, if they agree: a (mm), α [deg].
 * @param {string[]} row @param {(string | null)[]} columns
 * @param {{key: string, cells: string[], units: Record<string, string>}} kind
 */
function unitIn(row, columns, { key, cells, units }) {
  const named = row.flatMap((heading, i) => {
    const unit = cells.includes(columns[i] ?? "") && /[[(]\s*(°|deg|rad|mm|cm|m|in)[^[\]()]*[\])]\s*$/.exec(heading);
    return unit && unit[1] in units ? [units[unit[1]]] : [];
  });
  return new Set(named).size === 1 ? { [key]: named[0] } : {};
}

/** Whether rows without headings may be a table at all: most of their cells hold a number, a Greek letter or one letter. @param {string[][]} body */
function looksLikeValues(body) {
  const cells = body.flat();
  const values = cells.filter((/** @type {string} */ cell) => /[\dα-ωΑ-Ω°]|^-?[A-Za-z]$|pi/u.test(cell));
  return values.length * 2 > cells.length;
}

/**
 * What columns without headings are: as the form shows them, unless the joint variables say that they stand the
 * other way round, as the other convention's textbooks print them.
 * @param {string[][]} body @param {any} shown
 */
function guessedColumns(body, shown) {
  const width = Math.max(...body.map((/** @type {string[]} */ row) => row.length));
  const order = [...shown];
  const last = body.map((/** @type {string[]} */ row) =>
    row.filter((/** @type {any} */ _, /** @type {number} */ i) => i >= width - 4),
  );
  /** @param {number} k */
  const holds = (k) => last.some((cells) => inferredJoint({ d: "", theta: cells[k] ?? "" }) === "revolute");
  const turns = order.indexOf("theta");
  if (!holds(turns) && holds(3 - turns)) order.reverse();
  if (width === 4) return order;
  if (width < 4 || width > 6) return null;
  const extra = width - 4;
  const lead = [];
  for (let i = 0; i < extra; i += 1) {
    const column = body.map((/** @type {string[]} */ row) => row[i] ?? "");
    if (
      column.every(
        (/** @type {string} */ cell, /** @type {number} */ k) => cell === String(k + 1) || cell === `${k + 1}.`,
      )
    )
      lead.push("index");
    else if (column.every((/** @type {string} */ cell) => jointOf(cell))) lead.push("joint");
    else break;
  }
  if (lead.length === extra) return [...lead, ...order];
  const tail = body.map((/** @type {string[]} */ row) => row[width - 1] ?? "");
  if (lead.length === extra - 1 && tail.every((/** @type {string} */ cell) => jointOf(cell)))
    return [...lead, ...order, "joint"];
  return null;
}

/** @param {string[]} row @param {any[]} columns */
function readRow(row, columns) {
  /** @type {Partial<Record<CellName, string>>} */
  const cells = {};
  /** @type {JointType | null} */
  let joint = null;
  columns.forEach((/** @type {string} */ name, /** @type {number} */ i) => {
    const text = row[i] ?? "";
    if (name === "joint") joint = jointOf(text);
    else if (name && name !== "index") cells[/** @type {CellName} */ (name)] = text;
  });
  if (!joint) {
    const inferred = inferredJoint({ d: cells.d ?? "", theta: cells.theta ?? "" });
    joint = inferred === "fixed" ? null : inferred;
  }
  return { joint, cells };
}

/**
 * A table with pasted rows in it. Where some pasted rows hold a joint variable, the others are fixed; where
 * none does (a table of numbers only), rows keep the joint type that the form has for them.
 * @param {import("./model.js").Table} table @param {Pasted} pasted @param {number} at first row that is replaced
 * @param {boolean} whole leave nothing of the rows after them
 * @param {("standard" | "modified")[]} allowed conventions that the headings may choose
 * @returns {{table: import("./model.js").Table, left: number | null}} `left`: as in `Converted`; null if nothing was converted
 */
export function withPasted(table, pasted, at, whole, allowed) {
  const anyJoint = pasted.rows.some((row) => row.joint);
  const before = table.rows.slice(0, at);
  const kept = whole ? [] : table.rows.slice(at + pasted.rows.length);
  const fresh = pasted.rows.map(({ cells }) => ({ ...newRow(0, "fixed"), ...cells }));
  const { left, ...read } = inUnitsOf({ ...table, rows: [...before, ...kept] }, pasted.units, fresh);
  const rows = pasted.rows.map((row, i) => {
    const old = table.rows[at + i];
    const joint = row.joint ?? (anyJoint ? "fixed" : (old?.joint ?? "revolute"));
    const missing = CELLS.filter((cell) => row.cells[cell] === undefined);
    const filled = Object.fromEntries(missing.map((cell) => [cell, old?.[cell] ?? ""]));
    return { ...read.table.rows[i], ...filled, joint };
  });
  const convention = pasted.convention && allowed.includes(pasted.convention) ? pasted.convention : table.convention;
  return { table: { ...read.table, convention, rows: [...before, ...rows, ...kept].slice(0, MOST_ROWS) }, left };
}

/**
 * Pasted rows in their own units, or, where rows that stay hold numbers in other ones, in those.
 * @param {import("./model.js").Table} rest the rows that stay @param {Units} units of the pasted rows
 * @param {import("./model.js").Row[]} rows
 */
function inUnitsOf(rest, units, rows) {
  let table = { ...rest, ...units, rows };
  /** @type {number | null} */
  let left = null;
  /** @param {import("./convert.js").Converted} converted */
  const take = (converted) => {
    if (converted.left || JSON.stringify(converted.table.rows) !== JSON.stringify(rows))
      left = (left ?? 0) + converted.left;
    table = converted.table;
  };
  if (table.angleUnit !== rest.angleUnit && holdsNumbers(rest, ANGLES.cells))
    take(convertedAngles(table, rest.angleUnit, { keepsPi: true }));
  if (table.lengthUnit !== rest.lengthUnit && holdsNumbers(rest, LENGTHS.cells))
    take(convertedLengths(table, table.lengthUnit, rest.lengthUnit));
  return { table, left };
}

/**
 * A table with a block of cells pasted into it, as a spreadsheet does: to the right and down from one cell.
 * @param {import("./model.js").Table} table @param {string} text @param {number} row @param {CellName} cell
 * @returns {import("./model.js").Table | null} null if the text is one cell
 */
export function withBlock(table, text, row, cell) {
  const lines = text
    .replace(/\r/g, "")
    .replace(/\n$/, "")
    .split("\n")
    .map((line) => line.split("\t"));
  if (lines.length < 2 && lines[0].length < 2) return null;
  const order = COLUMNS[table.convention];
  let changed = table;
  lines.forEach((line, i) => {
    if (row + i >= changed.rows.length) changed = insertRow(changed, changed.rows.length);
    line.forEach((piece, k) => {
      const name = order[order.indexOf(cell) + k];
      if (name && row + i < changed.rows.length) changed = setCell(changed, row + i, name, cleaned(piece));
    });
  });
  return changed;
}
