import assert from "node:assert/strict";
import { test } from "node:test";
import { Problem } from "../../../static/js/api.js";

const made = [];
globalThis.document = {
  documentElement: { lang: "en" },
  createElement: () => {
    made.push({ setAttribute() {}, appendChild() {}, textContent: "" });
    return made.at(-1);
  },
};
const { problemNotice, telling } = await import("../../../static/js/problem.js");

/** What is said of an error. @param {unknown} error */
function saidOf(error) {
  made.length = 0;
  problemNotice(error);
  return made.map(({ textContent }) => textContent).filter(Boolean);
}

test("what something before the service refuses has a sentence, whatever the status", () => {
  for (const status of [403, 413, 502]) assert.deepEqual(saidOf(new Problem(status, {})), ["form-unreachable"], status);
  assert.deepEqual(saidOf(new Problem(413, { code: "body_too_large", detail: "Too large." })), ["Too large."]);
});

test("work that is under way is not begun anew, and may be afterwards", async () => {
  const place = { replaceChildren() {} };
  let begun = 0;
  /** @type {(value?: unknown) => void} */
  let go = () => {};
  const press = telling(place, async () => {
    begun += 1;
    await new Promise((resolve) => (go = resolve));
  });
  const first = press();
  await press();
  assert.equal(begun, 1);
  go();
  await first;
  const second = press();
  assert.equal(begun, 2);
  go();
  await second;
});
