/**
 * After a wrong answer: the student's robot as a ghost over the exercise's, laid on it as far as it goes, and the
 * first frame that leaves it marked. The service says how it lies there; nothing here knows the key.
 */

import { t } from "../i18n.js";
import { placed, scaled, together } from "../scene/model.js";
import { figureRobot } from "../scene/robots.js";
import { METRES } from "../units.js";
import { movingScene } from "./moving-scene.js";

/** @typedef {import("../scene/model.js").Item} Item */

/** @type {Record<string, import("../scene/model.js").Tone>} */
const GHOST = { own: "ghost", "own-joint": "ghost-joint" };
/** Radius of the mark, relative to the robot. */
const MARK = 0.045;

/**
 * The scene, with two of the ghost's frames, and its joint values as functions of a motion of the exercise's robot away from its figure.
 * @param {{figure: Wire.Figure, own: import("../scene/robots.js").TableModel, size: number, departure: Wire.Departure,
 *   length: string}} given `size` of the own robot, in its table's unit of length
 */
function ghostModel({ figure, own, size, departure, length }) {
  const reference = figureRobot(figure, { dimensions: false });
  const at = { node: own.frames[departure.row], at: /** @type {import("../scene/model.js").Vector} */ ([0, 0, 0]) };
  const shown = new Set([own.frames[departure.row - 1], own.frames[departure.row]]);
  const items = own.items.filter((item) => !isTriad(item) || shown.has(nodeOf(item))).map(asGhost);
  items.push({ kind: "ball", at, radius: size * MARK, tone: "lit" });
  const ghost = placed(scaled({ ...own, items }, METRES[/** @type {"m"} */ (length)]), departure.base);
  /** @param {number[]} change */
  const joints = (change) => [
    ...change.slice(0, reference.joints),
    ...departure.posture.map((value, i) => value + departure.senses[i] * (change[i] ?? 0)),
  ];
  return { model: together([reference, ghost]), joints, types: figure.axes.map(({ type }) => type) };
}

/** @param {Item} item */
const isTriad = ({ kind }) => kind === "arrow" || kind === "label";
/** @param {Item} item */
const nodeOf = (item) => ("from" in item ? item.from : item.at).node;
/** @param {Item} item @returns {Item} */
const asGhost = (item) => ({ ...item, tone: GHOST[item.tone] ?? item.tone });

/** @param {Parameters<typeof ghostModel>[0]} given */
export function ghostRobot(given) {
  const { row } = given.departure;
  return movingScene({
    ...ghostModel(given),
    reach: given.figure.size,
    label: t("form-ghost-label"),
    text: t("form-ghost-text", { row }),
    description: t("form-ghost-description", { row }),
  });
}
