import assert from "node:assert/strict";
import { test } from "node:test";
import { element } from "./silent-page.mjs";

globalThis.HTMLElement = class {};
globalThis.customElements = { define() {} };
Object.assign(globalThis.document, {
  createElement: (tag) => ({ ...element(), tag, addEventListener() {}, removeAttribute() {}, value: "" }),
  createElementNS: () => ({ ...element(), addEventListener() {} }),
});
const { MatrixField } = await import("../../../static/js/exercise/part-fields.js");
const { MatrixReading } = await import("../../../static/js/exercise/matrix-reading.js");

test("what cells were understood as goes with the last of them, and an answer about older ones is not shown", async (context) => {
  context.mock.timers.enable({ apis: ["setTimeout"] });
  const asked = [];
  const post = () => new Promise((answer) => asked.push(answer));
  const field = new MatrixField({ from: 0, to: 1 });
  const shown = [];
  field.showMeaning = (meanings) => shown.push(meanings.length);
  const reading = new MatrixReading({ post }, [{ field }], () => ({}));
  const type = (text) => {
    field.cells[0][0].input.value = text;
    reading.soon();
  };
  const pause = () => context.mock.timers.tick(1000);
  const settled = async () => {
    for (let i = 0; i < 20; i += 1) await Promise.resolve();
  };
  const answer = { matrices: [[["meaning"]]], faults: [] };
  type("c1");
  pause();
  asked[0](answer);
  await settled();
  assert.deepEqual(shown, [1]);
  type("c12");
  pause();
  type("c12*");
  asked[1](answer);
  await settled();
  assert.deepEqual(shown, [1]);
  type("");
  pause();
  await settled();
  assert.deepEqual(shown, [1, 0]);
});
