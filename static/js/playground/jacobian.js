/** The Jacobian at the present joint values, in the base's frame and in the end's. */

import { el } from "../dom.js";
import { t } from "../i18n.js";
import { asked, Tool } from "./tool.js";
import { matrix, named } from "./values.js";

/** @param {import("../api.js").Api} api */
export function jacobianTool(api) {
  return new Tool(t("playground-jacobian"), async (subject) => {
    if (subject.joints.length === 0) return [el("p", { class: "hint", text: t("playground-no-joints") })];
    const answer = await api.post("jacobian", { ...asked(subject), joints: subject.joints });
    return [
      named([
        [t("playground-rank"), String(answer.rank)],
        [t("playground-singular"), t(answer.singular ? "playground-yes" : "playground-no")],
        [t("playground-manipulability"), answer.manipulability.toPrecision(4)],
      ]),
      matrix(t("playground-jacobian-base"), answer.J0, "J0"),
      matrix(t("playground-jacobian-end"), answer.Jn, "Jn"),
    ];
  });
}
