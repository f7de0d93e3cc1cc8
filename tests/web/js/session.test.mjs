import assert from "node:assert/strict";
import { mock, test } from "node:test";
import { Problem } from "../../../static/js/api.js";
import "./silent-page.mjs";

const { CourseSession } = await import("../../../static/js/session/course-session.js");

const START = Date.parse("2030-01-01T12:00:00Z");
const TOLD = {
  link: { id: 1 },
  person: { key: "someone", name: "Ada" },
  course: { title: "Robotics" },
  attempts: [],
  attempts_made: 0,
  attempts_allowed: null,
  counting: "best",
  penalty: 0,
  opens: null,
  closes: null,
  grade: null,
  refusal: null,
  return_url: null,
  draft: null,
  version: null,
  seed: null,
  now: new Date(START).toISOString(),
};

/** Time that the test moves, and what is under way settled. */
function clockOf(context) {
  context.mock.timers.enable({ apis: ["setTimeout", "Date"], now: START });
  return async (seconds) => {
    context.mock.timers.tick(1000 * seconds);
    for (let i = 0; i < 20; i += 1) await Promise.resolve();
  };
}

test("a draft that is slow on its way never comes after a later one", async (context) => {
  const wait = clockOf(context);
  const sent = [];
  const put = (path, state) => new Promise((done) => sent.push({ state, done }));
  const session = new CourseSession({ put }, TOLD);
  session.draft("first");
  await wait(2);
  session.draft("second");
  await wait(2);
  assert.deepEqual(
    sent.map(({ state }) => state),
    ["first"],
  );
  sent[0].done({});
  await wait(0);
  await wait(1);
  assert.deepEqual(
    sent.map(({ state }) => state),
    ["first", "second"],
  );
});

test("a draft that could not be stored is stored once the service answers, though nobody types again", async (context) => {
  const wait = clockOf(context);
  const errors = [new Error("offline"), new Problem(503, {}, "", 5), new Problem(413, { code: "body_too_large" })];
  const sent = [];
  const put = async (path, state) => {
    sent.push(state);
    if (errors.length) throw errors.shift();
  };
  const session = new CourseSession({ put }, TOLD);
  session.draft("typed");
  await wait(2);
  assert.equal(sent.length, 1);
  await wait(3);
  await wait(2);
  assert.equal(sent.length, 2);
  await wait(4);
  assert.equal(sent.length, 2, "not before the service asked for it");
  await wait(4);
  await wait(2);
  assert.equal(sent.length, 3);
  await wait(200);
  await wait(200);
  assert.equal(sent.length, 3, "what is refused for good is not sent again");
});

test("the service's clock goes on where its answer after a hand-in is lost", async (context) => {
  const wait = clockOf(context);
  const api = {
    post: async () => ({}),
    put: mock.fn(() => new Promise(() => {})),
    get: async () => {
      throw new Error("offline");
    },
  };
  const session = new CourseSession(api, { ...TOLD, link: { id: 2 } });
  await wait(3600);
  await session.submit({}, {});
  session.draft({ typed: "last" });
  session.told = {
    ...TOLD,
    link: { id: 2 },
    now: new Date(START + 3_600_000).toISOString(),
    draft: { state: { typed: "before" }, at: new Date(START + 1_800_000).toISOString() },
  };
  assert.deepEqual(session.latest({ typed: "last" }).state, { typed: "last" });
});

test("an attempt that is slow to reopen gives way to another one, and to what is typed or handed in", async (context) => {
  clockOf(context);
  const asked = new Map();
  const get = (path) => (path === "session" ? { ...TOLD } : new Promise((answer) => asked.set(path, answer)));
  const session = new CourseSession(
    { get: async (path) => get(path), put: async () => ({}), post: async () => ({}) },
    TOLD,
  );
  const reopen = (number) => session.reopen(number, async (attempt) => attempt.number);
  const answer = async (number) => {
    for (let i = 0; i < 20; i += 1) await Promise.resolve();
    asked.get(`session/attempts/${number}`)({ number });
  };
  const first = reopen(1);
  const second = reopen(2);
  await answer(2);
  await answer(1);
  assert.deepEqual([await first, await second], [null, 2]);
  for (const act of [() => session.draft({ typed: "meanwhile" }), () => session.submit({}, {})]) {
    const late = reopen(3);
    act();
    await answer(3);
    assert.equal(await late, null);
  }
});
