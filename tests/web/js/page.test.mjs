import assert from "node:assert/strict";
import { test } from "node:test";
import "./silent-page.mjs";

const kept = new Map();
globalThis.sessionStorage = {
  getItem: (name) => kept.get(name) ?? null,
  setItem: (name, value) => kept.set(name, value),
  removeItem: (name) => kept.delete(name),
};

/** The settings of a link that the page at an address sends along. */
async function contextAt(address) {
  globalThis.location = new URL(address, "https://example.org/exercises/scara");
  const { api } = await import(`../../../static/js/page.js?${encodeURIComponent(address)}`);
  return api.context;
}

test("the settings of a link hold in the tab until a launch from a course", async () => {
  assert.equal(await contextAt("?context=signed"), "signed");
  assert.equal(await contextAt("?lang=en"), "signed");
  assert.equal(await contextAt("?lang=fr#session=code"), "");
  assert.equal(await contextAt("?lang=es"), "");
});
