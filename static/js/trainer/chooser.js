/** One frame's part as a list to choose from, in an order that says nothing; what is wrong is said once it was checked. */

import { el, fill, uniqueId } from "../dom.js";
import { t } from "../i18n.js";
import { shown } from "../numbers.js";
import { same } from "./steps.js";

/**
 * @param {HTMLElement} place
 * @param {{state: import("./steps.js").State, part: "z" | "origin" | "x", candidates: Wire.Candidate[],
 *   findings: Wire.Finding[], choose: (vector: Wire.Vector) => void, point: (candidate: Wire.Candidate | null) => void}} view
 *   `point` lights the candidate in the picture whose option is pointed at or has the focus
 */
export function showChooser(place, { state, part, candidates, findings, choose, point }) {
  const shownNow = JSON.stringify([state.frame, part, candidates]);
  if (place.dataset.shown !== shownNow) {
    const focused = document.activeElement instanceof HTMLInputElement ? document.activeElement.dataset.choice : "";
    fill(place, optionsOf(state.frame, part, candidates, { choose, point }));
    place.dataset.shown = shownNow;
    if (focused)
      /** @type {HTMLElement | null} */ (place.querySelector(`[data-choice="${focused}"]`))?.focus({
        preventScroll: true,
      });
  }
  const chosen = state.frames[state.frame][part];
  place.querySelectorAll("input").forEach((input, i) => (input.checked = same(chosen, candidates[i].vector)));
  const status = place.querySelector("[role=status]");
  if (status) fill(status, findings.map(findingNotice));
}

/**
 * @param {number} frame @param {"z" | "origin" | "x"} part @param {Wire.Candidate[]} candidates
 * @param {{choose: (vector: Wire.Vector) => void, point: (candidate: Wire.Candidate | null) => void}} actions
 */
function optionsOf(frame, part, candidates, { choose, point }) {
  const group = uniqueId("choice");
  return el(
    "fieldset",
    { class: "choices current" },
    el("legend", { text: t(`trainer-part-${part}`, { frame }) }),
    candidates.map((candidate, i) =>
      el(
        "label",
        { class: "choice", onpointerenter: () => point(candidate), onpointerleave: () => point(null) },
        el("input", {
          onfocus: () => point(candidate),
          onblur: () => point(null),
          type: "radio",
          name: group,
          dataset: { choice: String(i) },
          onchange: () => choose(candidate.vector),
        }),
        el("span", { text: candidateText(candidate) }),
        el("span", { class: "hint", text: `(${candidate.vector.map((value) => shown(value, 3)).join("; ")})` }),
      ),
    ),
    el("div", { role: "status" }),
  );
}

/** What a candidate is, in words. @param {Wire.Candidate} candidate */
export function candidateText({ kind, params }) {
  const text = t(`trainer-candidate-${kind}`, params);
  return params.sign === -1 ? `${t("trainer-opposite")} ${text}` : text;
}

/** @param {Wire.Finding} finding */
export function findingNotice({ severity, message }) {
  return el("p", { class: severity === "broken" ? "notice notice-problem" : "notice", text: message });
}
