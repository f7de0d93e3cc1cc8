import assert from "node:assert/strict";
import { test } from "node:test";
import { Api, Latest, pauseAfter, Problem, Throttled } from "../../../static/js/api.js";

globalThis.document = { documentElement: {} };
const { LiveRobot } = await import("../../../static/js/live-robot.js");
delete globalThis.document;

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

test("pauses are never shorter than the service asked for, grow, end, and differ from page to page", (context) => {
  const chance = context.mock.method(Math, "random", () => 0);
  const pauses = Array.from({ length: 12 }, (_, i) => pauseAfter(i + 1));
  assert.ok(pauses.every((pause, i) => i === 0 || pause >= pauses[i - 1]));
  assert.ok(pauses[3] > pauses[0]);
  assert.equal(pauses[11], pauses[10]);
  assert.equal(pauseAfter(1, 45), 45_000);
  chance.mock.mockImplementation(() => 0.9);
  assert.ok(pauseAfter(1, 45) > 45_000);
});

/** A robot whose service fails with an error, and how often it has been asked. */
function failing(context, error) {
  context.mock.timers.enable({ apis: ["setTimeout", "Date"], now: 1_000_000 });
  context.mock.method(Math, "random", () => 0);
  const asked = { times: 0, faults: 0 };
  const post = async () => {
    asked.times += 1;
    throw error;
  };
  const robot = new LiveRobot({ post });
  robot.addEventListener("reading", () => (asked.faults += 1));
  /** Lets time pass, and what waits for it happen. */
  const pass = async (milliseconds) => {
    context.mock.timers.tick(milliseconds);
    for (let turn = 0; turn < 20; turn += 1) await Promise.resolve();
  };
  return { robot, asked, pass };
}

for (const status of [429, 503])
  test(`a robot leaves the service alone for as long as it asks: ${status}`, async (context) => {
    const { robot, asked, pass } = failing(context, new Problem(status, {}, "", 30));
    robot.take({ rows: [] }, { now: true });
    await pass(0);
    assert.equal(asked.times, 1);
    await pass(15_000);
    robot.take({ rows: [1] }, { now: true });
    await pass(14_000);
    assert.deepEqual(asked, { times: 1, faults: 0 });
    await pass(2_000);
    assert.deepEqual(asked, { times: 2, faults: 0 });
  });

test("a refusal by something before the service is no fault of the table", async (context) => {
  const { robot, asked, pass } = failing(context, new Problem(413, {}));
  let failures = 0;
  robot.addEventListener("failure", () => (failures += 1));
  robot.take({ rows: [] }, { now: true });
  await pass(0);
  assert.deepEqual([asked.faults, failures], [0, 1]);
});

test("a robot whose service is away asks less and less often, and at once what is typed", async (context) => {
  const { robot, asked, pass } = failing(context, new Error("unreachable"));
  robot.take({ rows: [] }, { now: true });
  for (let second = 0; second < 60; second += 1) await pass(1000);
  assert.ok(asked.times > 2 && asked.times < 8, asked.times);
  const { times } = asked;
  robot.take({ rows: [1] }, { now: true });
  await pass(0);
  assert.equal(asked.times, times + 1);
});

test("what is typed while a service is away does not put off when it is asked again", async (context) => {
  const { robot, asked, pass } = failing(context, new Error("unreachable"));
  for (let typed = 0; typed < 8; typed += 1) {
    robot.take({ rows: [typed] }, { now: true });
    await pass(0);
  }
  const { times } = asked;
  await pass(5000);
  assert.equal(asked.times, times + 1);
});

test("an answer is sent again not sooner than the service asked for", async (context) => {
  context.mock.timers.enable({ apis: ["setTimeout"] });
  context.mock.method(Math, "random", () => 0.5);
  let sent = 0;
  context.mock.method(globalThis, "fetch", async () => {
    sent += 1;
    const status = sent === 1 ? 503 : 200;
    return new Response("{}", { status, headers: { "Retry-After": "2" } });
  });
  const answer = new Api("http://127.0.0.1/", "en").post("a", {}, { patience: 1 });
  const turns = async () => {
    for (let turn = 0; turn < 20; turn += 1) await new Promise((resolve) => setImmediate(resolve));
  };
  await turns();
  context.mock.timers.tick(2_400);
  await turns();
  assert.equal(sent, 1);
  context.mock.timers.tick(200);
  assert.deepEqual(await answer, {});
});
