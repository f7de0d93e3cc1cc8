/** The text of a table, from wherever it was copied, cut into cells. What a cell means is for the API to say. */

import { fromLatex } from "./latex.js";

/** Whether a text is more than one cell. @param {string} text */
export function isTable(text) {
  const trimmed = text.trim();
  return (
    /\t/.test(trimmed) ||
    /\n/.test(trimmed) ||
    /\\\\/.test(trimmed) ||
    /^\[[^[\]]*;/.test(trimmed) ||
    (trimmed.match(/\|/g) ?? []).length > 1 ||
    /&/.test(trimmed)
  );
}

/**
 * Cuts a text into rows of cells.
 * @param {string} text
 * @returns {{format: "latex" | "markdown" | "tabs" | "csv" | "text", grid: string[][]}}
 */
export function gridOf(text) {
  const clean = text
    .replace(/\r\n?/g, "\n")
    .replace(/[\u00a0\u2009\u202f]/g, " ")
    .replace(/[\u200b\ufeff]/g, "")
    .replace(/[\u{1d400}-\u{1d7ff}\uff01-\uff5e]/gu, (letter) => letter.normalize("NFKC"));
  if (/&/.test(clean)) return { format: "latex", grid: latexGrid(clean) };
  const lines = withoutBrackets(clean)
    .split("\n")
    .filter((line) => line.trim() !== "" && !isRule(line));
  if (lines.filter((line) => (line.match(/\|/g) ?? []).length > 1).length >= Math.max(1, lines.length / 2)) {
    return { format: "markdown", grid: markdownGrid(lines) };
  }
  if (lines.some((line) => line.includes("\t")))
    return { format: "tabs", grid: lines.map((line) => line.split("\t").map(cleaned)) };
  if (lines.every((line) => line.includes(";")))
    return { format: "csv", grid: lines.map((line) => separated(line, ";")) };
  if (lines.every((line) => (line.match(/,/g) ?? []).length >= 3))
    return { format: "csv", grid: lines.map((line) => separated(line, ",")) };
  return { format: "text", grid: wideGrid(lines) ?? lines.map(textCells) };
}

/** The lines of a nested list or a matrix as programs write it: [[0, 0], [1, 0]], {{0, 0}, {1, 0}}, [0 0; 1 0]. @param {string} text */
function withoutBrackets(text) {
  const trimmed = text.trim().replace(/[;,]$/, "");
  if (!/^[[{][^]*[\]}]$/.test(trimmed)) return text;
  const lines = trimmed.replace(/[\]}]\s*[;,]?\s*[[{]/g, "\n").replace(/[[\]{}]/g, " ");
  return lines.trim().includes("\n") ? lines.replace(/[;,]\s*$/gm, "") : lines.replaceAll(";", "\n");
}

/** Whether a line only rules a table off, in Markdown, in plain text or drawn with crosses. @param {string} line */
function isRule(line) {
  return /[-=–—]{2}/.test(line) && /^[\s|:+=–—-]+$/.test(line);
}

/** @param {string} text */
function latexGrid(text) {
  const inner =
    /\\begin\{(?:tabular|array|matrix|[bp]matrix|tabularx|longtable)\*?\}(?:\[[^\]]*\])?(?:\{(?:[^{}]|\{[^{}]*\})*\})*([\s\S]*?)\\end\{/.exec(
      text,
    );
  return (inner ? inner[1] : text)
    .replace(/(?<!\\)%.*$/gm, "")
    .replace(/\\(?:hline|toprule|midrule|bottomrule|centering|cline\{[^}]*\}|rule\{[^}]*\}\{[^}]*\})/g, "")
    .split(/\\\\(?:\[[^\]]*\])?|\\tabularnewline/)
    .filter((line) => line.includes("&"))
    .map((line) => line.split(/(?<!\\)&/).map((cell) => cleaned(fromLatex(cell))));
}

/** @param {string[]} lines */
function markdownGrid(lines) {
  return lines
    .filter((line) => line.includes("|") && !/^[\s|:+-]+$/.test(line))
    .map((line) =>
      line
        .trim()
        .replace(/^\|/, "")
        .replace(/\|$/, "")
        .split("|")
        .map((cell) => cleaned(fromLatex(cell))),
    );
}

/** @param {string} line @param {string} separator */
function separated(line, separator) {
  const cells = [];
  let cell = "";
  let quoted = false;
  let depth = 0;
  for (const character of line) {
    if (character === '"') quoted = !quoted;
    else if (character === separator && !quoted && depth === 0) {
      cells.push(cell);
      cell = "";
      continue;
    } else {
      depth += character === "(" ? 1 : character === ")" ? -1 : 0;
      cell += character;
    }
  }
  return [...cells, cell].map(cleaned);
}

/** Cells parted by several blanks each, if every line has as many; blanks inside a cell are single. @param {string[]} lines */
function wideGrid(lines) {
  const grid = lines.map((line) =>
    line
      .trim()
      .split(/\s{2,}/)
      .map((cell) => cleaned(cell.replace(/^([+\-−–])\s+/, "$1"))),
  );
  return grid[0].length >= 4 && grid.every((row) => row.length === grid[0].length) ? grid : null;
}

/** Cells parted by blanks; a sign with blanks on both sides joins, one before a number parts. @param {string} line */
function textCells(line) {
  const joined = line
    .trim()
    .replace(/\s+([+*/^·×])\s+/g, "$1")
    .replace(/(?<!\S)([\d.,]+°?)\s+([-−–])\s+(?=\S)/g, "$1 $2") // nobody subtracts from a number: the next cell begins
    .replace(/(\S)\s+([-−–])\s+(?=\S)/g, "$1$2")
    .replace(/\(\s+/g, "(")
    .replace(/\s+\)/g, ")")
    .replace(/,\s+(?=[^()]*\))/g, ",")
    .replace(/\s+°/g, "°");
  return joined.split(/\s+/).map(cleaned);
}

/** A cell without blanks, emphasis, quotes or a variable's star around it, and with a decimal point. @param {string} cell */
export function cleaned(cell) {
  const text = cell
    .trim()
    .replace(/^["'*_`]+|["'*∗⋆★`]+$/g, "")
    .replace(/[◦∘º˚]/g, "°")
    .replace(/\s+/g, " ")
    .trim();
  return /^[+\-−–]?\d+,\d+(?:e[+\-−–]?\d+)?\s*°?$/i.test(text) ? text.replace(",", ".") : text;
}
