import assert from "node:assert/strict";
import { test } from "node:test";
import "./silent-page.mjs";

/** As much of an element as the bar of a film asks for. */
class Element {
  attributes = new Map();
  setAttribute(name, value) {
    this.attributes.set(name, value);
  }
  removeAttribute(name) {
    this.attributes.delete(name);
  }
  toggleAttribute(name, on) {
    if (on) this.setAttribute(name, "");
    else this.removeAttribute(name);
  }
  addEventListener() {}
  appendChild() {}
  replaceChildren() {}
}
Object.assign(globalThis.document, {
  createElement: () => new Element(),
  createElementNS: () => new Element(),
  getElementById: () => null,
});
globalThis.cancelAnimationFrame = () => {};
const { FilmBar } = await import("../../../static/js/exercise/film-bar.js");

test("a button that leads no further keeps the focus of whoever has just pressed it", () => {
  const scene = { overlay: { items: [] } };
  const bar = new FilmBar(scene, { units: () => ({ angle: "deg", length: "m" }), light: () => {} });
  bar.clear();
  for (const button of bar.rows) {
    assert.equal(button.attributes.has("disabled"), false);
    assert.equal(button.attributes.get("aria-disabled"), "true");
  }
});
