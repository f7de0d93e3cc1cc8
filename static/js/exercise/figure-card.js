/** The exercise's robot: its drawing, and the same geometry in space. */

import { el, fill, segmented } from "../dom.js";
import { t } from "../i18n.js";
import { keep, recall } from "../storage.js";
import { figureRobot } from "../scene/robots.js";

/**
 * @param {{figure: any, title: string}} exercise
 * @param {{mode: HTMLElement, body: HTMLElement, drawing: HTMLImageElement, description: HTMLElement}} parts
 */
export function showFigure({ figure, title }, { mode, body, drawing, description }) {
  description.textContent = figure.description;
  drawing.alt = t("form-figure-alt", { title });
  const model = figureRobot(figure);
  /** @type {any} */
  let scene = null;
  const show = (which) => {
    keep("figure-mode", which);
    drawing.hidden = which !== "drawing";
    if (which === "space" && !scene) {
      scene = el("robot-scene", { label: t("form-figure-label", { title }) });
      body.append(scene);
      scene.describe(figure.description);
      scene.model = model;
    }
    if (scene) scene.hidden = which !== "space";
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
