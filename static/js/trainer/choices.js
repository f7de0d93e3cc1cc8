/** The frames as far as chosen: plain data and pure functions, one step of undo for each frame. */

/**
 * @typedef {[number, number, number]} Vector
 * @typedef {"z" | "origin" | "x"} Part
 * @typedef {{z?: Vector, origin?: Vector, x?: Vector}} Chosen
 * @typedef {{convention: "standard" | "modified", frames: Chosen[], current: number, part: Part}} State
 */

/** @type {Part[]} */
export const PARTS = ["z", "origin", "x"];

/** @param {number} joints @param {"standard" | "modified"} convention @returns {State} */
export function start(joints, convention) {
  return { convention, frames: Array.from({ length: joints + 1 }, () => ({})), current: 0, part: "z" };
}

/**
 * The state with one part of the current frame chosen, gone on to what is to be chosen next.
 * @param {State} state @param {Part} part @param {Vector} vector @returns {State}
 */
export function choose(state, part, vector) {
  const frames = state.frames.map((frame, i) => (i === state.current ? { ...frame, [part]: vector } : frame));
  const missing = PARTS.find((name) => !frames[state.current][name]);
  return { ...state, frames, part: missing ?? part };
}

/** The state at another frame. @param {State} state @param {number} frame @returns {State} */
export function goTo(state, frame) {
  const current = Math.max(0, Math.min(state.frames.length - 1, frame));
  return { ...state, current, part: PARTS.find((name) => !state.frames[current][name]) ?? "z" };
}

/** The state with the current frame empty again. @param {State} state @returns {State} */
export function clear(state) {
  return { ...state, frames: state.frames.map((frame, i) => (i === state.current ? {} : frame)), part: "z" };
}

/** What goes to the API. @param {State} state */
export function wire(state) {
  return state.frames.map(({ z, origin, x }) => (z || origin || x ? { ...(z && { z }), ...(origin && { origin }), ...(x && { x }) } : null));
}

/** Whether two vectors are the same, to the eye. @param {Vector | undefined} a @param {Vector} b */
export function same(a, b) {
  return Boolean(a) && a.every((value, k) => Math.abs(value - b[k]) < 1e-9 * (1 + Math.abs(b[k])));
}
