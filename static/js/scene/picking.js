/** What a click on the picture means: the named item whose projection is nearest. */

import { project } from "./camera.js";
import { placesOf, position } from "./model.js";

const REACH = 14;

/**
 * @param {import("./model.js").Model} model @param {import("./matrix.js").Matrix[]} found poses of its nodes
 * @param {import("./camera.js").Camera} camera @param {number} x [px] @param {number} y [px]
 * @param {number} [reach] [px] how far from the item the point may be
 * @returns {string | null} the item's `pick`
 */
export function pickAt(model, found, camera, x, y, reach = REACH) {
  let best = null;
  for (const item of model.items) {
    if (item.kind === "label" || item.kind === "points" || !item.pick) continue;
    const ends = placesOf(item).map((place) => project(camera, position(found, place)));
    const from = ends[0];
    const to = ends[ends.length - 1];
    const thickness = "radius" in item ? item.radius * camera.scale : 0;
    const distance = Math.max(0, distanceToSegment(x, y, from, to) - thickness);
    const near = Math.max(from.near, to.near);
    if (distance > reach) continue;
    if (!best || distance < best.distance - 2 || (distance < best.distance + 2 && near > best.near)) {
      best = { pick: item.pick, distance, near };
    }
  }
  return best?.pick ?? null;
}

/** @param {number} x @param {number} y @param {{x: number, y: number}} from @param {{x: number, y: number}} to */
function distanceToSegment(x, y, from, to) {
  const dx = to.x - from.x;
  const dy = to.y - from.y;
  const length = dx * dx + dy * dy;
  const along = length > 0 ? Math.max(0, Math.min(1, ((x - from.x) * dx + (y - from.y) * dy) / length)) : 0;
  return Math.hypot(x - from.x - along * dx, y - from.y - along * dy);
}
