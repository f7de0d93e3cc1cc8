import assert from "node:assert/strict";
import { test } from "node:test";
import { asPoints, fractionIn, numberIn, pointsTold } from "../../../static/js/numbers.js";

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

test("dates are written in the order of the texts' English, day before month, and in 24 hours", async () => {
  const options = { dateStyle: "medium", timeStyle: "short", timeZone: "UTC" };
  const written = async (lang, query) => {
    globalThis.document = { documentElement: { lang } };
    const { dates } = await import(`../../../static/js/i18n.js?${query}`);
    return dates(options).format(new Date("2026-11-22T16:00:00Z"));
  };
  assert.equal(await written("en", "dates-en"), "22 Nov 2026, 16:00");
  assert.equal(await written("fr", "dates-fr"), "22 nov. 2026, 16:00");
});

test("a pose's numbers may be roots and fractions, as books print them", () => {
  const root = Math.SQRT1_2;
  for (const text of ["√2/2", "sqrt(2)/2", " 1 / √2", "0,5√2", "0.5*sqrt(2)", "√0.5"])
    assert.ok(Math.abs((fractionIn(text) ?? 0) - root) < 1e-15, text);
  assert.equal(fractionIn("1/2"), 0.5);
  assert.equal(fractionIn("\u2212√(9)/4"), -0.75);
  assert.equal(fractionIn("-1.5e-3"), -0.0015);
  for (const text of ["", "x", "1/", "/2", "1/0", "1/2/3", "√", "√-1", "2 3", "√2√3"])
    assert.equal(fractionIn(text), null, text);
});

test("a number from a PDF or a text program may have another minus and what nobody sees", () => {
  for (const text of [
    "\u22122.5",
    "\u20132.5",
    "\u20112,5",
    "\uff0d2.5",
    "\u200b-2.5\u200e",
    "\ufeff\u22122.5",
    "\u2011\u00ad2.5",
  ])
    assert.equal(numberIn(text), -2.5, JSON.stringify(text));
  assert.equal(numberIn("1.5e\u22123"), 0.0015);
  for (const text of ["2\u20133", "\u2013", "\u200b"]) assert.equal(numberIn(text), null, JSON.stringify(text));
});

test("a number has decimal digits", () => {
  for (const text of ["0x10", "0b11", "0o7", "-0x1", "Infinity", "1e999", ".", "e5"])
    assert.equal(numberIn(text), null, text);
  for (const text of ["10", "+10.", "1e1", "010"]) assert.equal(numberIn(text), 10, text);
  assert.equal(numberIn(",5"), 0.5);
  assert.equal(fractionIn("0x10/2"), null);
});
