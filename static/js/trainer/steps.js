/**
 * The frames as far as chosen, in the steps of the lecture: all z, the common normals, the origins, all x, and the
 * table read off. Plain data and pure functions; whether a step is right is said when it is checked, not before.
 */

/**
 * @typedef {[number, number, number]} Vector
 * @typedef {"z" | "origin" | "x"} Part
 * @typedef {"z" | "normals" | "origin" | "x" | "read"} Step
 * @typedef {{z?: Vector, origin?: Vector, x?: Vector}} Chosen
 * @typedef {{convention: "standard" | "modified", frames: Chosen[], step: Step, frame: number, checked: boolean}} State
 *   `checked` if the step as it stands was found wrong, so that its faults are shown until it is right
 */

/** @type {Step[]} */
export const STEPS = ["z", "normals", "origin", "x", "read"];

/** The part that is chosen in a step; null where nothing is. @param {Step} step @returns {Part | null} */
export const partOf = (step) => (step === "normals" || step === "read" ? null : step);

/** @param {number} joints @param {"standard" | "modified"} convention @returns {State} */
export function start(joints, convention) {
  return { convention, frames: Array.from({ length: joints + 1 }, () => ({})), step: "z", frame: 0, checked: false };
}

/**
 * The state with the step's part of a frame chosen, gone on to the next frame that lacks it.
 * @param {State} state @param {Vector} vector @returns {State}
 */
export function choose(state, vector) {
  const part = partOf(state.step);
  if (!part) return state;
  const frames = state.frames.map((frame, i) => (i === state.frame ? { ...frame, [part]: vector } : frame));
  const later = frames.findIndex((frame, i) => i > state.frame && !frame[part]);
  const open = later >= 0 ? later : frames.findIndex((frame) => !frame[part]);
  return { ...state, frames, frame: open >= 0 ? open : state.frame };
}

/** Whether the step has a choice for every frame. @param {State} state */
export function isFull({ step, frames }) {
  const part = partOf(step);
  return part === null || frames.every((frame) => frame[part] !== undefined);
}

/** The state at a step, with everything that comes after it still to be chosen. @param {State} state @param {Step} step @returns {State} */
export function backTo(state, step) {
  const later = STEPS.slice(STEPS.indexOf(step) + 1).map(partOf);
  const kept = (/** @type {Chosen} */ frame) =>
    Object.fromEntries(Object.entries(frame).filter(([part]) => !later.includes(/** @type {Part} */ (part))));
  return { ...state, step, frames: state.frames.map(kept), frame: 0, checked: false };
}

/** The state at the next step. @param {State} state @returns {State} */
export function onward(state) {
  const step = STEPS[Math.min(STEPS.indexOf(state.step) + 1, STEPS.length - 1)];
  return { ...state, step, frame: 0, checked: false };
}

/** What goes to the API. @param {State} state */
export function wire({ frames }) {
  return frames.map((frame) => (Object.keys(frame).length ? frame : null));
}

/** Whether two vectors are the same, to the eye. @param {Vector | undefined} a @param {Vector} b */
export function same(a, b) {
  return a !== undefined && a.every((value, k) => Math.abs(value - b[k]) < 1e-9 * (1 + Math.abs(b[k])));
}

/**
 * Candidates in an order that says nothing of which is right: the same at every visit, another one for each robot,
 * frame and part. Directions of the coordinates stand among the directions, as likely and as unlikely as the others.
 * @param {Wire.Candidate[]} candidates @param {string} key @param {Part} part
 * @returns {Wire.Candidate[]}
 */
export function shuffled(candidates, key, part) {
  const all =
    part === "origin"
      ? candidates
      : [...candidates, ...COORDINATES.filter((one) => !candidates.some(({ vector }) => same(vector, one.vector)))];
  return all
    .map((candidate, i) => ({ candidate, rank: hash(`${key}/${part}/${i}`) }))
    .sort((a, b) => a.rank - b.rank)
    .map(({ candidate }) => candidate);
}

/** @type {Wire.Candidate[]} */
const COORDINATES = [0, 1, 2].flatMap((k) =>
  [1, -1].map((sign) => ({
    kind: "coordinates",
    vector: /** @type {Vector} */ ([0, 1, 2].map((i) => (i === k ? sign : 0))),
    params: { axis: k + 1, sign },
  })),
);

/** FNV-1a, finished as in MurmurHash3 so that neighbours differ. @param {string} text */
function hash(text) {
  let h = 0x811c9dc5;
  for (let i = 0; i < text.length; i += 1) h = Math.imul(h ^ text.charCodeAt(i), 0x01000193);
  h = Math.imul(h ^ (h >>> 16), 0x85ebca6b);
  return (h ^ (h >>> 13)) >>> 0;
}
