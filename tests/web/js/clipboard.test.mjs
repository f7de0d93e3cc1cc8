import assert from "node:assert/strict";
import { test } from "node:test";
import "./silent-page.mjs";

globalThis.HTMLElement = class {};
const { copyText } = await import("../../../static/js/clipboard.js");

test("without the browser's clipboard, as without TLS, text in a dialog is copied from inside the dialog", async () => {
  let holder = null;
  const place = (name) => ({ append: () => (holder = name) });
  Object.assign(globalThis.document, {
    body: place("page"),
    querySelector: () => place("dialog"),
    createElement: () => ({ setAttribute() {}, select() {}, remove() {} }),
    execCommand: () => holder === "dialog", // the page outside of it is inert
  });
  assert.equal(await copyText("a receipt"), true);
  globalThis.document.querySelector = () => null;
  assert.equal(await copyText("a matrix"), false);
  assert.equal(holder, "page");
});
