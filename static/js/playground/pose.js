/** Where the end frame is: position and orientation in every notation. */

import { t } from "../i18n.js";
import { asked, Tool } from "./tool.js";
import { angleSign, named, numbers } from "./values.js";

/** @param {import("../api.js").Api} api */
export function poseTool(api) {
  return new Tool(t("playground-pose"), async (subject) => {
    const answer = await api.post("forward-kinematics", {
      ...asked(subject),
      joints: subject.joints,
      parts: ["position", "orientation"],
    });
    const { quaternion, rpy, axis_angle: turn, xyzabc } = answer.orientation;
    const degrees = angleSign(answer.angle_unit);
    return [
      named([
        [t("playground-position"), numbers(answer.position, answer.length_unit)],
        [t("playground-quaternion"), numbers(quaternion)],
        [t("playground-rpy"), numbers(rpy, degrees)],
        [t("playground-axis-angle"), `${numbers(turn.axis)} · ${numbers([turn.angle], degrees)}`],
        [
          t("playground-xyzabc"),
          `${numbers(xyzabc.slice(0, 3), answer.length_unit)} · ${numbers(xyzabc.slice(3), degrees)}`,
        ],
      ]),
    ];
  });
}
