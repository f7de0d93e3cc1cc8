/** Elements in one expression; nothing here knows what they are for. */

/**
 * @typedef {import("../../types/dom").Properties} Properties attributes by name; `onclick` and the like are
 *   listeners, `class`, `text`, `hidden` and `dataset` mean what they say; null, undefined and false leave an
 *   attribute out.
 * @typedef {import("../../types/dom").Child} Child
 */

const SVG = "http://www.w3.org/2000/svg";
const MATHML = "http://www.w3.org/1998/Math/MathML";

/**
 * An HTML element with its properties and children.
 * @template {keyof HTMLElementTagNameMap} Tag
 * @param {Tag} tag
 * @param {Properties} [properties]
 * @param {...Child} children
 * @returns {HTMLElementTagNameMap[Tag]}
 */
export function el(tag, properties = {}, ...children) {
  return build(document.createElement(tag), properties, children);
}

/** The same for SVG. @param {keyof SVGElementTagNameMap} tag @param {Properties} [properties] @param {...Child} children */
export function svg(tag, properties = {}, ...children) {
  return build(document.createElementNS(SVG, tag), properties, children);
}

/** The same for MathML. @param {string} tag @param {Properties} [properties] @param {...Child} children */
export function math(tag, properties = {}, ...children) {
  return build(document.createElementNS(MATHML, tag), properties, children);
}

/**
 * @template {Element} Built
 * @param {Built} element @param {Properties} properties @param {Child[]} children @returns {Built}
 */
function build(element, properties, children) {
  for (const [name, value] of Object.entries(properties)) set(element, name, value);
  append(element, children);
  return element;
}

/** @param {Element} element @param {string} name @param {unknown} value */
function set(element, name, value) {
  if (value === null || value === undefined || value === false) return;
  if (name.startsWith("on")) element.addEventListener(name.slice(2), /** @type {EventListener} */ (value));
  else if (name === "dataset") Object.assign(/** @type {HTMLElement} */ (element).dataset, value);
  else if (name === "text") element.textContent = String(value);
  else if (name === "value" && "value" in element) element.value = value;
  else element.setAttribute(name, value === true ? "" : String(value));
}

/** @param {Node} parent @param {Child[]} children */
export function append(parent, children) {
  for (const child of children) {
    if (Array.isArray(child)) append(parent, child);
    else if (child !== null && child !== undefined && child !== false) {
      parent.appendChild(typeof child === "object" ? child : document.createTextNode(String(child)));
    }
  }
}

/** Has an element hold these children, in this order, without moving the one that has the focus. @param {Element} parent @param {Element[]} children */
export function arrange(parent, children) {
  for (const child of [...parent.children]) if (!children.includes(child)) child.remove();
  children.forEach((child, i) => {
    while (parent.children[i] !== child) {
      if (child.isConnected && child.contains(document.activeElement)) parent.append(parent.children[i]);
      else parent.insertBefore(child, parent.children[i] ?? null);
    }
  });
}

/** Replaces what an element holds. @param {Element} parent @param {...Child} children */
export function fill(parent, ...children) {
  parent.replaceChildren();
  append(parent, children);
}

/**
 * Of fields for what is no prose: a phone's keyboard corrects nothing, and begins with no capital. It is the one for
 * texts: an iPhone's keyboard for decimals has no minus.
 */
export const VERBATIM = { autocomplete: "off", autocapitalize: "off", autocorrect: "off", spellcheck: "false" };

const STROKES = {
  up: "M12 19V5m-6 6 6-6 6 6",
  down: "M12 5v14m6-6-6 6-6-6",
  remove: "M6 6l12 12M18 6 6 18",
  add: "M12 5v14M5 12h14",
  undo: "M8 5 4 9l4 4M4 9h10a6 6 0 0 1 0 12h-3",
  redo: "m16 5 4 4-4 4m4-4H10a6 6 0 0 0 0 12h3",
  paste: "M9 4h6v3H9zM9 5H6v15h12V5h-3M9 12h6M9 16h4",
  copy: "M9 9h11v11H9zM5 15H4V4h11v1",
  home: "M4 4v6h6M4.500 10a8 8 0 1 1-.5 4",
  play: "M8 5v14l11-7z",
  pause: "M8 5v14M16 5v14",
  check: "m5 13 4.500 4.500L19 7",
  cross: "M7 7l10 10M17 7 7 17",
  less: "M5 12h14",
  turn: "M5 14a7 7 0 0 1 14 0m-3.5-2.5L19 14.500l3-3.500",
  tilt: "M10 5a7 7 0 0 1 0 14m2.500-3.500L9.500 19l3.500 3",
  enlarge: "M4 9V4h5M20 9V4h-5M4 15v5h5M20 15v5h-5",
  picture: "M4 7h4l2-2h4l2 2h4v12H4zM12 16a3 3 0 1 0 0-6 3 3 0 0 0 0 6",
  back: "M16 5v14L7 12zM5 5v14",
  forward: "M8 5v14l9-7zM19 5v14",
};

/** A small line drawing, hidden from screen readers. @param {keyof typeof STROKES} name */
export function icon(name) {
  return svg(
    "svg",
    { viewBox: "0 0 24 24", width: 20, height: 20, "aria-hidden": "true", focusable: "false" },
    svg("path", { d: STROKES[name] }),
  );
}

/**
 * A button that shows a drawing and is read as a label.
 * @param {keyof typeof STROKES} name @param {string} label @param {(event: Event) => void} onclick
 * @param {Properties} [properties]
 */
export function iconButton(name, label, onclick, properties = {}) {
  return el(
    "button",
    { type: "button", class: "icon quiet", "aria-label": label, title: label, onclick, ...properties },
    icon(name),
  );
}

/** Whether there is something for a button to do; one that has the focus keeps it. @param {HTMLElement} button @param {boolean} able */
export function setAble(button, able) {
  if (able) button.removeAttribute("aria-disabled");
  else button.setAttribute("aria-disabled", "true");
}

/** Whether what stands in a field can be taken. @param {Element} field @param {boolean} valid */
export function setValid(field, valid) {
  if (valid) field.removeAttribute("aria-invalid");
  else field.setAttribute("aria-invalid", "true");
}

/** A fault's message below a field. @param {string} [id] */
export function faultLine(id) {
  return el("div", { class: "fault", id, hidden: true });
}

/** Says what is wrong with a field in the line below it; an empty text: nothing. @param {Element} field @param {HTMLElement} line @param {string} text */
export function setFault(field, line, text) {
  line.textContent = text;
  line.hidden = !text;
  setValid(field, !text);
}

/**
 * Radio buttons drawn as one control.
 * @param {{name: string, label: string, value: string, options: {value: string, label: string}[],
 *   onchange: (value: string) => void}} choice
 */
export function segmented({ name, label, value, options, onchange }) {
  return el(
    "fieldset",
    { class: "segmented" },
    el("legend", { class: "visually-hidden", text: label }),
    options.map((option) =>
      el(
        "label",
        {},
        el("input", {
          type: "radio",
          name,
          value: option.value,
          checked: option.value === value,
          onchange: () => onchange(option.value),
        }),
        option.label,
      ),
    ),
  );
}

let counter = 0;

/** An id that no other element has. @param {string} stem */
export function uniqueId(stem) {
  counter += 1;
  return `${stem}-${counter}`;
}

/**
 * Shows a dialog, unless one is open: whoever presses a button again while its dialog is on its way wants one.
 * @param {HTMLDialogElement} dialog @param {HTMLElement} [parent]
 */
export function showDialog(dialog, parent = document.body) {
  if (document.querySelector("dialog[open]")) return;
  parent.append(dialog);
  dialog.showModal();
}

/** Says something to screen readers without moving the focus. @param {string} text */
export function announce(text) {
  const announcer = document.getElementById("announcer");
  if (!announcer) return;
  announcer.textContent = "";
  requestAnimationFrame(() => (announcer.textContent = text));
}

/**
 * A function that runs once its calls have paused.
 * @template {unknown[]} Arguments
 * @param {(...values: Arguments) => void} action @param {number} milliseconds
 */
export function debounced(action, milliseconds) {
  let timer = 0;
  return (/** @type {Arguments} */ ...values) => {
    clearTimeout(timer);
    timer = setTimeout(() => action(...values), milliseconds);
  };
}

/** A name with its digits as an index. @param {string} name */
export function variable(name) {
  const match = /^([A-Za-z]+)_?(\d*)$/.exec(name);
  return el("var", {}, match ? match[1] : name, match?.[2] ? el("sub", { text: match[2] }) : null);
}
