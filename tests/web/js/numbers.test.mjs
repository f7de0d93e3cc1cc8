import assert from "node:assert/strict";
import { test } from "node:test";
import { asPoints } from "../../../static/js/numbers.js";

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
