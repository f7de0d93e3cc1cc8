import assert from "node:assert/strict";
import { test } from "node:test";
import "./silent-page.mjs";

/** As much of an element as the form asks for. */
class Element extends EventTarget {
  children = [];
  attributes = new Map();
  value = "";
  constructor(tag) {
    super();
    this.tag = tag;
  }
  get all() {
    return [this, ...this.children.flatMap((child) => child.all ?? [])];
  }
  setAttribute(name, value) {
    this.attributes.set(name, value);
  }
  toggleAttribute(name, on) {
    if (on) this.attributes.set(name, "");
    else this.attributes.delete(name);
  }
  appendChild(child) {
    this.children.push(child);
  }
  replaceChildren(...children) {
    this.children = children;
  }
  querySelector(tag) {
    return this.all.find((each) => each.tag === tag);
  }
  querySelectorAll() {
    return [];
  }
}
Object.assign(globalThis.document, {
  createElement: (tag) => new Element(tag),
  createTextNode: () => new Element("#text"),
});
globalThis.FormData = class {
  constructor(form) {
    this.fields = form.all.filter(({ attributes }) => attributes.has("name") && !attributes.has("disabled"));
  }
  get(name) {
    return this.fields.find(({ attributes }) => attributes.get("name") === name)?.value ?? null;
  }
};
const { settingsForm } = await import("../../../static/js/lecturer/settings-form.js");

test("a number that its choice has hidden keeps no rules from being saved, and stays what it was", () => {
  let saved = null;
  const form = settingsForm([], { feedback_after: 3 }, (chosen) => (saved = chosen), "save");
  const field = (name) => form.all.find(({ attributes }) => attributes.get("name") === name);
  const timing = form.all.find(({ tag, children }) => tag === "label" && children.includes(field("feedback")));
  const choose = (value) => {
    field("feedback").value = value;
    timing.dispatchEvent(new Event("change"));
  };
  choose("after_attempts");
  field("feedback_after").value = "0";
  assert.equal(field("feedback_after").attributes.has("disabled"), false);
  choose("at_once");
  assert.ok(field("feedback_after").attributes.has("disabled"));
  form.dispatchEvent(new Event("submit", { cancelable: true }));
  assert.equal(saved.feedback_after, 3);
  choose("after_attempts");
  field("feedback_after").value = "2";
  form.dispatchEvent(new Event("submit", { cancelable: true }));
  assert.equal(saved.feedback_after, 2);
});
