import assert from "node:assert/strict";
import { test } from "node:test";
import { stepAsked } from "../../../static/js/undo.js";

const pressed = (key, code, more = {}) => stepAsked({ key, code, ctrlKey: true, shiftKey: false, ...more });

test("undo and redo are asked for by the letters on the keys", () => {
  assert.equal(pressed("z", "KeyW"), "undo", "a French keyboard has Z where others have W");
  assert.equal(pressed("y", "KeyZ"), "redo", "a German one Y where others have Z");
  assert.equal(pressed("Z", "KeyZ", { shiftKey: true }), "redo");
  assert.equal(pressed("w", "KeyZ"), null);
  assert.equal(pressed("z", "KeyZ", { ctrlKey: false }), null);
  assert.equal(pressed("z", "KeyZ", { altKey: true }), null);
});

test("on a Cyrillic keyboard the keys of Z and Y ask for them", () => {
  assert.equal(pressed("я", "KeyZ"), "undo");
  assert.equal(pressed("Я", "KeyZ", { shiftKey: true }), "redo");
  assert.equal(pressed("н", "KeyY"), "redo");
  assert.equal(pressed("ф", "KeyA"), null);
});
