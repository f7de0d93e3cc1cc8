import assert from "node:assert/strict";
import { test } from "node:test";
import { element } from "./silent-page.mjs";

const stored = new Map();
const page = new EventTarget();
globalThis.window = Object.assign(page, {
  localStorage: {
    getItem: (key) => stored.get(key) ?? null,
    setItem: (key, text) => void stored.set(key, text),
    removeItem: (key) => void stored.delete(key),
  },
});
const buttons = [];
const shown = [];
const warning = (tag) => ({
  ...element(),
  tag,
  isConnected: true,
  addEventListener: (_, press) => buttons.push(press),
  remove() {
    this.isConnected = false;
  },
});
Object.assign(globalThis.document, {
  createElement: warning,
  querySelector: () => ({ prepend: (notice) => shown.push(notice) }),
  getElementById: () => null,
});
const { watchOtherTabs } = await import("../../../static/js/page.js");
const { DraftStore, KEPT } = await import("../../../static/js/author/draft-store.js");

const draft = (id) => ({ id, definition: {}, statements: {} });

/** What another tab of this browser does. */
function keptElsewhere(work) {
  const event = Object.assign(new Event("storage"), { key: `framewise:${KEPT}`, newValue: JSON.stringify(work) });
  stored.set(event.key, event.newValue);
  page.dispatchEvent(event);
}

test("an author with two tabs is told once, and takes the other draft as a step that can be taken back", () => {
  const store = new DraftStore();
  store.load(draft("mine"), null);
  watchOtherTabs(KEPT, "also open elsewhere", () => store.takeKept());
  keptElsewhere({ draft: draft("hers"), source: null });
  keptElsewhere({ draft: draft("hers-now"), source: null });
  assert.equal(shown.length, 1);
  assert.equal(store.draft.id, "mine");
  buttons[0]();
  assert.equal(store.draft.id, "hers-now");
  store.undo();
  assert.equal(store.draft.id, "mine");
});
