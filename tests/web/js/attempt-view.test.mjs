import assert from "node:assert/strict";
import { test } from "node:test";
import { Problem } from "../../../static/js/api.js";
import "./silent-page.mjs";

globalThis.HTMLElement = class {};
globalThis.customElements = { define() {} };
globalThis.matchMedia = () => ({ matches: false });
const { AttemptView } = await import("../../../static/js/lecturer/attempt-view.js");

const settled = () => new Promise((done) => setTimeout(done));

test("an attempt whose answer comes after another one was asked for is not shown", async () => {
  const asked = [];
  const get = (path) => new Promise((answer, refuse) => asked.push({ path, answer, refuse }));
  const card = { hidden: true };
  const view = new AttemptView({ get }, card, {});
  const slow = view.open(1);
  const quick = view.open(2);
  asked[1].refuse(new Problem(404, { code: "attempt_unknown" }));
  await assert.rejects(quick, Problem);
  asked[0].answer({ exercise: "puma560", version: "puma560-1", answer: {}, report: { parts: {} }, person: "ada" });
  await settled();
  asked[2]?.answer({ parts: [] });
  await slow;
  assert.equal(card.hidden, true);
});
