import assert from "node:assert/strict";
import { test } from "node:test";
import { until } from "./live-page.mjs";

/** As much of an element as the form asks for. */
class Element extends EventTarget {
  children = [];
  value = "";
  textContent = "";
  constructor(tag) {
    super();
    this.tag = tag;
  }
  get all() {
    return [this, ...this.children.flatMap((child) => child.all ?? [])];
  }
  setAttribute() {}
  toggleAttribute() {}
  appendChild(child) {
    this.children.push(child);
  }
  append(child) {
    this.children.push(child);
  }
  replaceChildren() {
    this.children = [];
  }
  querySelector() {
    return new Element("input");
  }
  querySelectorAll() {
    return [];
  }
  submit() {}
}
const place = new Element("div");
Object.assign(globalThis.document, {
  createElement: (tag) => new Element(tag),
  createTextNode: () => new Element("#text"),
  getElementById: (id) => (id === "choose" ? place : null),
  querySelectorAll: () => [],
  addEventListener() {},
});
globalThis.window = globalThis;
globalThis.FormData = class {
  get() {
    return "";
  }
};
globalThis.location = new URL("https://example.org/lti/choose#choice=code");

const sent = [];
let isReached = true;
globalThis.fetch = async (address, { method } = {}) => {
  if (String(address).includes("/locales/")) return new Response("");
  if (method === "POST") {
    sent.push(address);
    return new Promise(() => {});
  }
  return isReached ? Response.json({ exercises: [{ id: "scara", title: "SCARA", parts: [] }] }) : Response.error();
};

test("an exercise that is inserted twice at once makes one link", async () => {
  await import("../../../static/js/pages/choose.js");
  const form = await until(() => place.all.find(({ tag }) => tag === "form"));
  for (let i = 0; i < 2; i += 1) form.dispatchEvent(new Event("submit", { cancelable: true }));
  await until(() => sent.length);
  assert.equal(sent.length, 1);
});

test("where the exercises cannot be had, the page says so and asks again", async () => {
  isReached = false;
  await import("../../../static/js/pages/choose.js?again");
  assert.ok(await until(() => place.all.some(({ textContent }) => textContent === "form-retry")));
});
