/**
 * The table as it is typed: plain data and pure functions, with undo. Nothing here knows the page.
 *
 * @typedef {"standard" | "modified"} Convention
 * @typedef {"revolute" | "prismatic" | "fixed"} JointType
 * @typedef {"alpha" | "a" | "d" | "theta"} CellName
 * @typedef {{key: number, joint: JointType, alpha: string, a: string, d: string, theta: string}} Row
 *   `key` stays with a row wherever it moves
 * @typedef {{convention: Convention, angleUnit: "deg" | "rad", lengthUnit: "m" | "cm" | "mm" | "in", rows: Row[]}} Table
 */

/** Columns in the order in which each convention's textbooks print them. @type {Record<Convention, CellName[]>} */
export const COLUMNS = {
  modified: ["alpha", "a", "d", "theta"],
  standard: ["theta", "d", "a", "alpha"],
};

/** How each column is written. @type {Record<CellName, string>} */
export const LETTERS = { alpha: "α", a: "a", d: "d", theta: "θ" };

/** @type {CellName[]} */
export const CELLS = ["alpha", "a", "d", "theta"];

export const MOST_ROWS = 64;

const VARIABLE = /(?<![A-Za-z0-9_Α-ω])(θ|ϑ|[Tt]heta|q|Q|d)(_?)(\d+|[₀-₉]+)(?![A-Za-z0-9_])/gu;

let lastKey = 0;

/** A row with nothing typed but its variable. @param {number} number @param {JointType} [joint] @returns {Row} */
export function newRow(number, joint = "revolute") {
  lastKey += 1;
  const row = { key: lastKey, joint, alpha: "", a: "", d: "", theta: "" };
  return withVariable(row, number);
}

/** A table of so many revolute rows. @param {Convention} convention @param {number} rows @param {Partial<Table>} [units] @returns {Table} */
export function newTable(convention, rows, units = {}) {
  return {
    convention,
    angleUnit: "deg",
    lengthUnit: "m",
    ...units,
    rows: Array.from({ length: rows }, (_, i) => newRow(i + 1)),
  };
}

/** Number of the joint that each row has or would have. @param {Row[]} rows */
export function jointNumbers(rows) {
  let joint = 0;
  return rows.map((row) => (row.joint === "fixed" ? joint + 1 : (joint += 1)));
}

/** The cell that holds a row's variable. @param {JointType} joint @returns {CellName | null} */
export function variableCell(joint) {
  return joint === "revolute" ? "theta" : joint === "prismatic" ? "d" : null;
}

/** How a row's variable is written into an empty cell. @param {JointType} joint @param {number} number */
export function variableName(joint, number) {
  return joint === "prismatic" ? `d${number}` : `θ${number}`;
}

/** Whether a cell holds nothing but a variable. @param {string} text */
export function isBareVariable(text) {
  const match = [...text.trim().matchAll(VARIABLE)];
  return match.length === 1 && match[0][0] === text.trim();
}

/** @param {Row} row @param {number} number */
function withVariable(row, number) {
  const cell = variableCell(row.joint);
  return cell && row[cell].trim() === "" ? { ...row, [cell]: variableName(row.joint, number) } : row;
}

/** @param {Table} table @param {number} index @param {CellName} cell @param {string} text @returns {Table} */
export function setCell(table, index, cell, text) {
  return withRow(table, index, (/** @type {Row} */ row) => ({ ...row, [cell]: text }));
}

/**
 * Another joint type: a bare variable moves to its new cell, anything else that was typed stays.
 * @param {Table} table @param {number} index @param {JointType} joint @returns {Table}
 */
export function setJoint(table, index, joint) {
  const before = table.rows[index];
  const left = variableCell(before.joint);
  const changed = withRow(table, index, (/** @type {Row} */ row) => {
    const cleared = left && isBareVariable(row[left]) ? { ...row, [left]: "" } : row;
    return { ...cleared, joint };
  });
  const renumbered = renumber(table.rows, changed.rows);
  const numbers = jointNumbers(renumbered);
  return { ...changed, rows: renumbered.map((row, i) => (i === index ? withVariable(row, numbers[i]) : row)) };
}

/** @param {Table} table @param {number} at @returns {Table} */
export function insertRow(table, at) {
  if (table.rows.length >= MOST_ROWS) return table;
  const rows = [...table.rows.slice(0, at), { ...newRow(0, "revolute"), theta: "" }, ...table.rows.slice(at)];
  const renumbered = renumber(table.rows, rows);
  const numbers = jointNumbers(renumbered);
  return { ...table, rows: renumbered.map((row, i) => (i === at ? withVariable(row, numbers[i]) : row)) };
}

/** @param {Table} table @param {number} index @returns {Table} */
export function removeRow(table, index) {
  if (table.rows.length <= 1) return table;
  return {
    ...table,
    rows: renumber(
      table.rows,
      table.rows.filter((_, i) => i !== index),
    ),
  };
}

/** @param {Table} table @param {number} index @param {number} to @returns {Table} */
export function moveRow(table, index, to) {
  if (to < 0 || to >= table.rows.length || to === index) return table;
  const rows = [...table.rows];
  const [row] = rows.splice(index, 1);
  rows.splice(to, 0, row);
  return { ...table, rows: renumber(table.rows, rows) };
}

/**
 * Rows in a new order, each with its own variable's number brought up to date. Variables may be numbered by
 * joint or by row; whichever the table did, it goes on doing.
 * @param {Row[]} before @param {Row[]} after
 */
function renumber(before, after) {
  const jointsBefore = jointNumbers(before);
  const jointsAfter = jointNumbers(after);
  const byRow = before.some((row, i) => {
    const cell = variableCell(row.joint);
    return cell && jointsBefore[i] !== i + 1 && numbersIn(row[cell]).includes(i + 1);
  });
  return after.map((row, i) => {
    const was = before.findIndex((candidate) => candidate.key === row.key);
    const cell = variableCell(row.joint);
    if (was < 0 || !cell) return row;
    const from = byRow ? was + 1 : jointsBefore[was];
    const to = byRow ? i + 1 : jointsAfter[i];
    return from === to ? row : { ...row, [cell]: withNumber(row[cell], from, to) };
  });
}

const DIGITS = "₀₁₂₃₄₅₆₇₈₉";

/** @param {string} digits */
function numberOf(digits) {
  return Number([...digits].map((digit) => (DIGITS.includes(digit) ? DIGITS.indexOf(digit) : digit)).join(""));
}

/** @param {string} text */
function numbersIn(text) {
  return [...text.matchAll(VARIABLE)].map((match) => numberOf(match[3]));
}

/** @param {string} text @param {number} from @param {number} to */
function withNumber(text, from, to) {
  return text.replace(
    VARIABLE,
    (
      /** @type {string} */ whole,
      /** @type {string} */ name,
      /** @type {string} */ joiner,
      /** @type {string} */ digits,
    ) => {
      if (numberOf(digits) !== from) return whole;
      const written = DIGITS.includes(digits[0]) ? String(to).replace(/\d/g, (digit) => DIGITS[Number(digit)]) : to;
      return `${name}${joiner}${written}`;
    },
  );
}

/** @param {Table} table @param {number} index @param {(row: Row) => Row} change */
function withRow(table, index, change) {
  return {
    ...table,
    rows: table.rows.map((/** @type {Row} */ row, /** @type {number} */ i) => (i === index ? change(row) : row)),
  };
}

/** Cells in which nothing stands yet. @param {Table} table @returns {{row: number, cell: CellName}[]} */
export function emptyCells(table) {
  return table.rows.flatMap((row, i) =>
    COLUMNS[table.convention].filter((cell) => row[cell].trim() === "").map((cell) => ({ row: i, cell })),
  );
}

/**
 * The table as it goes to the API.
 * @param {Table} table @param {{decimalComma?: boolean}} [options] whether a comma between digits is a decimal point
 */
export function toWire(table, { decimalComma = false } = {}) {
  const written = decimalComma ? withPoint : (/** @type {string} */ text) => text;
  return {
    convention: table.convention,
    angle_unit: table.angleUnit,
    length_unit: table.lengthUnit,
    rows: table.rows.map(({ joint, alpha, a, d, theta }) => ({
      joint,
      alpha: written(alpha),
      a: written(a),
      d: written(d),
      theta: written(theta),
    })),
  };
}

/**
 * A cell with decimal points for decimal commas; the comma of atan2(1, 2) separates, and stays. As long as before, so
 * that what is said of a character is said of the same one.
 * @param {string} text
 */
export function withPoint(text) {
  return /tan2\s*\(/.test(text) ? text : text.replace(/(?<=\d),(?=\d)/g, ".");
}

/** A table of the API as something to edit. @param {any} wire @returns {Table} */
export function fromWire(wire) {
  return {
    convention: wire.convention,
    angleUnit: wire.angle_unit ?? "rad",
    lengthUnit: wire.length_unit ?? "m",
    rows: wire.rows.map((/** @type {Row} */ row) => {
      lastKey += 1;
      /** @param {CellName} cell */
      const text = (cell) => (row[cell] === undefined || row[cell] === null ? "" : String(row[cell]));
      const cells = { alpha: text("alpha"), a: text("a"), d: text("d"), theta: text("theta") };
      return { key: lastKey, joint: row.joint ?? inferredJoint(cells), ...cells };
    }),
  };
}

/** What may stand between a letter and its index: \theta_{1}, {{\theta }_{1}}, theta[1], θ<sub>1</sub>, θ*₁. */
const TO_INDEX = String.raw`(?:[\s_{}[\](),;]|<sub>|\^?\{?(?:\*|\\ast\s*)\}?(?=[_₀-₉]))*[\d₀-₉]`;
const TURNING = new RegExp(`(?:[θϑѲѳӨө𝜃]|[Tt]heta|THETA|[qQ])${TO_INDEX}`, "u");
const SLIDING = new RegExp(`(?:^|[^A-Za-z])[qQd]${TO_INDEX}`, "u");

/** What a row's cells say of its joint. @param {{d: string, theta: string}} cells @returns {JointType} */
export function inferredJoint({ d, theta }) {
  if (TURNING.test(theta)) return "revolute";
  return SLIDING.test(d) ? "prismatic" : "fixed";
}
