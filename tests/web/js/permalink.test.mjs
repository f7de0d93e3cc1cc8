import assert from "node:assert/strict";
import { test } from "node:test";
import { decode, encode, permalink, sharedOf } from "../../../static/js/playground/permalink.js";

const ROBOT = {
  table: {
    convention: "modified",
    angle_unit: "deg",
    length_unit: "mm",
    rows: [{ joint: "revolute", alpha: 0, a: "L₁", d: "−2", theta: "θ1" }],
  },
  parameters: { L1: 0.5 },
  joints: [0.25],
};

test("a robot survives the way through an address", () => {
  const address = permalink("https://x.example/dh/playground?lang=uk#old", ROBOT);
  assert.ok(address.startsWith("https://x.example/dh/playground?lang=uk#robot="));
  assert.deepEqual(decode(new URL(address).hash), ROBOT);
  assert.match(encode(ROBOT), /^[\w-]+$/);
});

test("what is no robot is none, whoever wrote it", () => {
  const row = ROBOT.table.rows[0];
  const table = (more) => ({ table: { ...ROBOT.table, ...more } });
  const none = [
    null,
    1,
    [],
    {},
    { table: 1 },
    table({ rows: [] }),
    table({ rows: [null] }),
    table({ rows: Array(65).fill(row) }),
    table({ rows: [{ ...row, a: { x: 1 } }] }),
    table({ rows: [{ ...row, joint: "ball" }] }),
    table({ convention: "other" }),
    table({ length_unit: "parsec" }),
  ];
  for (const data of none) assert.equal(sharedOf(data), null, JSON.stringify(data));
  for (const hash of ["", "#robot=", "#robot=%%", "#robot=bm90IGpzb24", "#other=1"]) assert.equal(decode(hash), null);
});

test("what can be used is used", () => {
  const found = sharedOf({ table: { rows: [{ theta: "q1" }] }, parameters: { a: 1, b: "2", c: null }, joints: ["x"] });
  assert.deepEqual(found.parameters, { a: 1 });
  assert.deepEqual(found.joints, []);
  assert.deepEqual([found.table.convention, found.table.angle_unit, found.table.length_unit], ["standard", "rad", "m"]);
});
