/** Turning, moving and zooming a scene by pointer, wheel and keys. */

import { orbited, panned, zoomed } from "./camera.js";

/** @typedef {import("./camera.js").Camera} Camera */

export const TURN = Math.PI / 24;
export const ZOOM = 1.2;
const DRAG = 0.008;
const CLICK = 5;
const PAN = 24;
const SECONDARY = 2;

/**
 * @param {HTMLElement} view
 * @param {{camera: () => Camera, change: (camera: Camera) => void, reset: () => void, click: (event: PointerEvent) => void,
 *   grab: (event: PointerEvent) => boolean, drag: (event: PointerEvent) => void, drop: (event: PointerEvent) => void}} scene
 *   `grab` says whether something is taken hold of; it is then dragged and dropped instead of the view being turned
 */
export function listenTo(view, { camera, change, reset, click, grab, drag, drop }) {
  view.addEventListener("keydown", (event) => key(event, camera(), change, reset));
  view.addEventListener(
    "wheel",
    (event) => {
      // The page keeps scrolling unless the view was entered or a modifier says that zooming is meant.
      if (document.activeElement !== view && !event.ctrlKey) return;
      event.preventDefault();
      change(zoomed(camera(), Math.exp(-event.deltaY * 0.0015)));
    },
    { passive: false },
  );
  /** @type {Map<number, {x: number, y: number}>} */
  const fingers = new Map();
  let moved = 0;
  let held = -1;
  let before = camera();
  // A finger that holds something does not scroll the page.
  view.addEventListener("touchstart", (event) => held >= 0 && event.preventDefault(), { passive: false });
  view.addEventListener("pointerdown", (event) => {
    if (event.button === SECONDARY) return; // its menu may take the release
    fingers.set(event.pointerId, { x: event.clientX, y: event.clientY });
    if (fingers.size === 1) [moved, before] = [0, camera()];
    if (fingers.size === 1 && event.button === 0 && grab(event)) held = event.pointerId;
    view.setPointerCapture(event.pointerId);
  });
  view.addEventListener("pointermove", (event) => {
    const last = fingers.get(event.pointerId);
    if (!last) return;
    const dx = event.clientX - last.x;
    const dy = event.clientY - last.y;
    moved += Math.abs(dx) + Math.abs(dy);
    const apart = spread(fingers);
    fingers.set(event.pointerId, { x: event.clientX, y: event.clientY });
    if (event.pointerId === held) drag(event);
    else if (fingers.size === 2) {
      const near = apart > 0 ? zoomed(camera(), spread(fingers) / apart) : camera();
      change(panned(near, dx / 2, dy / 2));
    } else if (event.shiftKey || event.buttons === 4) change(panned(camera(), dx, dy));
    else change(orbited(camera(), -dx * DRAG, dy * DRAG));
  });
  const lift = (/** @type {PointerEvent} */ event) => {
    if (!fingers.delete(event.pointerId)) return;
    if (event.pointerId === held) {
      held = -1;
      return drop(event);
    }
    // The finger scrolls the page: the view is as it was before.
    if (event.type === "pointercancel") change(before);
    else if (moved < CLICK) click(event);
  };
  view.addEventListener("pointerup", lift);
  view.addEventListener("pointercancel", lift);
}

/** @param {KeyboardEvent} event @param {Camera} camera @param {(camera: Camera) => void} change @param {() => void} reset */
function key(event, camera, change, reset) {
  if (event.altKey || event.ctrlKey || event.metaKey) return;
  const pan = event.shiftKey ? PAN : 0;
  /** @type {Record<string, () => void>} */
  const keys = {
    ArrowLeft: () => change(pan ? panned(camera, pan, 0) : orbited(camera, -TURN, 0)),
    ArrowRight: () => change(pan ? panned(camera, -pan, 0) : orbited(camera, TURN, 0)),
    ArrowUp: () => change(pan ? panned(camera, 0, pan) : orbited(camera, 0, TURN)),
    ArrowDown: () => change(pan ? panned(camera, 0, -pan) : orbited(camera, 0, -TURN)),
    "+": () => change(zoomed(camera, ZOOM)),
    "=": () => change(zoomed(camera, ZOOM)),
    "-": () => change(zoomed(camera, 1 / ZOOM)),
    0: reset,
    Home: reset,
  };
  const action = keys[event.key];
  if (!action) return;
  event.preventDefault();
  action();
}

/** @param {Map<number, {x: number, y: number}>} fingers */
function spread(fingers) {
  if (fingers.size < 2) return 0;
  const [a, b] = [...fingers.values()];
  return Math.hypot(a.x - b.x, a.y - b.y);
}
