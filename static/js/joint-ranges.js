/**
 * How far joints are moved by hand.
 *
 * @typedef {{name: string, type: string, min: number, max: number, value?: number}} JointRange
 *   angles in radians, lengths in the table's unit; `value` is where the joint stands at first, 0 if left out
 */

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

/** A joint value within its range. @param {JointRange} joint @param {number} [value] */
export function clamped(joint, value) {
  return Math.min(joint.max, Math.max(joint.min, value ?? 0));
}
