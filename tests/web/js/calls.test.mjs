import assert from "node:assert/strict";
import { test } from "node:test";
import { Latest, Throttled } from "../../../static/js/api.js";

const later = (milliseconds, value) => new Promise((resolve) => setTimeout(() => resolve(value), milliseconds));

test("an answer that was overtaken is dropped, whatever order answers arrive in", async () => {
  const latest = new Latest();
  const slow = latest.run(() => later(30, "first"));
  const quick = latest.run(() => later(5, "second"));
  assert.deepEqual(await Promise.all([slow, quick]), [null, { value: "second" }]);
});

test("a call under way is aborted by the next one, and its failure is nobody's business", async () => {
  const latest = new Latest();
  let aborted = false;
  const first = latest.run(
    (signal) =>
      new Promise((_, reject) =>
        signal.addEventListener("abort", () => ((aborted = true), reject(new Error("aborted")))),
      ),
  );
  await latest.run(async () => 1);
  assert.equal(await first, null);
  assert.ok(aborted);
});

test("the newest call's failure is told", async () => {
  await assert.rejects(
    new Latest().run(async () => Promise.reject(new Error("no"))),
    /no/,
  );
});

test("of calls that come while one is under way only the last is made", async () => {
  const throttled = new Throttled(0);
  const made = [];
  const call = (name) => async () => {
    made.push(name);
    await later(10);
  };
  const running = throttled.run(call("a"));
  throttled.run(call("b"));
  throttled.run(call("c"));
  await running;
  assert.deepEqual(made, ["a", "c"]);
});

test("a failing call does not stop the next one", async () => {
  const throttled = new Throttled(0);
  await assert.rejects(
    throttled.run(async () => Promise.reject(new Error("no"))),
    /no/,
  );
  let ran = false;
  await throttled.run(async () => void (ran = true));
  assert.ok(ran);
});

test("the call that waits is made although the one before it fails", async () => {
  const throttled = new Throttled(0);
  let ran = false;
  const running = throttled.run(() => later(5).then(() => Promise.reject(new Error("no"))));
  throttled.run(async () => void (ran = true));
  await running;
  assert.ok(ran);
});
