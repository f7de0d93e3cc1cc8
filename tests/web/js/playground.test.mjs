import assert from "node:assert/strict";
import { test } from "node:test";
import { withPoint } from "../../../static/js/editor/model.js";
import { limited } from "../../../static/js/joint-ranges.js";
import { numberIn } from "../../../static/js/numbers.js";
import { sharedOf } from "../../../static/js/playground/permalink.js";
import { ellipsoidModel, shadeModel } from "../../../static/js/scene/figures.js";
import { drawnPoints, position } from "../../../static/js/scene/model.js";
import { tableRobot } from "../../../static/js/scene/robots.js";

const identity = [
  [1, 0, 0, 0],
  [0, 1, 0, 0],
  [0, 0, 1, 0],
  [0, 0, 0, 1],
];

test("a decimal comma becomes a point, the comma between arguments stays", () => {
  assert.equal(withPoint("1,5*a2 + 0,25"), "1.5*a2 + 0.25");
  assert.equal(withPoint("atan2(1,2)"), "atan2(1,2)");
  assert.equal(withPoint("a2, 5"), "a2, 5");
});

test("numbers are read with a point or a comma, and nothing else is", () => {
  assert.deepEqual(["1.5", "1,5", " −2 ", ",5", "1,000.5", "", "x"].map(numberIn), [
    1.5,
    1.5,
    -2,
    0.5,
    null,
    null,
    null,
  ]);
});

test("limits narrow and widen ranges, in degrees too; one side alone leaves the other", () => {
  const ranges = [
    { name: "q1", type: "revolute", min: -Math.PI, max: Math.PI },
    { name: "q2", type: "prismatic", min: -0.5, max: 0.5 },
    { name: "q3", type: "revolute", min: -Math.PI, max: Math.PI },
  ];
  const found = limited(ranges, [[-90, 270], [null, 2], null], "deg");
  assert.ok(Math.abs(found[0].min + Math.PI / 2) < 1e-12);
  assert.ok(Math.abs(found[0].max - 1.5 * Math.PI) < 1e-12);
  assert.deepEqual([found[1].min, found[1].max], [-0.5, 2]);
  assert.deepEqual(found[2], ranges[2]);
});

test("a shade stands where the robot would, whatever the joints do", () => {
  const model = tableRobot({
    convention: "standard",
    rows: [{ joint: "revolute", sign: 1 }],
    links: [[[1, 0, 0, 2], ...identity.slice(1)]],
  });
  const shade = shadeModel(model, [Math.PI / 2]);
  assert.equal(shade.joints, 0);
  const far = drawnPoints(shade, []).map((p) => p[1]);
  assert.ok(Math.abs(Math.max(...far) - 2) < 1e-12);
});

test("the ellipsoid's extreme points are its radii, and a blocked direction is a dashed line", () => {
  const axes = [
    [1, 0, 0],
    [0, 1, 0],
    [0, 0, 1],
  ];
  const model = ellipsoidModel([0, 0, 1], { axes, radii: [2, 1, 0] }, 1);
  const tubes = model.items.filter((item) => item.kind === "tube");
  const xs = tubes.map((item) => position([identity], item.to)[0]);
  assert.ok(Math.abs(Math.max(...xs) - 0.6) < 1e-12);
  assert.equal(model.items.filter((item) => item.kind === "line" && item.dashed).length, 1);
});

test("a link keeps limits, and drops what is none", () => {
  const table = { convention: "standard", rows: [{ a: 0 }] };
  assert.deepEqual(sharedOf({ table, limits: [[-1, null], null] })?.limits, [[-1, null], null]);
  assert.equal(sharedOf({ table, limits: ["x"] })?.limits, undefined);
});
