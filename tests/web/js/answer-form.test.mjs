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
  setAttribute() {}
  removeAttribute() {}
  addEventListener() {}
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
globalThis.document.createElement = () => new Element();
globalThis.document.createTextNode = () => new Element();
globalThis.HTMLElement = class {};
globalThis.customElements = { define() {} };
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
