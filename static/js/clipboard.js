/** Copying text, and numbers in the notations of programs. */

import { announce, el } from "./dom.js";
import { t } from "./i18n.js";
import { exactly } from "./numbers.js";

/** @param {string} text @returns {Promise<boolean>} */
export async function copyText(text) {
  try {
    await navigator.clipboard.writeText(text);
    return true;
  } catch {
    return copyBySelection(text);
  }
}

/** The old way, for pages in a frame or without a secure connection. @param {string} text */
function copyBySelection(text) {
  const area = el("textarea", { class: "visually-hidden", "aria-hidden": "true", tabindex: "-1" });
  area.value = text;
  const focused = document.activeElement;
  // What is outside an open dialog cannot be marked.
  (document.querySelector("dialog[open]") ?? document.body).append(area);
  area.select();
  try {
    return document.execCommand("copy");
  } finally {
    area.remove();
    if (focused instanceof HTMLElement) focused.focus({ preventScroll: true });
  }
}

/** A matrix of numbers in a notation. @param {number[][]} values @param {"latex" | "python" | "c" | "matlab"} format @param {string} [name] */
export function matrixSource(values, format, name = "T") {
  const rows = values.map((row) => row.map(exactly));
  switch (format) {
    case "latex":
      return `\\begin{bmatrix}\n${rows.map((row) => row.join(" & ")).join(" \\\\\n")}\n\\end{bmatrix}`;
    case "python":
      return `${name} = np.array([\n${rows.map((row) => `    [${row.join(", ")}],`).join("\n")}\n])`;
    case "c":
      return `const double ${name}[4][4] = {\n${rows.map((row) => `    {${row.join(", ")}},`).join("\n")}\n};`;
    default:
      return `${name} = [\n${rows.map((row) => `    ${row.join(", ")}`).join(";\n")}\n];`;
  }
}

/** @typedef {"latex" | "python" | "c" | "matlab"} Format */

/** @type {[Format, string][]} */
const FORMATS = [
  ["latex", "LaTeX"],
  ["python", "Python"],
  ["c", "C"],
  ["matlab", "MATLAB"],
];

/**
 * Buttons that copy something in each notation.
 * @param {string} what what is copied, for screen readers
 * @param {(format: "latex" | "python" | "c" | "matlab") => string | Promise<string>} source
 */
export function copyButtons(what, source) {
  /** @param {any} event @param {Format} format @param {string} label */
  const copy = async (event, format, label) => {
    const button = event.currentTarget;
    const done = await copyText(await source(format));
    announce(t(done ? "form-copied" : "form-copy-failed", { format: label }));
    if (!done) return;
    button.classList.add("done");
    setTimeout(() => button.classList.remove("done"), 1200);
  };
  return el(
    "div",
    { class: "copy-as no-print", role: "group", "aria-label": t("form-copy-group", { what }) },
    el("span", { class: "hint", "aria-hidden": "true", text: t("form-copy") }),
    FORMATS.map(([format, label]) =>
      el("button", { type: "button", class: "quiet small", onclick: (event) => copy(event, format, label) }, label),
    ),
  );
}
