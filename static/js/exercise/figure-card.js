/** The exercise's robot: its drawing, and the same geometry in space. */

import { isPassing, pauseAfter, waitOf } from "../api.js";
import { el, fill, segmented } from "../dom.js";
import { t } from "../i18n.js";
import { usualRanges } from "../joint-ranges.js";
import { resetButton } from "../joint-sliders.js";
import { framesModel } from "../scene/figures.js";
import { inverse, multiply } from "../scene/matrix.js";
import { frozen, poses, together } from "../scene/model.js";
import { figureRobot } from "../scene/robots.js";
import { keep, recall } from "../storage.js";

/** How often a drawing that did not come is asked for again. */
const TRIES = 20;

/**
 * @param {{figure: any, title: string}} exercise
 * @param {{mode: HTMLElement, body: HTMLElement, drawing: HTMLImageElement, description: HTMLElement}} parts
 */
export function showFigure({ figure, title }, { mode, body, drawing, description }) {
  description.textContent = figure.description;
  drawing.alt = t("form-figure-alt", { title });
  insist(drawing);
  const model = withFrames(figure);
  /** @type {HTMLElement | null} */
  let space = null;
  /** @param {any} which */
  const show = (which) => {
    keep("figure-mode", which);
    drawing.hidden = which !== "drawing";
    if (which === "space" && !space) {
      space = inSpace(model, figure, title);
      body.append(space);
    }
    if (space) space.hidden = which !== "space";
  };
  const chosen = recall("figure-mode", "drawing");
  fill(
    mode,
    segmented({
      name: "figure-mode",
      label: t("form-figure-mode"),
      value: chosen,
      options: [
        { value: "drawing", label: t("form-figure-drawing") },
        { value: "space", label: t("form-figure-space") },
      ],
      onchange: show,
    }),
  );
  show(chosen);
}

/**
 * Asks again for a drawing that did not come, as from a service that starts anew: browsers don't, and they don't say
 * why it did not come. One that is refused for good is not asked for again.
 * @param {HTMLImageElement} drawing
 */
function insist(drawing) {
  let failures = 0;
  const again = (wait = 0) => {
    failures += 1;
    if (failures <= TRIES) setTimeout(() => void ask(), pauseAfter(failures, wait));
  };
  const ask = async () => {
    const answer = await fetch(drawing.src).catch(() => null);
    if (answer?.ok) {
      await answer.blob().catch(() => null);
      drawing.setAttribute("src", drawing.src);
    } else if (!answer || isPassing(answer.status)) again(answer ? waitOf(answer) : 0);
  };
  drawing.addEventListener("error", () => again());
  if (drawing.complete && drawing.naturalWidth === 0) again();
}

/** The robot with the frames that the figure shows. With all of them it stands still, for they belong to that posture; a last frame alone moves with its link. @param {Wire.Figure} figure */
function withFrames(figure) {
  const robot = figureRobot(figure);
  const drawn = figure.frames ?? [];
  if (!drawn.length) return robot;
  const model = together([robot, framesModel(drawn, figure.size)]);
  const still = Array(robot.joints).fill(0);
  if (drawn.length > figure.axes.length) return frozen(model, still);
  const [parent, first] = [robot.nodes.length - 1, robot.nodes.length];
  const link = inverse(poses(robot, still)[parent]);
  drawn.forEach(({ number }, i) => {
    const { constant } = model.nodes[first + i];
    if (number > 0) model.nodes[first + i] = { parent, constant: multiply(link, constant) };
  });
  return model;
}

/** The robot in space, with a slider for each of its joints, counted from the posture of the drawing. @param {import("../scene/model.js").Model} model @param {Wire.Figure} figure @param {string} title */
function inSpace(model, figure, title) {
  const scene = el("robot-scene", { label: t("form-figure-label", { title }) });
  const element = el("div", {}, scene);
  if (model.joints) {
    const sliders = /** @type {any} */ (el("joint-sliders"));
    const joints = figure.axes.map((/** @type {any} */ { joint, type }) => ({ name: String(joint), type }));
    sliders.joints = usualRanges(joints, figure.size);
    sliders.addEventListener("joints-change", (/** @type {any} */ event) => (scene.joints = event.detail.values));
    sliders.addEventListener("change", () => scene.settle());
    const head = el(
      "div",
      { class: "card-head" },
      el("span", { class: "hint", text: t("form-figure-posture") }),
      resetButton(sliders),
    );
    element.append(
      el("details", { class: "figure-text" }, el("summary", { text: t("form-figure-move") }), head, sliders),
    );
  }
  scene.describe(`${figure.description} ${t("form-scene-keys")}`);
  scene.model = model;
  return element;
}
