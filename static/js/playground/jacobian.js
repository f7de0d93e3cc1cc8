/** The Jacobian at the present joint values and in closed form, with the velocity ellipsoid in the scene. */

import { Latest } from "../api.js";
import { el, segmented, uniqueId } from "../dom.js";
import { t } from "../i18n.js";
import { shown } from "../numbers.js";
import { ellipsoidModel } from "../scene/figures.js";
import { column } from "../scene/matrix.js";
import { poses } from "../scene/model.js";
import { asked, Tool } from "./tool.js";
import { closedForm, FORMATS, matrix, named, numbers } from "./values.js";

/** @param {import("../api.js").Api} api @param {import("./tool.js").Picture} picture */
export function jacobianTool(api, picture) {
  const symbols = new Symbols(api);
  let mode = "numbers";
  const choice = segmented({
    name: uniqueId("jacobian-mode"),
    label: t("form-matrix-mode"),
    value: mode,
    options: ["numbers", "symbols"].map((value) => ({ value, label: t(`form-matrix-${value}`) })),
    onchange: (value) => {
      mode = value;
      tool.refresh();
    },
  });
  const tool = new Tool(
    t("playground-jacobian"),
    async (subject) => {
      if (subject.joints.length === 0) return [el("p", { class: "hint", text: t("playground-no-joints") })];
      if (mode === "symbols") return symbols.of(subject.table);
      const request = { ...asked(subject), joints: subject.joints };
      const [answer, { ellipsoids }] = await Promise.all([api.post("jacobian", request), api.post("rates", request)]);
      draw(picture, ellipsoids);
      return [
        named([
          [t("playground-rank"), String(answer.rank)],
          [t("playground-singular"), t(answer.singular ? "playground-yes" : "playground-no")],
          [t("playground-manipulability"), answer.singular ? "0" : answer.manipulability.toPrecision(4)],
          [t("playground-ellipsoid"), numbers(ellipsoids.translation.radii, `${answer.length_unit}/rad`)],
        ]),
        el("p", { class: "hint", text: t("playground-ellipsoid-hint") }),
        ...blocked(ellipsoids, answer.length_unit),
        matrix(t("playground-jacobian-base"), answer.J0, "J0"),
        matrix(t("playground-jacobian-end"), answer.Jn, "Jn"),
      ];
    },
    { controls: [choice], closed: () => picture.layer("ellipsoid", null) },
  );
  return tool;
}

/** @param {import("./tool.js").Picture} picture @param {any} ellipsoids */
function draw(picture, { translation }) {
  const robot = picture.robot();
  if (!robot) return;
  const tip = poses(robot.model, picture.joints())[robot.model.frames[robot.model.frames.length - 1]];
  picture.layer("ellipsoid", ellipsoidModel(column(tip, 3), translation, robot.size));
}

/** Motions that the end frame does not have here. @param {any} ellipsoids @param {string} unit */
function blocked({ blocked: twists, characteristic_length: length }, unit) {
  if (!twists.length) return [];
  const vector = (/** @type {number[]} */ values) => `(${values.map((value) => shown(value, 3)).join("; ")})`;
  const line = (/** @type {number[]} */ twist) =>
    el("li", {
      text: t("playground-blocked-motion", {
        v: vector(twist.slice(0, 3).map((value) => value * length)),
        w: vector(twist.slice(3)),
        unit,
      }),
    });
  return [el("p", { text: t("playground-blocked") }), el("ul", { class: "plain-list" }, twists.map(line))];
}

/** The closed form: the same wherever the joints stand, so it is asked for once for each table. */
class Symbols {
  #asked = "";
  /** @type {Node[]} */
  #nodes = [];
  #latest = new Latest();

  /** @param {import("../api.js").Api} api */
  constructor(api) {
    this.api = api;
  }

  /** @param {any} table */
  async of(table) {
    const asked = JSON.stringify(table);
    if (asked === this.#asked) return this.#nodes;
    const request = { table, form: "symbolic", notation: "short", formats: FORMATS };
    const found = await this.#latest.run((signal) => this.api.post("jacobian", request, { signal }));
    if (!found) return this.#nodes;
    this.#asked = asked;
    const { J0, Jn } = found.value;
    this.#nodes = [closedForm(t("playground-jacobian-base"), J0), closedForm(t("playground-jacobian-end"), Jn)];
    return this.#nodes;
  }
}
