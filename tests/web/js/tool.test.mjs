import assert from "node:assert/strict";
import { test } from "node:test";
import "./silent-page.mjs";

/** As much of an element as a tool asks for. */
class Element extends EventTarget {
  classList = { toggle() {} };
  childNodes = [];
  setAttribute() {}
  appendChild(child) {
    this.childNodes.push(child);
  }
  replaceChildren() {
    this.childNodes = [];
  }
}
globalThis.document.createElement = () => new Element();
globalThis.document.createTextNode = (text) => text;
const { Tool } = await import("../../../static/js/playground/tool.js");

test("what a tool draws after it was closed is taken away again", async () => {
  let layer = null;
  let arrive = () => {};
  const answer = async () => {
    await new Promise((done) => (arrive = done));
    layer = "cloud";
    return [];
  };
  const tool = new Tool("workspace", answer, { closed: () => (layer = null) });
  tool.element.open = true;
  tool.take({ table: {}, parameters: {} });
  tool.element.open = false;
  tool.element.dispatchEvent(new Event("toggle"));
  arrive();
  await new Promise((done) => setTimeout(done));
  assert.equal(layer, null);
});
