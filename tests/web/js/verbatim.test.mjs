import assert from "node:assert/strict";
import { test } from "node:test";
import "./silent-page.mjs";

/** As much of an element as fields and their grids ask for. */
class Element {
  children = [];
  attributes = {};
  dataset = {};
  constructor(tag) {
    this.tag = tag;
  }
  get fields() {
    return [this, ...this.children.flatMap((child) => child.fields ?? [])].filter(
      ({ tag, attributes }) => tag === "input" && attributes.type === "text",
    );
  }
  setAttribute(name, value) {
    this.attributes[name] = value;
  }
  removeAttribute() {}
  addEventListener() {}
  appendChild(child) {
    this.children.push(child);
  }
  append(child) {
    this.children.push(child);
  }
  replaceChildren() {
    this.children = [];
  }
  querySelectorAll() {
    return this.fields;
  }
}
Object.assign(globalThis.document, {
  createElement: (tag) => new Element(tag),
  createElementNS: (_, tag) => new Element(tag),
  createTextNode: () => new Element("#text"),
});
globalThis.HTMLElement = class {};
globalThis.customElements = { define() {} };
const { AnswerForm } = await import("../../../static/js/exercise/answer-form.js");
const { MatrixField, NumbersField } = await import("../../../static/js/exercise/part-fields.js");
const { Cells } = await import("../../../static/js/playground/cells.js");
const { JointLimits } = await import("../../../static/js/playground/limits.js");

const form = { name: "rates", label: "", shape: "vector", labels: ["dq1"], rows: 1, options: [] };
const range = { name: "q1", type: "revolute", min: -1, max: 1 };
const limits = new JointLimits(() => {});
limits.show({ types: ["revolute"], ranges: [range], units: { angle: "deg", length: "m" }, limits: null });

const PLACES = {
  "a form's cell": new AnswerForm({ form: [form], numbers: [] }),
  "a matrix": new MatrixField({ from: 0, to: 1 }),
  "a radius": new NumbersField([{ name: "inner", label: "", unit: "m" }]),
  "a grid of the playground": new Cells("", [{ name: "x", label: "x", otherwise: "0" }], { rows: [{ x: "1" }] }),
  "a joint's limit": limits,
};

for (const [name, { element }] of Object.entries(PLACES)) {
  test(`no keyboard corrects ${name}, and any has the minus that it may need`, () => {
    assert.ok(element.fields.length > 0);
    for (const { attributes } of element.fields) {
      assert.deepEqual(
        ["autocorrect", "autocapitalize", "autocomplete", "spellcheck"].map((each) => attributes[each]),
        ["off", "off", "off", "false"],
      );
      assert.equal(attributes.inputmode, undefined);
    }
  });
}
