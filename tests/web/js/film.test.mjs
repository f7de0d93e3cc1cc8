/** The film of a row ends where the link matrix does, in both conventions, and is continuous. */

import assert from "node:assert/strict";
import { test } from "node:test";

import { poseAt, still, stepsOf } from "../../../static/js/scene/film.js";
import { namePlaces } from "../../../static/js/scene/robots.js";
import { apply, identity, poseAlong } from "../../../static/js/scene/matrix.js";

const row = { joint: "revolute", sign: -1, variable: "q1", values: { alpha: 0.7, a: 0.4, d: -0.2, theta: 1.1 } };
const q = 0.3;
const th = 1.1 - q;
const [c, s, ca, sa] = [Math.cos(th), Math.sin(th), Math.cos(0.7), Math.sin(0.7)];
const [a, d] = [0.4, -0.2];

/** Craig, eq. 3.6; Spong, eq. 3.10: written out, element by element. */
const LINKS = {
  modified: [
    [c, -s, 0, a],
    [s * ca, c * ca, -sa, -sa * d],
    [s * sa, c * sa, ca, ca * d],
    [0, 0, 0, 1],
  ],
  standard: [
    [c, -s * ca, s * sa, a * c],
    [s, c * ca, -c * sa, a * s],
    [0, sa, ca, d],
    [0, 0, 0, 1],
  ],
};

function close(one, other) {
  one.forEach((line, i) =>
    line.forEach((value, k) => assert.ok(Math.abs(value - other[i][k]) < 1e-12, `${i},${k}: ${value}`)),
  );
}

test("the last frame of the film is the link matrix", () => {
  for (const convention of ["modified", "standard"]) close(poseAt(stepsOf(convention, row, q), 4), LINKS[convention]);
});

test("the film starts where frame i-1 is and goes on in the order of the convention", () => {
  assert.deepEqual(
    stepsOf("standard", row, q).map(({ cell }) => cell),
    ["theta", "d", "a", "alpha"],
  );
  assert.deepEqual(
    stepsOf("modified", row, q).map(({ cell }) => cell),
    ["alpha", "a", "theta", "d"],
  );
  close(poseAt(stepsOf("modified", row, q), 0), identity());
});

test("a still lights the cell whose turn it is, and nothing else", () => {
  const steps = stepsOf("standard", row, q);
  const { items } = still(steps, 3, identity(), { size: 1, index: 0 });
  const lit = new Set(items.filter(({ tone }) => tone === "lit").map(({ pick }) => pick));
  assert.deepEqual([...lit], ["a"]);
  const seen = new Set(items.filter(({ tone }) => tone === "muted").map(({ pick }) => pick));
  assert.deepEqual([...seen], ["theta", "d"]);
});

test("a joint's motion is in the step of its variable", () => {
  const slide = { joint: "prismatic", sign: 1, variable: "q1", values: { alpha: 0, a: 0, d: 0.1, theta: 0 } };
  assert.equal(stepsOf("standard", slide, 0.25).find(({ cell }) => cell === "d").amount, 0.35);
});

test("numbers of joints on one line stand on no other joint's body", () => {
  const size = 1;
  const world = [0, 0.3, 0.45, 0.6].map((z) => poseAlong([0, 0, z], [0, 0, 1]));
  const names = namePlaces(world, size).map((at, i) => apply(world[i], at));
  names.forEach((name, i) => {
    world.forEach((pose, k) => {
      if (k === i) return;
      const away = Math.hypot(name[0], name[1], Math.max(0, Math.abs(name[2] - pose[2][3]) - 0.065));
      assert.ok(away > 0.08, `${i + 1} on ${k + 1}`);
    });
    names.forEach((other, k) => assert.ok(k === i || Math.hypot(...name.map((v, j) => v - other[j])) > 0.08));
  });
});
