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

test("a page whose texts do not come says so, and runs once they do", async () => {
  const button = new EventTarget();
  const notice = { hidden: true, querySelector: () => button };
  const main = { focused: 0, focus: () => (main.focused += 1) };
  Object.assign(globalThis.document, {
    getElementById: (id) => ({ unloaded: notice, main })[id] ?? null,
    querySelectorAll: () => [],
    addEventListener() {},
  });
  globalThis.window = globalThis;
  globalThis.location = new URL("https://example.org/");
  const answers = [new Response("", { status: 503 }), null, new Response("")];
  globalThis.fetch = async () => answers.shift() ?? Promise.reject(new TypeError("offline"));
  const turns = async () => {
    for (let turn = 0; turn < 20; turn += 1) await new Promise((done) => setTimeout(done));
  };
  const { startPage } = await import("../../../static/js/page.js?without-texts");
  let runs = 0;
  const started = startPage(() => void (runs += 1));
  for (const left of [2, 1]) {
    await turns();
    assert.deepEqual([notice.hidden, answers.length, runs], [false, left, 0]);
    button.dispatchEvent(new Event("click"));
  }
  await started;
  assert.deepEqual([notice.hidden, runs, main.focused], [true, 1, 2]);
});
