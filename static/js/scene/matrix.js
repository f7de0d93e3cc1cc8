/**
 * Rigid motions as 4×4 rows, the way the API sends them. Only what a scene graph needs: products, inverses,
 * and a turn about or a slide along one's own z.
 *
 * @typedef {number[][]} Matrix 4×4, row by row
 * @typedef {[number, number, number]} Vector
 */

/** @type {() => Matrix} */
export const identity = () => [
  [1, 0, 0, 0],
  [0, 1, 0, 0],
  [0, 0, 1, 0],
  [0, 0, 0, 1],
];

/** @param {Matrix} a @param {Matrix} b @returns {Matrix} */
export function multiply(a, b) {
  return a.map((row) =>
    [0, 1, 2, 3].map((k) => row[0] * b[0][k] + row[1] * b[1][k] + row[2] * b[2][k] + row[3] * b[3][k]),
  );
}

/** Inverse of a rigid motion. @param {Matrix} m @returns {Matrix} */
export function inverse(m) {
  const turned = [0, 1, 2].map((i) => [m[0][i], m[1][i], m[2][i]]);
  return [...turned.map((row) => [...row, -(row[0] * m[0][3] + row[1] * m[1][3] + row[2] * m[2][3])]), [0, 0, 0, 1]];
}

/** @param {Matrix} m @param {Vector} p @returns {Vector} */
export function apply(m, p) {
  return /** @type {Vector} */ ([0, 1, 2].map((i) => m[i][0] * p[0] + m[i][1] * p[1] + m[i][2] * p[2] + m[i][3]));
}

/** A joint's motion: a turn about z [rad] or a slide along it. @param {string} type @param {number} q @returns {Matrix} */
export function jointMotion(type, q) {
  if (type === "prismatic") {
    const slide = identity();
    slide[2][3] = q;
    return slide;
  }
  const c = Math.cos(q);
  const s = Math.sin(q);
  return [
    [c, -s, 0, 0],
    [s, c, 0, 0],
    [0, 0, 1, 0],
    [0, 0, 0, 1],
  ];
}

/** @param {Vector} a @param {Vector} b @returns {Vector} */
export const plus = (a, b) => [a[0] + b[0], a[1] + b[1], a[2] + b[2]];

/** @param {Vector} a @param {Vector} b @returns {Vector} */
export const minus = (a, b) => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];

/** @param {Vector} a @param {number} k @returns {Vector} */
export const times = (a, k) => [a[0] * k, a[1] * k, a[2] * k];

/** @param {Vector} a @param {Vector} b */
export const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];

/** @param {Vector} a @param {Vector} b @returns {Vector} */
export const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];

/** @param {Vector} a */
export const norm = (a) => Math.hypot(a[0], a[1], a[2]);

/** A vector of length one, or z where there is no direction. @param {Vector} a @returns {Vector} */
export function unit(a) {
  const length = norm(a);
  return length > 0 ? times(a, 1 / length) : [0, 0, 1];
}

/** Column of a pose: 0 … 2 its axes, 3 its origin. @param {Matrix} m @param {number} k @returns {Vector} */
export const column = (m, k) => [m[0][k], m[1][k], m[2][k]];

/** Some direction across another. @param {Vector} z @returns {Vector} */
export function across(z) {
  return unit(cross(Math.abs(z[0]) < 0.8 ? [1, 0, 0] : [0, 1, 0], z));
}

/** A pose with its z along a direction, its x anywhere across it. @param {Vector} origin @param {Vector} z @returns {Matrix} */
export function poseAlong(origin, z) {
  const k = unit(z);
  const i = across(k);
  const j = cross(k, i);
  return [
    [i[0], j[0], k[0], origin[0]],
    [i[1], j[1], k[1], origin[1]],
    [i[2], j[2], k[2], origin[2]],
    [0, 0, 0, 1],
  ];
}
