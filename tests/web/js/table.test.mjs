import assert from "node:assert/strict";
import { test } from "node:test";
import * as convert from "../../../static/js/editor/convert.js";
import * as model from "../../../static/js/editor/model.js";
import { UndoHistory } from "../../../static/js/undo.js";
import { convertedValues } from "../../../static/js/units.js";

const texts = (table, cell) => table.rows.map((row) => row[cell]);

test("a new table holds the variables of revolute joints and nothing else", () => {
  const table = model.newTable("modified", 3);
  assert.deepEqual(texts(table, "theta"), ["θ1", "θ2", "θ3"]);
  assert.equal(model.emptyCells(table).length, 9);
});

test("columns stand in the order of each convention's textbooks", () => {
  assert.deepEqual(model.COLUMNS.modified, ["alpha", "a", "d", "theta"]);
  assert.deepEqual(model.COLUMNS.standard, ["theta", "d", "a", "alpha"]);
});

test("a change of joint type moves a bare variable and keeps what was typed", () => {
  let table = model.setCell(model.newTable("standard", 2), 1, "alpha", "90");
  table = model.setJoint(table, 1, "prismatic");
  assert.equal(table.rows[1].d, "d2");
  assert.equal(table.rows[1].theta, "");
  assert.equal(table.rows[1].alpha, "90");
  table = model.setCell(table, 1, "d", "d2 + L1");
  table = model.setJoint(table, 1, "revolute");
  assert.equal(table.rows[1].d, "d2 + L1", "an expression is never thrown away");
  assert.equal(table.rows[1].theta, "θ2");
});

test("moved and removed rows keep their own variable, under its new number", () => {
  let table = model.newTable("modified", 3);
  table = model.setCell(table, 2, "theta", "θ₃ - pi/2");
  table = model.setCell(table, 0, "d", "d3");
  table = model.moveRow(table, 2, 0);
  assert.deepEqual(texts(table, "theta"), ["θ₁ - pi/2", "θ2", "θ3"]);
  assert.equal(table.rows[1].d, "d3", "a parameter is not a variable");
  table = model.removeRow(table, 0);
  assert.deepEqual(texts(table, "theta"), ["θ1", "θ2"]);
});

test("a fixed row does not count as a joint", () => {
  let table = model.setJoint(model.newTable("modified", 3), 1, "fixed");
  assert.deepEqual(texts(table, "theta"), ["θ1", "", "θ2"]);
  assert.deepEqual(model.jointNumbers(table.rows), [1, 2, 2]);
  table = model.setJoint(table, 1, "prismatic");
  assert.equal(table.rows[1].d, "d2");
  assert.equal(table.rows[2].theta, "θ3");
});

test("a table numbered by row goes on being numbered by row", () => {
  const rows = ["θ1", "0", "θ3"].map((theta, i) => ({
    key: 900 + i,
    joint: i === 1 ? "fixed" : "revolute",
    alpha: "0",
    a: "0",
    d: "0",
    theta,
  }));
  const table = model.moveRow({ ...model.newTable("modified", 1), rows }, 1, 0);
  assert.deepEqual(texts(table, "theta"), ["0", "θ2", "θ3"]);
});

test("the last row stays, and rows stay within the limit", () => {
  const one = model.newTable("modified", 1);
  assert.equal(model.removeRow(one, 0), one);
  const full = model.newTable("modified", model.MOST_ROWS);
  assert.equal(model.insertRow(full, 3), full);
});

test("a table survives the way to the API and back", () => {
  const wire = model.toWire(model.setCell(model.newTable("standard", 2), 0, "a", "L1"));
  assert.deepEqual(model.toWire(model.fromWire(wire)), wire);
  assert.equal(
    model.fromWire({ convention: "modified", rows: [{ alpha: 0, a: 0, d: "q1", theta: 0 }] }).rows[0].joint,
    "prismatic",
  );
});

test("the numbers of a sum are converted exactly, what stands in anything else is counted", () => {
  const cases = [
    ["90", "rad", "pi/2"],
    ["-90", "rad", "-pi/2"],
    ["−45", "rad", "−pi/4"],
    ["0", "rad", "0"],
    ["120", "rad", "2*pi/3"],
    ["θ1", "rad", "θ1"],
    ["θ1 + 90", "rad", "θ1 + pi/2"],
    ["90 - q1", "rad", "pi/2 - q1"],
    ["pi/2", "rad", "pi/2"],
    ["90°", "rad", "90°"],
    ["pi/2", "deg", "90"],
    ["-π/2", "deg", "-90"],
    ["2*pi/3", "deg", "120"],
    ["q2 + pi/2", "deg", "q2 + 90"],
    ["2*(q1+90)", "rad", "2*(q1+90)"],
  ];
  for (const [text, unit, expected] of cases) {
    const table = model.setCell(model.newTable("modified", 1), 0, "alpha", text);
    assert.equal(convert.convertedAngles(table, unit).table.rows[0].alpha, expected);
  }
  const ten = convert.convertedSum("10", (term) => String(Number(term) + 1));
  assert.equal(ten, "11");
  const table = model.setCell(model.newTable("modified", 1), 0, "alpha", "2*(q1+90)");
  assert.equal(convert.convertedAngles(table, "rad").left, 1);
});

test("lengths are written in another unit, parameters stay", () => {
  let table = model.newTable("modified", 1, { lengthUnit: "m" });
  table = model.setCell(model.setCell(table, 0, "a", "0.4318"), 0, "d", "L1 - 0.1 + d2");
  const { table: found, left } = convert.convertedLengths(table, "m", "mm");
  assert.deepEqual([found.lengthUnit, found.rows[0].a, found.rows[0].d, left], ["mm", "431.8", "L1 - 100 + d2", 0]);
  assert.ok(convert.holdsNumbers(table, ["a", "d"]));
  assert.ok(!convert.holdsNumbers(model.newTable("standard", 2), ["a", "d"]));
  assert.deepEqual(
    convertedValues(
      { a2: 0.5, beta: 90 },
      (name) => (name === "beta" ? "angle" : "length"),
      { angle: "deg", length: "m" },
      { angle: "deg", length: "cm" },
    ),
    { a2: 50, beta: 90 },
  );
});

test("a number with an exponent or a decimal comma is one number, and keeps its comma", () => {
  const inMillimetres = (text) => {
    const table = model.setCell(model.newTable("standard", 1), 0, "a", text);
    const { table: found, left } = convert.convertedLengths(table, "m", "mm");
    return [found.rows[0].a, left];
  };
  const cases = [
    ["1e-3", "1"],
    ["2.5E−3", "2.5"],
    ["L1 - 1.2e-4", "L1 - 0.12"],
    ["1e3", "1000000"],
    ["6.1e-17+0.4", "6.1e-14+400"],
    ["0,4318", "431,8"],
    ["L1 + 0,25", "L1 + 250"],
    ["L1e-3", "L1e-3000"],
  ];
  for (const [text, expected] of cases) assert.deepEqual(inMillimetres(text), [expected, 0], text);
  const turned = model.setCell(model.newTable("standard", 1, { angleUnit: "rad" }), 0, "alpha", "6.123e-17");
  assert.equal(convert.doubtfulAngle(turned), null);
  assert.equal(convert.convertedAngles(turned, "deg").table.rows[0].alpha, "3.50822057959e-15");
  const comma = model.setCell(model.newTable("standard", 1), 0, "alpha", "-1,5708");
  assert.deepEqual(convert.doubtfulAngle(comma), { text: "1,5708", unit: "rad" });
  assert.equal(convert.convertedAngles(model.setCell(turned, 0, "alpha", "0,0"), "deg").table.rows[0].alpha, "0");
});

test("an angle that is usual in the other unit is doubted, whatever sum it is in", () => {
  const doubted = (angleUnit, alpha) => {
    const table = model.newTable("standard", 1, { angleUnit });
    return convert.doubtfulAngle(model.setCell(table, 0, "alpha", alpha));
  };
  assert.deepEqual(doubted("rad", "-90"), { text: "90", unit: "deg" });
  assert.deepEqual(doubted("rad", "q + 45"), { text: "45", unit: "deg" });
  assert.deepEqual(doubted("deg", "-1.5708"), { text: "1.5708", unit: "rad" });
  assert.deepEqual(doubted("deg", "0.785"), { text: "0.785", unit: "rad" });
  for (const text of ["", "0", "-90", "pi/2", "1", "1.5", "2.25", "a1", "atan2(1.57, 1)"])
    assert.equal(doubted("deg", text), null, text);
  for (const text of ["0", "-1.5708", "pi/2", "90°", "2*pi", "6.28", "b90"])
    assert.equal(doubted("rad", text), null, text);
});

test("a row's joint is told by its variable, however that is written", () => {
  const written = [
    ...[
      "θ1",
      "θ 1",
      "θ ₁",
      "theta[1]",
      "theta(1)",
      "θ*₁",
      "\\theta^{*}_1",
      "{\\theta}_1",
      "{{\\theta }_{1}}",
      "q 1 + 90",
    ],
    ...["Subscript[\\[Theta], 1]", "\\[Theta]1", "&theta;<sub>1</sub>", "Ѳ1", "𝜃₁"],
  ];
  for (const theta of written) assert.equal(model.inferredJoint({ d: "d1", theta }), "revolute", theta);
  for (const d of ["q3", "d 3", "d[3]", "{{d}_{3}}", "Subscript[d, 3]", "d<sub>3</sub>", "L1 + d₃", "d^{*}_3"])
    assert.equal(model.inferredJoint({ d, theta: "90" }), "prismatic", d);
  for (const d of ["", "L1", "sqrt(2)", "0.3 m", "rad2", "q_L + 2"])
    assert.equal(model.inferredJoint({ d, theta: "90 deg" }), "fixed", d);
});

test("undo and redo step over runs of typing", () => {
  const start = model.newTable("modified", 1);
  const history = new UndoHistory(start);
  history.change(model.setCell(history.state, 0, "a", "L"), "0/a");
  history.change(model.setCell(history.state, 0, "a", "L1"), "0/a");
  history.change(model.setCell(history.state, 0, "d", "5"), "0/d");
  assert.ok(history.undo());
  assert.deepEqual([history.state.rows[0].a, history.state.rows[0].d], ["L1", ""]);
  assert.ok(history.undo());
  assert.equal(history.state, start);
  assert.ok(!history.undo());
  assert.ok(history.redo() && history.redo());
  assert.equal(history.state.rows[0].d, "5");
  assert.ok(!history.redo());
});
