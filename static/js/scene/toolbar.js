/** The buttons below a scene: turning, zooming, views, the whole screen, a picture to keep. */

import { announce, el, icon, iconButton } from "../dom.js";
import { t } from "../i18n.js";
import { orbited, VIEWS, zoomed } from "./camera.js";
import { TURN, ZOOM } from "./gestures.js";

/**
 * @param {{camera: () => import("./camera.js").Camera, change: (camera: import("./camera.js").Camera) => void,
 *   reset: (view?: string) => void, enlarge: () => void, record: () => void}} scene
 */
export function toolbar({ camera, change, reset, enlarge, record }) {
  const turn = (/** @type {number} */ right, /** @type {number} */ up) => () => change(orbited(camera(), right, up));
  const view = el(
    "select",
    {
      "aria-label": t("form-scene-view"),
      onchange: (event) => {
        reset(event.target.value);
        announce(t("form-scene-view-now", { view: event.target.selectedOptions[0].textContent }));
      },
    },
    Object.keys(VIEWS).map((name) => el("option", { value: name, text: t(`form-scene-view-${name}`) })),
  );
  const home = () => {
    view.value = "corner";
    reset();
  };
  return el(
    "div",
    { class: "scene-tools no-print", role: "group", "aria-label": t("form-scene-tools") },
    turnButton("turn", "left", turn(-TURN * 2, 0)),
    turnButton("turn", "right", turn(TURN * 2, 0)),
    turnButton("tilt", "up", turn(0, TURN * 2)),
    turnButton("tilt", "down", turn(0, -TURN * 2)),
    iconButton("add", t("form-scene-zoom-in"), () => change(zoomed(camera(), ZOOM))),
    iconButton("less", t("form-scene-zoom-out"), () => change(zoomed(camera(), 1 / ZOOM))),
    iconButton("home", t("form-scene-reset"), home),
    iconButton("enlarge", t("form-scene-enlarge"), enlarge, {
      "aria-pressed": "false",
      class: "icon quiet scene-enlarge",
    }),
    iconButton("picture", t("form-scene-record"), record),
    view,
  );
}

/** @param {"turn" | "tilt"} drawing @param {"left" | "right" | "up" | "down"} way @param {() => void} onclick */
function turnButton(drawing, way, onclick) {
  const label = t(`form-scene-turn-${way}`);
  const mirrored = way === "left" || way === "down" ? "mirrored" : null;
  const shape = icon(drawing);
  if (mirrored) shape.setAttribute("class", mirrored);
  return el("button", { type: "button", class: "icon quiet", "aria-label": label, title: label, onclick }, shape);
}
