/** LaTeX as a cell of the form would have it. */

const FUNCTIONS = "sin|cos|tan|arcsin|arccos|arctan|sqrt";

/** A piece of LaTeX as a cell would have it. @param {string} cell */
export function fromLatex(cell) {
  let text = withQuantities(cell)
    .replace(/(\d)\{([.,])\}(?=\d)/g, "$1$2")
    .replace(/\^\s*(?:\*|\\(?:ast|star)(?![A-Za-z])|\{\s*(?:\*|\\(?:ast|star))\s*\})/g, "*")
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

/** What siunitx writes with commands: \ang{90}, \num{0.2}, \SI{90}{\degree}. @param {string} cell */
function withQuantities(cell) {
  return cell
    .replace(/\\num\s*(?:\[[^\]]*\])?\s*\{([^{}]*)\}/g, "$1")
    .replace(/\\ang\s*(?:\[[^\]]*\])?\s*\{([^{}]*)\}/g, "$1°")
    .replace(/\\(?:SI|qty)\s*(?:\[[^\]]*\])?\s*\{([^{}]*)\}\s*\{([^{}]*)\}/g, (_, value, unit) => value + unitOf(unit));
}

/** @param {string} written */
function unitOf(written) {
  const text = written
    .replace(/\\degree/, "°")
    .replace(/\\radian/, "rad")
    .replace(/\\milli\s*/, "m")
    .replace(/\\centi\s*/, "c")
    .replace(/\\met(?:re|er)/, "m")
    .trim();
  return text === "°" ? text : ` ${text}`;
}
