/**
 * How far joints are moved by hand.
 *
 * @typedef {{name: string, type: string, min: number, max: number, value?: number}} JointRange
 *   angles in radians, lengths in the table's unit; `value` is where the joint stands at first, 0 if left out
 * @typedef {([number | null, number | null] | null)[] | null} Limits
 *   [least, greatest] of joint 1 … n in a table's units; null where there is none
 */

import { radians } from "./numbers.js";

/**
 * Ranges for a robot's joints where nothing else is known: a turn either way, a slide of half the robot's size.
 * @param {{type: string, name: string}[]} joints @param {number} size
 * @returns {JointRange[]}
 */
export function usualRanges(joints, size) {
  return joints.map((joint) =>
    joint.type === "prismatic"
      ? { ...joint, min: -size / 2, max: size / 2 }
      : { ...joint, min: -Math.PI, max: Math.PI },
  );
}

/**
 * The ranges of joints that have limits; a limit that is missing on one side leaves that side as it is.
 * @param {JointRange[]} ranges @param {Limits} limits of joint 1 … n @param {string} angleUnit of the limits
 * @returns {JointRange[]}
 */
export function limited(ranges, limits, angleUnit) {
  return ranges.map((range, i) => {
    const inward = (/** @type {number} */ value) =>
      range.type === "revolute" && angleUnit === "deg" ? radians(value) : value;
    const [least, greatest] = (limits?.[i] ?? [null, null]).map((end) => (end === null ? null : inward(end)));
    const [min, max] = [
      least ?? Math.min(range.min, greatest ?? range.min),
      greatest ?? Math.max(range.max, least ?? range.max),
    ];
    return min <= max ? { ...range, min, max } : range;
  });
}

/** A joint value within its range. @param {JointRange} joint @param {number} [value] */
export function clamped(joint, value) {
  return Math.min(joint.max, Math.max(joint.min, value ?? 0));
}
