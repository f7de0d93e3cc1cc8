/**
 * Tables as people paste them: from a spreadsheet, LaTeX, Markdown, a CSV file, the text of a PDF.
 * What a cell means is for the API to say; here text is only cut into cells, and LaTeX spelled out.
 *
 * @typedef {import("./model.js").CellName} CellName
 * @typedef {import("./model.js").JointType} JointType
 * @typedef {{format: string, convention: "standard" | "modified" | null,
 *   rows: {joint: JointType | null, cells: Partial<Record<CellName, string>>}[]}} Pasted
 */

import { CELLS, COLUMNS, inferredJoint, insertRow, MOST_ROWS, newRow, setCell } from "./model.js";

/** Whether a text is more than one cell. @param {string} text */
export function isTable(text) {
  const trimmed = text.trim();
  return (
    /\t/.test(trimmed) ||
    /\n/.test(trimmed) ||
    /\\\\/.test(trimmed) ||
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
    .replace(/\u00a0/g, " ")
    .replace(/[\u200b\ufeff]/g, "");
  if (/&/.test(clean)) return { format: "latex", grid: latexGrid(clean) };
  const lines = clean.split("\n").filter((line) => line.trim() !== "");
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
    .filter((line) => line.includes("|") && !/^[\s|:+-]+$/.test(line.replace(/[–—]/g, "-")))
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
    .replace(/(\S)\s+([-−–])\s+(?=\S)/g, "$1$2")
    .replace(/\(\s+/g, "(")
    .replace(/\s+\)/g, ")")
    .replace(/,\s+(?=[^()]*\))/g, ",")
    .replace(/\s+°/g, "°");
  return joined.split(/\s+/).map(cleaned);
}

const FUNCTIONS = "sin|cos|tan|arcsin|arccos|arctan|sqrt";

/** A piece of LaTeX as a cell would have it. @param {string} cell */
export function fromLatex(cell) {
  let text = cell
    .replace(/\$+|\\[(){}[\]]/g, (found) => (found === "\\{" || found === "\\}" ? found.slice(1) : " "))
    .replace(/\\(?:left|right|displaystyle|textstyle|,|;|:|!|quad|qquad|limits)(?![A-Za-z])/g, " ")
    .replace(/\\(?:mathrm|text|textbf|mathbf|mathit|operatorname|boldsymbol|bm)\s*\{([^{}]*)\}/g, "$1")
    .replace(/\^\s*\{?\s*\\circ\s*\}?|\\degree|\\textdegree/g, "°")
    .replace(/\\(?:cdot|times)(?![A-Za-z])/g, "*")
    .replace(/\\(?:var)?theta(?![A-Za-z])/g, "θ")
    .replace(/\\alpha(?![A-Za-z])/g, "α")
    .replace(/\\pi(?![A-Za-z])/g, "π");
  for (let previous = ""; previous !== text;) {
    previous = text;
    text = text
      .replace(
        /\\[dt]?frac\s*\{([^{}]*)\}\s*\{([^{}]*)\}/g,
        (_, top, bottom) => `${bracketed(top)}/${bracketed(bottom)}`,
      )
      .replace(/\\[dt]?frac\s*(\d)\s*(\d)/g, "$1/$2")
      .replace(/\\sqrt\s*\{([^{}]*)\}/g, "sqrt($1)")
      .replace(/_\s*\{\s*([^{}]*?)\s*\}/g, (_, index) => `_${index.replace(/\s+/g, "")}`)
      .replace(/\^\s*\{\s*([^{}]*?)\s*\}/g, "^($1)");
  }
  return text
    .replace(new RegExp(`\\\\(${FUNCTIONS})`, "g"), "$1")
    .replace(/[{}]/g, " ")
    .replace(/\\ /g, " ");
}

/** @param {string} text */
function bracketed(text) {
  const inner = text.trim();
  return /^[\w.πθα°]+$/u.test(inner) ? inner : `(${inner})`;
}

/** A cell without blanks, emphasis, quotes or a variable's star around it, and with a decimal point. @param {string} cell */
function cleaned(cell) {
  const text = cell
    .trim()
    .replace(/^["'*_`]+|["'*∗⋆★`]+$/g, "")
    .replace(/[◦∘º˚]/g, "°")
    .replace(/\s+/g, " ")
    .trim();
  return /^[+\-−–]?\d+,\d+\s*°?$/.test(text) ? text.replace(",", ".") : text;
}

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
  const { format, grid } = gridOf(text);
  const rows = grid.filter((row) => row.some((cell) => cell !== ""));
  if (rows.length === 0) return null;
  const heading = headingOf(rows[0]);
  const body = heading ? rows.slice(1) : rows;
  if (body.length === 0) return null;
  const columns = numbered(heading?.columns ?? (looksLikeValues(body) ? guessedColumns(body, order) : null), body);
  if (!columns) return null;
  const read = body.map((row) => readRow(row, columns));
  return { format, convention: heading?.convention ?? null, rows: read };
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
 * @returns {{columns: (CellName | "joint" | "index" | null)[], convention: "standard" | "modified" | null} | null}
 */
function headingOf(row) {
  const columns = row.map(meaningOf);
  const found = columns.filter((name) => name !== null && /** @type {string[]} */ (CELLS).includes(name));
  if (new Set(found).size < 3 || found.length !== new Set(found).size) return null;
  if (row.some((/** @type {string} */ cell, /** @type {number} */ i) => columns[i] && /^[θq][_ ]?\d/.test(cell)))
    return null;
  const lengths = row
    .filter((/** @type {any} */ _, /** @type {number} */ i) => columns[i] === "alpha" || columns[i] === "a")
    .join(" ");
  const before = /[ijn]\s*[-−–]\s*1|[ijn]₋₁/i.test(lengths);
  const same = /[_\s]*[ijn]\b|[ᵢⱼₙ]/i.test(lengths.replace(/alpha|alfa|α/gi, ""));
  return { columns, convention: before ? "modified" : same ? "standard" : null };
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
  const holds = (k) => last.some((/** @type {any} */ cells) => /(θ|ϑ|theta|q)_?[{]?[\d₀-₉]/iu.test(cells[k] ?? ""));
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
 * @returns {import("./model.js").Table}
 */
export function withPasted(table, pasted, at, whole, allowed) {
  const anyJoint = pasted.rows.some((row) => row.joint);
  const rows = pasted.rows.map((row, i) => {
    const old = table.rows[at + i];
    const joint = row.joint ?? (anyJoint ? "fixed" : (old?.joint ?? "revolute"));
    const cells = Object.fromEntries(CELLS.map((cell) => [cell, row.cells[cell] ?? old?.[cell] ?? ""]));
    return { ...newRow(0, "fixed"), ...cells, joint };
  });
  const kept = whole ? [] : table.rows.slice(at + rows.length);
  const convention = pasted.convention && allowed.includes(pasted.convention) ? pasted.convention : table.convention;
  return { ...table, convention, rows: [...table.rows.slice(0, at), ...rows, ...kept].slice(0, MOST_ROWS) };
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
