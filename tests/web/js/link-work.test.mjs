import assert from "node:assert/strict";
import { test } from "node:test";
import { Api } from "../../../static/js/api.js";
import "./silent-page.mjs";

/** As much of an element as buttons and answers ask for. */
class Element extends EventTarget {
  children = [];
  textContent = "";
  setAttribute() {}
  appendChild(child) {
    this.children.push(child);
  }
  replaceChildren() {
    this.children = [];
  }
  named(text) {
    if (this.textContent === text) return this;
    return this.children.map((child) => child.named?.(text)).find(Boolean);
  }
}
Object.assign(globalThis.document, {
  createElement: () => new Element(),
  createTextNode: (text) => Object.assign(new Element(), { textContent: text }),
});
const { linkWork } = await import("../../../static/js/lecturer/link-work.js");

const settled = () => new Promise((done) => setTimeout(done));

test("what releases or applies grades is no longer there to be pressed while it is under way", async () => {
  const asked = [];
  const post = async (path) => {
    asked.push(path);
    const change = { key: "ada", number: 1, before: 0, after: 1 };
    return path === "regradings" ? { run: 7, changes: [change], unread: [] } : new Promise(() => {});
  };
  const act = { path: (rest) => rest, changed: async () => {} };
  const view = linkWork({ post }, { released: false }, { mode: "exam", feedback: "at_once" }, act);
  const press = async (text) => {
    view.named(text)?.dispatchEvent(new Event("click"));
    await settled();
  };
  for (const text of ["lecturer-release", "lecturer-release-now", "lecturer-release-now"]) await press(text);
  assert.deepEqual(asked, ["release"]);
  for (const text of ["lecturer-regrade-all", "lecturer-apply", "lecturer-apply"]) await press(text);
  assert.deepEqual(asked, ["release", "regradings", "regradings/7/apply"]);
});

test("an export is asked for with the token, and saved under its name", async () => {
  const saved = [];
  globalThis.document.createElement = (tag) =>
    Object.assign(new Element(), {
      setAttribute: (name, value) => name === "download" && saved.push(value),
      click: () => saved.push(tag),
    });
  globalThis.URL.createObjectURL = () => "blob:";
  const act = { path: (rest) => rest, changed: async () => {} };
  const asked = [];
  globalThis.fetch = async (address, { method, headers }) => {
    asked.push(address, method, headers.Authorization);
    return new Response("a,b");
  };
  const api = new Api("/api/v1/", "en");
  api.token = "secret";
  linkWork(api, { released: true }, { mode: "exam", feedback: "at_once" }, act)
    .named("CSV")
    .dispatchEvent(new Event("click"));
  for (let turn = 0; turn < 50 && saved.length < 2; turn += 1) await settled();
  assert.deepEqual(asked, ["/api/v1/export.csv", "GET", "Bearer secret"]);
  assert.deepEqual(saved, ["attempts.csv", "a"]);
});
