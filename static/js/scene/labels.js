/** Names in the picture. Where names of the same axis fall onto each other they become one: z₁,₂. */

import { el } from "../dom.js";
import { project } from "./camera.js";
import { position } from "./model.js";

const CLOSE = 13;

/** @param {any} item */
export function labelElement(item) {
  const sub = item.sub ? el("sub", { text: item.sub }) : null;
  return el("span", { class: `scene-label tone-${item.tone}` }, item.text, sub);
}

/**
 * @param {{element: HTMLElement, item: any}[]} labels @param {import("./matrix.js").Matrix[]} found
 * @param {import("./camera.js").Camera} camera
 */
export function placeLabels(labels, found, camera) {
  /** @type {{x: number, y: number, text: string, subs: string[], element: HTMLElement}[]} */
  const placed = [];
  for (const { element, item } of labels) {
    const { x, y } = project(camera, position(found, item.at));
    const same =
      "xyz".includes(item.tone) &&
      placed.find((other) => other.text === item.text && Math.hypot(other.x - x, other.y - y) < CLOSE);
    element.hidden = Boolean(same);
    if (same) same.subs.push(item.sub);
    else placed.push({ x, y, text: item.text, subs: item.sub ? [item.sub] : [], element });
  }
  for (const { x, y, subs, element } of placed) {
    element.style.transform = `translate(-50%, -50%) translate(${x.toFixed(1)}px, ${y.toFixed(1)}px)`;
    const sub = element.lastElementChild;
    const text = subs.join(",");
    if (sub && sub.textContent !== text) sub.textContent = text;
  }
}
