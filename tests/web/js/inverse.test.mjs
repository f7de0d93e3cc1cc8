import assert from "node:assert/strict";
import { test } from "node:test";
import "./silent-page.mjs";

/** As much of an element as the tool and its grid ask for. */
class Element extends EventTarget {
  children = [];
  attributes = new Map();
  dataset = {};
  value = "";
  constructor(tag) {
    super();
    this.tag = tag;
  }
  get rows() {
    return this.children;
  }
  setAttribute(name, value) {
    this.attributes.set(name, value);
  }
  removeAttribute(name) {
    this.attributes.delete(name);
  }
  appendChild(child) {
    this.children.push(child);
  }
  replaceChildren() {
    this.children = [];
  }
  hasChildNodes() {
    return this.children.length > 0;
  }
  get all() {
    return [this, ...this.children.flatMap((child) => child.all ?? [])];
  }
  querySelectorAll() {
    return this.all.filter(({ dataset }) => dataset.name);
  }
  querySelector() {
    return this.all.find(({ attributes }) => attributes.get("role") === "alert") ?? null;
  }
}
Object.assign(globalThis.document, {
  createElement: (tag) => new Element(tag),
  createElementNS: (_, tag) => new Element(tag),
});
const { inverseTool } = await import("../../../static/js/playground/inverse.js");

const subject = (length, limits = null) => ({ table: { a: length }, parameters: {}, joints: [0], limits });
const settled = () => new Promise((done) => setTimeout(done));

/** The tool with its button to solve, what is on its way, and the solutions that others are told of. */
function opened() {
  const asked = [];
  const told = [];
  const post = () => new Promise((answer) => asked.push(answer));
  const tool = inverseTool({ post }, { pose: async () => null, show() {}, shade() {}, found: (all) => told.push(all) });
  const solve = tool.element.all.find(({ attributes }) => attributes.get("class") === "primary");
  const cell = tool.element.all.find(({ dataset }) => dataset.name);
  const press = async () => {
    solve.dispatchEvent(new Event("click"));
    await settled();
  };
  return { tool, asked, told, solve, cell, press };
}

const ANSWER = { solutions: [{ joints: [1], residual: 0 }], status: "some", complete: true };

test("a robot that is changed while it is solved has the button back, and no solutions of the one before", async () => {
  const { tool, asked, told, solve, press } = opened();
  tool.take(subject(1));
  await press();
  assert.ok(solve.attributes.has("aria-disabled"));
  tool.take(subject(2));
  asked[0](ANSWER);
  await settled();
  assert.equal(solve.attributes.has("aria-disabled"), false);
  assert.deepEqual(told.flat(), []);
});

test("solutions go with the target and the limits that they are for, and not with the joints", async () => {
  const { tool, asked, told, cell, press } = opened();
  const changes = [() => cell.dispatchEvent(new Event("input")), () => tool.take(subject(1, [[-90, 90]]))];
  tool.take(subject(1));
  for (const change of changes) {
    await press();
    asked.pop()(ANSWER);
    await settled();
    tool.take({ ...subject(1), joints: [2] });
    assert.deepEqual(told.at(-1), [[1]]);
    change();
    assert.deepEqual(told.at(-1), []);
  }
});
