/** From where a scene is seen: parallel projection, so that what is parallel looks parallel. */

import { cross, dot, minus, plus, times } from "./matrix.js";

/**
 * @typedef {import("./matrix.js").Vector} Vector
 * @typedef {{azimuth: number, elevation: number, scale: number, target: Vector, width: number, height: number}} Camera
 *   angles of the eye [rad], pixels per length unit, the point in the middle, size of the picture [px]
 */

/** Named directions to look from. @type {Record<string, {azimuth: number, elevation: number}>} */
export const VIEWS = {
  corner: { azimuth: -1.05, elevation: 0.44 },
  front: { azimuth: -Math.PI / 2, elevation: 0 },
  side: { azimuth: 0, elevation: 0 },
  top: { azimuth: -Math.PI / 2, elevation: Math.PI / 2 },
};

const STEEPEST = Math.PI / 2;
const EDGE = 34;
const DEPTH = 0.7;

/** Directions to the eye, to the right and up in the picture. @param {Camera} camera */
export function directions({ azimuth, elevation }) {
  const eye = /** @type {Vector} */ ([
    Math.cos(elevation) * Math.cos(azimuth),
    Math.cos(elevation) * Math.sin(azimuth),
    Math.sin(elevation),
  ]);
  const right = /** @type {Vector} */ ([-Math.sin(azimuth), Math.cos(azimuth), 0]);
  return { eye, right, up: cross(eye, right) };
}

/** Where a point appears [px] and how near it is. @param {Camera} camera @param {Vector} point */
export function project(camera, point) {
  const { eye, right, up } = directions(camera);
  const away = minus(point, camera.target);
  return {
    x: camera.width / 2 + dot(away, right) * camera.scale,
    y: camera.height / 2 - dot(away, up) * camera.scale,
    near: dot(away, eye),
  };
}

/** The camera that shows all of the points, from where it looks. @param {Camera} camera @param {Vector[]} points @returns {Camera} */
export function fitted(camera, points) {
  if (points.length === 0) return camera;
  const { eye, right, up } = directions(camera);
  const [x, y, z] = [right, up, eye].map((axis) => {
    const along = points.map((point) => dot(point, axis));
    const [low, high] = [Math.min(...along), Math.max(...along)];
    return { middle: (low + high) / 2, span: high - low };
  });
  const target = [x, y, z].reduce(
    (sum, { middle }, k) => plus(sum, times([right, up, eye][k], middle)),
    /** @type {Vector} */ ([0, 0, 0]),
  );
  /** @param {number} pixels @param {number} span */
  const room = (pixels, span) => Math.max(1, pixels - 2 * Math.min(EDGE, pixels / 8)) / span;
  // A part of the depth counts too, so that what turns into view later stays inside.
  const depth = z.span * DEPTH;
  const most = Math.max(x.span, y.span, z.span) || 1;
  const scale = Math.min(
    room(camera.width, Math.max(x.span, depth, most / 4)),
    room(camera.height, Math.max(y.span, depth, most / 4)),
  );
  return { ...camera, target, scale };
}

/** @param {Camera} camera @param {number} right [rad] @param {number} up [rad] @returns {Camera} */
export function orbited(camera, right, up) {
  const elevation = Math.max(-STEEPEST, Math.min(STEEPEST, camera.elevation + up));
  return { ...camera, azimuth: camera.azimuth + right, elevation };
}

/** @param {Camera} camera @param {number} factor @returns {Camera} */
export function zoomed(camera, factor) {
  return { ...camera, scale: camera.scale * factor };
}

/** Moves what is seen by so many pixels. @param {Camera} camera @param {number} dx @param {number} dy @returns {Camera} */
export function panned(camera, dx, dy) {
  const { right, up } = directions(camera);
  const shift = plus(times(right, -dx / camera.scale), times(up, dy / camera.scale));
  return { ...camera, target: plus(camera.target, shift) };
}
