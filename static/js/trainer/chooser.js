/** One frame's parts as lists to choose from, with what the rules say of each choice. */

import { el, fill, uniqueId } from "../dom.js";
import { knows, t } from "../i18n.js";
import { shown } from "../numbers.js";
import { PARTS, same } from "./choices.js";

/** The focus goes back to where it was: that is nobody's choice of a part. */
let restoring = false;

/**
 * @param {HTMLElement} place
 * @param {{state: import("./choices.js").State, judged: any, choose: (part: any, vector: any) => void, part: (part: any) => void}} view
 *   `judged` is what the service says of the current frame
 */
export function showChooser(place, { state, judged, choose, part }) {
  const focused = document.activeElement instanceof HTMLInputElement ? document.activeElement.dataset.choice : "";
  const chosen = state.frames[state.current];
  fill(
    place,
    PARTS.map((name) => {
      const candidates = judged.candidates[name];
      const findings = judged.findings.filter((finding) => finding.part === name);
      const group = uniqueId("choice");
      return el(
        "fieldset",
        { class: `choices${state.part === name ? " current" : ""}`, onfocusin: () => restoring || part(name) },
        el("legend", { text: t(`trainer-part-${name}`, { frame: state.current }) }),
        candidates.map((candidate, i) =>
          el(
            "label",
            { class: "choice" },
            el("input", {
              type: "radio",
              name: group,
              dataset: { choice: `${name}:${i}` },
              checked: same(chosen[name], candidate.vector),
              onchange: () => choose(name, candidate.vector),
            }),
            el("span", { class: "choice-number", text: String(i + 1) }),
            el("span", { text: candidateText(candidate) }),
            el("span", { class: "hint", text: `(${candidate.vector.map((value) => shown(value, 3)).join(", ")})` }),
          ),
        ),
        el("div", { role: "status" }, findings.map(findingNotice)),
      );
    }),
  );
  restoring = true;
  if (focused) place.querySelector(`[data-choice="${focused}"]`)?.focus({ preventScroll: true });
  restoring = false;
}

/** What a candidate is, in words. @param {{kind: string, params: Record<string, number>}} candidate */
export function candidateText({ kind, params }) {
  const text = t(`trainer-candidate-${kind}`, params);
  return params.sign === -1 ? `${t("trainer-opposite")} ${text}` : text;
}

function findingNotice(finding) {
  const broken = finding.severity === "broken";
  const id = `trainer-rule-${finding.rule}`;
  const sentence = finding.message ?? (knows(id) ? t(id, finding.params) : finding.rule);
  return el("p", { class: broken ? "notice notice-problem" : "notice", text: sentence });
}
