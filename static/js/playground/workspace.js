/** How far the robot reaches. Slides need a least and a greatest value; where nobody knows them, they are asked for. */

import { el, fill, uniqueId } from "../dom.js";
import { t } from "../i18n.js";
import { plain } from "../numbers.js";
import { cellValue } from "./cells.js";
import { asked, Tool } from "./tool.js";
import { named, numbers } from "./values.js";

/** @param {import("../api.js").Api} api */
export function workspaceTool(api) {
  const slides = new Slides(() => tool.refresh());
  /** Where the joints stand makes no difference: what was found is shown until the robot or a range changes. */
  let found = { asked: "", nodes: /** @type {Node[]} */ ([]) };
  const tool = new Tool(
    t("playground-workspace"),
    async (subject) => {
      slides.show(subject);
      const limits = slides.limits(subject);
      if (!limits) return [el("p", { class: "hint", text: t("playground-slide-needed") })];
      const request = { ...asked(subject), limits };
      if (JSON.stringify(request) === found.asked) return found.nodes;
      const answer = await api.post("workspace", request);
      const unit = answer.length_unit;
      const nodes = [
        named([
          [t("playground-inner-axis"), numbers([answer.inner_radius.axis], unit)],
          [t("playground-outer-axis"), numbers([answer.outer_radius.axis], unit)],
          [t("playground-inner-origin"), numbers([answer.inner_radius.origin], unit)],
          [t("playground-outer-origin"), numbers([answer.outer_radius.origin], unit)],
        ]),
      ];
      found = { asked: JSON.stringify(request), nodes };
      return nodes;
    },
    { controls: [slides.element] },
  );
  return tool;
}

/** Fields for the ranges of slides, which start with those of their sliders. */
class Slides {
  element = el("div", { class: "slides", hidden: true });
  /** @type {Map<number, {least: HTMLInputElement, greatest: HTMLInputElement}>} */
  #fields = new Map();

  shown = "";

  /** @param {() => void} changed */
  constructor(changed) {
    this.changed = changed;
  }

  /** @param {import("./tool.js").Subject} subject */
  show({ ranges, limits, units }) {
    const open = ranges
      .map((range, i) => ({ ...range, i }))
      .filter(({ type, i }) => type === "prismatic" && !limits?.[i]);
    const shown = JSON.stringify([open, units.length]);
    if (shown === this.shown) return;
    this.shown = shown;
    this.#fields.clear();
    this.element.hidden = open.length === 0;
    fill(
      this.element,
      open.map((joint) => this.#line(joint, units.length)),
    );
  }

  /** The limits of every joint; null if a field holds no number. @param {import("./tool.js").Subject} subject */
  limits({ types, limits }) {
    const all = types.map((_, i) => {
      const field = this.#fields.get(i);
      return field
        ? [cellValue(field.least.value.trim()), cellValue(field.greatest.value.trim())]
        : (limits?.[i] ?? null);
    });
    return all.flat().every((value) => value === null || typeof value === "number") ? all : null;
  }

  /** @param {any} options @param {string} unit */
  #line({ name, min, max, i }, unit) {
    /** @param {string} id @param {string} label @param {any} value */
    const field = (id, label, value) =>
      el("input", {
        id,
        type: "text",
        inputmode: "decimal",
        autocomplete: "off",
        value: plain(value, 3),
        "aria-label": t(label, { name, unit }),
        oninput: () => this.changed(),
      });
    const id = uniqueId("slide");
    const least = /** @type {HTMLInputElement} */ (field(id, "playground-slide-least", min));
    const greatest = /** @type {HTMLInputElement} */ (field(`${id}-greatest`, "playground-slide-greatest", max));
    this.#fields.set(i, { least, greatest });
    return el(
      "div",
      { class: "row" },
      el("label", { for: id, text: t("playground-slide", { name }) }),
      least,
      "–",
      greatest,
      el("span", { class: "hint", text: unit }),
    );
  }
}
