import assert from "node:assert/strict";
import { test } from "node:test";
import { listenTo } from "../../../static/js/scene/gestures.js";
import { printable } from "../../../static/js/scene/paper.js";
import { fitted, orbited, project, VIEWS, zoomed } from "../../../static/js/scene/camera.js";
import * as matrix from "../../../static/js/scene/matrix.js";
import { drawnPoints, placed, poses, position, scaled, together } from "../../../static/js/scene/model.js";
import { piecesOf } from "../../../static/js/scene/bodies.js";
import { pickAt } from "../../../static/js/scene/picking.js";
import { figureRobot, tableRobot } from "../../../static/js/scene/robots.js";
import { coordinates } from "../../../static/js/trainer/picture.js";

const near = (actual, expected, tolerance = 1e-9) =>
  actual.forEach((value, i) => assert.ok(Math.abs(value - expected[i]) < tolerance, `${actual} ≠ ${expected}`));
const lift = (x, y, z) => [
  [1, 0, 0, x],
  [0, 1, 0, y],
  [0, 0, 1, z],
  [0, 0, 0, 1],
];
const quarter = [
  [1, 0, 0, 0],
  [0, 0, -1, 0],
  [0, 1, 0, 0],
  [0, 0, 0, 1],
]; // a turn by 90° about x
const origin = (pose) => matrix.column(pose, 3);

test("a rigid motion and its inverse cancel", () => {
  const pose = matrix.multiply(lift(1, 2, 3), quarter);
  near(matrix.multiply(pose, matrix.inverse(pose)).flat(), matrix.identity().flat());
});

test("the figure's coordinates are drawn where they count from, wherever the robot is fixed", () => {
  const drawn = coordinates({ size: 1, ground: { at: [0, 0, -0.34], normal: [0, 0, 1] } });
  const arrow = drawn.items.find(({ kind }) => kind === "arrow");
  near(position(poses(drawn, []), arrow.from), [0, 0, 0]);
});

test("a standard table's joint turns before its constant transform, a modified one's after", () => {
  const links = [lift(1, 0, 0), lift(1, 0, 0)];
  const rows = [
    { joint: "revolute", sign: 1 },
    { joint: "revolute", sign: 1 },
  ];
  const q = [Math.PI / 2, 0];
  const standard = tableRobot({ convention: "standard", rows, links });
  near(origin(poses(standard, q).at(-1)), [0, 2, 0]);
  const modified = tableRobot({ convention: "modified", rows, links });
  near(origin(poses(modified, q).at(-1)), [1, 1, 0]);
});

test("signs, slides and fixed rows", () => {
  const rows = [
    { joint: "fixed", sign: 1 },
    { joint: "prismatic", sign: -1 },
  ];
  const model = tableRobot({ convention: "standard", rows, links: [quarter, lift(0, 0, 1)] });
  assert.equal(model.joints, 1);
  near(origin(poses(model, [3]).at(-1)), [0, 2, 0]);
});

test("tubes follow the common normals: along the joint's axis first, then across it", () => {
  const model = tableRobot({ convention: "standard", rows: [{ joint: "revolute", sign: 1 }], links: [lift(2, 0, 5)] });
  const tubes = model.items.filter((item) => item.kind === "tube");
  const found = poses(model, [0]);
  assert.deepEqual(
    tubes.map((tube) => [position(found, tube.from), position(found, tube.to)]),
    [
      [
        [0, 0, 0],
        [0, 0, 5],
      ],
      [
        [0, 0, 5],
        [2, 0, 5],
      ],
    ],
  );
});

test("the figure's robot moves about its axes, bodies and all", () => {
  const figure = {
    axes: [
      { joint: 1, type: "revolute", point: [0, 0, 0], direction: [0, 0, 1] },
      { joint: 2, type: "prismatic", point: [1, 0, 0], direction: [0, 1, 0] },
    ],
    links: [
      [
        [0, 0, -1],
        [0, 0, 0],
        [1, 0, 0],
        [1, 1, 0],
      ],
    ],
  };
  const model = figureRobot(figure);
  const found = poses(model, [Math.PI / 2, 1]);
  const ends = model.items.filter((item) => item.kind === "tube").map((tube) => position(found, tube.to));
  near(ends[0], [0, 0, 0]);
  near(ends[1], [0, 1, 0]);
  near(ends[2], [-2, 1, 0]);
  assert.equal(model.joints, 2);
});

test("pieces follow the last joint before them, also where joints stand inside a stretch or side by side", () => {
  const axes = [
    [0, 0, 1],
    [0, 0, 3],
    [0, 0, 3],
  ].map((point, i) => ({ joint: i + 1, point }));
  const pieces = piecesOf(
    [
      [
        [0, 0, 0],
        [0, 0, 2],
        [0, 0, 4],
      ],
      [
        [0, 0, 2],
        [1, 0, 2],
      ],
    ],
    axes,
    4,
  );
  assert.deepEqual(
    pieces.map(({ from, to, body }) => [from[2], to[2], body]),
    [
      [0, 1, 0],
      [1, 2, 1],
      [2, 3, 1],
      [3, 4, 3],
      [2, 2, 1],
    ],
  );
});

test("a rod slides through the first joint that it meets, whole", () => {
  const axes = [
    [0, 0, 1],
    [1, 0, 1],
    [1, 0, 0.5],
  ].map((point, i) => ({ joint: i + 1, point }));
  const arm = [
    [0, 0, 0],
    [0, 0, 1],
    [1, 0, 1],
  ];
  const rod = [
    [1, 0, 2],
    [1, 0, 0],
  ];
  const bodies = (links) => piecesOf(links, axes, 2).map(({ from, to, body }) => [from[2], to[2], body]);
  assert.deepEqual(bodies([arm, rod]), [
    [0, 1, 0],
    [1, 1, 1],
    [2, 0.5, 2],
    [0.5, 0, 3],
  ]);
  assert.deepEqual(bodies([arm.slice(0, 2), rod]), [
    [0, 1, 0],
    [2, 0.5, 2],
    [0.5, 0, 3],
  ]);
});

test("a figure whose joints are off its links stands still", () => {
  const axes = [{ joint: 1, type: "revolute", point: [5, 0, 0], direction: [0, 0, 1] }];
  const model = figureRobot({
    axes,
    links: [
      [
        [0, 0, 0],
        [0, 0, 2],
      ],
    ],
  });
  assert.equal(model.joints, 0);
  assert.deepEqual(poses(model, [1]), poses(model, [0]));
});

test("placed and together keep what they hold", () => {
  const model = tableRobot({ convention: "modified", rows: [{ joint: "revolute", sign: 1 }], links: [lift(1, 0, 0)] });
  const moved = placed(model, lift(0, 0, 4));
  near(origin(poses(moved, [0.3]).at(-1)), [1, 0, 4]);
  const both = together([model, moved]);
  assert.equal(both.joints, 2);
  const found = poses(both, [0, Math.PI]);
  near(matrix.column(found.at(-1), 0), [-1, 0, 0]);
  near(origin(found.at(-1)), [1, 0, 4]);
});

test("what is fitted is inside the picture, and nearer things are nearer", () => {
  const model = tableRobot({ convention: "standard", rows: [{ joint: "revolute", sign: 1 }], links: [lift(3, 1, 2)] });
  const camera = fitted(
    { ...VIEWS.corner, scale: 1, target: [0, 0, 0], width: 400, height: 300 },
    drawnPoints(model, []),
  );
  for (const item of model.items) {
    const { x, y } = project(camera, position(poses(model, []), "from" in item ? item.to : item.at));
    assert.ok(x > 0 && x < 400 && y > 0 && y < 300);
  }
  const top = { ...camera, ...VIEWS.top };
  assert.ok(project(top, [0, 0, 1]).near > project(top, [0, 0, 0]).near);
  near([project(top, [1, 0, 0]).x - project(top, [0, 0, 0]).x], [camera.scale]);
  assert.ok(orbited(top, 0, 1).elevation <= Math.PI / 2);
  assert.ok(zoomed(top, 2).scale === top.scale * 2);
});

test("a model in another unit has the same shape", () => {
  const model = tableRobot({
    convention: "modified",
    rows: [{ joint: "prismatic", sign: 1 }],
    links: [lift(10, 20, 30)],
  });
  const metres = scaled(model, 0.001);
  near(
    drawnPoints(metres, [0.5]).flat(),
    drawnPoints(model, [500])
      .flat()
      .map((value) => value / 1000),
  );
  assert.ok(Math.abs(metres.items[0].radius - model.items[0].radius / 1000) < 1e-12);
});

test("a click means the nearest thing that can be picked", () => {
  const model = {
    nodes: [],
    joints: 0,
    items: [
      { kind: "line", from: { node: -1, at: [0, 0, 0] }, to: { node: -1, at: [1, 0, 0] }, tone: "line", pick: "along" },
      { kind: "ball", at: { node: -1, at: [0, 0, 1] }, radius: 0.01, tone: "pick", pick: "above" },
      { kind: "ball", at: { node: -1, at: [0, 0, 0.9] }, radius: 0.01, tone: "pick" },
    ],
  };
  const camera = { ...VIEWS.front, scale: 100, target: [0, 0, 0], width: 400, height: 400 };
  assert.equal(pickAt(model, [], camera, 250, 203), "along");
  assert.equal(pickAt(model, [], camera, 201, 101), "above");
  assert.equal(pickAt(model, [], camera, 20, 20), null);
});

test("a press of the secondary button, whose menu may take its release, neither turns nor picks", () => {
  const view = Object.assign(new EventTarget(), { setPointerCapture() {} });
  const told = [];
  const tell = (name) => () => told.push(name);
  const camera = () => ({ ...VIEWS.corner, scale: 1, target: [0, 0, 0], width: 320, height: 240 });
  listenTo(view, { camera, change: tell("change"), click: tell("click"), grab: () => false });
  const pointer = (type, more) =>
    view.dispatchEvent(Object.assign(new Event(type), { pointerId: 1, clientX: 9, clientY: 9, ...more }));
  pointer("pointerdown", { button: 2, buttons: 2 });
  pointer("pointermove", { button: -1, buttons: 0, clientX: 99 });
  pointer("pointerup", { button: 2, buttons: 0 });
  assert.deepEqual(told, []);
  pointer("pointerdown", { button: 0, buttons: 1 });
  pointer("pointerup", { button: 0, buttons: 0 });
  assert.deepEqual(told, ["click"]);
});

test("a scene that has left the page is not drawn for paper", () => {
  const page = new EventTarget();
  globalThis.addEventListener = page.addEventListener.bind(page);
  let measured = 0;
  const viewport = {
    get clientWidth() {
      measured += 1;
      return 0;
    },
  };
  const listening = new AbortController();
  printable(viewport, () => {}, listening.signal);
  page.dispatchEvent(new Event("beforeprint"));
  listening.abort();
  page.dispatchEvent(new Event("beforeprint"));
  delete globalThis.addEventListener;
  assert.equal(measured, 1);
});
