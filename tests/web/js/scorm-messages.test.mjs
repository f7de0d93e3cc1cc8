import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import { runInNewContext } from "node:vm";

const PLAYER = readFileSync(new URL("../../../service/adapters/scorm_package/player.js", import.meta.url), "utf8");
const SERVICE = "https://framewise.example";

/** The package's page with an LMS of a version; hears messages, and keeps what the LMS is told. */
async function page(version, stored) {
  const told = new Map();
  const heard = {};
  const set = (name, value) => (told.set(name, value), "true");
  const get = (name) => (name === "cmi.suspend_data" ? stored : "");
  const api =
    version === "2004"
      ? { Initialize: () => "", GetValue: get, SetValue: set, Commit: () => "", Terminate: () => "" }
      : { LMSInitialize: () => "", LMSGetValue: get, LMSSetValue: set, LMSCommit: () => "", LMSFinish: () => "" };
  const frame = { contentWindow: { postMessage: () => {} } };
  const settings = { url: `${SERVICE}/exercises/x`, version, per_student: false, pass: 0.5, salt: "" };
  const elements = { settings: { textContent: JSON.stringify(settings) }, exercise: frame, "no-lms": {} };
  const window = { addEventListener: (name, listener) => (heard[name] = listener), opener: null };
  window.parent = window;
  window[version === "2004" ? "API_1484_11" : "API"] = api;
  runInNewContext(PLAYER, {
    window,
    document: { getElementById: (id) => elements[id] },
    URL,
    TextEncoder,
    crypto: {},
  });
  await new Promise((resolve) => setImmediate(resolve));
  const hear = (data) => heard.message({ origin: SERVICE, source: frame.contentWindow, data });
  return { told, hear, leave: heard.pagehide };
}

const VALUES = [
  0,
  1,
  -1,
  5,
  10,
  1e308,
  -1e308,
  NaN,
  Infinity,
  null,
  undefined,
  true,
  "",
  "5",
  "x",
  [],
  [10],
  {},
  { table: {} },
  "y".repeat(70000),
  { table: "z".repeat(70000) },
  10n,
  { toString: null },
];
const SUBJECTS = ["framewise.ready", "framewise.draft", "framewise.verdict", "framewise.other", null, {}];

/** Numbers from 0 to 1, the same for the same seed (mulberry32). */
function chance(seed) {
  return () => {
    seed = (seed + 0x6d2b79f5) | 0;
    let t = Math.imul(seed ^ (seed >>> 15), 1 | seed);
    t = (t + Math.imul(t ^ (t >>> 7), 61 | t)) ^ t;
    return ((t ^ (t >>> 14)) >>> 0) / 2 ** 32;
  };
}

test("whatever message comes, the LMS is told scores from 0 to 100 or none", async () => {
  const next = chance(1);
  const pick = (values) => values[Math.floor(next() * values.length)];
  for (let run = 0; run < 300; run++) {
    const version = pick(["1.2", "2004"]);
    const { told, hear, leave } = await page(version, pick(["", "null", "{}", "{", '"x"', "[1]"]));
    for (let n = 0; n < 12; n++) {
      const message = { subject: pick(SUBJECTS) };
      for (const name of ["state", "points", "max_points", "complete", "receipt"]) {
        if (next() < 0.8) message[name] = pick(VALUES);
      }
      hear(pick([message, message, message, message, pick(VALUES)]));
    }
    leave();
    const raw = told.get(version === "2004" ? "cmi.score.raw" : "cmi.core.score.raw");
    if (raw !== undefined) assert.ok(Number(raw) >= 0 && Number(raw) <= 100, `score ${raw}`);
    const kept = told.get("cmi.suspend_data");
    if (kept !== undefined) assert.ok(kept.length <= (version === "2004" ? 64000 : 4096));
    const receipt = told.get(version === "2004" ? "cmi.comments_from_learner.0.comment" : "cmi.comments");
    assert.ok(receipt === undefined || VALUES.includes(receipt));
  }
});

test("a verdict is told as it is", async () => {
  const { told, hear } = await page("2004", "");
  hear({ subject: "framewise.verdict", points: 7, max_points: 10, complete: true, receipt: "r", state: { table: 1 } });
  assert.deepEqual(
    ["cmi.score.raw", "cmi.score.scaled", "cmi.success_status", "cmi.suspend_data"].map((name) => told.get(name)),
    ["70", "0.7", "passed", '{"table":1}'],
  );
});
