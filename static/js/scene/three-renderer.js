/** Draws a scene with WebGL. Loaded only when a scene is on the screen and the browser can. */

import {
  AmbientLight,
  BoxGeometry,
  BufferAttribute,
  BufferGeometry,
  Color,
  ConeGeometry,
  CylinderGeometry,
  DirectionalLight,
  Group,
  Mesh,
  MeshBasicMaterial,
  MeshLambertMaterial,
  OrthographicCamera,
  Points,
  PointsMaterial,
  Quaternion,
  Scene,
  SphereGeometry,
  Vector3,
  WebGLRenderer,
} from "../../vendor/three/three.js";
import { directions } from "./camera.js";
import { direction, position } from "./model.js";

const UP = new Vector3(0, 1, 0);
const LINE_PIXELS = 1.4;
const POINT_PIXELS = 2;
/** Joints of the student's robot are glass: the frames are inside them. */
/** @type {Record<string, number>} */
const GLASS = { "own-joint": 0.5, ghost: 0.45, "ghost-joint": 0.35, shade: 0.35, "shade-joint": 0.25 };
const FLAT = new Set(["line", "muted", "x", "y", "z", "pick", "lit"]);

/** What a typed row is drawn with: one tone of each kind of material. @type {import("./model.js").Tone[]} */
const TYPED = ["own", "own-joint", "lit"];
/** Too small to be seen, too large to be left out. */
const SPECK = 1e-6;

/** Shared shapes of size one, along y. */
const SHAPES = {
  cylinder: new CylinderGeometry(1, 1, 1, 28),
  cone: new ConeGeometry(1, 1, 20),
  ball: new SphereGeometry(1, 24, 16),
  block: new BoxGeometry(1, 1, 1),
  dashes: dashes(),
};

export class ThreeRenderer {
  constructor() {
    this.renderer = new WebGLRenderer({ antialias: true, alpha: true });
    this.element = this.renderer.domElement;
    this.element.className = "scene-canvas";
    this.element.setAttribute("aria-hidden", "true");
    this.camera = new OrthographicCamera();
    this.scene = new Scene();
    this.light = new DirectionalLight(0xffffff, 2.1);
    this.scene.add(new AmbientLight(0xffffff, 1.35), this.light, this.light.target);
    this.group = new Group();
    this.scene.add(this.group);
    /** @type {Map<string, MeshLambertMaterial | MeshBasicMaterial>} */
    this.materials = new Map();
    /** @type {{item: import("./model.js").Item, parts: (Mesh | Points)[]}[]} */
    this.drawn = [];
    this.size = "";
    this.warm = false;
  }

  /** Has every kind of material compiled, unseen: the first link that somebody types need not wait for that. */
  warmUp() {
    this.warm = true;
    const specks = TYPED.map((tone) => new Mesh(SHAPES.cylinder, this.material(tone)));
    for (const speck of specks) speck.scale.setScalar(SPECK);
    this.scene.add(...specks);
    this.renderer.render(this.scene, this.camera);
    this.scene.remove(...specks);
  }

  /** @param {import("./model.js").Model} model */
  setModel(model) {
    for (const { item, parts } of this.drawn) if (item.kind === "points") dispose(/** @type {Points} */ (parts[0]));
    this.group.clear();
    this.drawn = model.items
      .filter((item) => item.kind !== "label")
      .map((item) => {
        const parts =
          item.kind === "points"
            ? [this.cloud(item)]
            : shapesFor(item).map((shape) => new Mesh(shape, this.material(item.tone)));
        this.group.add(...parts);
        return { item, parts };
      });
  }

  /** Takes the colours of the style sheet. */
  takeColours() {
    const style = getComputedStyle(this.element);
    for (const [tone, material] of this.materials) material.color.set(colourOf(style, tone));
    for (const { item, parts } of this.drawn) {
      if (item.kind !== "points") continue;
      const { material } = /** @type {Points<BufferGeometry, PointsMaterial>} */ (parts[0]);
      material.color.set(colourOf(style, item.tone));
    }
  }

  /** @param {Extract<import("./model.js").Item, {kind: "points"}>} item */
  cloud(item) {
    const geometry = new BufferGeometry();
    geometry.setAttribute("position", new BufferAttribute(new Float32Array(item.points.flat()), 3));
    const color = colourOf(getComputedStyle(this.element), item.tone);
    const size = POINT_PIXELS * Math.min(window.devicePixelRatio, 2);
    const points = new Points(geometry, new PointsMaterial({ color, size, sizeAttenuation: false }));
    points.matrixAutoUpdate = false;
    return points;
  }

  /** @param {import("./matrix.js").Matrix[]} found @param {import("./camera.js").Camera} camera */
  draw(found, camera) {
    for (const { item, parts } of this.drawn) place(item, parts, found, camera);
    this.aim(camera);
    if (!this.warm) this.warmUp();
    this.renderer.render(this.scene, this.camera);
  }

  dispose() {
    this.renderer.dispose();
    this.renderer.forceContextLoss();
    this.element.remove();
  }

  /** @param {import("./model.js").Tone} tone */
  material(tone) {
    const known = this.materials.get(tone);
    if (known) return known;
    const Material = FLAT.has(tone) ? MeshBasicMaterial : MeshLambertMaterial;
    const glass = tone in GLASS ? { transparent: true, opacity: GLASS[tone], depthWrite: false } : {};
    const made = new Material({ color: colourOf(getComputedStyle(this.element), tone), ...glass });
    this.materials.set(tone, made);
    return made;
  }

  /** @param {import("./camera.js").Camera} camera */
  aim(camera) {
    const size = `${camera.width}x${camera.height}@${window.devicePixelRatio}`;
    if (size !== this.size) {
      this.size = size;
      this.renderer.setPixelRatio(Math.min(window.devicePixelRatio, 2));
      this.renderer.setSize(camera.width, camera.height, false);
    }
    const { eye, right, up } = directions(camera);
    const half = { x: camera.width / 2 / camera.scale, y: camera.height / 2 / camera.scale };
    const far = 1000 * Math.max(half.x, half.y);
    const { camera: view, light } = this;
    Object.assign(view, { left: -half.x, right: half.x, top: half.y, bottom: -half.y, near: 0, far: 2 * far });
    const target = new Vector3(...camera.target);
    view.position.copy(target).addScaledVector(new Vector3(...eye), far);
    view.up.set(...up);
    view.lookAt(target);
    view.updateProjectionMatrix();
    light.target.position.copy(target);
    light.position
      .copy(target)
      .addScaledVector(new Vector3(...eye), 1)
      .addScaledVector(new Vector3(...up), 0.9)
      .addScaledVector(new Vector3(...right), -0.5);
  }
}

/** @param {any} item */
function shapesFor(item) {
  switch (item.kind) {
    case "arrow":
      return [SHAPES.cylinder, SHAPES.cone];
    case "tube":
      return [SHAPES.cylinder, SHAPES.ball];
    case "ball":
      return [SHAPES.ball];
    case "block":
      return [SHAPES.block];
    case "line":
      return [item.dashed ? SHAPES.dashes : SHAPES.cylinder];
    default:
      return [SHAPES.cylinder];
  }
}

const start = new Vector3();
const end = new Vector3();
const along = new Vector3();
const turn = new Quaternion();

/** @param {any} item @param {any} parts @param {import("./matrix.js").Matrix[]} found @param {import("./camera.js").Camera} camera */
function place(item, parts, found, camera) {
  if (item.kind === "points") {
    if (item.at.node >= 0) parts[0].matrix.set(...found[item.at.node].flat());
    return;
  }
  if (!("from" in item)) {
    start.set(...position(found, item.at));
    if (item.kind === "ball") {
      parts[0].position.copy(start);
      parts[0].scale.setScalar(item.radius);
      return;
    }
    along.set(...direction(found, item.at.node, item.axis)).normalize();
    turn.setFromUnitVectors(UP, along);
    const wide = item.kind === "block" ? item.width : item.radius;
    set(parts[0], start, turn, wide, item.length);
    return;
  }
  start.set(...position(found, item.from));
  end.set(...position(found, item.to));
  along.subVectors(end, start);
  const length = along.length();
  if (length > 0) turn.setFromUnitVectors(UP, along.normalize());
  const radius = item.kind === "line" ? LINE_PIXELS / 2 / camera.scale : item.radius;
  if (item.kind === "arrow") {
    const head = Math.min(length * 0.4, radius * 6);
    set(parts[1], end.addScaledVector(along, -head / 2).clone(), turn, head * 0.38, head);
    end.addScaledVector(along, -head / 2);
    set(parts[0], start.add(end).multiplyScalar(0.5), turn, radius, Math.max(length - head, 1e-9));
    return;
  }
  if (item.kind === "tube") {
    parts[1].position.copy(end);
    parts[1].scale.setScalar(radius);
  }
  set(parts[0], start.add(end).multiplyScalar(0.5), turn, radius, Math.max(length, 1e-9));
}

/** @param {Points} points */
function dispose({ geometry, material }) {
  geometry.dispose();
  for (const each of [material].flat()) each.dispose();
}

/** @param {any} mesh @param {any} centre @param {any} rotation @param {number} wide @param {any} length */
function set(mesh, centre, rotation, wide, length) {
  mesh.position.copy(centre);
  mesh.quaternion.copy(rotation);
  mesh.scale.set(wide, length, wide);
}

/** A dash-dot centre line of length one, as one shape. */
function dashes() {
  const pieces = [];
  const period = 1 / 9;
  for (let k = 0; k < 9; k += 1) {
    pieces.push([k * period - 0.5, 0.62 * period], [(k + 0.77) * period - 0.5, 0.08 * period]);
  }
  const positions = [];
  const normals = [];
  const indices = [];
  for (const [from, length] of pieces) {
    const piece = new CylinderGeometry(1, 1, length, 8).translate(0, from + length / 2, 0);
    const offset = positions.length / 3;
    positions.push(...piece.attributes.position.array);
    normals.push(...piece.attributes.normal.array);
    indices.push(...Array.from(piece.index?.array ?? [], (index) => index + offset));
    piece.dispose();
  }
  const whole = new BufferGeometry();
  whole.setAttribute("position", new BufferAttribute(new Float32Array(positions), 3));
  whole.setAttribute("normal", new BufferAttribute(new Float32Array(normals), 3));
  whole.setIndex(indices);
  return whole;
}

/** @type {Record<string, string>} */
const NAMES = { x: "--axis-x", y: "--axis-y", z: "--axis-z" };

/** @param {CSSStyleDeclaration} style @param {string} tone */
function colourOf(style, tone) {
  return new Color(style.getPropertyValue(NAMES[tone] ?? `--scene-${tone}`).trim() || "#888888");
}
