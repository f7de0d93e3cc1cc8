import assert from "node:assert/strict";
import { getEventListeners } from "node:events";
import { test } from "node:test";
import { Element } from "./live-page.mjs";

const [page, screen] = [new EventTarget(), new EventTarget()];
class Observer {
  observe() {}
  unobserve() {}
}
Object.assign(globalThis, {
  HTMLElement: class extends Element {},
  IntersectionObserver: Observer,
  ResizeObserver: Observer,
  requestAnimationFrame: () => 0,
  customElements: { define() {} },
  addEventListener: page.addEventListener.bind(page),
  matchMedia: () => screen,
});
globalThis.document.createElementNS = (_, tag) => new Element(tag);
const { RobotScene } = await import("../../../static/js/scene/robot-scene.js");

test("a scene listens to the window and the screen while it is on the page, and once", async () => {
  const listening = () => [getEventListeners(page, "beforeprint").length, getEventListeners(screen, "change").length];
  const scene = new RobotScene();
  const come = () => (globalThis.document.body.append(scene), scene.connectedCallback());
  const go = () => (scene.remove(), scene.disconnectedCallback());
  come();
  assert.deepEqual(listening(), [1, 1]);
  go();
  come();
  await null;
  assert.deepEqual(listening(), [1, 1]);
  go();
  await null;
  assert.deepEqual(listening(), [0, 0]);
  come();
  assert.deepEqual(listening(), [1, 1]);
});
