import assert from "node:assert/strict";
import { test } from "node:test";
import { asPoints, pointsTold } from "../../../static/js/numbers.js";

test("points read the same, earned or worked out again from the share of all points", () => {
  for (let total = 1; total <= 100; total += 1) {
    for (let share = 0; share <= 1; share += 0.005) {
      const score = (share * total) / 100;
      assert.equal(asPoints(score * 100), asPoints(share * total), `${share} of ${total}`);
    }
  }
  assert.equal(asPoints(31.15), asPoints(31.150000000000002));
  assert.equal(asPoints(35), "35");
  assert.equal(asPoints(1250), "1250");
});

test("a number in a sentence has the decimal sign of the language", async () => {
  assert.equal((await import("../../../static/js/numbers.js")).inSentence(-0.5), "\u22120.5");
  globalThis.document = { documentElement: { lang: "fr" } };
  const french = await import("../../../static/js/numbers.js?in-french");
  delete globalThis.document;
  assert.equal(french.inSentence(-0.5), "\u22120,5");
  assert.equal(french.shown(-0.5), "\u22120.5");
});

test("points are a number as long as their digits are not grouped", () => {
  assert.equal(pointsTold(17.46), 17.5);
  assert.equal(pointsTold(1250), "1250");
});
