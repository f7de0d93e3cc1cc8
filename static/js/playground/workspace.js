/** How far the robot reaches: radii, the cloud of places in the scene, and its section through the first axis. */

import { el } from "../dom.js";
import { t } from "../i18n.js";
import { shown } from "../numbers.js";
import { figure } from "../plots.js";
import { identity } from "../scene/matrix.js";
import { asked, Tool } from "./tool.js";
import { named, numbers } from "./values.js";

/** Points of the cloud: enough to show holes, few enough to be drawn at once. */
const SAMPLES = 4000;
const BANDS = 12;
/** Of the drawing [px]: a section is twice as high as wide. */
const WIDEST = 380;
/** Below it [m], what a tip moves is rounding. */
const NOTHING = 1e-9;

/** @param {import("../api.js").Api} api @param {import("./tool.js").Picture} picture */
export function workspaceTool(api, picture) {
  /** Where the joints stand makes no difference: what was found is shown until the robot or a limit changes. */
  let found = { asked: "", nodes: /** @type {Node[]} */ ([]), points: /** @type {Wire.Vector[]} */ ([]) };
  return new Tool(
    t("playground-workspace"),
    async (subject) => {
      const { types, limits } = subject;
      const endless = types.some((type, i) => type === "prismatic" && !limits?.[i]?.every((end) => end !== null));
      if (endless) {
        picture.layer("workspace", null);
        return [el("p", { class: "hint", text: t("playground-slide-needed") })];
      }
      const request = { ...asked(subject), limits: limits ?? types.map(() => null), samples: SAMPLES };
      if (JSON.stringify(request) !== found.asked) {
        const answer = await api.post("workspace", request);
        found = { asked: JSON.stringify(request), nodes: report(answer), points: answer.points };
      }
      picture.layer("workspace", cloud(found.points));
      return found.nodes;
    },
    { closed: () => picture.layer("workspace", null) },
  );
}

/** @param {any} answer */
function report(answer) {
  const unit = answer.length_unit;
  return [
    named([
      [t("playground-inner-axis"), numbers([answer.inner_radius.axis], unit)],
      [t("playground-outer-axis"), numbers([answer.outer_radius.axis], unit)],
      [t("playground-inner-origin"), numbers([answer.inner_radius.origin], unit)],
      [t("playground-outer-origin"), numbers([answer.outer_radius.origin], unit)],
    ]),
    el("p", { class: "hint", text: t("playground-cloud", { count: answer.points.length }) }),
    section(answer, unit),
  ];
}

/** Distance from the first axis and height along it, as if the arm stood in one half-plane. @param {any} answer @param {string} unit */
function section({ section: places, outer_radius: outer }, unit) {
  const radius = `${t("playground-section-radius")} [${unit}]`;
  const height = `${t("playground-section-height")} [${unit}]`;
  const domains = shownDomains(places, outer.axis);
  return figure(
    t("playground-section"),
    (plot, width) => ({
      width: Math.min(width, WIDEST),
      marginBottom: 42,
      x: { label: radius, labelOffset: 38, domain: domains.radius },
      y: { label: height, grid: true, domain: domains.height },
      aspectRatio: 1,
      marks: [
        plot.dot(places, {
          x: (/** @type {number[]} */ p) => p[0],
          y: (/** @type {number[]} */ p) => p[1],
          r: 1.1,
          fill: "var(--curve-1)",
          fillOpacity: 0.55,
        }),
        plot.ruleX([0], { stroke: "currentColor", strokeDasharray: "8 3 2 3" }),
      ],
    }),
    {
      caption: t("playground-section"),
      head: [height, `${radius}, ${t("playground-least")}`, `${radius}, ${t("playground-greatest")}`],
      rows: bands(places),
    },
  );
}

/**
 * What the axes of a section show, at equal scales: between half and twice as high as wide, even where the tip stays
 * on the first axis, at one height, or at one point.
 * @param {[number, number][]} places @param {number} outer the greatest radius
 */
function shownDomains(places, outer) {
  const heights = places.map(([, height]) => height);
  const [low, high] = [Math.min(...heights), Math.max(...heights)];
  const reach = Math.max(outer * 1.02, (high - low) / 2);
  const radius = reach > NOTHING ? reach : 1;
  const missing = Math.max(0, radius / 2 - (high - low)) / 2;
  return { radius: [0, radius], height: [low - missing, high + missing] };
}

/** The least and the greatest radius in each band of height. @param {[number, number][]} places @returns {(string | number)[][]} */
function bands(places) {
  const heights = places.map(([, height]) => height);
  const [low, high] = [Math.min(...heights), Math.max(...heights)];
  const step = (high - low) / BANDS;
  const count = step > 0 ? BANDS : 1;
  return Array.from({ length: count }, (_, k) => {
    const [from, to] = [low + k * step, low + (k + 1) * step];
    const inside = places.filter(([, height]) => height >= from && (height < to || k === count - 1)).map(([r]) => r);
    const ends = inside.length ? [Math.min(...inside), Math.max(...inside)].map((r) => shown(r, 3)) : ["–", "–"];
    return [step > 0 ? `${shown(from, 3)} … ${shown(to, 3)}` : shown(low, 3), ...ends];
  });
}

/** @param {Wire.Vector[]} points @returns {import("../scene/model.js").Model} */
function cloud(points) {
  const items = /** @type {import("../scene/model.js").Item[]} */ ([
    { kind: "points", at: { node: 0, at: [0, 0, 0] }, points, tone: "muted" },
  ]);
  return { nodes: [{ parent: -1, constant: identity() }], items, joints: 0 };
}
