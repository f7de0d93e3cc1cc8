/**
 * Matrices as people write them: LaTeX, MATLAB, Python, a spreadsheet's cells, blanks between numbers. What a cell
 * means is for the API to say; here text is only cut into cells, and text that is no matrix is left alone.
 */

import { fromLatex } from "../editor/latex.js";

const LAST = ["0", "0", "0", "1"];

/**
 * Rows of a homogeneous matrix, 4×4; of three rows the last one is added.
 * @param {string} text
 * @returns {string[][] | null} null if there is no such matrix in it
 */
export function readMatrix(text) {
  const rows = blockOf(text);
  if (!rows || rows.some((row) => row.length !== 4)) return null;
  if (rows.length === 3) return [...rows, LAST];
  return rows.length === 4 ? rows : null;
}

/**
 * Any block of cells, for pasting to the right and down from one cell.
 * @param {string} text
 * @returns {string[][] | null} null if the text is one cell, prose, or rows of different lengths
 */
export function blockOf(text) {
  const clean = text
    .replace(/\r\n?/g, "\n")
    .replace(/\u00a0/g, " ")
    .trim();
  const rows = (/\\\\|&/.test(clean) ? latexRows(clean) : plainRows(clean)).filter((row) => row.length > 0);
  if (rows.length === 0 || (rows.length === 1 && rows[0].length < 2)) return null;
  if (rows.some((row) => row.length !== rows[0].length || row.length > 4) || rows.length > 4) return null;
  return rows.flat().every(isEntry) ? rows : null;
}

/** @param {string} text */
function latexRows(text) {
  const inner =
    /\\begin\{[a-zA-Z]*matrix\*?\}([\s\S]*?)\\end\{/.exec(text) ??
    /\\begin\{array\}\{[^}]*\}([\s\S]*?)\\end\{/.exec(text);
  return (inner ? inner[1] : text)
    .split(/\\\\(?:\[[^\]]*\])?/)
    .filter((row) => row.includes("&"))
    .map((row) => row.split("&").map((cell) => called(fromLatex(cell).replace(/\s+/g, " ").trim())));
}

/** A cell with its functions' arguments in parentheses, which LaTeX leaves out: cos θ_1. @param {string} cell */
function called(cell) {
  return cell.replace(/(sin|cos|tan)\s*([θϑq]_?\d+)/gu, "$1($2)");
}

/** Python, MATLAB, TSV or blanks. @param {string} text */
function plainRows(text) {
  const bare = text
    .replace(/^[A-Za-z_]\w*\s*=\s*/, "")
    .replace(/^(?:np\.|numpy\.|sp\.|sympy\.)?(?:array|matrix|Matrix)\s*\(/, "")
    .replace(/\)?\s*;?\s*$/, (end) => (text.includes("(") && end.includes(")") && unbalanced(text) ? ")" : ""));
  const nested = /\]\s*,?\s*\[/.test(bare);
  const lines = nested ? bare.split(/\]\s*,?\s*\[/) : bare.replace(/^\s*[[{]|[\]}]\s*$/g, "").split(/;\s*\n?|\n/);
  return lines.map((line) =>
    cellsOf(
      line
        .replace(/[[\]{}]/g, " ")
        .replace(/,\s*$/, "")
        .trim(),
    ),
  );
}

/** @param {string} text */
function unbalanced(text) {
  return (text.match(/\(/g) ?? []).length < (text.match(/\)/g) ?? []).length;
}

/** Cells of a line, parted by tabs, else by commas outside parentheses, else by blanks outside parentheses. @param {string} line */
function cellsOf(line) {
  if (line === "") return [];
  if (line.includes("\t")) return line.split("\t").map((cell) => cell.trim());
  const commas = split(line, /,/);
  if (commas.length > 1 && !hasDecimalCommas(line)) return commas;
  const joined = line.replace(/\s*([*/^·])\s*/g, "$1").replace(/(\S)\s+([+\-−])\s+(?=\S)/g, "$1$2");
  return split(joined, /\s/);
}

/** Whether blanks part the cells, and every comma stands between digits: 0,5 0 -0,866 1. @param {string} line */
function hasDecimalCommas(line) {
  return /\S\s+\S/.test(line) && !/(^|\D),|,(\D|$)/.test(line);
}

/** @param {string} line @param {RegExp} separator */
function split(line, separator) {
  const cells = [""];
  let depth = 0;
  for (const character of line) {
    depth += character === "(" ? 1 : character === ")" ? -1 : 0;
    if (depth === 0 && separator.test(character)) cells.push("");
    else cells[cells.length - 1] += character;
  }
  return cells.map((cell) => cell.trim()).filter((cell) => cell !== "");
}

/** Whether a text can be an entry: a number, or a formula of short names without words beside each other. @param {string} cell */
function isEntry(cell) {
  if (cell === "" || /[.!?:;"]$/.test(cell)) return false;
  const words = cell.match(/\p{L}{2,}/gu) ?? [];
  return (
    words.every((word) =>
      /^(sin|cos|tan|asin|acos|atan|arcsin|arccos|arctan|sqrt|pi|abs|theta|alpha|[a-zA-Z]{1,3}|(?:sin|cos|tan)?[θαβγφψ].*)$/u.test(
        word,
      ),
    ) && !/\p{L}{2,}\s+\p{L}{2,}/u.test(cell)
  );
}
