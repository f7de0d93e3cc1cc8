/** How far the robot reaches. */

import { t } from "../i18n.js";
import { asked, Tool } from "./tool.js";
import { named, numbers } from "./values.js";

/** @param {import("../api.js").Api} api @param {{limits: () => [number, number][] | null}} options */
export function workspaceTool(api, { limits }) {
  return new Tool(t("playground-workspace"), async (subject) => {
    const known = limits();
    const answer = await api.post("workspace", { ...asked(subject), ...(known ? { limits: known } : {}) });
    const unit = answer.length_unit;
    return [
      named([
        [t("playground-inner-axis"), numbers([answer.inner_radius.axis], unit)],
        [t("playground-outer-axis"), numbers([answer.outer_radius.axis], unit)],
        [t("playground-inner-origin"), numbers([answer.inner_radius.origin], unit)],
        [t("playground-outer-origin"), numbers([answer.outer_radius.origin], unit)],
      ]),
    ];
  });
}
