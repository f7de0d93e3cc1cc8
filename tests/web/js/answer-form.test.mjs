import assert from "node:assert/strict";
import { test } from "node:test";
import "./silent-page.mjs";

/** As much of an element as a form asks for. */
class Element {
  children = [];
  value = "";
  get lastElementChild() {
    return this.children.at(-1);
  }
  listeners = {};
  setAttribute() {}
  removeAttribute() {}
  addEventListener(name, listener) {
    this.listeners[name] = listener;
  }
  appendChild(child) {
    this.children.push(child);
    child.parent = this;
  }
  append(child) {
    this.appendChild(child);
  }
  remove() {
    this.parent.children.pop();
  }
  replaceChildren() {
    this.children = [];
  }
}
const made = () => new Element();
Object.assign(globalThis.document, { createElement: made, createElementNS: made, createTextNode: made });
globalThis.HTMLElement = class {};
globalThis.customElements = { define() {} };
const { numberOf } = await import("../../../static/js/author/fields.js");
const { MatrixField, SchematicField } = await import("../../../static/js/exercise/part-fields.js");
const { AnswerForm } = await import("../../../static/js/exercise/answer-form.js");

test("an earlier answer of fewer rows takes the place of all that stands in the form", () => {
  const field = { name: "solutions", label: "", shape: "list", labels: ["q1", "q2"], rows: 8, options: [] };
  const form = new AnswerForm({ form: [field], numbers: [] });
  form.state = {
    solutions: [
      ["1", "2"],
      ["3", "4"],
    ],
  };
  form.state = { solutions: [["5", "6"]] };
  assert.deepEqual(form.value, { solutions: [["5", "6"]] });
  assert.equal(form.fields[0].body.children.length, 1);
});

test("what put a whole matrix in is not to be undone once an earlier answer has taken its place", () => {
  const field = new MatrixField({ from: 0, to: 1 });
  const typed = field.cells[0][0].input;
  const paste = { clipboardData: { getData: () => "1 2 3 4\n5 6 7 8\n9 10 11 12" }, preventDefault() {} };
  typed.listeners.paste(paste);
  assert.equal(field.undo.hidden, false);
  const earlier = Array.from({ length: 4 }, () => ["5", "5", "5", "5"]);
  field.state = earlier;
  assert.equal(field.undo.hidden, true);
  assert.deepEqual(field.state, earlier);
});

test("of an earlier answer without a structure nothing of a later one stays", () => {
  const field = new SchematicField(2);
  const blank = field.state;
  field.state = { joints: ["revolute", "prismatic"], relations: ["parallel"] };
  field.state = blank;
  assert.equal(field.touched, false);
});

test("the fields of an author's draft take the numbers that all others take", () => {
  assert.deepEqual(["\u22121,5", "0x10", " ", "l1"].map(numberOf), [-1.5, "0x10", undefined, "l1"]);
});
